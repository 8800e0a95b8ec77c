# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may use whom in the add-on: dependencies point one way."""

import ast
import re
from pathlib import Path

import pytest

INNER = Path(__file__).resolve().parents[2] / "addon" / "hull_tools"

# What each part may use beside itself.
ALLOWED = {
    "io": set(),
    "bridge": {"io"},
    "properties": {"bridge", "io"},
    "operators": {"bridge", "io", "properties"},
    "panels": {"bridge", "io", "properties"},
    "overlays": {"bridge", "io", "properties"},
    "handlers": {"bridge", "io", "properties"},
}


def sources(folder):
    return sorted(folder.rglob("*.py"))


def used_modules(path):
    """What a file of the inner package imports of it: each as a tuple of names from `INNER` on."""
    package = path.relative_to(INNER).with_suffix("").parts[:-1]
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and 0 < node.level <= len(package) + 1:
            base = package[: len(package) + 1 - node.level]
            base += tuple(node.module.split(".")) if node.module else ()
            for alias in node.names:
                yield (*base, alias.name)


def subjects():
    """The subjects of the bridge in the order of its description."""
    text = ast.get_docstring(ast.parse((INNER / "bridge" / "__init__.py").read_text()))
    return re.findall(r"^ {2}(\w+) {2,}\S", text, re.MULTILINE)


@pytest.mark.parametrize("part", ALLOWED)
def test_parts_use_what_is_below_them(part):
    for path in sources(INNER / part):
        for used in used_modules(path):
            assert used[0] in ALLOWED[part] | {part}, f"{path.relative_to(INNER)}: {used}"


def test_all_parts_have_a_place():
    assert {path.name for path in INNER.iterdir() if (path / "__init__.py").exists()} == set(
        ALLOWED
    )


def test_all_of_the_bridge_is_described():
    names = {path.stem for path in (INNER / "bridge").iterdir() if path.stem[0] != "_"}
    assert len(subjects()) == len(set(subjects()))
    assert set(subjects()) == names


def test_subjects_of_the_bridge_use_those_above_them():
    order, bridge = subjects(), INNER / "bridge"
    for path in sources(bridge):
        own = path.relative_to(bridge).with_suffix("").parts[0]
        for used in used_modules(path):
            if used[0] == "bridge":
                assert order.index(used[1]) <= order.index(
                    own
                ), f"{path.relative_to(bridge)}: {used}"


def test_only_one_module_imports_the_native_one():
    for path in sources(INNER):
        imports = re.search(r"^\s*(from|import)\b.*\bhull_native\b", path.read_text(), re.MULTILINE)
        assert bool(imports) == (path == INNER / "bridge" / "native.py"), path
