# SPDX-License-Identifier: GPL-3.0-or-later
"""The bases of shape fields besides points and creases, and what varies along them."""

import bpy
import numpy as np
import pytest
from addon_under_test import part
from edited_hulls import edit, select
from test_fields import add, points_of, sample, side_point


def line_object(name, points, hull):
    return part("bridge.objects.curve_lines").made(name, points, False, hull)


def test_faces_are_a_base_and_follow_edits():
    hull = sample()
    before = points_of(hull)
    edit(hull, (False, False, True))
    place = side_point(hull)
    middles = np.array([polygon.center for polygon in hull.data.polygons])
    near = np.linalg.norm(middles - place, axis=1).argsort()[:4]
    field = add(hull, (0.0, 0.0, 0.0), base="FACES", extent=10.0, shift=(0.0, 0.2, 0.0))
    with pytest.raises(RuntimeError, match="Select the faces"):
        bpy.ops.hull.take_field_faces()
    with pytest.raises(RuntimeError, match="Field 1: Select its faces in edit mode"):
        bpy.ops.hull.apply_fields()
    select(hull, "face", near)
    assert bpy.ops.hull.take_field_faces() == {"FINISHED"}
    faces = part("bridge.objects.field_faces")
    assert set(faces.of_field(hull, field)) == set(near)
    bpy.ops.hull.duplicate_field()
    copy = hull.hull.fields.fields[1]
    assert set(faces.of_field(hull, copy)) == set(near)
    assert copy.faces_number != hull.hull.fields.fields[0].faces_number
    bpy.ops.hull.remove_field()
    field = hull.hull.fields.fields[0]
    bpy.ops.object.mode_set(mode="OBJECT")
    assert set(faces.of_field(hull, field)) == set(near)
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    moved = (points_of(hull) - before)[:, 1]
    assert 0.1 < moved.max() < 0.4
    # Faces that are cut keep to the field.
    edit(hull, (False, False, True))
    select(hull, "face", near[:1])
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(faces.of_field(hull, field)) >= 7


def test_protected_faces_stay_bit_by_bit():
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    middles = np.array([polygon.center for polygon in hull.data.polygons])
    near = np.linalg.norm(middles - place, axis=1).argsort()[:4]
    add(hull, place + [18.0, 0.0, 0.0], extent=30.0, shift=(0.0, 0.2, 0.0))
    field = add(hull, (0.0, 0.0, 0.0), base="FACES", role="PROTECT", extent=3.0)
    part("bridge.objects.field_faces").give(hull, field, near)
    surface = part("features.hull.hull_state").state_of(hull).ship.source.new_surface()
    bpy.ops.hull.apply_fields()
    control = part("features.hull.hull_state").state_of(hull).ship.source.control
    cells = part("features.fields.bases").cells_of(hull, field, control)
    now = part("features.hull.hull_state").state_of(hull).ship.source.new_surface()
    uv = np.random.default_rng(7).random((len(cells), 2))
    np.testing.assert_array_equal(now.evaluate(cells, uv)[0], surface.evaluate(cells, uv)[0])
    assert not np.array_equal(points_of(hull), before)


def test_a_section_is_a_base():
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    add(hull, place, base="SECTION", axis="X", extent=10.0, shift=(0.5, 0.0, 0.0))
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    moved = (points_of(hull) - before)[:, 0]
    # All around the station, not at its side alone.
    near = np.abs(before[:, 0] - place[0]) < 3.0
    assert near.sum() > 5 and (moved[near] > 0.1).all()
    hull.hull.fields.fields[0].place = (1e3, 0.0, 0.0)
    with pytest.raises(RuntimeError, match="Field 1: Its plane does not cut the hull"):
        bpy.ops.hull.apply_fields()


@pytest.mark.parametrize("is_drawn_forward", [True, False])
def test_what_varies_goes_from_the_aft_end_to_the_fore_end(is_drawn_forward):
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    line = [(place[0] + x, place[1], place[2]) for x in (-20.0, 0.0, 20.0)]
    field = add(hull, place, base="CURVE", extent=15.0, varies=True, extent_end=15.0)
    field.curve = line_object("Line", line if is_drawn_forward else line[::-1], hull)
    field.shift_end = (0.0, 0.3, 0.0)  # none at the aft end
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    moved = (points_of(hull) - before)[:, 1]
    along = before[:, 0] - place[0]
    is_side = before[:, 1] > 0.9 * place[1]
    fore, aft = (is_side & (np.abs(along - x) < 6.0) for x in (18.0, -18.0))
    assert fore.any() and aft.any() and moved[fore].max() > 4.0 * np.abs(moved[aft]).max()


@pytest.mark.parametrize("is_drawn_back", [True, False])
def test_a_base_becomes_a_curve(is_drawn_back):
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    line = np.array([(place[0] + x, place[1], place[2]) for x in np.linspace(-20.0, 20.0, 9)])
    target = line + np.outer(np.cos(np.linspace(-0.5, 0.5, 9) * np.pi) ** 2, (0.0, 0.4, 0.0))
    field = add(hull, place, base="CURVE", extent=15.0)
    field.curve = line_object("Line", line, hull)
    field.becomes = line_object("Target", target[::-1] if is_drawn_back else target, hull)
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    assert 0.2 < (points_of(hull) - before)[:, 1].max() < 0.7
    assert np.abs((points_of(hull) - before)[:, 0]).max() < 0.1
    field.becomes.data.splines[0].use_cyclic_u = True
    with pytest.raises(RuntimeError, match="both open or both closed"):
        bpy.ops.hull.apply_fields()


@pytest.mark.parametrize(
    "count, told",
    [
        (1, "Line is a single point: give its curve another one"),
        (10_000, "Line is shown with 10000 points, 1000 at most may be: lower its resolution"),
    ],
)
def test_curves_that_cannot_be_bases_are_told(count, told):
    hull = sample()
    before, place = points_of(hull), side_point(hull)
    line = place + np.outer(np.linspace(-8.0, 8.0, count), (1.0, 0.0, 0.0))
    field = add(hull, place, base="CURVE", extent=15.0, shift=(0.0, 0.2, 0.0))
    field.curve = line_object("Line", line, hull)
    with pytest.raises(RuntimeError, match=f"Field 1: {told}"):
        bpy.ops.hull.apply_fields()
    # What a base becomes as well.
    field.becomes = field.curve
    field.curve = line_object("Base", [place, place + [5.0, 0.0, 0.0]], hull)
    with pytest.raises(RuntimeError, match=f"Field 1: {told}"):
        bpy.ops.hull.apply_fields()
    assert np.array_equal(points_of(hull), before)


def test_along_the_surface_the_other_side_of_a_thin_part_is_far():
    """Of two hulls, each thin: what is shifted on the outer side stays on the inner one."""
    hull = sample("catamaran")
    before = points_of(hull)
    outer = before[before[:, 1].argmax()]
    add(hull, outer, extent=1.6 * np.ptp(before[:, 1]), shift=(0.0, 0.05, 0.0))
    moved = []
    for along in (False, True):
        hull.hull.fields.fields[0].along_surface = along
        bpy.ops.hull.preview_fields()
        assert part("features.fields.preview").of_hull(hull).problem == ""
        moved.append(np.abs(points_of(hull) - before).max(axis=1))
        bpy.ops.hull.cancel_fields()
    inner = (before[:, 1] < 0.9 * before[:, 1].mean()) & (before[:, 2] > 2.0)
    assert moved[1][inner].max() < 0.5 * moved[0][inner].max()
    assert moved[1].max() > 0.03
    field = hull.hull.fields.fields[0]
    field.along_surface, field.place = True, (0.0, 100.0, 0.0)
    with pytest.raises(RuntimeError, match="Field 1: The base is nowhere on the hull"):
        bpy.ops.hull.apply_fields()


def test_all_that_fields_have_is_kept_by_hull_files(tmp_path):
    hull = sample()
    place = side_point(hull)
    section = add(hull, place, base="SECTION", axis="Z", varies=True, extent_end=3.0)
    section.shift_end, section.falloff_end = (0.0, 0.25, 0.0), 0.5
    section.along_surface = True
    section.becomes = line_object("Target", [(60, 6, 5), (70, 5, 5)], hull)
    faces = part("bridge.objects.field_faces")
    faces.give(hull, add(hull, place, base="FACES"), [3, 4, 9])
    path = str(tmp_path / "fields.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.view_layer.objects.active
    first, second = again.hull.fields.fields
    assert (first.base, first.axis, first.varies, first.extent_end) == ("SECTION", "Z", True, 3.0)
    assert (
        first.along_surface
        and first.falloff_end == 0.5
        and tuple(first.shift_end) == (0.0, 0.25, 0.0)
    )
    points, _ = part("bridge.objects.curve_lines").points_of(first.becomes, again)
    assert points.tolist() == [[60, 6, 5], [70, 5, 5]]
    assert faces.of_field(again, second).tolist() == [3, 4, 9]


def test_faces_of_a_joined_hull_are_of_no_field_of_the_other():
    faces = part("bridge.objects.field_faces")
    first, second = sample(), sample()
    for hull in (second, first):
        bpy.context.view_layer.objects.active = hull
        faces.give(hull, add(hull, side_point(hull), base="FACES"), [30, 31])
    bpy.ops.object.select_all(action="DESELECT")
    for hull in (second, first):
        hull.select_set(True)
    count = len(first.data.polygons)
    bpy.ops.object.join()
    assert len(first.data.polygons) == 2 * count
    assert faces.of_field(first, first.hull.fields.fields[0]).tolist() == [30, 31]


def test_more_fields_have_faces_than_there_are_numbers():
    faces, most = part("bridge.objects.field_faces"), part("bridge.limits").MOST_FIELDS
    first, second = sample(), sample()
    for hull in (first, second):
        bpy.context.view_layer.objects.active = hull
        hull.hull.fields.show_fields = False
        for number in range(most):
            faces.give(hull, add(hull, side_point(hull), base="FACES"), [number])
    for hull in (first, second):
        rows = hull.hull.fields.fields
        assert [faces.of_field(hull, row).tolist() for row in rows] == [[i] for i in range(most)]
