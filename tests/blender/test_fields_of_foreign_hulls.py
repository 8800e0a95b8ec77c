# SPDX-License-Identifier: GPL-3.0-or-later
"""Recipes of shape fields on foreign hulls and on copies of them as other programs might have left
them: each works, or refuses in one sentence and leaves the hull as it is.

HULL_ALL_COPIES=1 tries all hulls with all copies, not one of each small one.
"""

import bpy
import numpy as np
import pytest
from addon_under_test import mesh_points, part
from test_form_of_foreign_hulls import hull, works_or_refuses  # noqa: F401: hull is a fixture

pytestmark = pytest.mark.once

RECIPES = part("properties.field_settings").RECIPES


@pytest.mark.parametrize("recipe", [item[0] for item in RECIPES])
def test_recipes_work_or_refuse(hull, recipe):  # noqa: F811
    before = mesh_points(hull)

    def preview():
        assert bpy.ops.hull.add_field_recipe(recipe=recipe) == {"FINISHED"}
        assert bpy.ops.hull.preview_fields() == {"FINISHED"}

    if not works_or_refuses(preview):
        return
    shown = mesh_points(hull)
    problem = part("features.fields.preview").of_hull(hull).problem
    assert not problem or ("\n" not in problem and np.array_equal(shown, before)), problem
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(mesh_points(hull), before)
    # Applied by itself it is the same. It is refused as the preview was, or where nothing moves.
    moves = not np.array_equal(shown, before)
    assert works_or_refuses(bpy.ops.hull.apply_fields) == moves
    if moves:
        assert np.allclose(mesh_points(hull), shown, rtol=0.0, atol=1e-6 * np.ptp(before))
