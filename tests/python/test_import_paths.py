# SPDX-License-Identifier: GPL-3.0-or-later
"""Who adds folders to Python's path: only files that Blender runs, which has not even their own
folder on it. Tests have theirs by pytest.ini, other scripts by PYTHONPATH."""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("addon", "native", "python", "samples", "scripts", "tests")
RUN_BY_BLENDER = {
    "scripts/demo.py",
    "scripts/live_benchmark.py",
    "scripts/recipe_hulls.py",
    "scripts/sample_blends.py",
    "scripts/screenshots.py",
    "tests/blender/foreign_operations/run.py",
    "tests/window/in_blender.py",
}
REASON = "# Blender runs a file without its folder on the path.\nsys.path[:0] = "


def is_path(node):
    return isinstance(node, ast.Attribute) and ast.unparse(node) == "sys.path"


def changes_path(text):
    """Whether a source calls a method of sys.path, or gives it or a part of it a value."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if is_path(node.func.value):
                return True
        targets = node.targets if isinstance(node, ast.Assign) else ()
        targets = [node.target] if isinstance(node, ast.AugAssign) else targets
        for target in targets:
            if is_path(target) or isinstance(target, ast.Subscript) and is_path(target.value):
                return True
    return False


@pytest.mark.parametrize(
    "text", ["sys.path.insert(0, a)", "sys.path += [a]", "sys.path[:0] = [a]", "sys.path = [a]"]
)
def test_changes_are_found(text):
    assert changes_path(text) and not changes_path("folders = [*sys.path, a]")


def test_only_what_blender_runs_adds_folders():
    sources = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*.py")]
    texts = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in sources
    }
    assert {name for name, text in texts.items() if changes_path(text)} == RUN_BY_BLENDER
    for name in RUN_BY_BLENDER:
        assert texts[name].count(REASON) == 1, f"{name}: one change, with its reason"
