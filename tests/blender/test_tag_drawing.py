# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of tags: the arrays for the graphics card, and what of a hull they are made of."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_box, add_hull, part, state_of
from edited_hulls import BORDERS, KNUCKLES, at, edit, find, grid_hull, select, tags_of

SEED = 20261122
VIEWPORT = (800, 400)
LARGE_VIEWPORT = (8000, 4000)  # with room for all marks


@pytest.fixture
def arrays():
    return part("overlays.tag_arrays")


def in_dots(places):
    """Places in the picture as dots from its middle."""
    return np.asarray(places)[..., :2] * 0.5 * np.array(VIEWPORT)


def perspective():
    """To clip coordinates of an eye at the origin that looks along -z, a right angle wide."""
    near, far = 0.1, 100.0
    matrix = np.zeros((4, 4))
    matrix[0, 0], matrix[1, 1] = 1.0, VIEWPORT[0] / VIEWPORT[1]
    matrix[2, 2], matrix[2, 3] = (far + near) / (near - far), 2.0 * far * near / (near - far)
    matrix[3, 2] = -1.0
    return matrix


def test_rails_are_beside_their_edge(arrays):
    rng = np.random.default_rng(SEED)
    places = rng.uniform(-1.0, 1.0, (50, 2, 3))
    rails = arrays.rails(places, 3.0, VIEWPORT)
    assert rails.shape == (100, 2, 3)
    ends, along = in_dots(np.concatenate([places, places])), in_dots(places[:, 1] - places[:, 0])
    shifts = in_dots(rails) - ends
    assert np.linalg.norm(shifts, axis=2) == pytest.approx(3.0)
    dots = np.einsum("nki,ni->nk", shifts, np.concatenate([along, along]))
    assert np.abs(dots).max() < 1e-9
    assert shifts[:50] == pytest.approx(-shifts[50:])
    assert np.array_equal(rails[:, :, 2], np.concatenate([places, places])[:, :, 2])


def test_rails_of_an_edge_seen_from_its_end(arrays):
    point = np.zeros((1, 2, 3))
    assert np.isfinite(arrays.rails(point, 3.0, VIEWPORT)).all()


def test_points_that_are_no_numbers_do_not_change_the_spacing(arrays):
    points = np.random.default_rng(SEED).uniform(-1.0, 1.0, (40, 3)) - (0.0, 0.0, 5.0)
    clip = arrays.in_clip(points, perspective())
    odd = np.concatenate([clip[:9], np.full((3, 4), np.nan), clip[9:]])
    assert arrays.spacing(odd, VIEWPORT) == arrays.spacing(clip, VIEWPORT)
    assert arrays.spacing(odd[9:12], VIEWPORT) == np.inf


def test_segments_end_before_the_eye(arrays):
    points = np.array([(0, 0, -5), (1, 0, -5), (0, 0, 5), (1, 1, 3)], dtype=float)
    clip = arrays.in_clip(points, perspective())
    found = arrays.segments(clip, [(0, 1), (0, 2), (2, 3)])
    # Of the second one what is before the eye is in the middle of the picture; none of the third.
    assert found.shape == (2, 2, 3)
    assert found[0, :, :2] == pytest.approx(np.array([(0, 0), (0.2, 0)]))
    assert np.isfinite(found).all()
    assert np.abs(found[1, :, :2]).max() < 1e-9
    reverse = arrays.segments(clip, [(2, 0)])
    assert reverse[0] == pytest.approx(found[1][::-1])


def test_a_segment_that_is_cut_stays_on_its_line(arrays):
    rng = np.random.default_rng(SEED + 1)
    a = rng.uniform(-1, 1, (40, 3)) + (0, 0, -3)
    b = rng.uniform(-1, 1, (40, 3)) + (0, 0, 3)
    inside = a + 0.2 * (b - a)
    points = np.concatenate([a, b, inside])
    clip = arrays.in_clip(points, perspective())
    found = arrays.segments(clip, np.arange(80).reshape(2, 40).T)[:, :, :2]
    third = (clip[80:, :2] / clip[80:, 3:]) - found[:, 0]
    along = found[:, 1] - found[:, 0]
    cross = along[:, 0] * third[:, 1] - along[:, 1] * third[:, 0]
    assert np.abs(cross / np.linalg.norm(along, axis=1)).max() < 1e-6


def test_places_behind_the_eye_are_not_seen(arrays):
    points = np.array([(0, 0, -5), (0, 0, 5), (9, 0, -5)], dtype=float)
    _, is_seen = arrays.places(arrays.in_clip(points, perspective()))
    assert is_seen.tolist() == [True, False, False]


def test_spacing_is_about_that_of_a_grid(arrays):
    x, y = np.meshgrid(np.linspace(-0.5, 0.5, 11), np.linspace(-0.5, 0.5, 6))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    wide, high = 0.5 * VIEWPORT[0] / 10, 0.5 * VIEWPORT[1] / 5
    clip = arrays.in_clip(points, np.eye(4))
    assert arrays.spacing(clip, VIEWPORT) == pytest.approx(np.sqrt(wide * high), rel=0.15)
    assert arrays.spacing(arrays.in_clip(points, perspective()), VIEWPORT) == np.inf


@pytest.mark.parametrize("name", ["square", "ring"])
def test_outlines_are_closed_and_as_large_as_said(arrays, name):
    corners = in_dots(arrays.outlines(name, np.array([(0.5, 0.5, 0.25)]), 8.0, VIEWPORT))
    corners -= in_dots(np.array([0.5, 0.5]))
    assert np.abs(corners).max() == pytest.approx(8.0)
    ends = {tuple(np.round(corner, 6)) for corner in corners[1::2]}
    assert ends == {tuple(np.round(corner, 6)) for corner in corners[::2]}


def test_numbers_stand_side_by_side(arrays):
    place = np.zeros((1, 3))
    written = {n: in_dots(arrays.numbers([n], place, 10.0, (4.0, 2.0), VIEWPORT)) for n in (1, 12)}
    assert written[12][: len(written[1])] == pytest.approx(written[1])
    assert written[12][len(written[1]) :, 0].min() > written[1][:, 0].max()
    for corners in written.values():
        assert corners[:, 1].min() == pytest.approx(2.0)
        assert corners[:, 1].max() == pytest.approx(12.0)
    shapes = {arrays.numbers([n], place, 1.0, (0, 0), VIEWPORT).tobytes() for n in range(10)}
    assert len(shapes) == 10
    assert arrays.numbers([], np.empty((0, 3)), 1.0, (0, 0), VIEWPORT).shape == (0, 3)


def test_sizes_are_those_of_the_numbers_written(arrays):
    numbers, place = [3, 12, 140], np.zeros((1, 3))
    for number, size in zip(numbers, arrays.number_sizes(numbers, 10.0)):
        corners = in_dots(arrays.numbers([number], place, 10.0, (0, 0), VIEWPORT))
        assert np.ptp(corners, axis=0) == pytest.approx(size, abs=2.5)  # a 1 is narrower
        assert (corners.max(axis=0) <= size + 1e-9).all()
    assert arrays.number_sizes([], 10.0).shape == (0, 2)


def test_triangles_and_rim_of_faces(arrays):
    faces = [np.array([0, 1, 2, 3]), np.array([1, 4, 5, 6, 2])]
    assert arrays.fan_triangles(faces).tolist() == [
        [0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 6], [1, 6, 2]
    ]  # fmt: skip
    rim = {tuple(edge) for edge in arrays.rim(faces).tolist()}
    assert rim == {(0, 1), (2, 3), (0, 3), (1, 4), (4, 5), (5, 6), (2, 6)}
    assert arrays.rim([]).shape == (0, 2) and arrays.fan_triangles([]).shape == (0, 3)


def drawing_of(hull, is_refreshed=True, zoom=1.0):
    """What is drawn of a hull, seen along z from above."""
    drawing = part("overlays.tag_drawing")
    scene = bpy.context.scene
    if is_refreshed:
        part("features.hull.hull_state").refresh(hull, scene)
    to_clip = np.diag([0.05 * zoom, 0.05 * zoom, 0.01, 1.0])
    picture = drawing.Picture(
        to_clip, LARGE_VIEWPORT, 1.0, part("bridge.blender.units").metres_per_unit(scene)
    )
    return drawing.drawing_of(hull, state_of(hull), scene, picture)


def counts(drawing):
    """How many segments are drawn in each colour of tags; corners have that of knuckles."""
    names = {}
    for name, colour in part("bridge.blender.preferences").colours("tags").items():
        names.setdefault(tuple(colour), name)
    found = {}
    for colour, _, corners in drawing.lines:
        if tuple(colour) in names:
            name = names[tuple(colour)]
            found[name] = found.get(name, 0) + len(corners) // 2
    return found


def test_a_box_is_drawn_by_kinds():
    hull = add_hull()
    edit(hull)
    # Knuckles and corners have one colour: two rails for each edge, four sides for each square.
    assert counts(drawing_of(hull)) == {"knuckle": 2 * KNUCKLES + 4 * 8, "border": 2 * BORDERS}


def test_borders_on_the_centre_plane_of_a_half_hull_are_fine():
    hull = add_hull()
    edit(hull)
    colour = part("bridge.blender.preferences").colour("tags", "border")

    def border_widths():
        return {
            round(width, 3): len(corners) // 4
            for found, width, corners in drawing_of(hull).lines
            if tuple(found) == colour
        }

    half = border_widths()
    # Three are along the deck, three on the centre plane.
    assert list(half.values()) == [3, 3] and min(half) == pytest.approx(0.6 * max(half), rel=1e-3)
    hull.hull.keep_centre = False
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    bm.verts[find(hull, 0, 0, 0)].co.y = 1e-3
    bmesh.update_edit_mesh(hull.data)
    assert sorted(border_widths().items()) == [(min(half), 1), (max(half), 5)]
    hull.hull.half = False
    assert border_widths() == {max(half): BORDERS}


@pytest.mark.parametrize(
    "switch, missing",
    [("show_border", "border"), ("show_deck_edge", "deck_edge"), ("show_irregular", "irregular"),
     ("show_odd_faces", "odd_face"), ("show_problems", "problem"), ("show_flats", "flat"),
     ("show_locked", "locked"), ("show_kept", "kept")],
)  # fmt: skip
def test_each_switch_takes_its_kind_away(switch, missing):
    hull = grid_hull()
    bm = edit(hull)
    bm.faces.ensure_lookup_table()
    bmesh.ops.poke(bm, faces=[bm.faces[0]])
    bmesh.update_edit_mesh(hull.data)
    select(hull, "vertex", [at(3, 3)])
    bpy.ops.hull.tag_corner()  # without creases: a warning, and irregular
    select(hull, "edge", [(at(2, 4), at(3, 4))])
    bpy.ops.hull.mark_deck_edge()
    part("features.constraints.flats").mark(hull, [12], (0.0, 1.0, 0.0, 1.0))
    bpy.ops.hull.lock_points()
    bpy.ops.hull.keep_points(plane="BUTTOCK")
    before = counts(drawing_of(hull))
    assert set(before) == {
        "knuckle", "border", "deck_edge", "irregular", "odd_face", "problem", "flat", "locked",
        "kept",
    }  # fmt: skip
    setattr(hull.hull.tags, switch, False)
    after = counts(drawing_of(hull))
    assert after == {name: count for name, count in before.items() if name != missing}


def test_locks_are_where_their_points_are():
    hull = add_hull()
    # A point without faces, which is no control point, comes before others then.
    bm = edit(hull)
    bmesh.ops.delete(bm, geom=[f for f in bm.faces if f.calc_center_median().x < 1e-6],
                     context="FACES_ONLY")  # fmt: skip
    bmesh.update_edit_mesh(hull.data)
    tags, place = tags_of(hull), (0.0, 2.0, 0.0)
    select(hull, "vertex", [find(hull, *place), find(hull, 10, 0, 3)])
    bpy.ops.hull.lock_points()
    points = state_of(hull).ship.surface.mesh.points
    locked = points[part("features.hull.tags").locked_points(hull, tags)]
    assert {tuple(point) for point in locked} == {place, (10.0, 0.0, 3.0)}
    assert counts(drawing_of(hull))["locked"] == 2 * 4


def test_nothing_is_drawn_of_points_that_lost_all_faces():
    hull = grid_hull()
    bm = edit(hull)
    select(hull, "vertex", [at(1, 1), at(2, 2)])
    bpy.ops.hull.lock_points()
    bpy.ops.hull.keep_points(plane="STATION")
    bmesh.ops.delete(bm, geom=bm.edges[:], context="EDGES_FACES")
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()
    assert not counts(drawing_of(hull))


def test_kept_points_have_strokes_as_their_planes_run_in_the_body_plan(arrays):
    hull = grid_hull()
    edit(hull)
    select(hull, "vertex", [at(1, 1), at(2, 2)])
    bpy.ops.hull.keep_points(plane="STATION")
    select(hull, "vertex", [at(2, 2), at(3, 2), at(3, 3)])
    bpy.ops.hull.keep_points(plane="WATERLINE")
    assert counts(drawing_of(hull))["kept"] == (2 + 3) * 2
    strokes = {name: arrays.OUTLINES[name].reshape(-1, 2, 2) for name in
               ("station", "waterline", "buttock")}  # fmt: skip
    along = {name: np.ptp(ends, axis=1) for name, ends in strokes.items()}
    assert (along["station"] == (0.0, 0.9)).all() and (along["waterline"] == (0.9, 0.0)).all()
    assert (along["buttock"] > 0.5).all()
    places = [np.sort(np.abs(ends.mean(axis=1)), axis=0) for ends in strokes.values()]
    assert len({place.tobytes() for place in places}) == 3  # none covers another


def test_corners_darts_and_knuckles_have_switches():
    hull = grid_hull()
    edit(hull)
    select(hull, "edge", [(at(2, 2), at(3, 2))])
    bpy.ops.hull.tag_crease()
    settings = hull.hull.tags
    squares, diamonds, rails = 4 * 4, 2 * 4, 2
    assert counts(drawing_of(hull))["knuckle"] == squares + diamonds + rails
    settings.show_darts = False
    assert counts(drawing_of(hull))["knuckle"] == squares + rails
    settings.show_corners = False
    assert counts(drawing_of(hull))["knuckle"] == rails
    settings.show_knuckle = False
    assert "knuckle" not in counts(drawing_of(hull))


def test_what_is_hidden_is_not_drawn():
    hull = add_hull()
    edit(hull)
    select(hull, "vertex", [find(hull, 0, 2, 0)])
    bpy.ops.mesh.hide()
    # Three knuckles meet there.
    assert counts(drawing_of(hull))["knuckle"] == 2 * (KNUCKLES - 3) + 4 * 7


def test_a_mesh_with_errors_is_drawn_by_its_tags_with_what_is_wrong():
    hull = add_hull()
    bm = edit(hull)
    extra = bm.verts.new((5.0, 3.0, 1.0))
    bm.verts.ensure_lookup_table()
    a, b = find(hull, 0, 2, 0), find(hull, 10, 2, 0)
    bm.faces.new((bm.verts[a], bm.verts[b], extra))
    bmesh.update_edit_mesh(hull.data)
    drawing = drawing_of(hull)
    assert state_of(hull).status
    found = counts(drawing)
    assert found["knuckle"] == 2 * KNUCKLES and found["border"] == 2 * (BORDERS + 2)
    assert found["problem"] >= 2


def test_a_mesh_that_never_had_its_whole_surface_is_drawn():
    box = add_box()
    bm = bmesh.new()
    bm.from_mesh(box.data)
    bm.verts.ensure_lookup_table()
    bm.faces.new((bm.verts[2], bm.verts[6], bm.verts.new((5.0, 3.0, 1.0))))
    bm.to_mesh(box.data)
    bm.free()
    bpy.ops.hull.make_hull(half=True)
    assert "Edge 2–6" in state_of(box).status
    edit(box)
    # Two rails and a ring of an edge with three faces.
    assert counts(drawing_of(box))["problem"] == 2 + 24


def test_an_empty_mesh_is_drawn_as_nothing():
    hull = add_hull()
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete(type="VERT")
    assert counts(drawing_of(hull)) == {}


def test_a_mesh_that_is_not_known_yet_is_drawn_as_it_is():
    hull = grid_hull()
    edit(hull)
    select(hull, "vertex", [at(2, 2)])  # without creases: a problem that lists it
    bpy.ops.hull.tag_corner()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    bm = bmesh.from_edit_mesh(hull.data)
    bm.faces.ensure_lookup_table()
    bmesh.ops.delete(bm, geom=bm.faces[2:], context="FACES")
    # Two faces one after the other are left.
    assert counts(drawing_of(hull, is_refreshed=False))["border"] == 2 * 6


def test_tags_stand_where_the_points_are_in_any_unit():
    bpy.context.scene.unit_settings.scale_length = 0.5
    hull = grid_hull()
    edit(hull)
    select(hull, "vertex", [at(3, 3)])
    bpy.ops.hull.tag_corner()
    middle = 0.5 * np.array(bmesh.from_edit_mesh(hull.data).verts[at(3, 3)].co)
    rings = [
        corners
        for colour, width, corners in drawing_of(hull).lines
        if tuple(colour) == part("bridge.blender.preferences").colour("tags", "problem")
    ]
    assert len(rings) == 1
    assert rings[0].mean(axis=0)[:2] == pytest.approx(0.05 * middle[:2], abs=1e-6)


def test_marks_are_smaller_where_there_is_no_room():
    hull = grid_hull()
    edit(hull)
    select(hull, "vertex", [at(3, 3)])
    bpy.ops.hull.tag_corner()
    colour = part("bridge.blender.preferences").colour("tags", "irregular")

    def marks(zoom):
        drawing = drawing_of(hull, zoom=zoom)
        return [np.ptp(corners[:, 0]) for c, _, corners in drawing.lines if tuple(c) == colour]

    # The ring and its number, and the ring alone.
    near, far = marks(1.0), marks(0.1)
    assert len(near) == 2 and len(far) == 1
    assert far[0] == pytest.approx(0.5 * near[0])


def test_of_numbers_that_would_cover_one_another_the_nearest_is_written():
    hull = grid_hull()
    bm = edit(hull)
    bm.faces.ensure_lookup_table()
    bmesh.ops.poke(bm, faces=[bm.faces[0]])
    bmesh.update_edit_mesh(hull.data)
    triangles = [face for face in bm.faces if len(face.verts) == 3]
    heights = sorted(face.calc_center_median().z for face in triangles)
    colour = part("bridge.blender.preferences").colour("tags", "odd_face")

    def depths(zoom):
        """Of the numbers written; a 3 has four strokes."""
        lines = drawing_of(hull, zoom=zoom).lines
        (corners,) = (corners for found, _, corners in lines if tuple(found) == colour)
        return sorted(corners[:: 2 * 4, 2] / 0.01)

    # Two triangles of the four are one above the other and seen as one behind the other.
    assert depths(2.0) == pytest.approx(heights)
    assert depths(1.0) == pytest.approx(heights[:-1])


def test_sizes_are_those_of_the_preferences():
    chosen = part("bridge.blender.preferences").of_addon()
    hull = add_hull()
    edit(hull)
    usual = {width for _, width, _ in drawing_of(hull).lines}
    chosen.tag_width = 6.0
    try:
        wide = {width for _, width, _ in drawing_of(hull).lines}
    finally:
        chosen.property_unset("tag_width")
    assert 2.0 * min(usual - wide) in wide


def test_tied_points_have_diamonds_and_lines_to_what_they_follow():
    hull = grid_hull()
    edit(hull)
    before = counts(drawing_of(hull))
    select(hull, "vertex", [at(1, 1), at(2, 1), at(3, 1), at(4, 1)])
    bpy.ops.hull.tie_points(kind="LINE")
    after = counts(drawing_of(hull))
    # Two points with four strokes, and two rails to each end.
    assert after.pop("kept") - before.pop("kept", 0) == 2 * 4 + 4 * 2 and after == before
    hull.hull.tags.show_kept = False
    assert counts(drawing_of(hull)) == before
