# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/live_benchmark.py times by name is there."""

import ast
import functools
from pathlib import Path

import pytest
from addon_under_test import part

SCRIPT = Path(__file__).resolve().parents[2] / "scripts/live_benchmark.py"


def constants():
    """The literals that the script gives names in capitals; it starts to work when it is run."""
    found = {}
    for node in ast.parse(SCRIPT.read_text()).body:
        names = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
        if isinstance(node, ast.Assign) and names in ({"STEPS"}, {"DRAWN"}):
            found[names.pop()] = ast.literal_eval(node.value)
    return found


@pytest.mark.parametrize("module, name, label", constants()["STEPS"])
def test_steps_are_there(module, name, label):
    assert callable(functools.reduce(getattr, name.split("."), part(module)))


@pytest.mark.parametrize("name, handler", constants()["DRAWN"])
def test_what_is_drawn_is_there(name, handler):
    assert callable(getattr(part(f"overlays.{name}"), handler)._draw)
