# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields in Blender: kept with the hull, put in order, applied as one step; what is protected
or beyond stays, and what would fold is refused."""

import bpy
import numpy as np
import pytest
from addon_under_test import part, sample


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def add(hull, place, **settings):
    assert bpy.ops.hull.add_field() == {"FINISHED"}
    field = hull.hull.fields.fields[hull.hull.fields.active_field]
    field.place = place
    for name, value in settings.items():
        setattr(field, name, value)
    return field


def side_point(hull):
    """The control point at the side nearest to amidships at half depth."""
    points = points_of(hull)
    wanted = [points[:, 0].mean(), points[:, 1].max(), 0.5 * points[:, 2].max()]
    return points[np.linalg.norm(points - wanted, axis=1).argmin()]


def names(hull):
    return [field.name for field in hull.hull.fields.fields]


def test_fields_come_are_ordered_and_go():
    hull = sample()
    bpy.context.scene.cursor.location = (10.0, 2.0, 3.0)
    assert bpy.ops.hull.add_field(role="PROTECT", base="PLANE") == {"FINISHED"}
    first = hull.hull.fields.fields[0]
    assert tuple(first.place) == (10.0, 2.0, 3.0) and first.role == "PROTECT"
    assert first.falloff == pytest.approx(0.6)
    first.extent, first.axes = 7.0, (False, True, True)
    bpy.ops.hull.duplicate_field()
    copy = hull.hull.fields.fields[1]
    assert (copy.extent, tuple(copy.axes), copy.role) == (7.0, (False, True, True), "PROTECT")
    bpy.ops.hull.move_field(direction="UP")
    assert names(hull) == ["Field 1 copy", "Field 1"]
    bpy.ops.hull.move_field(direction="UP")
    assert names(hull) == ["Field 1 copy", "Field 1"]
    bpy.ops.hull.remove_field()
    assert names(hull) == ["Field 1"]
    bpy.ops.hull.remove_field()
    assert not bpy.ops.hull.apply_fields.poll()


def test_a_shoulder_follows_and_what_is_beyond_stays_bit_by_bit():
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    add(hull, place, extent=12.0, shift=(0.0, 0.3, 0.0))
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    after = points_of(hull)
    is_moved = (after != before).any(axis=1)
    assert 0.1 < (after - before)[:, 1].max() < 0.6
    # A control point moves the surface no further than two faces away.
    edges = np.array([edge.vertices for edge in hull.data.edges])
    reach = 12.0 + 2 * np.linalg.norm(before[edges[:, 0]] - before[edges[:, 1]], axis=1).max()
    away = np.linalg.norm(before - place, axis=1)
    assert is_moved.any() and away[is_moved].max() < reach < away.max()


def test_a_protected_crease_stays_exactly():
    hull = sample()
    tool, place = part("features.fields.base_curves"), side_point(hull)
    before = points_of(hull)
    deck = before[before[:, 2].argmax()]
    add(hull, place, extent=40.0, shift=(0.0, 0.3, 0.2))
    add(hull, deck, extent=4.0, role="PROTECT", base="CREASE")
    parent = part("features.transformation.parents").of_hull(hull, bpy.context.scene)
    _, crease = tool.base_crease(hull.hull.fields.fields[1], parent.surface, parent.scale)
    kept = parent.control.vertex_ids[np.asarray(crease.vertices)]
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    after = points_of(hull)
    assert len(kept) > 3 and np.array_equal(after[kept], before[kept])
    assert not np.array_equal(after, before)


def test_a_curve_object_is_a_base():
    hull = sample()
    place = side_point(hull)
    data = bpy.data.curves.new("Line", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("POLY")
    spline.points.add(2)
    for point, x in zip(spline.points, (-8.0, 0.0, 8.0)):
        point.co = (place[0] + x, place[1], place[2], 1.0)
    line = bpy.data.objects.new("Line", data)
    bpy.context.collection.objects.link(line)
    field = add(hull, place, base="CURVE", extent=15.0, shift=(0.0, 0.2, 0.0))
    with pytest.raises(RuntimeError, match="Field 1: Choose the curve object"):
        bpy.ops.hull.apply_fields()
    field.curve, before = line, points_of(hull)
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert (points_of(hull) - before)[:, 1].max() > 0.05


@pytest.mark.parametrize(
    "settings, message",
    [
        ({"shift": (9.0, 0.0, 0.0), "extent": 12.0}, "fold"),
        ({"shift": (0.0, 0.0, 0.0)}, "shift nothing"),
        ({"role": "PROTECT"}, "Add a field that shifts"),
        ({"use": False}, "Add a field that shifts"),
        ({"axes": (False, False, False)}, "Field 1: Switch on one axis"),
        ({"extent": 0.0}, "Field 1: The extent"),
    ],
)
def test_refusals_change_nothing(settings, message):
    hull = sample()
    add(hull, side_point(hull), **{"extent": 20.0, "shift": (0.0, 0.2, 0.0), **settings})
    before = points_of(hull)
    with pytest.raises(RuntimeError, match=message):
        bpy.ops.hull.apply_fields()
    assert np.array_equal(points_of(hull), before)


def test_what_the_points_cannot_follow_is_told():
    hull = sample()
    report = part("features.fields.shaping")
    add(hull, side_point(hull), extent=5.0, shift=(0.0, 0.5, 0.0))
    applied = report.apply(hull, bpy.context.scene)
    assert not applied.is_followed and "Subdivide Exactly" in report.summary(applied)
    other = sample()
    add(other, side_point(other), extent=60.0, shift=(0.0, 0.1, 0.0))
    applied = report.apply(other, bpy.context.scene)
    assert applied.is_followed, report.summary(applied)


def test_locked_points_stay():
    hull = sample()
    place = side_point(hull)
    before = points_of(hull)
    nearest = int(np.linalg.norm(before - place, axis=1).argmin())
    part("features.constraints.point_locks").write(hull.data, [nearest])
    add(hull, place, extent=40.0, shift=(0.0, 0.2, 0.0))
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert np.array_equal(points_of(hull)[nearest], before[nearest])


def test_hull_files_have_them(tmp_path):
    hull = sample()
    line = part("bridge.objects.curve_lines").made("Knuckle", [(60, 6, 5), (70, 5, 5)], False, hull)
    bow = add(hull, side_point(hull), name="Bow", extent=20.0, shift=(0.0, 0.2, 0.0), use=False)
    add(hull, (60.0, 6.0, 9.0), name="Deck", role="PROTECT", base="CREASE", extent=2.5)
    add(hull, (0.0, 0.0, 0.0), name="Knuckle", base="CURVE", axes=(False, True, False)).curve = line
    place, colour = tuple(bow.place), tuple(bow.colour)
    path = str(tmp_path / "fields.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.view_layer.objects.active
    assert again != hull and names(again) == ["Bow", "Deck", "Knuckle"]
    first, second, third = again.hull.fields.fields
    assert (first.use, tuple(first.place), tuple(first.colour)) == (False, place, colour)
    assert (first.extent, tuple(first.shift)) == (20.0, tuple(bow.shift))
    assert (second.role, second.base, second.extent) == ("PROTECT", "CREASE", 2.5)
    assert tuple(third.axes) == (False, True, False) and third.curve not in (None, line)
    points, is_closed = part("bridge.objects.curve_lines").points_of(third.curve, again)
    assert points.tolist() == [[60, 6, 5], [70, 5, 5]] and not is_closed


def test_fields_follow_when_the_hull_is_scaled():
    hull = sample()
    place = side_point(hull)
    add(hull, place, extent=20.0, shift=(1.0, 0.2, 0.1))
    assert bpy.ops.hull.set_dimensions(length=92.4, beam=15.0) == {"FINISHED"}
    field = hull.hull.fields.fields[0]
    assert field.extent == pytest.approx(22.0)
    assert tuple(field.shift) == pytest.approx((1.1, 0.2 * 15.0 / 13.6, 0.1))
    assert field.place[1] == pytest.approx(place[1] * 15.0 / 13.6)


def test_fields_are_saved_and_undone(tmp_path):
    hull = sample()
    add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.2, 0.0))
    before = points_of(hull)
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.hull.apply_fields()
    bpy.ops.ed.undo_push(message="applied")
    assert not np.array_equal(points_of(hull), before)
    bpy.ops.ed.undo()
    hull = bpy.context.view_layer.objects.active
    assert np.array_equal(points_of(hull), before)
    path = str(tmp_path / "fields.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    field = bpy.context.view_layer.objects.active.hull.fields.fields[0]
    assert field.extent == 20.0 and tuple(field.shift) == pytest.approx((0.0, 0.2, 0.0))


def test_another_hull_gets_them_in_proportion():
    source, other = sample(), sample("naval_vessel")
    bpy.context.view_layer.objects.active = source
    place = side_point(source)
    add(source, place, extent=20.0, shift=(0.0, 0.2, 0.0), name="Side")
    line = part("bridge.objects.curve_lines").made("Line", [(60, 6, 5), (70, 5, 5)], False, source)
    add(source, place, base="CURVE", extent=8.0).curve = line
    faces = part("bridge.objects.field_faces")
    faces.give(source, add(source, place, base="FACES", extent=5.0), [0, 1, 2, 3])
    other.select_set(False)
    assert not bpy.ops.hull.copy_fields.poll()
    other.select_set(True)
    source.select_set(True)
    assert bpy.ops.hull.copy_fields() == {"FINISHED"}
    side, curve, region = other.hull.fields.fields
    own, wanted = points_of(source), points_of(other)
    factors = np.ptp(wanted, axis=0) / np.ptp(own, axis=0)
    factors[1] = wanted[:, 1].max() / own[:, 1].max()
    assert side.name == "Side" and side.extent == pytest.approx(20.0 * factors[0])
    assert side.shift[1] == pytest.approx(0.2 * factors[1])
    low, size = own.min(axis=0), np.ptp(own, axis=0)
    part_of = (place - low) / size
    assert np.array(side.place) == pytest.approx(
        wanted.min(axis=0) + part_of * np.ptp(wanted, axis=0), abs=1e-4
    )
    assert curve.curve not in (None, line) and 0 < len(faces.of_field(other, region))
    assert len(source.hull.fields.fields) == 3
    # What is applied there is found where it should be.
    other.hull.fields.fields[1].use = other.hull.fields.fields[2].use = False
    bpy.context.view_layer.objects.active = other
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    moved = (points_of(other) - wanted)[:, 1]
    assert np.abs(moved).max() > 0.05
    assert np.linalg.norm(wanted[moved.argmax()] - np.array(side.place)) < 0.5 * side.extent
