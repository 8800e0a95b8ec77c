# SPDX-License-Identifier: GPL-3.0-or-later
"""The docs' page of hull_native, made of its docstrings.

PYTHONPATH=build/release/python python3 scripts/reference/page.py FILE
"""

import importlib
import inspect
import re
import sys
from pathlib import Path

import signatures
import stubs

_HEAD = """\
# The Python module

`import hull_native` is all: what needs large libraries is loaded when it is asked for. This page is
made of the docstrings of the module (`./hull reference`); wheels carry them as type stubs. Lengths
are in metres, angles in radians, x forward, y to port, z up: [conventions.md](conventions.md).
"""
_GROUPS = {
    "_core": "Surface, lines, hydrostatics, stability, modelling",
    "_exchange": "CAD files",
    "_drawing": "Drawings",
    "_morphing": "Morphing",
    "_network": "Networks of curves",
    "_production": "Models, panels",
    "_resistance": "Resistance",
}


def _plain(kind):
    """A type as a reader wants it: without the names of compiled modules and of NumPy's types."""
    kind = re.sub(r"\bhull_native\._\w+\.", "", kind)
    kind = re.sub(r"numpy\.ndarray(\[[\w.]+(\[[\d, ]+\])?\])?", "array", kind)
    return kind.replace("os.PathLike", "path")


def _default(text):
    return "…" if text.startswith("<") else text


def _call(function):
    words = []
    for argument in function.arguments:
        if argument.name != "self":
            default = "" if argument.default is None else f"={_default(argument.default)}"
            words.append(argument.name + default)
    result = "" if function.returns == "None" else f" → {_plain(function.returns)}"
    return f"`{function.name}({', '.join(words)}){result}`"


def _one_line(text):
    return re.sub(r"\s+", " ", text).strip()


def _cell(text):
    return _one_line(text).replace("|", "\\|")


def _class_lines(cls):
    lines = [f"### {cls.name}", "", *([cls.text, ""] if cls.text else [])]
    made = [way for ways in cls.functions if ways[0].name == "__init__" for way in ways]
    for way in made:
        call = _call(way).replace("__init__", cls.name)
        lines += [f"- {call}: {_one_line(way.text)}" if way.text else f"- {call}"]
    others = [way for ways in cls.functions if ways[0].name != "__init__" for way in ways]
    for way in others:
        lines += [f"- {_call(way)}" + (f": {_one_line(way.text)}" if way.text else "")]
    if made or others:
        lines.append("")
    if cls.properties:
        lines += ["| | | |", "| --- | --- | --- |"]
        for one in cls.properties:
            lines.append(f"| `{one.name}` | {_cell(_plain(one.kind))} | {_cell(one.text)} |")
        lines.append("")
    return lines


def _function_lines(ways):
    lines = [f"### {ways[0].name}", ""]
    for way in ways:
        lines += [_call(way), ""]
        lines += [way.text, ""] if way.text else []
    return lines


def _python_lines(package):
    """Of what is written in Python beside the compiled modules."""
    lines = []
    for name, module in sorted(package._LATER.items()):
        if module.lstrip(".").startswith("_"):
            continue
        value = getattr(importlib.import_module(f"hull_native{module}"), name)
        lines += [f"### {name}", ""]
        if callable(value) and not inspect.isclass(value):
            lines += [f"`{name}{inspect.signature(value)}`", ""]
        lines += [inspect.getdoc(value) or "", ""]
    return lines


def page():
    """The text of the page."""
    import hull_native

    lines = [_HEAD]
    for name, module in stubs.compiled_modules().items():
        classes, functions, values = signatures.members(module)
        lines += [f"## {_GROUPS[name]}", ""]
        for ways in sorted(functions, key=lambda ways: ways[0].name):
            lines += _function_lines(ways)
        for cls in sorted(classes, key=lambda cls: cls.name):
            lines += _class_lines(cls)
    lines += ["## Written in Python", "", *_python_lines(hull_native)]
    text = re.sub(r"\n{3,}", "\n\n", "\n".join(lines).rstrip() + "\n")
    # Where defaults are objects: these by their public names, without their places in memory.
    text = re.sub(r"<hull_native\.[\w.]+\.(\w+) object", r"<hull_native.\1 object", text)
    return re.sub(r" at 0x[0-9a-f]+", "", text)


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(page(), encoding="utf-8")
