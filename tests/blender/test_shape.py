# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces made flat and points put where they belong, by operators in edit mode."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_hull, mesh_points, part


def update():
    bpy.context.view_layer.update()


def bumpy_hull():
    """A box whose faces are nine each, in edit mode; the side's points are out by some tenths."""
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=2)
    bm = bmesh.from_edit_mesh(hull.data)
    random = np.random.default_rng(3)
    for vertex in bm.verts:
        if 1.0 < vertex.co.x < 9.0 and vertex.co.y > 1.9 and vertex.co.z > 0.5:
            vertex.co.y += random.uniform(0.05, 0.3)
    bmesh.update_edit_mesh(hull.data)
    update()
    return hull


def edited_points(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def select_faces(hull, wanted):
    bpy.context.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    for face in bm.faces:
        face.select_set(wanted(face.calc_center_median()))
    bmesh.update_edit_mesh(hull.data)
    return {vertex.index for face in bm.faces if face.select for vertex in face.verts}


def select_points(hull, indices, active=None):
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.select_history.clear()
    for index in indices:
        bm.verts[index].select_set(True)
    if active is not None:
        bm.select_history.add(bm.verts[active])
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)


def side(centre):
    return centre.y > 1.9


def regions(hull):
    return part("features.constraints.flats").regions(hull)


def test_a_side_is_made_flat_and_kept():
    hull = bumpy_hull()
    own = sorted(select_faces(hull, side))
    assert np.ptp(edited_points(hull)[own, 1]) > 0.1
    assert bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=2.25) == {"FINISHED"}
    assert (edited_points(hull)[own, 1] == 2.25).all()
    (region,) = regions(hull)
    assert region.kind == "SIDE" and region.points.tolist() == own
    assert region.plane.tolist() == [0.0, 1.0, 0.0, 2.25]
    bpy.ops.object.mode_set(mode="OBJECT")
    flat = part("features.modelling.flat_making")
    assert flat.describe(bpy.context.scene, region.plane) == "y = 2.250 m"
    tilted = np.array([0.0, -0.6, 0.8, 3.0])
    assert flat.describe(bpy.context.scene, tilted) == "slope 36.9°"


def test_places_of_a_plane():
    hull = bumpy_hull()
    own = sorted(select_faces(hull, side))
    before = edited_points(hull)[own, 1]
    make = part("features.modelling.flat_making").make_flat
    bpy.ops.ed.undo_push(message="before")
    make(hull, bpy.context.scene, "SIDE", "MOST", keep=False)
    assert edited_points(hull)[own, 1] == pytest.approx(np.median(before), abs=1e-7)
    assert not regions(hull)
    select_points(hull, own, active=own[5])
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[own[5]].co.y = 3.125
    make(hull, bpy.context.scene, "SIDE", "ACTIVE", keep=False)
    assert (edited_points(hull)[own, 1] == 3.125).all()
    bm.verts[own[7]].co.y = 3.5
    bm.verts[own[8]].co.y = 1.0
    make(hull, bpy.context.scene, "SIDE", "OUTERMOST", keep=False)
    assert (edited_points(hull)[own, 1] == 3.5).all()


def test_the_outermost_of_a_bottom_is_the_lowest():
    hull = bumpy_hull()
    own = sorted(select_faces(hull, lambda centre: centre.z < 0.1))
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[own[3]].co.z = 0.5
    bm.verts[own[4]].co.z = -0.25
    bpy.ops.hull.make_flat(kind="BOTTOM", place="OUTERMOST")
    assert (edited_points(hull)[own, 2] == -0.25).all()


def test_raked_and_best_planes_fit_with_least_squares():
    hull = bumpy_hull()
    own = sorted(select_faces(hull, lambda centre: centre.x < 0.1))
    random = np.random.default_rng(11)
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    for index in own:
        vertex = bm.verts[index]
        vertex.co.x = 0.4 * vertex.co.z + 0.1 * vertex.co.y + random.normal(scale=0.02)
    before = edited_points(hull)[own]
    bpy.ops.hull.make_flat(kind="BEST", keep=True)
    (region,) = regions(hull)
    spread = np.linalg.svd(before - before.mean(axis=0), compute_uv=False)
    distances = before @ region.plane[:3] - region.plane[3]
    assert np.sqrt((distances**2).sum()) == pytest.approx(spread[2], rel=1e-5)
    bpy.ops.hull.make_flat(kind="RAKED")
    (region,) = regions(hull)
    assert region.kind == "RAKED" and region.plane[1] == 0.0
    after = edited_points(hull)[own]
    slope = np.polyfit(after[:, 2], after[:, 0], 1)
    assert slope == pytest.approx([0.4, 0.1], abs=0.05)
    assert np.abs(after[:, 0] - np.polyval(slope, after[:, 2])).max() < 2e-6


def test_a_creased_rim_makes_all_of_it_flat():
    hull = bumpy_hull()
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.hull.tag_smooth()
    select_faces(hull, side)
    make = part("features.modelling.flat_making").make_flat
    smooth = make(hull, bpy.context.scene, "SIDE")
    assert not smooth.is_flat and "rim" in smooth.message
    creased = make(hull, bpy.context.scene, "SIDE", crease_rim=True)
    assert creased.is_flat
    assert bpy.ops.hull.check_flat() == {"FINISHED"}


def test_flat_regions_are_selected_and_released():
    hull = bumpy_hull()
    own = select_faces(hull, side)
    bpy.ops.hull.make_flat(kind="SIDE")
    select_faces(hull, lambda centre: centre.z < 0.1)
    bpy.ops.hull.make_flat(kind="BOTTOM")
    assert len(regions(hull)) == 2
    select_faces(hull, lambda centre: centre.y > 1.9 and centre.x < 2.0 and centre.z < 1.0)
    bpy.ops.hull.select_flat()
    bm = bmesh.from_edit_mesh(hull.data)
    assert {v.index for face in bm.faces if face.select for v in face.verts} == own
    assert bpy.ops.hull.release_flat() == {"FINISHED"}
    assert [region.kind for region in regions(hull)] == ["BOTTOM"]
    with pytest.raises(RuntimeError, match="None of the selected"):
        bpy.ops.hull.release_flat()
    select_faces(hull, lambda centre: False)
    bpy.ops.hull.select_flat()
    assert sum(face.select for face in bm.faces) == 9


def test_faces_at_a_selected_point_are_released():
    hull = bumpy_hull()
    select_faces(hull, side)
    bpy.ops.hull.make_flat(kind="SIDE")
    (region,) = regions(hull)
    select_points(hull, [int(region.points[0])])
    assert bpy.ops.hull.release_flat() == {"FINISHED"}
    (left,) = regions(hull)
    assert 0 < len(left.faces) < len(region.faces) and region.points[0] not in left.points
    select_points(hull, [])
    with pytest.raises(RuntimeError, match="Select the faces or points"):
        bpy.ops.hull.release_flat()


def test_what_cannot_be_flat_is_refused():
    hull = bumpy_hull()
    select_faces(hull, lambda centre: False)
    with pytest.raises(RuntimeError, match="Select the faces"):
        bpy.ops.hull.make_flat()
    with pytest.raises(RuntimeError, match="No faces are kept flat"):
        bpy.ops.hull.select_flat()
    select_faces(hull, side)
    with pytest.raises(RuntimeError, match="position is for planes across an axis"):
        bpy.ops.hull.make_flat(kind="BEST", place="POSITION")
    with pytest.raises(RuntimeError, match="selected last"):
        bpy.ops.hull.make_flat(kind="SIDE", place="ACTIVE")


@pytest.mark.parametrize("plane, axis", [("STATION", 0), ("BUTTOCK", 1), ("WATERLINE", 2)])
def test_points_are_put_in_planes(plane, axis):
    hull = bumpy_hull()
    own = sorted(select_faces(hull, side))[4:9]
    others = [other for other in range(3) if other != axis]
    before = edited_points(hull)
    select_points(hull, own, active=own[2])
    mean = before[own, axis].mean()
    for place, wanted in (("ACTIVE", before[own[2], axis]), ("POSITION", 1.375)):
        bpy.ops.hull.put_in_plane(plane=plane, place=place, position=1.375)
        after = edited_points(hull)
        assert (after[own, axis] == wanted).all()
        assert np.array_equal(after[:, others], before[:, others])
        assert np.array_equal(np.delete(after, own, 0), np.delete(before, own, 0))
    part("bridge.mesh.mesh_points").write(hull.data, np.array(own), before[own])
    bpy.ops.hull.put_in_plane(plane=plane, place="MEAN")
    assert edited_points(hull)[own, axis] == pytest.approx(mean, abs=1e-6)


def test_points_are_put_in_the_nearest_line():
    hull = bumpy_hull()
    hull.hull.length_pp, hull.hull.lines.station_count = LENGTH, 20
    hull.hull.lines.waterlines, hull.hull.lines.buttock_spacing = "0.9 1.7 2.75", 0.75
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    select_points(hull, [5])
    hull.hull.keep_centre = False
    bm.verts[5].co = (4.3, -0.8, 1.4)
    for plane in ("STATION", "WATERLINE", "BUTTOCK"):
        bpy.ops.hull.put_in_plane(plane=plane, place="NEAREST")
    assert edited_points(hull)[5] == pytest.approx([4.5, -0.75, 1.7], abs=1e-7)
    hull.hull.lines.waterlines, hull.hull.lines.waterline_spacing = "", 0.0
    with pytest.raises(RuntimeError, match="no waterlines"):
        bpy.ops.hull.put_in_plane(plane="WATERLINE", place="NEAREST")


def test_coordinates_by_a_table():
    hull = bumpy_hull()
    before = edited_points(hull)
    rows = [{"name": "3", "co": (1.1, 0.2, 0.3)}, {"name": "9", "co": (2.1, 1.2, 1.3)}]
    assert bpy.ops.hull.set_coordinates(points=rows) == {"FINISHED"}
    after = edited_points(hull)
    for row in rows:
        assert (after[int(row["name"])] == np.array(row["co"], dtype=np.float32)).all()
    assert np.array_equal(np.delete(after, [3, 9], 0), np.delete(before, [3, 9], 0))
    bpy.context.scene.unit_settings.scale_length = 0.5
    bpy.ops.hull.set_coordinates(points=rows[:1], in_metres=True)
    assert edited_points(hull)[3] == pytest.approx([2.2, 0.4, 0.6], abs=1e-6)


def test_the_table_has_the_selected_points_in_order():
    hull = bumpy_hull()
    select_points(hull, [2, 7, 11, 14])
    rows = part("features.modelling.point_places").selected_points(hull)
    assert {index for index, _ in rows} == {2, 7, 11, 14}
    assert [place[0] for _, place in rows] == sorted(place[0] for _, place in rows)
    points = edited_points(hull)
    assert all(tuple(points[index]) == place for index, place in rows)


def test_slips_in_the_table():
    bumpy_hull()
    with pytest.raises(RuntimeError, match="Select the points"):
        bpy.ops.hull.set_coordinates()
    with pytest.raises(RuntimeError, match="no point 9999"):
        bpy.ops.hull.set_coordinates(points=[{"name": "9999", "co": (0, 0, 0)}])
    with pytest.raises(RuntimeError, match="is no point"):
        bpy.ops.hull.set_coordinates(points=[{"name": "P1", "co": (0, 0, 0)}])
    with pytest.raises(RuntimeError, match="no number"):
        bpy.ops.hull.set_coordinates(points=[{"name": "1", "co": (float("nan"), 0, 0)}])


def test_points_kept_flat_are_said_to_stay():
    hull = bumpy_hull()
    own = sorted(select_faces(hull, side))
    bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=HALF_BREADTH)
    held = part("features.modelling.point_places").set_points(
        hull, bpy.context.scene, {own[0]: (0.5, 2.5, DEPTH)}
    )
    assert held == 1
    assert edited_points(hull)[own[0]].tolist() == [0.5, HALF_BREADTH, DEPTH]


def test_shape_is_one_undo_step():
    hull = bumpy_hull()
    select_faces(hull, side)
    bpy.ops.ed.undo_push(message="before")
    before = edited_points(hull)
    bpy.ops.hull.make_flat(kind="SIDE")
    bpy.ops.ed.undo_push(message="flat")
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    assert np.array_equal(edited_points(hull), before) and not regions(hull)
    bpy.ops.ed.redo()
    hull = bpy.data.objects["box"]
    assert not np.array_equal(edited_points(hull), before)
    assert [region.kind for region in regions(hull)] == ["SIDE"]
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(mesh_points(hull)[:, 1], edited_points(hull)[:, 1])


def test_planes_do_not_pile_up():
    hull = bumpy_hull()
    select_faces(hull, side)
    for position in (2.0, 2.25, 2.5):
        bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=position)
        bpy.ops.ed.undo_push(message=str(position))
    assert len(hull.hull.flats) == 1
    bpy.ops.ed.undo()
    hull = bpy.data.objects["box"]
    update()
    assert [region.plane.tolist() for region in regions(hull)] == [[0.0, 1.0, 0.0, 2.25]]


def test_settings_of_one_flat_are_not_those_of_the_next():
    hull = bumpy_hull()
    select_faces(hull, side)
    bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=2.25, crease_rim=True)
    own = sorted(select_faces(hull, lambda centre: centre.z < 0.1))
    bpy.ops.hull.make_flat("EXEC_DEFAULT", kind="BOTTOM")
    assert (edited_points(hull)[own, 2] == 0.0).all()
    made = part("features.modelling.flat_making").make_flat(hull, bpy.context.scene, "BOTTOM")
    assert made.position == 0.0
    for name in ("place", "position", "keep", "crease_rim"):
        properties = bpy.ops.hull.make_flat.get_rna_type().properties
        assert properties[name].is_skip_save, name
