# SPDX-License-Identifier: GPL-3.0-or-later
"""Names in code, as docs/conventions.md has them: a name means one thing."""

import ast
import dataclasses
import re
from collections import defaultdict
from functools import cache
from pathlib import Path

import hull_io
import hull_native as hn
import pytest

ROOT = Path(__file__).resolve().parents[2]
SOURCES = ("addon", "python", "native/bindings/hull_native")
PAGE = (ROOT / "docs" / "conventions.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| ([^|]+?) \|", PAGE.split("## Names in code")[1], flags=re.M)
CLASSES = [name for row in ROWS for name in re.findall(r"`([A-Z]\w+)`", row)]


@cache
def trees():
    """{path: its tree} of the Python code."""
    paths = [path for folder in SOURCES for path in sorted((ROOT / folder).rglob("*.py"))]
    return {path: ast.parse(path.read_text(encoding="utf-8")) for path in paths}


def class_homes():
    """{name: the files that define a class of it}"""
    homes = defaultdict(list)
    for path, tree in trees().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                homes[node.name].append(str(path.relative_to(ROOT)))
    return homes


def test_the_page_has_classes():
    assert {"Particulars", "Hydrostatics", "FormParameters"} <= set(CLASSES)


@pytest.mark.parametrize("name", CLASSES)
def test_classes_of_the_page_are_one_class(name):
    """In Python, or in the core as the native module has it."""
    homes = class_homes()[name]
    if isinstance(getattr(hn, name, None), type) and not homes:
        homes = [getattr(hn, name).__module__]
    assert len(homes) == 1, homes


def test_a_trim_in_metres_says_so():
    """Settings: what is a length has its unit in the name where the name alone is an angle."""
    for path, tree in trees().items():
        for node in ast.walk(tree):
            if isinstance(node, ast.AnnAssign) and isinstance(node.annotation, ast.Call):
                made_by = getattr(node.annotation.func, "id", "")
                name = getattr(node.target, "id", "")
                assert not (name in ("trim", "heel") and made_by == "length"), path


def test_keep_is_for_points_and_variants():
    """Results and places are stored, or noted."""
    homes = {
        path.relative_to(ROOT).as_posix()
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and node.name.strip("_") == "keep"
    }
    features = "addon/hull_tools/features"
    assert homes == {
        f"{features}/constraints/flat_keeping.py",
        f"{features}/constraints/keeping.py",
        f"{features}/variants/kept_hulls.py",
    }


def test_openings_are_no_downflooding_points():
    names = {field.name for field in dataclasses.fields(hull_io.HullData)}
    assert "downflooding_points" in names and "openings" not in names
