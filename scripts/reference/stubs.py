# SPDX-License-Identifier: GPL-3.0-or-later
"""Type stubs (PEP 561) of hull_native, made of its docstrings.

PYTHONPATH=build/release/python python3 scripts/reference/stubs.py FOLDER

Writes FOLDER/_core.pyi and the like, __init__.pyi and py.typed: what a type checker or an editor
reads beside the module.
"""

import importlib
import re
import sys
import textwrap
import types
from pathlib import Path

import signatures

COMPILED = ("_core", "_drawing", "_exchange", "_morphing", "_network", "_production", "_resistance")
_HEAD = """\
# SPDX-License-Identifier: GPL-3.0-or-later
import os
from typing import Any, Callable, Dict, Iterable, List, Optional, Sequence, Tuple, Union, overload

import numpy
from numpy.typing import ArrayLike, NDArray

"""
# What pybind11 says of arguments and results that it leaves to the function.
_ANY = re.compile(r"\b(object|handle|function|method)\b")
_OWN = re.compile(r"\bhull_native\.(_\w+)\.(\w+)")
_ARRAY = re.compile(r"\bnumpy\.ndarray\[([\w.]+)(?:\[[\d, ]+\])?\]")
_FIXED = re.compile(r"\bList\[([\w.]+)\[\d+\]\]")
_BARE_ARRAY = re.compile(r"\bnumpy\.ndarray\b")


def compiled_modules():
    """The compiled modules of hull_native by name."""
    return {name: importlib.import_module(f"hull_native.{name}") for name in COMPILED}


def kind_in(module, text, is_argument):
    """A type of a docstring as it is written in the stub of a module."""
    text = _OWN.sub(lambda m: m[2] if m[1] == module else f"{m[1]}.{m[2]}", text)
    text = _ARRAY.sub("ArrayLike" if is_argument else r"NDArray[\1]", text)
    text = text.replace("NDArray[bool]", "NDArray[numpy.bool_]")
    text = _BARE_ARRAY.sub("ArrayLike" if is_argument else "NDArray[Any]", text)
    text = _FIXED.sub(r"List[\1]", text)
    text = _ANY.sub("Any", text)
    if is_argument:
        text = text.replace("List[", "Sequence[")
    return re.sub(r"\bos\.PathLike\b", "Union[str, os.PathLike[str]]", text)


def _call(module, function):
    words = []
    for argument in function.arguments:
        if argument.name == "self" or argument.name.startswith("*"):
            words.append(argument.name)
            continue
        kind = kind_in(module, argument.kind, True)
        default = "" if argument.default is None else " = ..."
        if argument.default == "None" and not kind.startswith(("Optional", "Any")):
            kind = f"Optional[{kind}]"
        words.append(f"{argument.name}: {kind}{default}")
    returns = kind_in(module, function.returns, False)
    return f"def {function.name}({', '.join(words)}) -> {returns}:"


def _docstring(text):
    """The body of a function of the stub: its docstring, or dots."""
    if not text:
        return "    ..."
    quoted = text.replace("\\", "\\\\").replace('"', '\\"')
    end = "\n" if "\n" in quoted else ""
    return textwrap.indent(f'"""{quoted}{end}"""', "    ", lambda line: line.strip())


def function_stub(module, ways, is_method=False):
    """The lines of a function, of all its ways of being called."""
    lines = []
    for way in ways:
        if len(ways) > 1:
            lines.append("@overload")
        if is_method and not (way.arguments and way.arguments[0].name == "self"):
            lines.append("@staticmethod")
        lines += [_call(module, way), _docstring(way.text)]
    return "\n".join(lines)


def class_stub(module, cls):
    bases = f"({', '.join(cls.bases)})" if cls.bases not in ((), ("object",)) else ""
    lines = [f"class {cls.name}{bases}:", _docstring(cls.text) if cls.text else ""]
    inner = []
    for one in cls.properties:
        kind = kind_in(module, one.kind, False)
        inner += ["@property", f"def {one.name}(self) -> {kind}:", _docstring(one.text)]
        if one.is_writable:
            kind = kind_in(module, one.kind, True)
            inner += [f"@{one.name}.setter", f"def {one.name}(self, value: {kind}) -> None: ..."]
    for ways in cls.functions:
        inner.append(function_stub(module, ways, is_method=True))
    lines.append(textwrap.indent("\n".join(inner) or "...", "    ", lambda line: line.strip()))
    return "\n".join(line for line in lines if line)


def module_stub(module):
    """The text of the stub of a compiled module."""
    name = module.__name__.rsplit(".", 1)[1]
    classes, functions, values = signatures.members(module)
    parts = [class_stub(name, cls) for cls in classes]
    parts += [function_stub(name, ways) for ways in functions]
    for key, value in values.items():
        if isinstance(value, types.ModuleType):
            inside = [f"    {k}: float" for k in vars(value) if not k.startswith("_")]
            parts.append("\n".join([f"class {key}:", *inside]))
        else:
            parts.append(f"{key}: {_value_kind(value)}")
    text = "\n\n".join(parts)
    others = [other for other in COMPILED if other != name and re.search(rf"\b{other}\.", text)]
    imports = "".join(f"from . import {other}\n" for other in others)
    return f"{_HEAD}{imports}\n{text}\n"


def _value_kind(value):
    if isinstance(value, list):
        return f"List[{type(value[0]).__name__}]"
    return type(value).__name__


def package_stub(package):
    """The text of the stub of hull_native itself: its names, each from the module that has it."""
    lines = ["# SPDX-License-Identifier: GPL-3.0-or-later"]
    for name in sorted(name for name in vars(package._core) if not name.startswith("_")):
        lines.append(f"from ._core import {name} as {name}")
    for name, module in sorted(package._LATER.items()):
        lines.append(f"from {module} import {name} as {name}")
    return "\n".join(lines) + "\n"


def write(folder):
    """Writes all stubs to a folder."""
    import hull_native

    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, module in compiled_modules().items():
        (folder / f"{name}.pyi").write_text(module_stub(module), encoding="utf-8")
    (folder / "__init__.pyi").write_text(package_stub(hull_native), encoding="utf-8")
    (folder / "py.typed").write_text("", encoding="utf-8")


if __name__ == "__main__":
    write(sys.argv[1])
