# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's own operators and settings, by chance between those of Blender."""

import bpy
import numpy as np
from addon_under_test import make_active, part

from . import operators, own_settings

# What is left out, by reason.
_NEEDS_A_FILE = {
    "hull.export_freeship",
    "hull.export_hull",
    "hull.export_iges",
    "hull.export_lines",
    "hull.export_model",
    "hull.export_panels",
    "hull.export_plates",
    "hull.export_plot",
    "hull.export_report",
    "hull.export_sections",
    "hull.export_series",
    "hull.export_series_table",
    "hull.export_step",
    "hull.export_table",
    "hull.import_hull",
    "hull.load_area_curve",
    "hull.load_sample",
    "hull.load_stl",
}
# Lamps and cameras: Blender's own operators come down with some objects that are no meshes.
_MAKES_NO_MESHES = {"hull.make_studio", "hull.studio_turntable", "hull.studio_view"}
# Seconds on hulls of many faces: test_seen_marks.py, test_fewest_marks.py, test_morph_sessions.py.
_TAKES_LONG = {"hull.count_marks", "hull.fewest_marks", "hull.make_morph", "hull.pair_again"}
LEFT_OUT = _NEEDS_A_FILE | _MAKES_NO_MESHES | _TAKES_LONG
# Of the field's hull.
_SHIFT, _EXTENTS = 0.05, (0.05, 0.6)
_CURVE_POINTS = 5


class OwnWork:
    """What a session.Session does with the add-on's own operators and settings. Its
    methods return what was done, or None."""

    def __init__(self, session):
        self._session, self._random = session, session.random

    def own_operator(self):
        for name in self._names():
            if operators.can_be_called(name):
                return self._call(name, self._arguments(name))
        return None

    def change_setting(self):
        hull = self._a_hull()
        return None if hull is None else own_settings.change(hull, self._random)

    def shape_field(self):
        """One thing that is done with a hull's shape fields and their preview."""
        hull = self._a_hull()
        if hull is None:
            return None
        if self._session.mode() == "OBJECT":
            make_active(hull)
        fields = hull.hull.fields
        if not fields.fields:
            return self._add_field(hull)
        ways = [self._change_field, self._give_curve, self._touch_curve]
        ways += [lambda hull, own=name: self._call(own, {}) for name in self._of_fields(fields)]
        return self._random.choice(ways)(hull)

    @staticmethod
    def _of_fields(fields):
        if fields.is_previewed:
            return "hull.cancel_fields", "hull.apply_fields", "hull.take_field_faces"
        return ("hull.preview_fields",) * 3 + ("hull.apply_fields", "hull.add_field")

    def _names(self):
        return operators.in_an_order_by_chance(("hull",), LEFT_OUT, self._random)

    def _a_hull(self):
        hulls = self._session.hulls()
        return self._random.choice(hulls) if hulls else None

    def _call(self, name, arguments):
        self._session.tell(f"{name} {arguments}")
        came = operators.call(name, arguments) if operators.can_be_called(name) else "no poll"
        return f"{name} {arguments}: {came}"

    def _arguments(self, name):
        """By chance, some of them at their limits, some of them names of objects."""
        arguments = operators.arguments_by_chance(name, self._random)
        for prop in operators.properties_of(name):
            if self._random.random() < 0.1:
                value = own_settings.limit_of(prop, self._random)
                if value is not None:
                    arguments[prop.identifier] = value
        return arguments

    def _add_field(self, hull):
        bases = ("POINT", "PLANE", "SECTION", "CREASE", "CURVE", "FACES")
        done = self._call("hull.add_field", {"base": self._random.choice(bases)})
        if hull.hull.fields.fields:
            self._change_field(hull)
        return done

    def _change_field(self, hull):
        """Place, extent and shift, in proportion to the hull."""
        field = self._random.choice(hull.hull.fields.fields)
        points = part("bridge.mesh.mesh_points").read(hull.data)
        if not len(points):
            return None
        size = float(np.ptp(points, axis=0).max())
        field.place = points[self._random.randrange(len(points))]
        field.extent = self._random.uniform(*_EXTENTS) * size
        field.shift = [self._random.uniform(-_SHIFT, _SHIFT) * size for _ in range(3)]
        return f"{hull.name} {field.name}"

    def _give_curve(self, hull):
        """A curve object through some of the hull's points, or one that is there."""
        field = self._random.choice(hull.hull.fields.fields)
        points = part("bridge.mesh.mesh_points").read(hull.data)
        if len(points) < 2:
            return None
        curves = [obj for obj in bpy.context.view_layer.objects if obj.type == "CURVE"]
        if not curves or self._random.random() < 0.5:
            along = points[np.argsort(points[:, 0])][:: max(len(points) // _CURVE_POINTS, 1)]
            make = part("bridge.objects.curve_lines").made
            curves = [make("base", along, self._random.random() < 0.3, hull)]
        field.base, field.curve = "CURVE", self._random.choice(curves)
        if self._random.random() < 0.2:
            field.becomes = field.curve
        return f"{hull.name} {field.name} {field.curve.name}"

    def _touch_curve(self, hull):
        """Moves, changes or removes the curve of a field."""
        curves = [field.curve for field in hull.hull.fields.fields if field.curve is not None]
        if not curves:
            return None
        curve, how = self._random.choice(curves), self._random.choice(("move", "shape", "remove"))
        told = f"{how} {curve.name}"
        self._session.tell(told)
        if how == "move":
            curve.location.y += self._random.uniform(-1.0, 1.0)
        elif how == "remove":
            bpy.data.objects.remove(curve)
        elif _has_points(curve):
            curve.data.splines[0].points[0].co.z += self._random.uniform(-1.0, 1.0)
            curve.data.update_tag()
        return told


def _has_points(curve):
    """Whether an object is a curve, still, whose points can be moved from here."""
    is_curve = curve.mode == "OBJECT" and curve.type == "CURVE"
    return is_curve and bool(curve.data.splines) and bool(curve.data.splines[0].points)
