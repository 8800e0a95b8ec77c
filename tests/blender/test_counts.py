# SPDX-License-Identifier: GPL-3.0-or-later
"""One of a thing is told as one."""

import bpy
import pytest
from addon_under_test import add_hull, part
from edited_hulls import edit, select


@pytest.mark.parametrize("count, words", [(0, "0 faces"), (1, "1 face"), (2, "2 faces")])
def test_counted(count, words):
    assert part("bridge.counts").counted(count, "face") == words


@pytest.mark.parametrize("points, words", [([0], "1 point locked"), ([0, 1], "2 points locked")])
def test_reports(points, words, capfd):
    hull = add_hull()
    edit(hull)
    select(hull, "vertex", points)
    assert bpy.ops.hull.lock_points() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert words in capfd.readouterr().out


@pytest.mark.parametrize("count, words", [(0, "0 edges are"), (1, "1 edge is"), (2, "2 edges are")])
def test_the_verb_agrees(count, words):
    assert part("bridge.counts").counted_are(count, "edge") == words
