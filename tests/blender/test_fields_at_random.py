# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields of all kinds with settings up to their limits, previewed, changed, applied and taken
back on hulls of all kinds: nothing fails but with a sentence, and Cancel is bit-equal.

HULL_FIELD_STEPS is the number of changes on each hull, 25 when not said.
"""

import os
import random

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from test_fields import points_of, sample

pytestmark = pytest.mark.once

SEED = int(os.environ.get("HULL_FIELD_SEED", 20261124))
STEPS = int(os.environ.get("HULL_FIELD_STEPS", 25))
HULLS = ("coaster", "barge", "sailing_yacht", "catamaran", "container_ship")
BASES = ("POINT", "CREASE", "CURVE", "SECTION", "PLANE", "FACES")


class Session:
    """Random changes of a hull's fields."""

    def __init__(self, hull, seed):
        self.hull, self.random = hull, random.Random(seed)
        points = points_of(hull)
        self.low, self.size = points.min(axis=0), np.ptp(points, axis=0)

    def place(self):
        parts = [self.random.uniform(-0.2, 1.2) for _ in range(3)]
        return self.low + self.size * parts

    def length(self):
        """Mostly sensible, at times none at all or far too long."""
        odd = (0.0, 1e-7, 1e6, -1.0)
        sound = 0.3 * self.size[0] * self.random.random()
        return self.random.choice(odd) if self.random.random() < 0.1 else sound

    def shift(self):
        return [self.random.choice((0.0, 1.0, -1.0)) * 0.05 * self.length() for _ in range(3)]

    def line(self):
        if self.random.random() < 0.2:
            return None
        points = [self.place() for _ in range(self.random.randint(2, 6))]
        if self.random.random() < 0.1:
            points[1] = points[0]
        is_closed = len(points) > 2 and self.random.random() < 0.2
        return part("bridge.objects.curve_lines").made("Line", points, is_closed, self.hull)

    def change(self, field):
        name = self.random.choice(
            """use role base place axis curve becomes extent falloff shift axes varies extent_end
            falloff_end shift_end faces along_surface""".split()
        )
        if name == "faces":
            count = len(self.hull.data.polygons)
            faces = [self.random.randrange(count) for _ in range(self.random.randint(0, 5))]
            module = part("bridge.objects.field_faces")
            module.forget(self.hull, field)
            module.give(self.hull, field, sorted(set(faces)))
            return
        values = {
            "use": lambda: self.random.random() < 0.8,
            "role": lambda: self.random.choice(("MOVE", "MOVE", "PROTECT")),
            "base": lambda: self.random.choice(BASES),
            "place": self.place,
            "axis": lambda: self.random.choice("XYZ"),
            "curve": self.line,
            "becomes": self.line,
            "axes": lambda: [self.random.random() < 0.8 for _ in range(3)],
            "along_surface": lambda: self.random.random() < 0.4,
            "varies": lambda: self.random.random() < 0.5,
        }
        of_kind = {"extent": self.length, "falloff": self.random.random, "shift": self.shift}
        make = values.get(name) or of_kind[name.removesuffix("_end")]
        setattr(field, name, make())

    def step(self):
        fields = self.hull.hull.fields.fields
        if not len(fields) or self.random.random() < 0.2:
            self.call(self.random.choice(("add_field", "duplicate_field", "remove_field")))
            return
        self.change(self.random.choice(fields))

    @staticmethod
    def call(name, **arguments):
        """An operator, which may refuse with a sentence; returns whether it did not."""
        operator = getattr(bpy.ops.hull, name)
        if not operator.poll():
            return False
        try:
            return operator(**arguments) == {"FINISHED"}
        except RuntimeError as error:
            assert "Traceback" not in str(error), error
            return False


@pytest.mark.parametrize("name", HULLS)
def test_fields_at_random(name):
    hull = sample(name)
    session = Session(hull, f"{SEED} {name}")
    before = points_of(hull)
    volume = state_of(hull).hydrostatics.values.displaced_volume
    shown = applied = 0
    for k in range(STEPS):
        session.step()
        bpy.context.view_layer.update()
        if not hull.hull.fields.is_previewed:
            if session.random.random() < 0.3 and session.call("preview_fields"):
                shown += 1
            continue
        preview = part("features.fields.preview").of_hull(hull)
        assert np.isfinite(points_of(hull)).all(), k
        if preview.applied is None and not preview.problem:
            np.testing.assert_array_equal(points_of(hull), before)
        if session.random.random() < 0.2:
            assert session.call("cancel_fields")
            np.testing.assert_array_equal(points_of(hull), before, f"seed {SEED}, step {k}")
            assert state_of(hull).hydrostatics.values.displaced_volume == volume
        elif session.random.random() < 0.05:
            session.call("apply_fields")
            applied += 1
            before = points_of(hull)
            volume = state_of(hull).hydrostatics.values.displaced_volume
    assert shown
