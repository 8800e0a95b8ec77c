# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields that are often wanted, in sizes that suit the hull: where to begin from."""

import numpy as np

from ...bridge import limits
from ...bridge.blender import units
from ...bridge.objects import curve_lines, field_faces
from . import body_recipes, bow_recipes, field_list, recipe_form


def add(obj, scene, name):
    """Adds the fields of a recipe, one of RECIPES, to a hull. ValueError where the hull has no part
    that it is about: nothing is added then."""
    form = recipe_form.form_of(obj, scene)
    rows = RECIPES[name](form)
    count = len(rows) + len(obj.hull.fields.fields)
    limits.at_most(count, "fields", limits.MOST_FIELDS)
    scale = units.metres_per_unit(scene)
    for row in rows:
        _add_row(obj, scene, row, scale)
    obj.hull.fields.active_field = count - len(rows)


def _add_row(obj, scene, row, scale):
    field = field_list.add(obj, scene, row.pop("role", "MOVE"), row.pop("base"))
    field.name = row.pop("name")
    field.axes = [axis in row.get("axes", "xyz") for axis in "xyz"]
    row.pop("axes", None)
    for name in ("curve", "becomes"):
        if name in row:
            title = field.name if name == "curve" else f"{field.name}: becomes"
            points = np.asarray(row.pop(name)) / scale
            setattr(field, name, curve_lines.made(title, points, False, obj))
    for name in ("extent", "extent_end", "place", "shift", "shift_end"):
        if name in row:
            setattr(field, name, np.asarray(row.pop(name)) / scale)
    field_faces.give(obj, field, row.pop("faces", ()))
    for name, value in row.items():
        setattr(field, name, value)


# By what properties.field_settings.RECIPES names them.
RECIPES = {
    "SHARPEN": bow_recipes.sharpen,
    "FATTEN": bow_recipes.fatten,
    "SHEER": body_recipes.sheer,
    "BILGE": body_recipes.bilge,
    "TUNNEL": body_recipes.tunnel,
    "FLARE": bow_recipes.flare,
    "BULB": bow_recipes.bulb,
}
