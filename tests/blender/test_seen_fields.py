# SPDX-License-Identifier: GPL-3.0-or-later
"""What the 3D view shows of shape fields: bases in their places, lines where the intensity is what
they say, arrows; nothing without a field."""

import bpy
import numpy as np
import pytest
from addon_under_test import part
from test_fields import add, sample, side_point

BASES = [("POINT", 6.0), ("PLANE", 12.0), ("CREASE", 3.0), ("SECTION", 8.0), ("FACES", 6.0)]


def seen_of(hull):
    """What is seen after Blender told of a change."""
    bpy.context.view_layer.update()
    return part("features.fields.seen").of_hull(hull)


def curve_of(row, hull, surface):
    return part("features.fields.base_curves").of_field(row, hull, surface, 1.0).curve


def fields_of(hull, row, surface, **settings):
    """The hull_native.ShapeFields of a row alone, of a shift of 1 m along x."""
    kind = part("bridge.native").require()
    options = {"extent": row.extent, "falloff": row.falloff, **settings}
    if row.base == "POINT":
        one = kind.ShapeField.at_point(list(row.place), (1, 0, 0), **options)
    elif row.base == "PLANE":
        one = kind.ShapeField.at_plane(list(row.place), (1, 0, 0), (1, 0, 0), **options)
    elif row.base == "FACES":
        control = part("features.hull.hull_state").state_of(hull).ship.source.control
        cells = part("features.fields.bases").cells_of(hull, row, control)
        one = kind.ShapeField.of_region(surface, cells, (1, 0, 0), **options)
    else:
        one = kind.ShapeField.along(curve_of(row, hull, surface), (1, 0, 0), **options)
    return kind.ShapeFields([one])


@pytest.mark.parametrize("base, extent", BASES)
def test_lines_are_where_the_field_has_their_intensity(base, extent):
    hull = sample()
    hull.hull.samples = 8
    row = add(hull, side_point(hull), base=base, extent=extent)
    if base == "FACES":
        part("bridge.objects.field_faces").give(hull, row, [30, 31])
        hull.data.update_tag()
    found = seen_of(hull)
    surface = part("features.hull.hull_state").state_of(hull).ship.surface
    fields = fields_of(hull, row, surface)
    intensities = part("features.fields.isolines").INTENSITIES
    assert len(found.lines.levels) == len(intensities) == 4
    for wanted, segments in zip(intensities, found.lines.levels):
        assert len(segments) > 10
        values = fields.at(segments.reshape(-1, 3))[0][:, 0]
        assert np.abs(values - wanted).max() < 0.01
    assert found.lines.is_mirrored == hull.hull.half


def test_bases_are_in_their_places():
    hull, arrays = sample(), part("overlays.field_arrays")
    place = side_point(hull)
    add(hull, place)
    add(hull, place, base="PLANE")
    add(hull, place, base="CREASE", use=False)
    add(hull, place, base="CURVE")  # of which the curve is missing
    hull.hull.fields.active_field = 1
    point, plane = seen_of(hull).bases
    dots = arrays.dots(point)
    assert np.abs(dots - [place, place * [1, -1, 1]]).max() < 1e-5
    assert len(arrays.base_strokes([point])) == 0 and len(arrays.dots(plane)) == 0
    corners = arrays.base_strokes([plane]).points
    points = part("bridge.mesh.mesh_points").read(hull.data)
    assert np.abs(corners[:, 0] - place[0]).max() < 1e-5
    assert corners[:, 1].max() > points[:, 1].max() and corners[:, 1].min() < -points[:, 1].max()
    assert seen_of(hull).chosen is plane
    hull.hull.fields.active_field = 2  # off, and seen while it is chosen
    crease = seen_of(hull).chosen
    assert crease.number == 2 and len(seen_of(hull).bases) == 2
    state = part("features.hull.hull_state").state_of(hull)
    row = hull.hull.fields.fields[2]
    curve = curve_of(row, hull, state.ship.surface)
    assert max(curve.distances(crease.polylines[0])) < 1e-6
    hull.hull.fields.active_field = 3
    assert seen_of(hull).chosen is None and seen_of(hull).lines is None


def test_nothing_is_seen_without_a_field_or_with_the_switch_off():
    hull = sample()
    assert seen_of(hull).bases == [] and seen_of(hull).lines is None
    add(hull, side_point(hull))
    assert seen_of(hull).lines is not None
    hull.hull.fields.show_fields = False
    assert (
        seen_of(hull).bases == [] and seen_of(hull).chosen is None and seen_of(hull).lines is None
    )
    hull.hull.fields.show_fields = True
    assert seen_of(hull).lines is not None
    bpy.ops.hull.remove_field()
    assert seen_of(hull).bases == [] and seen_of(hull).lines is None


def test_lines_are_kept_until_something_changes():
    hull = sample()
    row = add(hull, side_point(hull), extent=6.0)
    before = seen_of(hull).lines
    row.shift = (0.0, 0.1, 0.0)
    row.name, row.colour = "Shoulder", (1.0, 0.0, 0.0)
    assert seen_of(hull).lines is before
    row.extent = 7.0
    assert seen_of(hull).lines is not before


def test_lines_stay_on_their_points_of_a_previewed_surface():
    hull = sample()
    row = add(hull, side_point(hull), extent=20.0, shift=(0.0, 0.5, 0.0))
    before = seen_of(hull).lines.levels[1]
    bpy.ops.hull.preview_fields()
    after = seen_of(hull).lines.levels[1]
    assert after.shape == before.shape
    # At half the intensity, half the shift, as far as the control points can follow; the bottom
    # keeps its tangent across the centre plane.
    shifts = (after - before)[..., 1]
    assert np.abs(np.median(shifts) - 0.25) < 0.02 and shifts.max() < 0.28
    bpy.ops.hull.cancel_fields()
    assert np.array_equal(seen_of(hull).lines.levels[1], before)
    assert row.extent == 20.0


def test_arrows_reach_from_the_base_to_the_tip():
    arrays = part("overlays.field_arrays")
    segments, head = arrays.arrow(np.array([10.0, 10.0]), np.array([110.0, 10.0]), 1.0)
    assert segments[0].tolist() == [10.0, 10.0, 0.0] and head[0].tolist() == [110.0, 10.0, 0.0]
    assert segments[1, 0] == head[1, 0] == head[2, 0] and head[1:, 1].mean() == pytest.approx(10.0)
    assert all(len(part) == 0 for part in arrays.arrow(np.zeros(2), np.array([1.0, 0.0]), 1.0))


def eye_from_port(hull):
    """A pull_lines.Eye that looks along -y, 10 dots a metre, x to the left; the origin is in the
    middle of its picture."""
    size, dots = (2000, 1000), 10.0
    to_clip = np.diag([2.0 * dots / size[0], 2.0 * dots / size[1], 1e-3, 1.0])
    turned = np.array([[-1, 0, 0, 0], [0, 0, 1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], dtype=float)
    turned[2] *= -1.0  # what is nearer has less depth
    return part("features.modelling.pull_lines").Eye(to_clip @ turned, size)


def dot_of(eye, point):
    return part("features.modelling.drags").in_picture(eye.to_clip, eye.size, np.array([point]))[0]


def test_handles_follow_the_mouse():
    hull, handles = sample(), part("features.fields.handles")
    place, scene = side_point(hull), bpy.context.scene
    row = add(hull, place, extent=6.0, shift=(0.5, 0.25, 0.0))
    eye = eye_from_port(hull)
    _, base = handles.at_hand(hull, scene)
    found = handles.places(row, base, eye, 1.0)
    assert np.abs(found["extent"] - (place + (-6.0, 0.0, 0.0))).max() < 1e-5
    assert np.abs(found["shift"] - (place + (0.5, 0.25, 0.0))).max() < 1e-5
    mouse = dot_of(eye, found["shift"]) + (3.0, 0.0)
    assert handles.nearest(found, eye, mouse, handles.NEAR) == "shift"
    assert handles.nearest(found, eye, mouse + (0.0, 500.0), handles.NEAR) is None
    drag = handles.Drag(hull, scene, "shift", eye, mouse)
    drag.move(eye, mouse + (-10.0, 20.0))
    assert np.abs(np.array(row.shift) - (1.5, 0.25, 2.0)).max() < 1e-5
    drag.move(eye, mouse + (-10.0, 20.0), axis=2)
    assert np.abs(np.array(row.shift) - (0.5, 0.25, 2.0)).max() < 1e-5
    row.axes = (True, False, False)
    drag.move(eye, mouse + (-10.0, 20.0))
    assert np.abs(np.array(row.shift) - (1.5, 0.25, 0.0)).max() < 1e-5
    mouse = dot_of(eye, found["extent"])
    drag = handles.Drag(hull, scene, "extent", eye, mouse)
    drag.move(eye, mouse + (20.0, 0.0))
    assert row.extent == pytest.approx(8.0, abs=1e-5)
    assert handles.words(row, "extent", scene).startswith("Extent 8")
    row.role = "PROTECT"
    assert set(handles.places(row, base, eye, 1.0)) == {"extent"}


def test_a_script_gives_the_operator_what_is_dragged():
    hull = sample()
    row = add(hull, side_point(hull))
    with pytest.raises(RuntimeError, match="give shift or extent"):
        bpy.ops.hull.drag_field()
    assert bpy.ops.hull.drag_field(extent=3.0) == {"FINISHED"}
    assert row.extent == 3.0 and tuple(row.shift) == (0.0, 0.0, 0.0)


def line_of(hull, place, **settings):
    """A curve along the ship from a place, on which a new field of the hull is based."""
    points = [place, place + (8.0, 0.0, 0.0)]
    line = part("bridge.objects.curve_lines").made("Line", points, False, hull)
    add(hull, place, base="CURVE", extent=6.0, **settings).curve = line
    return line


def test_what_is_seen_follows_a_base_curve_and_other_faces():
    hull = sample()
    place = side_point(hull)
    line = line_of(hull, place)
    before = seen_of(hull).lines
    for point in line.data.splines[0].points:
        point.co.z += 0.5
    line.data.update_tag()
    assert np.abs(seen_of(hull).chosen.anchor[2] - place[2] - 0.5) < 1e-5
    assert seen_of(hull).lines is not before
    bpy.data.objects.remove(line)
    assert seen_of(hull).chosen is None
    row, faces = add(hull, place, base="FACES"), part("bridge.objects.field_faces")
    assert seen_of(hull).chosen is None
    faces.give(hull, row, [30, 31])
    hull.data.update_tag()
    before = seen_of(hull).chosen
    faces.forget(hull, row)
    faces.give(hull, row, [60])
    hull.data.update_tag()
    assert seen_of(hull).chosen.digest != before.digest


def test_a_base_curve_that_is_taken_out_of_the_scene_is_seen_no_longer():
    hull = sample()
    line = line_of(hull, side_point(hull))
    assert seen_of(hull).chosen is not None
    for collection in line.users_collection:
        collection.objects.unlink(line)
    assert seen_of(hull).chosen is None


def test_an_animated_base_curve_is_followed():
    hull = sample()
    line = line_of(hull, side_point(hull), shift=(0.0, 0.2, 0.0))
    for frame, z in ((1, 0.0), (11, 0.5)):
        line.location.z = z
        line.keyframe_insert("location", frame=frame)
    for is_previewed in (False, True):
        if is_previewed:
            bpy.context.scene.frame_set(1)
            assert bpy.ops.hull.preview_fields() == {"FINISHED"}
        found = {}
        for frame in (1, 11):
            bpy.context.scene.frame_set(frame)
            seen = part("features.fields.seen").of_hull(hull)
            found[frame] = seen.chosen.anchor[2], part("bridge.mesh.mesh_points").read(hull.data)
        assert found[11][0] - found[1][0] == pytest.approx(0.5, abs=1e-5)
        assert np.array_equal(found[1][1], found[11][1]) != is_previewed


def test_curves_are_read_once_within_one_another():
    """Reading a curve has Blender evaluate it, and tell of what has changed meanwhile."""
    module = part("bridge.objects.curve_lines")
    data = bpy.data.curves.new("line", "CURVE")
    data.dimensions = "3D"
    data.splines.new("POLY").points.add(1)
    data.splines[0].points[1].co = (1.0, 2.0, 3.0, 1.0)
    curve, hull = bpy.data.objects.new("line", data), sample()
    bpy.context.collection.objects.link(curve)
    bpy.context.view_layer.update()
    with module.read_once():
        with module.read_once():
            first = module.points_of(curve, hull)
        assert module.points_of(curve, hull) is first
    assert module.points_of(curve, hull) is not first


def test_all_that_is_shown_goes_by_another_unit_of_the_scene():
    hull = sample()
    row = add(hull, side_point(hull), base="POINT", extent=6.0)
    before = np.concatenate([lines.reshape(-1, 3) for lines in seen_of(hull).lines.levels])
    bpy.context.scene.unit_settings.scale_length = 0.5
    found = seen_of(hull)
    after = np.concatenate([lines.reshape(-1, 3) for lines in found.lines.levels])
    assert row.extent == 6.0
    assert np.ptp(after, axis=0) == pytest.approx(0.5 * np.ptp(before, axis=0), rel=0.02)
