# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/live_benchmark.py changes step by step, by random numbers of a fixed seed.

Each is called with the number of the step, and returns what kind of change it was.
"""

import random

import bmesh

SEED = 7
OF_SETTINGS = ("fields", "weight")


def changes(hull, drag):
    """Those of a hull by what is dragged: "one" or "all" points, "fields", or a "weight"."""
    if drag == "fields":
        return FieldChanges(hull)
    return WeightChanges(hull) if drag == "weight" else PointMoves(hull, drag)


class PointMoves:
    """Control points as a transform moves them in edit mode: one, or all."""

    def __init__(self, hull, which):
        self._mesh, self._is_one = hull.data, which == "one"
        self._random = random.Random(SEED)

    def __call__(self, step):
        bm = bmesh.from_edit_mesh(self._mesh)
        bm.verts.ensure_lookup_table()
        count = len(bm.verts)
        for index in [self._random.randrange(count)] if self._is_one else range(count):
            co = bm.verts[index].co
            co.x += self._random.uniform(-0.02, 0.02)
            if co.y > 0.1:
                co.y += self._random.uniform(-0.02, 0.02)
        bmesh.update_edit_mesh(self._mesh, loop_triangles=False, destructive=False)
        return "one moves" if self._is_one else "all move"


class FieldChanges:
    """Settings of the shape fields of a hull that is previewed, as sliders change them."""

    def __init__(self, hull):
        self._fields = hull.hull.fields.fields
        self._random = random.Random(SEED)

    def __call__(self, step):
        kinds = (self._falloff, self._extent, self._shift, self._base)
        kind = kinds[step % len(kinds)]
        kind()
        return kind.__name__.strip("_")

    def _falloff(self):
        self._fields[0].falloff = self._random.uniform(0.4, 0.8)

    def _extent(self):
        self._fields[0].extent = self._random.uniform(16.0, 20.0)

    def _shift(self):
        self._fields[0].shift[1] = self._random.uniform(0.3, 0.5)

    def _base(self):
        self._fields[0].place[0] = self._random.uniform(64.0, 66.0)


class WeightChanges:
    """The first parent's weight of a morph, as its slider changes it."""

    def __init__(self, hull):
        self._parent = hull.hull.morph.parents[0]
        self._random = random.Random(SEED)

    def __call__(self, step):
        self._parent.weight = self._random.uniform(-0.2, 1.2)
        return "weight"
