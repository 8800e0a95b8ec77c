# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may use whom in the Python code: dependencies point one way."""

import ast
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
OUTER = ROOT / "addon"
INNER = OUTER / "hull_tools"
NATIVE = ROOT / "native" / "bindings" / "hull_native"

# What the packages beside hull_native may use beside themselves and Python's own library.
PACKAGES = {
    "hull_io": {"numpy"},
    "hull_fairness": {"numpy", "hull_native"},
    "hull_fitting": {"numpy", "hull_native", "hull_io"},
    # Dask and pandas where they are there, and where they are asked for.
    "hull_studies": {"numpy", "hull_native", "hull_io", "distributed", "pandas"},
}

# What each folder of hull_native may use beside itself, compiled modules and the modules beside the
# folders, in the order of docs/architecture.md.
FOLDERS = {
    "drawings": set(),
    "resistance": {"drawings"},
    "production": set(),
    "networks": set(),
    "comparison": set(),
    "dimensions": set(),
    "morphing": set(),
}

# What each part of the add-on may use beside itself.
ALLOWED = {
    "bridge": {"hull_io"},
    "features": {"bridge", "hull_io", "hull_fairness", "hull_fitting"},
    "properties": {"features", "bridge", "hull_io"},
    "operators": {"features", "bridge", "hull_io", "properties"},
    "panels": {"features", "bridge", "hull_io", "properties"},
    "overlays": {"features", "bridge", "hull_io", "properties"},
    "handlers": {"features", "bridge", "hull_io", "properties"},
}

# Parts whose subjects stand in an order.
ORDERED = ("bridge", "features")


def sources(folder):
    return sorted(folder.rglob("*.py"))


def imports(path):
    """The import statements of a file, wherever they stand."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield node


def used_modules(path, inner=INNER):
    """What a file of the inner package imports of it and of what lies beside it: each as a tuple of
    names from `inner` or from the package beside it on."""
    package = path.relative_to(inner.parent).with_suffix("").parts[:-1]
    for node in imports(path):
        if isinstance(node, ast.ImportFrom) and 0 < node.level <= len(package) + 1:
            base = package[: len(package) + 1 - node.level]
            base += tuple(node.module.split(".")) if node.module else ()
            for alias in node.names:
                names = (*base, alias.name)
                yield names[1:] if names[0] == inner.name else names


def foreign_packages(path):
    """The packages that a file imports by their full names."""
    for node in imports(path):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif node.level == 0:
            yield node.module.split(".")[0]


def subjects(part):
    """The subjects of a part in the order of its description."""
    text = ast.get_docstring(ast.parse((INNER / part / "__init__.py").read_text()))
    return re.findall(r"^ {2}(\w+) {2,}\S", text, re.MULTILINE)


@pytest.mark.parametrize("package", PACKAGES)
def test_packages_of_plain_python_use_little(package):
    for path in sources(ROOT / "python" / package):
        foreign = set(foreign_packages(path)) - sys.stdlib_module_names
        assert foreign <= PACKAGES[package], path
        for node in imports(path):
            depth = len(path.relative_to(ROOT / "python").parts) - 1
            assert isinstance(node, ast.Import) or node.level <= depth, path


def test_packages_of_plain_python_have_a_place():
    assert {path.parent.name for path in (ROOT / "python").glob("*/__init__.py")} == set(PACKAGES)


def test_folders_of_hull_native_have_a_place():
    assert {path.parent.name for path in NATIVE.glob("*/*.py")} == set(FOLDERS)
    assert all((NATIVE / folder / "__init__.py").exists() for folder in FOLDERS)


def test_folders_of_hull_native_use_earlier_ones():
    order = list(FOLDERS)
    for folder, used in FOLDERS.items():
        assert all(order.index(other) < order.index(folder) for other in used)


@pytest.mark.parametrize("folder", [*FOLDERS, ""])
def test_hull_native_uses_what_is_below(folder):
    """Each folder, and the modules beside them, which use none; public names, that would come from
    anywhere, are for others."""
    beside = {path.stem for path in NATIVE.glob("[!_]*.py")}
    allowed = beside | ({folder} | FOLDERS[folder] if folder else set())
    paths = sources(NATIVE / folder) if folder else sorted(NATIVE.glob("[!_]*.py"))
    assert paths
    for path in paths:
        for used in used_modules(path, NATIVE):
            assert used[0].startswith("_") or used[0] in allowed, f"{path}: {used}"
        assert set(foreign_packages(path)) - sys.stdlib_module_names <= {"numpy"}, path


@pytest.mark.parametrize("part", ALLOWED)
def test_parts_use_what_is_below_them(part):
    for path in sources(INNER / part):
        for used in used_modules(path):
            assert used[0] in ALLOWED[part] | {part, "hull_native"}, f"{path}: {used}"


def test_all_parts_have_a_place():
    assert {path.name for path in INNER.iterdir() if (path / "__init__.py").exists()} == set(
        ALLOWED
    )


@pytest.mark.parametrize("part", ORDERED)
def test_all_subjects_are_described(part):
    names = {path.stem for path in (INNER / part).iterdir() if path.stem[0] != "_"}
    assert len(subjects(part)) == len(set(subjects(part)))
    assert set(subjects(part)) == names


@pytest.mark.parametrize("part", ORDERED)
def test_subjects_use_those_above_them(part):
    order, folder = subjects(part), INNER / part
    for path in sources(folder):
        own = path.relative_to(folder).with_suffix("").parts[0]
        for used in used_modules(path):
            if used[0] == part:
                assert order.index(used[1]) <= order.index(own), f"{path}: {used}"


def test_only_one_module_imports_the_native_one():
    for path in sources(INNER):
        native = re.search(r"^\s*(from|import)\b.*\bhull_native\b", path.read_text(), re.MULTILINE)
        assert bool(native) == (path == INNER / "bridge" / "native.py"), path
