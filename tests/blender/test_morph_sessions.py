# SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions with morphs: weights, points moved by hand, edit mode, copies, deleted parents, undo and
redo, saving and loading in random order. A hull is the member that its weights say, or is told not
to be of its family any longer."""

import random

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import make_active, mesh_points, part
from expect_morph import assert_is_member, boxes, morph_of

STEPS = 60


class Session:
    """Things a user does, chosen by a random number generator; each is one undo step."""

    def __init__(self, seed, folder):
        self.random, self.folder = random.Random(seed), folder
        morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9), (1.2, 2.0, 1.4)))
        self.done("start")

    def done(self, name):
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message=name)

    def morphs(self):
        return [obj for obj in bpy.context.scene.objects if len(obj.hull.morph.parents)]

    def one(self):
        if bpy.context.mode != "OBJECT":  # undone until then
            bpy.ops.object.mode_set(mode="OBJECT")
        hull = self.random.choice(self.morphs())
        make_active(hull)
        return hull

    def step(self):
        actions = [self.weigh, self.weigh, self.undo, self.undo, self.redo, self.equal]
        actions += [self.back, self.move, self.copy, self.lose_parent, self.save, self.again]
        action = self.random.choice(actions)
        action()
        bpy.context.view_layer.update()
        return action.__name__

    def weigh(self):
        parents = self.one().hull.morph.parents
        self.random.choice(list(parents)).weight = self.random.uniform(-0.3, 1.3)
        self.done("weight")

    def equal(self):
        self.one()
        try:
            bpy.ops.hull.set_weights()
        except RuntimeError as error:
            assert "no longer the family's" in str(error)
        self.done("equal")

    def move(self):
        hull = self.one()
        bpy.ops.object.mode_set(mode="EDIT")
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        bm.verts[self.random.randrange(len(bm.verts))].co.x += 0.1
        bmesh.update_edit_mesh(hull.data)
        self.done("move")
        bpy.ops.object.mode_set(mode="OBJECT")
        self.done("object mode")

    def back(self):
        self.one()
        assert bpy.ops.hull.back_to_family() == {"FINISHED"}
        self.done("back")

    def copy(self):
        if len(self.morphs()) < 3:
            self.one()
            bpy.ops.object.duplicate()
            self.done("copy")

    def lose_parent(self):
        hulls = [obj for obj in bpy.context.scene.objects if obj.hull.is_hull]
        lost = [hull for hull in hulls if not len(hull.hull.morph.parents)]
        if len(lost) > 2 and bpy.context.mode == "OBJECT":
            make_active(self.random.choice(lost))
            bpy.ops.object.delete()
            self.done("delete")

    def again(self):
        self.one()
        try:
            bpy.ops.hull.pair_again()
        except RuntimeError as error:
            assert "was deleted" in str(error)
        self.done("again")

    def undo(self):
        if bpy.ops.ed.undo.poll():
            bpy.ops.ed.undo()

    def redo(self):
        if bpy.ops.ed.redo.poll():
            bpy.ops.ed.redo()

    def save(self):
        if bpy.context.mode != "OBJECT":
            return
        path = str(self.folder / "session.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path)
        if self.random.random() < 0.5:
            bpy.ops.wm.open_mainfile(filepath=path)
            self.done("loaded")

    def check(self):
        members = part("features.morphing.members")
        for hull in self.morphs():
            weights = [entry.weight for entry in hull.hull.morph.parents]
            assert sum(weights) == pytest.approx(1.0, abs=1e-6)
            told = members.told(hull)
            assert told.is_of_family == members.is_of_family(hull)
            if told.is_of_family:
                assert_is_member(hull)
            assert np.isfinite(mesh_points(hull)).all()


@pytest.mark.parametrize("seed", range(6))
def test_a_session(seed, tmp_path):
    session = Session(seed, tmp_path)
    done = []
    for _ in range(STEPS):
        done.append(session.step())
        if not session.morphs():  # undone altogether
            session = Session(seed + 100 * len(done), tmp_path)
        try:
            session.check()
        except AssertionError as error:
            raise AssertionError(f"seed {seed}, after {done}") from error
