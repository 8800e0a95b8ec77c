# SPDX-License-Identifier: GPL-3.0-or-later
"""Long sessions: edit mode and object mode, duplicates, deletions, undo and redo, saving and
loading in random order. What is shown is always that of the control meshes, and nothing is left
over."""

import random

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import (
    LENGTH,
    add_hull,
    fresh_surface_points,
    make_active,
    mesh_points,
    part,
    state_of,
)

STEPS = 80


class Session:
    """Things a user does, chosen by a random number generator; each is one undo step."""

    def __init__(self, seed, folder):
        self.random = random.Random(seed)
        self.folder = folder
        self.depth = 0
        if seed % 2:
            add_hull()
        else:  # with faces that are kept flat
            assert bpy.ops.hull.add_hull(kind="BARGE") == {"FINISHED"}
        self.done("start")

    def done(self, name):
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message=name)
        bpy.context.view_layer.update()
        self.depth += 1

    def hulls(self):
        return part("bridge.objects.hull_objects").hulls(bpy.context.scene.objects)

    def step(self):
        in_edit_mode = bpy.context.mode == "EDIT_MESH"
        actions = [self.move, self.undo, self.undo, self.redo, self.toggle]
        actions += (
            [self.tag] if in_edit_mode else [self.duplicate, self.delete, self.hide, self.save]
        )
        action = self.random.choice(actions)
        action()
        bpy.context.view_layer.update()
        return action.__name__

    def move(self):
        hull = bpy.context.view_layer.objects.active
        if hull is None or not hull.hull.is_hull:
            return
        axis, index = self.random.randrange(3), self.random.randrange(len(hull.data.vertices))
        amount = self.random.uniform(0.05, 0.2)
        if hull.mode == "EDIT":
            bm = bmesh.from_edit_mesh(hull.data)
            bm.verts.ensure_lookup_table()
            bm.verts[index].co[axis] += amount
            bmesh.update_edit_mesh(hull.data)
        else:
            hull.data.vertices[index].co[axis] += amount
            hull.data.update()
        self.done("move")

    def tag(self):
        bpy.ops.mesh.select_all(action="SELECT")
        self.random.choice((bpy.ops.hull.tag_smooth, bpy.ops.hull.tag_crease))()
        self.done("tag")

    def toggle(self):
        active = bpy.context.view_layer.objects.active
        if active is None or not active.visible_get():
            return
        bpy.ops.object.mode_set(mode="OBJECT" if bpy.context.mode == "EDIT_MESH" else "EDIT")
        self.done("mode")

    def duplicate(self):
        if len(self.hulls()) < 4 and bpy.context.selected_objects:
            bpy.ops.object.duplicate()
            self.done("duplicate")

    def delete(self):
        if len(self.hulls()) > 1 and bpy.context.selected_objects:
            bpy.ops.object.delete()
            make_active(self.hulls()[0])
            self.done("delete")

    def hide(self):
        hull = self.random.choice(self.hulls())
        hull.hide_set(not hull.hide_get())
        self.done("hide")

    def undo(self):
        if self.depth > 1:
            bpy.ops.ed.undo()
            self.depth -= 1

    def redo(self):
        if bpy.ops.ed.redo.poll():
            try:
                bpy.ops.ed.redo()
                self.depth += 1
            except RuntimeError:
                pass  # nothing to redo

    def save(self):
        bpy.ops.wm.save_as_mainfile(filepath=str(self.folder / "session.blend"))


def assert_all_is_in_step(session, where):
    hulls = session.hulls()
    surfaces = [hull.hull.surface_object for hull in hulls]
    assert len({surface.name for surface in surfaces}) == len(hulls), where
    in_scene = {obj.name for obj in bpy.context.scene.objects}
    assert in_scene == {obj.name for obj in (*hulls, *surfaces)}, where
    for hull, surface in zip(hulls, surfaces):
        assert surface.parent == hull and hull.hide_get() == surface.hide_get(), where
        if hull.hide_get():
            continue
        wanted = fresh_surface_points(hull)
        assert not state_of(hull).status, where
        assert mesh_points(surface).shape == wanted.shape, where
        assert np.abs(mesh_points(surface) - wanted).max() <= 1e-5 * LENGTH, where


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_what_is_shown_is_what_there_is(seed, tmp_path):
    print("seed", seed)
    session = Session(seed, tmp_path)
    done = []
    for _ in range(STEPS):
        done.append(session.step())
        assert_all_is_in_step(session, " ".join(done[-12:]))
    if bpy.context.mode == "EDIT_MESH":
        bpy.ops.object.mode_set(mode="OBJECT")
    path = str(tmp_path / "end.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    before = {hull.name: mesh_points(hull.hull.surface_object) for hull in session.hulls()}
    bpy.ops.wm.open_mainfile(filepath=path)
    assert {hull.name for hull in session.hulls()} == set(before)
    for hull in session.hulls():
        hull.hide_set(False)
    bpy.context.view_layer.update()
    assert_all_is_in_step(session, "after loading")
