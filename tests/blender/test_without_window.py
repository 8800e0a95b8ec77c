# SPDX-License-Identifier: GPL-3.0-or-later
"""The script of docs/blender.md, and what Blender saves by itself."""

import re
from pathlib import Path

import bpy
import pytest
from addon_under_test import DEPTH, ROOT, add_hull, mesh_points, state_of
from edited_hulls import edit_to_twice_the_depth


def test_the_script_of_the_docs(tmp_path):
    page = (ROOT / "docs" / "blender.md").read_text(encoding="utf-8")
    (script,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    assert "/tmp/coaster.csv" in script
    exec(script.replace("/tmp", str(tmp_path)), {})
    rows = (tmp_path / "coaster.csv").read_text(encoding="utf-8").splitlines()
    assert len(rows) > 10
    assert state_of(bpy.context.object).hydrostatics.values.draft == pytest.approx(5.0)


def test_a_mesh_that_a_script_made_is_a_hull_in_one_call():
    mesh = bpy.data.meshes.new("plate")
    mesh.from_pydata([(0, 0, 0), (5, 0, 0), (5, 2, 1), (0, 2, 1)], [], [(0, 3, 2, 1)])
    obj = bpy.data.objects.new("plate", mesh)
    bpy.context.collection.objects.link(obj)
    with bpy.context.temp_override(object=obj, active_object=obj):
        assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    assert obj.hull.is_hull and state_of(obj).ship.surface is not None


def test_what_is_saved_for_recovery_is_the_edited_hull(tmp_path):
    """Blender's copy for recovery is a copy of its memory, as is that of Save Copy."""
    hull = add_hull()
    edit_to_twice_the_depth(hull)
    path = Path(tmp_path) / "copy.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
    assert bpy.context.mode == "EDIT_MESH"
    surface = hull.hull.surface_object
    assert mesh_points(surface)[:, 2].max() == pytest.approx(2.0 * DEPTH)
    bpy.ops.wm.open_mainfile(filepath=str(path))
    hull = bpy.data.objects["box"]
    assert mesh_points(hull)[:, 2].max() == pytest.approx(2.0 * DEPTH)
    assert not state_of(hull).status
    assert mesh_points(hull.hull.surface_object)[:, 2].max() == pytest.approx(2.0 * DEPTH)
