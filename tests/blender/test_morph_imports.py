# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of hulls that were imported: two of FREE!ship by the layout of a sample, as
neither's own comes onto the other; what has no part in a family is refused by name."""

import bpy
import pytest
from addon_under_test import part, state_of
from expect_morph import assert_is_member, select, set_weight, ships

pytestmark = pytest.mark.once


def imported(folder, *names):
    found = []
    for name in names:
        path = folder / f"{name}.fbm"
        assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
        found.append(bpy.context.object)
    bpy.context.view_layer.update()
    return found


def check_family(made):
    """Each parent is met, and members between them are there, with numbers."""
    assert [entry.shortfall for entry in made.hull.morph.parents] == [""] * len(
        made.hull.morph.parents
    )
    for number in range(len(made.hull.morph.parents)):
        for weight in (1.0, 0.5):
            set_weight(made, number, weight)
            assert_is_member(made)
            assert state_of(made).hydrostatics.values is not None


def test_two_hulls_of_freeship_by_the_layout_of_a_sample(freeship_folder):
    (vessel,) = ships("naval_vessel")
    demos = imported(freeship_folder, "FREE!ship demo 3", "FREE!ship demo 6")
    select(*demos)
    assert bpy.ops.hull.make_morph(layout=vessel.name) == {"FINISHED"}
    bpy.context.view_layer.update()
    made = bpy.context.object
    assert len(made.hull.morph.parents) == 2
    check_family(made)


def test_a_yacht_with_keel_and_rudder_is_refused_beside_a_hull_without(freeship_folder):
    (yacht,) = ships("sailing_yacht")
    (other,) = imported(freeship_folder, "FREE!ship demo 7")
    objects = len(bpy.data.objects)
    select(yacht, other)
    with pytest.raises(RuntimeError) as raised:
        bpy.ops.hull.make_morph()
    told = str(raised.value)
    assert f'"{other.name}" has no part in the family' in told
    assert f'leave out of "{yacht.name}" the body between' in told
    assert len(bpy.data.objects) == objects and not part("features.morphing.parents").is_member(
        yacht
    )
