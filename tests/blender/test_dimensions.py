# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls scaled to main dimensions, and what Blender scaled followed."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, hull_io, make_active, mesh_points, part, state_of
from test_docs import hull_rna, is_group

SAMPLES = ("barge", "bulk_carrier", "catamaran", "coaster", "container_ship", "naval_vessel",
           "planing_boat", "research_vessel", "roro", "sailing_yacht")  # fmt: skip


def load(name):
    assert bpy.ops.hull.load_sample(name=name) == {"FINISHED"}
    return bpy.context.object


def places_of(rna, before=""):
    """All numbers with a point and all texts among settings, by their places."""
    for prop in rna.properties:
        if prop.identifier in ("rna_type", "name"):
            continue
        if prop.type in ("POINTER", "COLLECTION"):
            if is_group(prop.fixed_type):
                yield from places_of(prop.fixed_type, f"{before}{prop.identifier}.")
        elif prop.type in ("FLOAT", "STRING"):
            yield before + prop.identifier


def test_of_every_setting_it_is_said_whether_it_follows():
    """A new property with a length has its row in features.dimensions.following."""
    following = part("features.dimensions.following")
    everything = set(places_of(hull_rna()))
    told = [set(following.FOLLOWING), following.PLANES, following.STAYING]
    of_groups = {place for place in everything if place.split(".")[0] in following.STAYING_GROUPS}
    not_told = everything - of_groups - set.union(*map(set, told))
    assert not not_told, f"say in features/dimensions/following.py how these follow: {not_told}"
    assert set.union(*map(set, told)) <= everything - of_groups
    assert sum(map(len, told)) + len(of_groups) == len(everything)


def close(value):
    """Single precision: half a unit in the last of its 24 bits, twice."""
    return pytest.approx(value, rel=1.3e-7, abs=1e-12)


@pytest.mark.parametrize("name", SAMPLES)
def test_samples_reach_their_dimensions_in_one_step(name):
    hull = load(name)
    settings = hull.hull
    before, points = state_of(hull), mesh_points(hull).astype(np.float64)
    volume = before.hydrostatics.values.displaced_volume
    wanted = {"length": 1.1 * settings.length_pp, "beam": 0.9 * settings.beam,
              "draft": 1.05 * settings.draft}  # fmt: skip
    depth, spacing = settings.depth, settings.lines.waterline_spacing
    data = part("features.hull.hull_to_data").hull_data(hull, bpy.context.scene)
    assert bpy.ops.hull.set_dimensions(**wanted) == {"FINISHED"}
    hull = bpy.context.object
    settings, state = hull.hull, state_of(hull)
    assert (settings.length_pp, settings.beam, settings.draft) == close(tuple(wanted.values()))
    assert settings.depth == close(1.05 * depth)
    assert settings.lines.waterline_spacing == close(1.05 * spacing)
    size = np.abs(points).max()
    assert np.abs(mesh_points(hull) - points * (1.1, 0.9, 1.05)).max() < 1e-6 * size
    # Single precision of the points and of the draft.
    assert state.hydrostatics.values.displaced_volume == pytest.approx(
        1.1 * 0.9 * 1.05 * volume, rel=3e-6
    )
    assert state.status == "" and state.keeping.held == "" and state.scaling.noticed() is None
    made = part("features.hull.hull_to_data").hull_data(hull, bpy.context.scene)
    core = hull_io().scaled(data, (1.1, 0.9, 1.05))
    assert np.abs(made.points - core.points).max() < 1e-6 * size
    assert len(made.flats) == len(core.flats) and made.creases == core.creases
    for flat in part("features.constraints.flats").regions(hull):
        off = mesh_points(hull)[flat.points].astype(np.float64) @ flat.plane[:3] - flat.plane[3]
        assert np.abs(off).max() < 1e-6 * size


def test_all_follows_and_is_taken_back_in_one_step():
    hull = load("coaster")
    settings = hull.hull
    settings.trim_m = 0.5
    case = settings.loading.load_cases.add()
    case.mass_t, case.lcg, case.tcg, case.vcg = 100.0, 40.0, 0.5, 3.0
    point = settings.loading.downflooding_points.add()
    point.position = (10.0, 3.0, 8.0)
    area = settings.wind.areas.add()
    area.area, area.z = 30.0, 9.0
    settings.lines.frame_spacing, settings.lines.stations = 0.5, "1 2:6:2"
    settings.studio.boot_top_height = 0.5
    part("features.constraints.kept_points").set_axes(hull.data, range(50), (0,), True)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="before")
    before, length, depth = mesh_points(hull), settings.length_pp, settings.depth
    assert bpy.ops.hull.set_dimensions(length=2 * length, beam=0, depth=1.5 * depth) == {"FINISHED"}
    bpy.ops.ed.undo_push(message="scaled")
    settings = bpy.context.object.hull
    case = settings.loading.load_cases[0]
    assert (case.mass_t, case.lcg, case.tcg, case.vcg) == close((300.0, 80.0, 0.5, 4.5))
    assert tuple(settings.loading.downflooding_points[0].position) == close((20.0, 3.0, 12.0))
    assert (settings.wind.areas[0].area, settings.wind.areas[0].z) == close((90.0, 13.5))
    assert (settings.trim_m, settings.lines.frame_spacing) == close((0.75, 1.0))
    assert settings.lines.stations == "2 4:12:4"
    assert settings.studio.boot_top_height == close(0.75)
    kept = part("features.constraints.kept_points").read(bpy.context.object.data)
    assert len(kept) == 50
    assert np.array_equal(kept.places[:, 0], mesh_points(bpy.context.object)[kept.indices, 0])
    bpy.ops.ed.undo()
    hull = bpy.context.object
    assert np.array_equal(mesh_points(hull), before)
    assert hull.hull.length_pp == length and hull.hull.loading.load_cases[0].mass_t == 100.0
    assert state_of(hull).scaling.noticed() is None


def test_guesses_stay_guesses():
    """They are scaled, and nobody has given them."""
    hull = load("coaster")
    loading = hull.hull.loading
    for is_guess in (True, False):
        loading.kg_is_guess = is_guess
        assert bpy.ops.hull.add_load_case() == {"FINISHED"}
    loading.kg_is_guess = True
    kg = loading.kg
    assert bpy.ops.hull.set_dimensions(depth=1.5 * hull.hull.depth) == {"FINISHED"}
    assert loading.kg == close(1.5 * kg) and loading.kg_is_guess
    assert [case.vcg_is_guess for case in loading.load_cases] == [True, False]
    assert [case.vcg for case in loading.load_cases] == close([1.5 * kg] * 2)


def test_the_surfaces_own_length():
    hull = load("roro")
    extents = state_of(hull).plausible.extents
    lpp, length = hull.hull.length_pp, extents.length
    wanted = 1.25 * length
    assert bpy.ops.hull.set_dimensions(measured="SURFACE", length=wanted) == {"FINISHED"}
    assert state_of(hull).plausible.extents.length == pytest.approx(wanted, rel=1e-6)
    assert hull.hull.length_pp == pytest.approx(1.25 * lpp, rel=1e-6)


@pytest.mark.parametrize(
    "wanted, said",
    [
        ({"length": 1e-6}, "cannot become"),
        ({"length": 2e4}, "must be from 0 to 10000"),
        ({"depth": float("nan")}, "above zero|cannot become"),
    ],
)
def test_nonsense_is_refused_and_nothing_changes(wanted, said):
    hull = load("barge")
    before, length = mesh_points(hull), hull.hull.length_pp
    with pytest.raises(RuntimeError, match=said):
        bpy.ops.hull.set_dimensions(**wanted)
    assert np.array_equal(mesh_points(hull), before) and hull.hull.length_pp == length
    hull.hull.beam = 0.0
    with pytest.raises(RuntimeError, match="no beam"):
        bpy.ops.hull.set_dimensions(beam=8.0)


def test_in_feet():
    bpy.context.scene.unit_settings.scale_length = 0.3048
    hull = load("barge")
    length = hull.hull.length_pp
    assert bpy.ops.hull.set_dimensions(length=200.0) == {"FINISHED"}
    assert hull.hull.length_pp == close(200.0)
    assert np.ptp(mesh_points(hull)[:, 0]) == pytest.approx(
        200.0 / length * np.ptp(mesh_points(load("barge"))[:, 0]), rel=1e-6
    )


def test_a_scale_that_is_not_applied_is_followed():
    hull = load("coaster")
    draft, points = hull.hull.draft, mesh_points(hull)
    hull.scale = (1.0, 1.0, 1.25)
    bpy.context.view_layer.update()
    assert "rotation or scale" in state_of(hull).status
    found = part("features.dimensions.dimensions")
    assert found.text_of(found.unapplied(hull)) == "The hull was scaled by 1.25 in height"
    assert bpy.ops.hull.follow_scale() == {"FINISHED"}
    assert tuple(hull.scale) == (1.0, 1.0, 1.0) and state_of(hull).status == ""
    assert hull.hull.draft == close(1.25 * draft)
    assert mesh_points(hull)[:, 2] == pytest.approx(1.25 * points[:, 2])
    assert not bpy.ops.hull.follow_scale.poll()


def test_a_scale_that_cannot_be_followed_stays():
    hull = load("coaster")
    hull.scale = (2000.0, 1.0, 1.0)
    bpy.context.view_layer.update()
    points = mesh_points(hull)
    with pytest.raises(RuntimeError, match="cannot become 2000 times"):
        bpy.ops.hull.follow_scale()
    assert tuple(hull.scale) == (2000.0, 1.0, 1.0)
    assert np.array_equal(mesh_points(hull), points)


def test_an_applied_scale_is_noticed_and_followed():
    hull = load("coaster")
    found = part("features.dimensions.dimensions")
    length, beam = hull.hull.length_pp, hull.hull.beam
    hull.scale = (1.1, 0.8, 1.0)
    bpy.context.view_layer.update()
    bpy.ops.object.transform_apply(location=False, rotation=False)
    bpy.context.view_layer.update()
    assert found.noticed(hull).factors == pytest.approx((1.1, 0.8, 1.0))
    assert found.text_of(found.noticed(hull).factors) == (
        "The hull was scaled by 1.1 lengthwise and 0.8 in breadth"
    )
    points = mesh_points(hull)
    assert bpy.ops.hull.follow_scale() == {"FINISHED"}
    assert (hull.hull.length_pp, hull.hull.beam) == close((1.1 * length, 0.8 * beam))
    assert np.array_equal(mesh_points(hull), points) and found.noticed(hull) is None


def test_a_scale_in_edit_mode_is_noticed_until_it_is_taken_back():
    hull = load("coaster")
    found = part("features.dimensions.dimensions")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.view_layer.update()
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.resize(value=(1.5, 1.0, 1.0), center_override=(10.0, 0.0, 0.0))
    bpy.context.view_layer.update()
    scale = found.noticed(hull)
    assert scale.factors == pytest.approx((1.5, 1.0, 1.0))
    assert scale.shift == pytest.approx((-5.0, 0.0, 0.0), abs=1e-4)
    bpy.ops.transform.resize(value=(1 / 1.5, 1.0, 1.0), center_override=(10.0, 0.0, 0.0))
    bpy.context.view_layer.update()
    assert found.noticed(hull) is None
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    hull.data.vertices[3].co.x += 1.0
    hull.data.update()
    bpy.context.view_layer.update()
    assert found.noticed(hull) is None


def test_hulls_that_share_a_mesh_are_refused():
    hull = add_hull()
    copy = hull.copy()
    bpy.context.collection.objects.link(copy)
    make_active(hull)
    with pytest.raises(RuntimeError, match="other objects|single"):
        bpy.ops.hull.set_dimensions(length=20.0)


def test_the_bilge_radius_is_kept_in_one_step():
    hull = load("bulk_carrier")
    settings, found = hull.hull, part("features.dimensions.dimensions")
    beam, draft, before = settings.beam, settings.draft, mesh_points(hull)
    bpy.ops.ed.undo_push(message="before")
    brought = found.set_dimensions(
        hull, bpy.context.scene, beam=1.1 * beam, draft=1.05 * draft, keep=("bilge",)
    )
    old, new = brought.kept.radii
    assert new == pytest.approx(old, rel=1e-6)
    assert brought.kept.surface.ends_missed < 1e-6
    assert (settings.beam, settings.draft) == close((1.1 * beam, 1.05 * draft))
    state = state_of(hull)
    assert state.plausible.extents.beam(True) == pytest.approx(1.1 * beam, rel=1e-6)
    assert state.status == "" and state.keeping.held == ""
    for flat in part("features.constraints.flats").regions(hull):
        off = mesh_points(hull)[flat.points].astype(np.float64) @ flat.plane[:3] - flat.plane[3]
        assert np.abs(off).max() < 1e-6 * np.abs(before).max()
    bpy.ops.ed.undo_push(message="stretched")
    bpy.ops.ed.undo()
    assert np.array_equal(mesh_points(bpy.context.object), before)


def test_bulb_and_knuckles_are_kept_by_the_operator():
    hull = load("container_ship")
    length, depth, before = hull.hull.length_pp, hull.hull.depth, mesh_points(hull)
    assert bpy.ops.hull.set_dimensions(length=1.1 * length, keep_bulb=True) == {"FINISHED"}
    hull = bpy.context.object
    bulb = (before[:, 0] > length) & (before[:, 2] < 10.0)
    moves = mesh_points(hull)[bulb] - before[bulb]
    assert bulb.any() and np.abs(moves - (0.1 * length, 0.0, 0.0)).max() < 1e-4
    assert hull.hull.length_pp == close(1.1 * length)
    before = mesh_points(hull)
    assert bpy.ops.hull.set_dimensions(depth=1.05 * depth, keep_knuckles=True) == {"FINISHED"}
    low = before[:, 2] < hull.hull.draft
    assert np.array_equal(mesh_points(bpy.context.object)[low], before[low])


@pytest.mark.parametrize(
    "name, wanted, said",
    [
        ("coaster", {"length": 90.0, "keep_bulb": True}, "no bulb"),
        ("planing_boat", {"beam": 4.0, "keep_bilge": True}, "no bilge arc"),
        ("coaster", {"beam": 136.0, "keep_bilge": True}, "can become"),
        ("coaster", {"beam": float("nan"), "keep_bilge": True}, "above zero|cannot become"),
    ],
)
def test_what_cannot_be_kept_is_refused_and_nothing_changes(name, wanted, said):
    hull = load(name)
    before, length = mesh_points(hull), hull.hull.length_pp
    with pytest.raises(RuntimeError, match=said):
        bpy.ops.hull.set_dimensions(**wanted)
    assert np.array_equal(mesh_points(hull), before) and hull.hull.length_pp == length


def test_kept_in_feet_is_kept_in_metres():
    bpy.context.scene.unit_settings.scale_length = 0.3048
    hull = load("coaster")
    found, beam = part("features.dimensions.dimensions"), hull.hull.beam
    brought = found.set_dimensions(
        hull, bpy.context.scene, beam=1.1 * beam * 0.3048, keep=("bilge",)
    )
    assert hull.hull.beam == close(1.1 * beam)
    assert brought.kept.radii[1] == pytest.approx(brought.kept.radii[0], rel=1e-3)
    assert np.ptp(mesh_points(hull)[:, 1]) == pytest.approx(0.5 * 1.1 * beam, rel=1e-6)
