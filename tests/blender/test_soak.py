# SPDX-License-Identifier: GPL-3.0-or-later
"""A thousand drags, tag changes, undos and redos in random order leave a hull as if it were made
anew, and nothing behind."""

import gc
import random
from collections import Counter

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of

pytestmark = pytest.mark.once

SEED = 20261122
STEPS = 1000
UNDO_STEPS = 24
# Blender itself takes a little more memory as undo steps differ in size; a surface that was kept
# with each step would take a hundred times as much.
MOST_GROWTH_MB = 25.0


def hull_with_all_shown():
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    hull = bpy.context.object
    hull.name = "soaked"
    hull.hull.samples = 2
    fairness = hull.hull.fairness
    fairness.comb_stations = fairness.comb_waterlines = fairness.comb_features = True
    hull.hull.plots.sectional_areas = True
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="start")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.ed.undo_push(message="edit mode")
    return hull


def the_hull():
    return bpy.data.objects["soaked"]


def points_of(hull):
    return part("bridge.mesh.mesh_arrays").read_mesh(hull.data).points


class Person:
    """Does at random what someone at work does."""

    def __init__(self):
        self.random = random.Random(SEED)
        self.done = Counter()

    def act(self):
        actions = {
            self.drag: 8,
            self.tag: 2,
            self.undo: 3,
            self.redo: 1,
            self.change_mode: 1,
            self.build: 1,
        }
        action = self.random.choices(list(actions), list(actions.values()))[0]
        self.done[action.__name__] += 1
        action()

    def drag(self):
        """Several steps of the mouse, and then one undo step."""
        hull = the_hull()
        self._edit(hull)
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        chosen = [
            self.random.randrange(len(bm.verts)) for _ in range(self.random.choice((1, 1, 6)))
        ]
        for _ in range(self.random.randint(1, 3)):
            step = [self.random.gauss(0.0, 0.01 * hull.hull.length_pp / 10.0) for _ in range(3)]
            for index in chosen:
                vertex = bm.verts[index]
                vertex.co.x += step[0]
                if vertex.co.y > 1e-3:
                    vertex.co.y = max(vertex.co.y + step[1], 2e-3)
                vertex.co.z += step[2]
            bmesh.update_edit_mesh(hull.data, loop_triangles=False, destructive=False)
            bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="drag")

    def tag(self):
        hull = the_hull()
        self._edit(hull)
        bm = bmesh.from_edit_mesh(hull.data)
        bm.edges.ensure_lookup_table()
        bpy.ops.mesh.select_all(action="DESELECT")
        for _ in range(3):
            bm.edges[self.random.randrange(len(bm.edges))].select_set(True)
        bm.select_flush_mode()
        self.random.choice((bpy.ops.hull.tag_crease, bpy.ops.hull.tag_smooth))()
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="tag")

    def build(self):
        """A fin that gives an edge three faces, which no hull has, and is taken away."""
        hull = the_hull()
        self._edit(hull)
        bm = bmesh.from_edit_mesh(hull.data)
        inner = [edge for edge in bm.edges if len(edge.link_faces) == 2]
        edge = self.random.choice(inner)
        fin = bm.verts.new((5.0, 20.0, 5.0))
        bm.faces.new((*edge.verts, fin))
        bmesh.update_edit_mesh(hull.data)
        bpy.context.view_layer.update()
        assert state_of(hull).status
        bmesh.ops.delete(bm, geom=[fin])
        bmesh.update_edit_mesh(hull.data)
        bpy.context.view_layer.update()
        assert not state_of(hull).status
        bpy.ops.ed.undo_push(message="build")

    def undo(self):
        steps = self.random.randint(1, 3)
        for _ in range(steps):
            self._step_through_history(bpy.ops.ed.undo, "undone")
        for _ in range(self.random.randint(0, steps)):
            self.redo()

    def redo(self):
        self._step_through_history(bpy.ops.ed.redo, "redone")

    def _step_through_history(self, operator, name):
        if self.done["drag"] < UNDO_STEPS or not operator.poll():
            return  # not beyond the start
        before = points_of(the_hull())
        try:
            operator()
        except RuntimeError:
            return  # nothing to redo
        self.done[name] += not np.array_equal(points_of(the_hull()), before)

    def change_mode(self):
        hull = the_hull()
        bpy.ops.object.mode_set(mode="OBJECT" if hull.mode == "EDIT" else "EDIT")
        bpy.context.view_layer.update()
        bpy.ops.ed.undo_push(message="mode")

    @staticmethod
    def _edit(hull):
        if hull.mode != "EDIT":
            bpy.ops.object.mode_set(mode="EDIT")


def assert_as_if_made_anew(hull):
    bpy.context.view_layer.update()
    kept = state_of(hull)
    assert not kept.status and not kept.lines.status and not kept.fairness.status
    hull_state = part("features.hull.hull_state")
    shown = np.empty((len(hull.hull.surface_object.data.vertices), 3), dtype=np.float32)
    hull.hull.surface_object.data.vertices.foreach_get("co", shown.reshape(-1))
    areas_of = part("features.analyses").outcome_of
    kept_areas = areas_of(hull, bpy.context.scene, "sectional_areas").result.areas

    hull_state.forget(hull)
    fresh = hull_state.refresh(hull, bpy.context.scene)
    assert fresh is not kept
    assert np.array_equal(kept.ship.surface.mesh.points, fresh.ship.surface.mesh.points)
    assert np.array_equal(shown, fresh.shown.points.coordinates)
    _assert_same_lines(kept, fresh)
    _assert_same_combs(kept, fresh)
    for name, value in vars(fresh.hydrostatics.values).items():
        before = getattr(kept.hydrostatics.values, name)
        if isinstance(value, float):
            # Their integrals are to 1e-8 of the whole.
            assert abs(before - value) <= 1e-7 * max(abs(value), 1.0), name
        else:
            assert before == value, name
    fresh_areas = areas_of(hull, bpy.context.scene, "sectional_areas").result.areas
    assert np.allclose(kept_areas.positions, fresh_areas.positions, rtol=0.0, atol=2e-8)
    scale = fresh_areas.areas.max()
    assert np.allclose(kept_areas.areas, fresh_areas.areas, rtol=0.0, atol=1e-6 * scale)


def _assert_same_lines(kept, fresh):
    assert kept.lines.groups.keys() == fresh.lines.groups.keys()
    for kind, group in fresh.lines.groups.items():
        lines = kept.lines.groups[kind].polylines
        assert len(lines) == len(group.polylines), kind
        for ours, theirs in zip(lines, group.polylines):
            assert np.array_equal(ours, theirs), kind


def _assert_same_combs(kept, fresh):
    assert kept.fairness.combs.keys() == fresh.fairness.combs.keys()
    for kind, group in fresh.fairness.combs.items():
        ours, count = kept.fairness.combs[kind].segments(1.0)
        theirs, their_count = group.segments(1.0)
        assert count == their_count and np.array_equal(ours, theirs), kind
        for name, marks in group.marks.items():
            assert np.array_equal(kept.fairness.combs[kind].marks[name], marks), (kind, name)


def _memory_mb():
    gc.collect()
    with open("/proc/self/status", encoding="ascii") as status:
        line = next(line for line in status if line.startswith("VmRSS"))
    return float(line.split()[1]) / 1024.0


def _own_handlers():
    own = part("handlers").__name__
    return Counter(
        (name, function)
        for name in dir(bpy.app.handlers)
        if isinstance(getattr(bpy.app.handlers, name), list)
        for function in getattr(bpy.app.handlers, name)
        if getattr(function, "__module__", "").startswith(own)
    )


def test_a_thousand_steps_leave_all_as_if_made_anew(capfd):
    print("seed", SEED)
    bpy.context.preferences.edit.undo_steps = UNDO_STEPS
    hull_with_all_shown()
    handlers = _own_handlers()
    person, memory = Person(), []
    for step in range(STEPS):
        person.act()
        if step % 100 == 99:
            memory.append(_memory_mb())
            assert_as_if_made_anew(the_hull())
    print(person.done, memory)
    assert min(person.done.values()) > 20, person.done
    assert _own_handlers() == handlers and set(handlers.values()) == {1}
    assert len(part("features.hull.hull_state")._states) == 1
    assert memory[-1] - memory[3] < MOST_GROWTH_MB, memory
    printed = capfd.readouterr()
    assert "Traceback" not in printed.out + printed.err
    assert "Error" not in printed.err
