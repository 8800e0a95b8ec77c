# SPDX-License-Identifier: GPL-3.0-or-later
"""Displacement and LCB by the least change of the surface: met, with all that is kept in place."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample, state_of, values

# Not of the barge: flat sides and bottom, and the greatest beam, leave it next to nothing.
SAMPLES = ("bulk_carrier", "catamaran", "coaster", "container_ship", "naval_vessel",
           "planing_boat", "research_vessel", "roro", "sailing_yacht")  # fmt: skip
# Of Cb and of the LCB over Lpp.
CHANGES = ((-0.02, 0.0), (0.02, 0.0), (0.0, -0.01), (0.0, 0.01))
# Points are kept in single precision.
SINGLE = 1e-6


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def own_surface(hull):
    return state_of(hull).ship.source.new_surface()


def breadth(hull):
    return part("bridge.native").require().half_breadth(own_surface(hull))


@pytest.mark.once
@pytest.mark.one_in(2)
@pytest.mark.parametrize("name", SAMPLES)
def test_samples(name):
    hull = sample(name)
    start, found = points_of(hull), values(hull)
    widest, size = breadth(hull), np.ptp(start[:, 0])
    centre = np.abs(start[:, 1]) <= 1e-9 * size
    for block, lcb in CHANGES:
        part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(start)), start)
        bpy.context.view_layer.update()
        wanted = found.project_block + block, found.lcb_percent + 100.0 * lcb
        assert bpy.ops.hull.change_displacement(
            measure="BLOCK", block=wanted[0], lcb_as="PERCENT", lcb_percent=wanted[1]
        ) == {"FINISHED"}
        assert values(hull).project_block == pytest.approx(wanted[0], abs=SINGLE)
        assert values(hull).lcb_percent == pytest.approx(wanted[1], abs=100.0 * SINGLE)
        assert breadth(hull) <= (1.0 + SINGLE) * widest
        after = points_of(hull)
        assert np.ptp(after[:, 0]) == pytest.approx(size, rel=SINGLE)
        assert np.abs(after[centre] - start[centre])[:, 1:].max(initial=0.0) <= SINGLE * size


def test_what_is_kept_stays():
    hull = sample("bulk_carrier")
    parents, form_parameters = (
        part(f"features.transformation.{name}") for name in ("parents", "form_parameters")
    )
    start = points_of(hull)
    x = parents.of_hull(hull, bpy.context.scene).control.points[:, 0]
    aft, forward = form_parameters.parallel_body(parents.of_hull(hull, bpy.context.scene))
    assert forward - aft > 50.0
    inside = (x >= aft) & (x <= forward)
    centre = np.abs(start[:, 1]) <= 1e-6
    bpy.ops.hull.change_displacement(measure="VOLUME", volume=315000.0, lcb_as="NONE")
    assert np.array_equal(points_of(hull)[inside], start[inside])
    assert np.array_equal(points_of(hull)[centre, 2], start[centre, 2])
    moved = points_of(hull)
    bpy.ops.hull.change_displacement(
        measure="NONE", lcb_as="PERCENT", lcb_percent=values(hull).lcb_percent + 0.1,
        keep_profile=True, keep_deck=True,
    )  # fmt: skip
    assert np.array_equal(points_of(hull)[centre], moved[centre])
    assert not np.array_equal(points_of(hull), moved)


def test_refusals_say_what_is_nearest_and_move_nothing():
    hull = sample("coaster")
    start = points_of(hull)
    for wanted, told in (
        ({"measure": "NONE", "lcb_as": "NONE"}, "Ask for a displacement"),
        ({"measure": "BLOCK", "block": 5.0, "lcb_as": "NONE"}, "the nearest is Cb 0."),
        ({"measure": "VOLUME", "volume": 1e30, "lcb_as": "NONE"}, "∇ wanted is 1e"),
    ):
        with pytest.raises(RuntimeError, match=told):
            bpy.ops.hull.change_displacement(**wanted)
        assert np.array_equal(points_of(hull), start)


@pytest.mark.parametrize(
    "wanted, said",
    [
        ({"measure": "BLOCK", "block": 0.7, "lcb_as": "NONE"}, "Give Lpp first: Cb"),
        ({"measure": "NONE", "lcb_as": "PERCENT"}, "Give Lpp first: LCB"),
    ],
)
def test_what_is_wanted_by_a_length_asks_for_it(wanted, said):
    hull = sample()
    hull.hull.length_pp = 0.0
    before = points_of(hull)
    with pytest.raises(RuntimeError, match=said):
        bpy.ops.hull.change_displacement(**wanted)
    assert np.array_equal(points_of(hull), before)


def test_what_is_told_is_of_the_hull_without_its_appendages():
    hull = sample()
    scene, volume = bpy.context.scene, values(hull).displaced_volume
    bpy.ops.hull.add_appendage(kind="TUNNEL", x=70.0, z=2.0, radius=1.0)
    bpy.context.view_layer.update()
    assert values(hull).displaced_volume < 0.999 * volume
    least = part("features.transformation.least_change")
    task = least.LeastChange(hull, scene, least.Asked({"volume": 1.01 * volume}))
    found = task.write(scene).after
    assert found.volume == pytest.approx(1.01 * volume, rel=SINGLE)
    part("features.conversion.conversions").take_finished()
    shifts = part("features.transformation.section_shifts")
    found = shifts.shift(hull, scene, shifts.Wanted({"volume": volume})).after
    assert found.volume == pytest.approx(volume, rel=SINGLE)
    sources = part("features.area_curves.sources")
    sources.take_present(hull, scene, 9)
    found = part("features.area_curves.matching").Matching(hull, scene).write(scene)
    assert abs(found.volume_change) < 1e-6 * volume


def test_it_is_one_step_of_undo():
    hull = sample("coaster")
    bpy.ops.ed.undo_push(message="start")
    start = points_of(hull)
    bpy.ops.hull.change_displacement(measure="BLOCK", block=0.72, lcb_as="NONE")
    bpy.ops.ed.undo_push(message="changed")
    assert not np.array_equal(points_of(hull), start)
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert np.array_equal(points_of(hull), start)
