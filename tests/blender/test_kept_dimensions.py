# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to dimensions while features keep their shape: beside Blender's work, with progress
and Esc, and only where the hull is as it was."""

import bpy
import numpy as np
import pytest
from addon_under_test import mesh_points, part, sample, state_of


def wider(hull):
    """(the scene, what the hull is asked for: a tenth more beam with its bilge kept)"""
    dimensions = part("features.dimensions.dimensions")
    return bpy.context.scene, dimensions.Asked(beam=1.1 * hull.hull.beam, keep=("bilge",))


def begun(hull):
    return part("features.dimensions.keeping_task").KeepingTask(hull, *wider(hull))


def ended(task):
    """What the task raises; it is a hull's task no longer then."""
    try:
        with pytest.raises(Exception) as told:
            task.write(bpy.context.scene)
    finally:
        part("features.conversion.conversions").take_finished()
    return told.value


def test_progress_rises_to_the_end():
    hull = sample("coaster")
    start = part("features.dimensions.dimensions").Start(hull, *wider(hull))
    told, before = [], mesh_points(hull)
    kept = start.find(told.append)
    assert len(told) >= 4 and told == sorted(told) and 0.0 <= told[0] and told[-1] <= 1.0
    assert np.array_equal(mesh_points(hull), before)
    brought = start.write(hull, bpy.context.scene, kept)
    assert brought.kept is kept and brought.factors[1] == pytest.approx(1.1)
    assert state_of(hull).plausible.extents.beam(True) == pytest.approx(1.1 * 13.6, rel=1e-6)


def test_escape_changes_nothing():
    hull = sample("coaster")
    before, beam = mesh_points(hull), hull.hull.beam
    task = begun(hull)
    task.cancel()
    assert isinstance(ended(task), part("bridge.background.jobs").Cancelled)
    assert np.array_equal(mesh_points(hull), before) and hull.hull.beam == beam


def test_a_hull_that_was_changed_meanwhile_stays():
    hull = sample("coaster")
    task = begun(hull)
    hull.hull.draft *= 1.01
    assert "dimensions were changed meanwhile" in str(ended(task))
    task = begun(hull)
    hull.data.vertices[3].co.y += 0.1
    hull.data.update()
    bpy.context.view_layer.update()
    before = mesh_points(hull)
    assert "was changed meanwhile" in str(ended(task))
    assert np.array_equal(mesh_points(hull), before) and hull.hull.beam == pytest.approx(13.6)


def test_one_task_at_a_time():
    hull = sample("coaster")
    task = begun(hull)
    with pytest.raises((ValueError, RuntimeError)):
        bpy.ops.hull.set_dimensions(beam=15.0, keep_bilge=True)
    task.cancel()
    ended(task)
