# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls of every type: whole, to their dimensions, flat and fair where they should be."""

import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, mesh_points, part, state_of

KINDS = ("BARGE", "ROUND_BILGE", "PLANING", "CANOE_BODY")
SEED = 20

# Block coefficients, on length, greatest beam and draft, that are usual for a type.
BLOCK = {
    "BARGE": (0.85, 0.96),
    "ROUND_BILGE": (0.58, 0.72),
    "PLANING": (0.36, 0.46),
    "CANOE_BODY": (0.22, 0.42),
}


def usual(kind):
    each = hull_io("new_hulls").TYPES[kind]
    lengths = [getattr(each.dimensions, name) for name in ("length", "beam", "draft", "depth")]
    return [*lengths, each.sections, each.points]


def cases(kind, count):
    """The usual hull, the smallest and the largest mesh, and others at random."""
    length, beam, draft, depth, sections, points = usual(kind)
    new_hulls = hull_io("new_hulls")
    yield length, beam, draft, depth, sections, points
    for end in (0, 1):
        yield length, beam, draft, depth, new_hulls.SECTIONS[end], new_hulls.POINTS[end]
    random = np.random.default_rng(SEED)
    for _ in range(count):
        scale = np.exp(random.uniform(-0.35, 0.35, 4))
        depth_here = max(depth * scale[3], 1.06 * draft * scale[2])
        yield (
            length * scale[0],
            beam * scale[1],
            draft * scale[2],
            depth_here,
            int(random.integers(new_hulls.SECTIONS[0], 25)),
            int(random.integers(new_hulls.POINTS[0], 15)),
        )


def native():
    return part("bridge.native").require()


def arrays(hull):
    sizes = [len(face) for face in hull.faces]
    vertices = [point for face in hull.faces for point in face]
    return hull.points, sizes, vertices, np.array(hull.creases).reshape(-1, 2)


def surface_of(hull):
    return native().LimitSurface(native().ControlMesh(*arrays(hull)))


def measured(surface, length, beam, draft):
    body = native().HullBody(surface, mirrored=True)
    return native().hydrostatics(body, draft=draft, length_pp=length, beam=beam, design_draft=draft)


@pytest.mark.parametrize("kind", KINDS)
def test_every_hull_is_whole_and_to_its_dimensions(kind):
    for case in cases(kind, 20):
        hull = hull_io("new_hulls").new_hull(kind, *case)
        assert native().check_mesh(*arrays(hull)) == [], case
        length, beam, draft, depth = case[:4]
        surface = surface_of(hull)
        found = measured(surface, length, beam, draft)
        assert found.waterline_aft == pytest.approx(0.0, abs=1e-9 * length), case
        assert found.waterline_forward == pytest.approx(length, rel=1e-9), case
        assert found.immersed_draft == pytest.approx(draft, rel=1e-9), case
        assert found.volume_from_breadths == pytest.approx(found.displaced_volume, rel=1e-6)
        low, high = BLOCK[kind]
        assert low < found.project.block < high, (case, found.project.block)
        assert abs(found.lcb_percent) < 13.0
        (points,) = surface.evaluate_grid(8)
        assert points[..., 1].min() >= -1e-12 * beam
        assert points[..., 2].min() >= -1e-12 * draft
        creases = np.concatenate([c.points for c in native().feature_curves(surface)])
        widest = max(points[..., 1].max(), creases[:, 1].max())
        assert 0.5 * beam * (1 - 1e-4) < widest < 0.5 * beam * (1 + 1e-9), case
        assert lowest_sheer(hull, surface) == pytest.approx(depth, rel=1e-3), case


def lowest_sheer(hull, surface):
    """The least height of the deck edge, by samples of it."""
    deck_edge = {point for edge in hull.deck_edge for point in edge}
    curves = [c for c in native().feature_curves(surface) if set(c.vertices) <= deck_edge]
    return min(c.points[:, 2].min() for c in curves)


@pytest.mark.parametrize("kind", KINDS)
def test_flats_are_flat(kind):
    for case in cases(kind, 5):
        hull = hull_io("new_hulls").new_hull(kind, *case)
        surface = surface_of(hull)
        for flat in hull.flats:
            points = hull.points[sorted({p for face in flat.faces for p in hull.faces[face]})]
            assert np.abs(points @ flat.normal - flat.offset).max() < 1e-12 * case[0], case
            # There is flat surface within, not control points alone.
            plane = [*flat.normal, flat.offset]
            assert native().flat_regions(surface, plane=plane), (case, flat)


def test_which_parts_are_flat():
    normals = {
        kind: sorted(
            tuple(np.abs(np.round(flat.normal)))
            for flat in hull_io("new_hulls").new_hull(kind, *usual(kind)).flats
        )
        for kind in KINDS
    }
    bottom, side, transom = (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 0.0)
    assert normals["BARGE"] == [bottom, side, transom, transom]
    assert normals["ROUND_BILGE"] == [bottom, side, transom]
    assert normals["PLANING"] == normals["CANOE_BODY"] == [transom]


# Inflections of a station, of all of them, and of a waterline. Stations but those of the bow bend
# one way; waterlines may be hollow at the entrance.
INFLECTIONS = {
    "BARGE": (0, 0, 0),
    "ROUND_BILGE": (1, 3, 4),
    "PLANING": (2, 3, 3),
    "CANOE_BODY": (1, 4, 3),
}


def inflections(surface, axis, positions):
    planes = np.array([native().plane_across(axis, position) for position in positions])
    found = native().section_fairness(surface, planes, relative_noise=0.02)
    return [sum(curve.inflection_count for curve in curves) for curves in found]


@pytest.mark.parametrize("kind", KINDS)
def test_lines_are_fair(kind):
    of_station, of_stations, of_waterline = INFLECTIONS[kind]
    for case in cases(kind, 12):
        length, depth = case[0], case[3]
        surface = surface_of(hull_io("new_hulls").new_hull(kind, *case))
        stations = inflections(surface, "x", np.linspace(0.05, 0.8, 16) * length)
        assert max(stations) <= of_station and sum(stations) <= of_stations, (case, stations)
        waterlines = inflections(surface, "z", np.linspace(0.1, 0.9, 9) * depth)
        assert max(waterlines) <= of_waterline, (case, waterlines)


def test_dimensions_that_no_hull_can_have():
    new_hull = hull_io("new_hulls").new_hull
    with pytest.raises(ValueError, match="no freeboard"):
        new_hull("BARGE", 60.0, 12.0, 4.0, 4.0, 8, 6)
    with pytest.raises(ValueError, match="beam is 0 m"):
        new_hull("BARGE", 60.0, 0.0, 2.0, 4.0, 8, 6)
    with pytest.raises(ValueError, match="7 sections"):
        new_hull("BARGE", 60.0, 12.0, 2.0, 4.0, 7, 6)
    with pytest.raises(ValueError, match="25 points"):
        new_hull("BARGE", 60.0, 12.0, 2.0, 4.0, 8, 25)


@pytest.mark.parametrize("kind", KINDS)
def test_operator_makes_the_usual_hull(kind):
    assert bpy.ops.hull.add_hull(kind=kind) == {"FINISHED"}
    hull = bpy.context.object
    wanted = hull_io("new_hulls").new_hull(kind, *usual(kind))
    assert hull.select_get() and len(bpy.context.selected_objects) == 1
    # Points of a raked transom may be moved by rounding, into its plane.
    np.testing.assert_allclose(mesh_points(hull), wanted.points, rtol=1e-6, atol=1e-6)
    assert len(hull.hull.flats) == len(wanted.flats)
    assert hull.hull.half and hull.hull.length_pp == pytest.approx(wanted.particulars.length_pp)
    state = state_of(hull)
    assert not state.status and not state.ship.check.problems
    assert state.ship.surface is not None and hull.hull.surface_object is not None


def test_operator_takes_dimensions_in_scene_units():
    bpy.context.scene.unit_settings.scale_length = 0.01
    given = {"length": 2000.0, "beam": 500.0, "draft": 80.0, "depth": 200.0}
    assert bpy.ops.hull.add_hull(kind="CANOE_BODY", sections=9, points=6, **given) == {"FINISHED"}
    hull = bpy.context.object
    wanted = hull_io("new_hulls").new_hull("CANOE_BODY", 20.0, 5.0, 0.8, 2.0, 9, 6)
    np.testing.assert_allclose(mesh_points(hull), 100.0 * wanted.points, rtol=1e-6, atol=1e-3)
    assert hull.hull.draft == pytest.approx(80.0)
    surface = state_of(hull).ship.surface
    found = measured(surface, 20.0, 5.0, 0.8)
    assert found.waterline_length == pytest.approx(20.0, rel=1e-6)


def test_dimensions_that_are_left_out_are_the_types():
    scene = bpy.context.scene
    scene.unit_settings.scale_length = 0.1
    assert bpy.ops.hull.add_hull(kind="BARGE", draft=20.0) == {"FINISHED"}
    hull = bpy.context.object
    assert hull.hull.draft == pytest.approx(20.0)
    assert hull.hull.length_pp == pytest.approx(600.0)


def test_refused_dimensions_leave_nothing_behind():
    before = [len(data) for data in (bpy.data.objects, bpy.data.meshes, bpy.data.materials)]
    with pytest.raises(RuntimeError, match="no freeboard"):
        bpy.ops.hull.add_hull(kind="BARGE", draft=4.0, depth=4.0)
    after = [len(data) for data in (bpy.data.objects, bpy.data.meshes, bpy.data.materials)]
    assert after == before


def test_not_in_edit_mode():
    bpy.ops.hull.add_hull(kind="BARGE")
    bpy.ops.object.mode_set(mode="EDIT")
    assert not bpy.ops.hull.add_hull.poll()


def test_one_undo_step():
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.hull.add_hull("EXEC_DEFAULT", True, kind="BARGE")
    assert "Barge" in bpy.data.objects
    bpy.ops.ed.undo()
    assert "Barge" not in bpy.data.objects
    bpy.ops.ed.redo()
    hull = bpy.data.objects["Barge"]
    assert hull.hull.is_hull and len(hull.hull.flats) == 4


@pytest.mark.parametrize("away", ["exclude", "hide_viewport"])
def test_what_is_made_where_the_active_collection_is_out_of_view_is_seen(away):
    collection = bpy.data.collections.new("Away")
    bpy.context.scene.collection.children.link(collection)
    layer = bpy.context.view_layer.layer_collection.children["Away"]
    bpy.context.view_layer.active_layer_collection = layer
    setattr(layer, away, True)
    assert bpy.ops.hull.add_hull() == {"FINISHED"}
    hull = bpy.context.object
    assert hull.select_get() and hull.visible_get() and hull.name not in collection.objects
