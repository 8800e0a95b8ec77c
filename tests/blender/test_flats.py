# SPDX-License-Identifier: GPL-3.0-or-later
"""What is to be flat stays so while points are moved, and lets go where it should."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import HALF_BREADTH, LENGTH, add_hull, mesh_points, part
from edited_hulls import faces_in

SIDE, BOTTOM, AFT = (0.0, 1.0, 0.0, 2.0), (0.0, 0.0, 1.0, 0.0), (1.0, 0.0, 0.0, 0.0)
GENERAL = (0.6, 0.0, 0.8, 1.2)


def divided_hull():
    """A box whose faces are four each."""
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    update()
    return hull


def update():
    bpy.context.view_layer.update()


def mark(hull, plane):
    number = part("features.constraints.flats").mark(hull, faces_in(hull, plane), plane)
    update()
    return number


def kept_planes(hull):
    return {
        region.number: region.plane.tolist()
        for region in part("features.constraints.flats").regions(hull)
    }


def move(hull, indices, by, in_edit_mode=False):
    """Adds (3,) or (k, 3) to points, as a drag does."""
    by = np.broadcast_to(by, (len(indices), 3))
    if in_edit_mode:
        bpy.ops.object.mode_set(mode="EDIT")
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        for index, step in zip(indices, by):
            bm.verts[index].co = np.array(bm.verts[index].co) + step
        bmesh.update_edit_mesh(hull.data)
        update()
        bpy.ops.object.mode_set(mode="OBJECT")
        return
    for index, step in zip(indices, by):
        hull.data.vertices[index].co = np.array(hull.data.vertices[index].co) + step
    hull.data.update()
    update()


def points_of(hull, number):
    regions = part("features.constraints.flats").regions(hull)
    return next(region.points for region in regions if region.number == number).tolist()


def inner_point(hull, number):
    """The point of a region in the middle of its four faces."""
    faces = next(
        r.faces for r in part("features.constraints.flats").regions(hull) if r.number == number
    )
    loops = [set(hull.data.polygons[face].vertices) for face in faces.tolist()]
    return set.intersection(*loops).pop()


@pytest.mark.parametrize("in_edit_mode", [False, True])
def test_a_point_goes_back_into_its_plane(in_edit_mode):
    hull = divided_hull()
    number = mark(hull, SIDE)
    index = inner_point(hull, number)
    before = mesh_points(hull)
    move(hull, [index], (0.25, 0.5, -0.125), in_edit_mode)
    after = mesh_points(hull)
    assert (after[index] == before[index] + (0.25, 0.0, -0.125)).all()
    assert np.array_equal(np.delete(after, index, 0), np.delete(before, index, 0))
    assert kept_planes(hull) == {number: [0.0, 1.0, 0.0, HALF_BREADTH]}


def test_points_go_into_a_plane_that_a_script_sets_with_the_next_edit():
    hull = divided_hull()
    number = mark(hull, SIDE)
    (entry,) = hull.hull.flats
    entry.normal, entry.offset = (0.0, 0.8, 0.6), 1.5
    move(hull, [], (0.0, 0.0, 0.0))
    own = mesh_points(hull)[points_of(hull, number)]
    assert np.abs(own @ (0.0, 0.8, 0.6) - 1.5).max() < 1e-6
    assert np.allclose(kept_planes(hull)[number], (0.0, 0.8, 0.6, 1.5), atol=1e-6)
    entry.offset = 1.25
    move(hull, [], (0.0, 0.0, 0.0))
    own = mesh_points(hull)[points_of(hull, number)]
    assert np.abs(own @ (0.0, 0.8, 0.6) - 1.25).max() < 1e-6


def test_points_of_the_interface():
    hull = divided_hull()
    mark(hull, SIDE)
    mark(hull, BOTTOM)
    found = part("features.constraints.flats").flat_planes(hull)
    assert [plane for _, plane in found] == [SIDE, BOTTOM]
    points = mesh_points(hull)
    for indices, plane in found:
        assert set(indices.tolist()) == set(np.flatnonzero(points @ plane[:3] == plane[3]))
    bpy.ops.object.mode_set(mode="EDIT")
    for (before, plane), (after, same) in zip(
        found, part("features.constraints.flats").flat_planes(hull)
    ):
        assert np.array_equal(before, after) and plane == same


def test_a_region_that_moves_as_a_whole_takes_its_plane_along():
    hull = divided_hull()
    number = mark(hull, SIDE)
    move(hull, points_of(hull, number), (0.0, 0.3, 0.0))
    plane = kept_planes(hull)[number]
    assert plane == [0.0, 1.0, 0.0, float(np.float32(2.3))]
    assert (mesh_points(hull)[points_of(hull, number), 1] == np.float32(2.3)).all()


def test_a_region_that_is_turned_takes_its_plane_along():
    hull = divided_hull()
    number = mark(hull, SIDE)
    points = mesh_points(hull).astype(np.float64)
    turned = points @ np.array([[0.8, 0.6, 0.0], [-0.6, 0.8, 0.0], [0.0, 0.0, 1.0]])
    move(hull, range(len(points)), turned - points)
    assert np.abs(mesh_points(hull) - turned).max() < 1e-6 * LENGTH
    assert kept_planes(hull)[number] == pytest.approx([-0.6, 0.8, 0.0, 2.0], abs=1e-6)
    move(hull, range(len(points)), points - turned)
    assert kept_planes(hull)[number] == pytest.approx(SIDE, abs=1e-6)
    assert kept_planes(hull)[number][:3] == [0.0, 1.0, 0.0]


def test_half_of_a_region_does_not_turn_it():
    """The points at one end stay plane with those at the other, but were pulled."""
    hull = add_hull()
    number = mark(hull, SIDE)
    aft = [i for i in points_of(hull, number) if mesh_points(hull)[i, 0] == 0.0]
    assert len(aft) == 2
    before = mesh_points(hull)
    move(hull, aft, (0.0, 0.5, 0.0))
    assert np.array_equal(mesh_points(hull), before)


def test_points_of_two_regions_slide_along_both():
    hull = divided_hull()
    mark(hull, SIDE), mark(hull, BOTTOM)
    bilge = np.flatnonzero((mesh_points(hull) == (LENGTH / 2, HALF_BREADTH, 0.0)).all(axis=1))
    move(hull, bilge.tolist(), (0.5, 0.25, -0.25))
    assert mesh_points(hull)[bilge[0]].tolist() == [LENGTH / 2 + 0.5, HALF_BREADTH, 0.0]


def test_three_planes_hold_a_point():
    hull = divided_hull()
    for plane in (SIDE, BOTTOM, AFT):
        mark(hull, plane)
    before = mesh_points(hull)
    corner = np.flatnonzero((before == (0.0, HALF_BREADTH, 0.0)).all(axis=1))
    move(hull, corner.tolist(), (0.5, 0.25, -0.25))
    assert np.array_equal(mesh_points(hull), before)


def test_points_go_to_the_nearest_place_in_oblique_planes():
    planes = part("features.constraints.planes")
    random = np.random.default_rng(7)
    for _ in range(200):
        count = random.integers(1, 4)
        normals = random.normal(size=(count, 3))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        kept = [planes.stored((*normal, random.normal())) for normal in normals]
        if count > 1 and np.linalg.cond(normals) > 50.0:
            continue
        point = random.normal(size=3)
        moved = planes.into_planes(point, kept)
        assert max(abs(planes.heights(moved, plane)) for plane in kept) < 1e-12
        # The way there is across all of them: nothing shorter leads there.
        step = moved - point
        rows = np.array(kept)[:, :3]
        assert np.abs(step - rows.T @ np.linalg.lstsq(rows.T, step, rcond=None)[0]).max() < 1e-11


def test_a_general_plane_is_kept_to_single_precision_and_at_rest():
    hull = divided_hull()
    flats, planes = part("features.constraints.flats"), part("features.constraints.planes")
    number = flats.mark(hull, faces_in(hull, AFT), GENERAL)
    update()
    plane = np.array(kept_planes(hull)[number])
    own = points_of(hull, number)
    assert np.abs(planes.heights(mesh_points(hull)[own].astype(float), plane)).max() < 3e-7 * 3
    move(hull, [inner_point(hull, number)], (0.3, 0.1, 0.2))
    points = mesh_points(hull)
    assert np.abs(planes.heights(points[own].astype(float), plane)).max() < 3e-7 * 3
    move(hull, [inner_point(hull, number)], (0.0, 0.0, 0.0))
    assert np.array_equal(mesh_points(hull), points)
    assert kept_planes(hull)[number] == plane.tolist()


def test_faces_that_are_extruded_go_free():
    hull = divided_hull()
    number = mark(hull, BOTTOM)
    faces = faces_in(hull, BOTTOM)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    for edge in bm.edges:
        edge.select_set(all(v.co.x == LENGTH and v.co.z == 0.0 for v in edge.verts))
    for edge in list(bm.edges):
        if any(v.co.z > 0.0 for v in edge.verts) and all(v.co.x == LENGTH for v in edge.verts):
            bm.edges.remove(edge)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.mesh.extrude_edges_move(TRANSFORM_OT_translate={"value": (1.0, 0.0, 1.0)})
    update()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert sorted(np.round(mesh_points(hull)[:, 2], 6))[-1] > 0.9
    assert (mesh_points(hull)[:, 0] == LENGTH + 1.0).sum() == 3
    region = part("features.constraints.flats").regions(hull)[0]
    assert region.number == number and len(region.faces) == len(faces)


def test_a_divided_region_stays_one():
    hull = divided_hull()
    number = mark(hull, SIDE)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=1)
    update()
    bpy.ops.object.mode_set(mode="OBJECT")
    (region,) = part("features.constraints.flats").regions(hull)
    assert region.number == number and len(region.faces) == 16
    index = region.points[np.argmax(mesh_points(hull)[region.points, 0])]
    move(hull, [index], (0.0, 1.0, 0.0))
    assert mesh_points(hull)[index, 1] == HALF_BREADTH


def test_undo_and_redo_keep_regions():
    hull = divided_hull()
    bpy.ops.ed.undo_push(message="before")
    number = mark(hull, SIDE)
    bpy.ops.ed.undo_push(message="marked")
    move(hull, points_of(hull, number), (0.0, 0.5, 0.0))
    bpy.ops.ed.undo_push(message="moved")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert kept_planes(hull) == {number: list(SIDE)}
    bpy.ops.ed.undo()
    assert kept_planes(bpy.data.objects["box"]) == {}
    bpy.ops.ed.redo()
    bpy.ops.ed.redo()
    hull = bpy.data.objects["box"]
    assert kept_planes(hull) == {number: [0.0, 1.0, 0.0, 2.5]}
    assert (mesh_points(hull)[points_of(hull, number), 1] == 2.5).all()


def test_joining_keeps_the_regions_of_both():
    first, second = divided_hull(), divided_hull()
    second.name = "second"
    first_number, second_number = mark(first, SIDE), mark(second, BOTTOM)
    assert first_number != second_number
    move(second, range(len(second.data.vertices)), (0.0, 0.0, 5.0))
    bpy.ops.object.select_all(action="SELECT")
    first.hull.surface_object.select_set(False)
    second.hull.surface_object.select_set(False)
    bpy.context.view_layer.objects.active = first
    bpy.ops.object.join()
    update()
    assert kept_planes(first) == {first_number: list(SIDE), second_number: [0.0, 0.0, 1.0, 5.0]}


def test_two_parallel_planes_through_a_point_are_refused():
    hull = divided_hull()
    mark(hull, SIDE)
    before, kept = mesh_points(hull), kept_planes(hull)
    side = faces_in(hull, SIDE)
    with pytest.raises(ValueError, match="another plane"):
        part("features.constraints.flats").mark(hull, side[:1], (0.0, 1.0, 0.0, 3.0))
    assert np.array_equal(mesh_points(hull), before) and kept_planes(hull) == kept
    number = part("features.constraints.flats").mark(hull, side, (0.0, 1.0, 0.0, 3.0))
    assert kept_planes(hull) == {number: [0.0, 1.0, 0.0, 3.0]}


def test_released_faces_move_freely():
    hull = divided_hull()
    number = mark(hull, SIDE)
    index = inner_point(hull, number)
    part("features.constraints.flats").release(hull, faces_in(hull, SIDE))
    move(hull, [index], (0.0, 0.5, 0.0))
    assert mesh_points(hull)[index, 1] == HALF_BREADTH + 0.5


def test_hull_files_keep_regions(tmp_path):
    hull = divided_hull()
    mark(hull, SIDE)
    part("features.constraints.flats").mark(hull, faces_in(hull, AFT), GENERAL)
    update()
    before = [
        (r.faces.tolist(), r.plane.tolist())
        for r in part("features.constraints.flats").regions(hull)
    ]
    path = str(tmp_path / "flat.hull.json")
    bpy.ops.hull.export_hull(filepath=path)
    bpy.ops.hull.import_hull(filepath=path)
    after = part("features.constraints.flats").regions(bpy.context.object)
    for (faces, plane), region in zip(before, after):
        assert region.faces.tolist() == faces
        assert region.plane == pytest.approx(plane, abs=1e-9)
    assert len(before) == len(after) == 2


def test_a_hull_without_flats_costs_no_look_at_its_points(monkeypatch):
    hull = divided_hull()
    asked = []
    monkeypatch.setattr(part("bridge.mesh.mesh_points"), "read", lambda *a: asked.append(a))
    move(hull, [0], (0.0, 0.1, 0.0))
    assert asked == []


def test_regions_that_touch_in_one_plane_become_one():
    hull, flats = divided_hull(), part("features.constraints.flats")
    side = faces_in(hull, SIDE)
    flats.mark(hull, side[:1], SIDE)
    flats.mark(hull, side[-1:], SIDE)
    flats.mark(hull, faces_in(hull, BOTTOM), BOTTOM)
    number = flats.mark(hull, side[1:-1], SIDE)
    found = {region.number: region for region in flats.regions(hull)}
    assert len(found) == 2 and found[number].faces.tolist() == side


def test_a_region_held_by_another_does_not_leave_it():
    hull, flats = divided_hull(), part("features.constraints.flats")
    side = faces_in(hull, SIDE)
    number = flats.mark(hull, side[:2], SIDE)
    # A second region in the same plane that is another to the add-on, as after joining hulls.
    part("features.constraints.flat_marks").write(hull.data, side[2:], number + 1)
    flats.store_plane(hull, number + 1, np.array(SIDE))
    update()
    before = mesh_points(hull)
    move(hull, points_of(hull, number), (0.0, 0.5, 0.0))
    assert np.array_equal(mesh_points(hull), before)
    assert set(map(tuple, kept_planes(hull).values())) == {SIDE}
    everything = sorted({*points_of(hull, number), *points_of(hull, number + 1)})
    move(hull, everything, (0.0, 0.5, 0.0))
    assert set(map(tuple, kept_planes(hull).values())) == {(0.0, 1.0, 0.0, 2.5)}


@pytest.mark.parametrize("kind", ["BEST", "RAKED", "SIDE"])
def test_points_without_places_are_in_no_plane(kind):
    """Blender's own operators may leave such, and what follows them must not end in a traceback."""
    points = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
    for wrong in (np.nan, np.inf):
        points[2, 1] = wrong
        with pytest.raises(ValueError, match="no numbers"):
            part("features.constraints.planes").fit(points, kind)
        assert part("features.constraints.flat_keeping").common_plane(points) is None


@pytest.mark.parametrize(
    "normal, offset",
    [((0.0, 1.0, 0.0), 1e30), ((0.0, 0.0, 0.0), 2.0), ((0.0, 1.0, 0.0), np.nan)],
)
def test_planes_that_are_none_are_found_anew(normal, offset):
    """Scripts may write anything there: no point goes where no plane is."""
    hull = divided_hull()
    number = mark(hull, SIDE)
    entry = part("features.constraints.flats").plane_entries(hull)[number]
    entry.normal, entry.offset = normal, offset
    before = mesh_points(hull)
    other = next(i for i in range(len(before)) if i not in points_of_region(hull, number))
    move(hull, [other], (0.0, 0.0, 0.25))
    assert np.array_equal(np.delete(mesh_points(hull), other, 0), np.delete(before, other, 0))
    assert kept_planes(hull) == {number: [0.0, 1.0, 0.0, HALF_BREADTH]}
    assert len(hull.hull.flats) == 1


def points_of_region(hull, number):
    flat = part("features.constraints.flat_marks").read(hull.data)
    return set(flat.of_region(number)[1].tolist())
