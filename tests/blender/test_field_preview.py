# SPDX-License-Identifier: GPL-3.0-or-later
"""The preview of shape fields: the hull follows each change, and comes back bit by bit."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from edited_hulls import edit
from foreign_operations import preview_oracle
from test_fields import add, points_of, sample, side_point


def changed():
    """As Blender does after a change in the window."""
    bpy.context.view_layer.update()


def shown(hull):
    return part("features.fields.preview").of_hull(hull)


def previewed(name="coaster"):
    """(hull, its field, its points before), previewed."""
    hull = sample(name)
    before = points_of(hull)
    field = add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    assert bpy.ops.hull.preview_fields() == {"FINISHED"}
    return hull, field, before


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_the_hull_follows_each_change_and_comes_back(mode):
    hull = sample()
    before, volume = points_of(hull), state_of(hull).hydrostatics.values.displaced_volume
    field = add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.3, 0.0))
    changed()
    if mode == "EDIT":
        edit(hull)
    assert np.array_equal(points_of(hull), before)  # nothing before it is asked for
    bpy.ops.hull.preview_fields()
    volumes = [volume, state_of(hull).hydrostatics.values.displaced_volume]
    for name, value in (("shift", (0.0, 0.6, 0.0)), ("extent", 30.0)):
        setattr(field, name, value)
        changed()
        volumes.append(state_of(hull).hydrostatics.values.displaced_volume)
    assert (np.diff(volumes) > 0.0).all()
    assert shown(hull).problem == "" and shown(hull).applied.result.rms > 0.0
    field.use = False
    changed()
    assert np.array_equal(points_of(hull), before) and shown(hull).applied is None
    field.use = True
    changed()
    assert not np.array_equal(points_of(hull), before)
    assert bpy.ops.hull.cancel_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), before)
    assert state_of(hull).hydrostatics.values.displaced_volume == volume
    assert not bpy.ops.hull.cancel_fields.poll()
    assert part("bridge.mesh.start_points").read(hull.data) is None
    if mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize("plane", ("STATION", "WATERLINE", "BUTTOCK"))
def test_it_follows_points_that_are_kept_meanwhile(plane):
    hull, _, _ = previewed()
    shift = points_of(hull)
    assert bpy.ops.hull.keep_all_points(plane=plane) == {"FINISHED"}
    changed()
    assert not preview_oracle.differences(hull, bpy.context.scene)
    assert (plane == "BUTTOCK") == (not np.allclose(points_of(hull), shift, 0.0, 1e-3))
    bpy.ops.hull.cancel_fields()


def test_it_follows_a_flat_side_that_is_released_meanwhile():
    hull, flats = sample("barge"), part("features.constraints.flats")
    breadth = points_of(hull)[:, 1].max()
    side = [face.index for face in hull.data.polygons
            if all(hull.data.vertices[i].co.y == breadth for i in face.vertices)]  # fmt: skip
    number = flats.mark(hull, side, np.array([0.0, 1.0, 0.0, breadth]))
    add(hull, side_point(hull), extent=40.0, shift=(0.0, 0.2, 0.1))
    bpy.ops.hull.preview_fields()
    of_side = np.unique([i for face in side for i in hull.data.polygons[face].vertices])
    assert (points_of(hull)[of_side, 1] == breadth).all()
    flats.release(hull, side)
    hull.data.update_tag()
    changed()
    assert number not in {region.number for region in flats.regions(hull)}
    assert not preview_oracle.differences(hull, bpy.context.scene)
    assert points_of(hull)[of_side, 1].max() > breadth + 0.1
    bpy.ops.hull.cancel_fields()


def test_a_plane_that_a_script_set_before_is_in_effect():
    hull, flats = sample("barge"), part("features.constraints.flats")
    breadth = points_of(hull)[:, 1].max()
    side = [face.index for face in hull.data.polygons
            if all(hull.data.vertices[i].co.y == breadth for i in face.vertices)]  # fmt: skip
    flats.mark(hull, side, np.array([0.0, 1.0, 0.0, breadth]))
    changed()
    add(hull, side_point(hull), extent=40.0, shift=(0.0, 0.2, 0.1))
    (entry,) = hull.hull.flats
    entry.normal = (0.02, 0.98, 0.02)
    assert bpy.ops.hull.preview_fields() == {"FINISHED"} and not shown(hull).problem
    assert not preview_oracle.differences(hull, bpy.context.scene)
    bpy.ops.hull.cancel_fields()
    changed()
    of_side = np.unique([i for face in side for i in hull.data.polygons[face].vertices])
    plane = flats.plane_of(entry)
    assert np.abs(points_of(hull)[of_side] @ plane[:3] - plane[3]).max() < 1e-4


def test_it_follows_a_point_that_is_tied_meanwhile():
    """To one that the field does not move, and so it stays as well."""
    hull, _, before = previewed()
    moved = np.linalg.norm(points_of(hull) - before, axis=1)
    follower, leader = int(moved.argmax()), int(moved.argmin())
    anchor = part("bridge.mesh.point_ties").ANCHOR
    part("features.constraints.ties").tie_points(hull, anchor, [follower], [(leader, leader)])
    hull.data.update_tag()
    changed()
    assert not preview_oracle.differences(hull, bpy.context.scene)
    assert np.array_equal(points_of(hull)[follower], before[follower])
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_each_change_is_followed_once(monkeypatch):
    """The points go first: nothing is computed of them as they were before."""
    live_ship, followed = part("features.flotation.live_ship").LiveShip, []
    follow = live_ship.follow

    def following(self, found, *arguments):
        followed.append(found.points_digest)
        return follow(self, found, *arguments)

    hull, field, before = previewed()
    monkeypatch.setattr(live_ship, "follow", following)
    for falloff in (0.4, 0.6):
        field.falloff = falloff
        changed()
        assert len(followed) == 1
        assert followed.pop() == part("bridge.objects.hull_mesh").read(hull).points_digest
    hull.hull.fields.fields.clear()
    hull.update_tag(refresh={"DATA"})
    changed()
    assert len(followed) == 1 and np.array_equal(points_of(hull), before)
    assert not hull.hull.fields.is_previewed


def test_a_hull_that_is_refused_for_now_follows_its_fields_all_the_same():
    hull, field, _ = previewed()
    hull.rotation_euler.z = 0.3
    changed()
    assert state_of(hull).refusal
    turned = points_of(hull)
    field.falloff = 0.4
    changed()
    assert not np.array_equal(points_of(hull), turned) and state_of(hull).refusal
    assert not preview_oracle.differences(hull, bpy.context.scene)
    hull.rotation_euler.z = 0.0
    changed()
    assert not state_of(hull).status
    assert not preview_oracle.differences(hull, bpy.context.scene)


def test_a_point_that_was_put_back_is_not_moved_by_something_else():
    """What holds points is put into effect before it is asked whether they are as shown."""
    hull, field, _ = previewed()
    assert hull.hull.half and hull.hull.keep_centre
    moved = points_of(hull)
    bm = edit(hull)
    point = next(vertex for vertex in bm.verts if vertex.co.y == 0.0)
    point.co.y += 0.5
    bmesh.update_edit_mesh(hull.data)
    changed()
    assert shown(hull).problem == ""
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.array_equal(points_of(hull), moved)
    field.falloff = 0.4
    changed()
    assert shown(hull).problem == "" and not np.array_equal(points_of(hull), moved)


def test_normals_wait_while_fields_change(monkeypatch):
    surface_mesh, written = part("features.surface.surface_mesh"), []
    write = surface_mesh.write_normals
    hull, field, _ = previewed()
    monkeypatch.setattr(surface_mesh, "write_normals", lambda *a: (written.append(1), write(*a)))
    for falloff in (0.4, 0.6):
        field.falloff = falloff
        changed()
    assert not written
    part("features.hull.live_normals")._write()
    assert written == [1]
    bpy.ops.hull.apply_fields()
    assert written == [1], "nothing has moved since"
    assert state_of(hull).shown.is_as_left(hull)


def test_applied_it_is_as_without_preview():
    hull, field, before = previewed()
    field.falloff = 0.4
    changed()
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert not hull.hull.fields.is_previewed and shown(hull) is None
    after = points_of(hull)
    other = sample()
    add(other, side_point(other), extent=20.0, shift=(0.0, 0.3, 0.0), falloff=0.4)
    bpy.ops.hull.apply_fields()
    assert np.array_equal(points_of(other), after) and not np.array_equal(after, before)
    field.falloff = 0.8  # nothing follows any longer
    changed()
    assert np.array_equal(points_of(hull), after)


def test_what_would_fold_is_told_and_not_shown():
    hull, field, before = previewed()
    good = points_of(hull)
    field.extent, field.shift = 12.0, (9.0, 0.0, 0.0)
    changed()
    assert "fold" in shown(hull).problem
    assert np.array_equal(points_of(hull), good)
    field.shift = (0.0, 0.2, 0.0)
    changed()
    assert shown(hull).problem == "" and not np.array_equal(points_of(hull), good)
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_a_field_without_faces_is_named_as_it_is_called_now():
    hull, _, _ = previewed()
    for name in ("bow", "stern"):
        bpy.ops.hull.add_field(role="MOVE", base="FACES")
        hull.hull.fields.fields[-1].name = name
    changed()
    assert shown(hull).problem.startswith("bow: ")
    bpy.ops.hull.move_field(direction="UP")
    changed()
    assert shown(hull).problem.startswith("stern: ")
    hull.hull.fields.fields[1].name = "transom"
    changed()
    assert shown(hull).problem.startswith("transom: ")


def test_points_moved_by_hand_meanwhile_are_not_lost():
    hull, field, before = previewed()
    hull.data.vertices[5].co.z += 0.5
    hull.data.update()
    changed()
    mine = points_of(hull)
    field.extent = 25.0
    changed()
    assert "Apply keeps the hull as it is" in shown(hull).problem
    assert np.array_equal(points_of(hull), mine)
    with pytest.raises(RuntimeError, match="changed while the fields are previewed"):
        bpy.ops.hull.cancel_fields()
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull), mine)


def test_locked_points_and_flats_stay_where_they_are():
    hull = sample("barge")
    before, place = points_of(hull), side_point(hull)
    nearest = int(np.linalg.norm(before - place, axis=1).argmin())
    part("features.constraints.point_locks").write(hull.data, [nearest])
    add(hull, place, extent=40.0, shift=(0.0, 0.2, 0.1))
    bpy.ops.hull.preview_fields()
    assert np.array_equal(points_of(hull)[nearest], before[nearest])
    assert not np.array_equal(points_of(hull), before)
    changed()  # nothing put the points elsewhere since
    assert shown(hull).problem == ""
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_undo_goes_through_it(tmp_path):
    hull, field, before = previewed()
    bpy.ops.ed.undo_push(message="previewed")
    first = points_of(hull)
    field.extent = 35.0
    changed()
    bpy.ops.ed.undo_push(message="extent")
    assert not np.array_equal(points_of(hull), first)
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert hull.hull.fields.fields[0].extent == 20.0
    assert np.array_equal(points_of(hull), first)
    path = str(tmp_path / "previewed.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    hull = bpy.context.view_layer.objects.active
    hull.hull.fields.fields[0].extent = 25.0
    changed()
    assert not np.array_equal(points_of(hull), first)
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_it_follows_the_curve_that_a_base_is():
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    line = [(place[0] + x, place[1], place[2]) for x in (-8.0, 0.0, 8.0)]
    curve = part("bridge.objects.curve_lines").made("Line", line, False, hull)
    field = add(hull, place, base="CURVE", extent=12.0, shift=(0.0, 0.2, 0.0))
    field.curve = curve
    bpy.ops.hull.preview_fields()
    first = points_of(hull)
    curve.location.x += 10.0
    changed()
    second = points_of(hull)
    assert not np.array_equal(second, first)
    curve.data.splines[0].points[1].co.z += 1.0
    curve.data.update_tag()
    changed()
    assert not np.array_equal(points_of(hull), second)
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_what_is_said_of_a_curve_is_said_anew_where_the_reason_is_another():
    hull = sample()
    place = side_point(hull)
    line = [(place[0] + x, place[1], place[2]) for x in (-8.0, 0.0, 8.0)]
    curve = part("bridge.objects.curve_lines").made("Line", line, False, hull)
    field = add(hull, place, base="CURVE", extent=12.0, shift=(0.0, 0.2, 0.0))
    field.curve = curve
    bpy.ops.hull.preview_fields()
    curve.data.bevel_depth = 1.0
    changed()
    assert "is no line" in shown(hull).problem
    curve.data.splines.new("POLY")
    curve.data.update_tag()
    changed()
    assert "has 2 splines" in shown(hull).problem
    assert not preview_oracle.differences(hull, bpy.context.scene)
    bpy.ops.hull.cancel_fields()


def test_a_hull_that_is_too_coarse_is_subdivided_meanwhile():
    hull = sample()
    field = add(hull, side_point(hull), extent=8.0, shift=(0.0, 0.5, 0.0))
    bpy.ops.hull.preview_fields()
    assert not shown(hull).applied.is_followed
    coarse, count = shown(hull).applied.result.largest, len(points_of(hull))
    assert bpy.ops.hull.subdivide_for_fields() == {"FINISHED"}
    assert len(points_of(hull)) > 3 * count and hull.hull.fields.is_previewed
    assert shown(hull).applied.result.largest < 0.5 * coarse
    volume = state_of(hull).hydrostatics.values.displaced_volume
    field.use = False
    changed()
    bpy.ops.hull.cancel_fields()
    assert state_of(hull).hydrostatics.values.displaced_volume < volume
    assert not bpy.ops.hull.subdivide_for_fields.poll()


def test_it_can_be_had_again():
    hull, field, before = previewed()
    moved = points_of(hull)
    bpy.ops.hull.cancel_fields()
    bpy.ops.hull.preview_fields()
    assert np.array_equal(points_of(hull), moved) and not np.array_equal(moved, before)
    bpy.ops.hull.cancel_fields()


def test_what_cannot_be_subdivided_stays_previewed(monkeypatch):
    hull, field, before = previewed()
    monkeypatch.setattr(part("bridge.limits"), "MOST_CONTROL_FACES", 10)
    now = points_of(hull)
    with pytest.raises(RuntimeError, match="more than 10"):
        bpy.ops.hull.subdivide_for_fields()
    assert hull.hull.fields.is_previewed and np.array_equal(points_of(hull), now)
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(points_of(hull), before)


def test_nothing_of_faces_before_is_shown_where_those_of_now_are_refused(monkeypatch):
    hull, _, before = previewed()
    hull.hull.fields.show_fields = True
    changed()
    bpy.ops.hull.apply_fields()
    bpy.ops.hull.subdivide_exactly()
    monkeypatch.setattr(part("bridge.limits"), "MOST_FIELD_POINTS", len(before))
    bpy.ops.hull.preview_fields()
    changed()
    assert "control points, and fields take" in shown(hull).problem
    assert shown(hull).own is None


def test_hulls_of_too_many_points_are_told(monkeypatch):
    hull, _, before = previewed()
    monkeypatch.setattr(part("bridge.limits"), "MOST_FIELD_POINTS", len(before))
    bpy.ops.hull.subdivide_for_fields()
    assert "control points, and fields take" in shown(hull).problem
    with pytest.raises(RuntimeError, match="Un-Subdivide"):
        bpy.ops.hull.cancel_fields()
        bpy.ops.hull.apply_fields()
