# SPDX-License-Identifier: GPL-3.0-or-later
"""Bilges rounded to a circle: what the surface's sections are then."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part
from edited_hulls import edit, select

X = np.arange(7) * 4.0
# From the centre plane: a flat bottom, a bilge, a flat side; 12 m broad, 8 m deep.
FLAT = [(0.0, 0.0), (2.0, 0.0), (4.0, 0.0)]
SIDE = [(6.0, 2.0), (6.0, 4.0), (6.0, 8.0)]


def bilge_points(count):
    """Anywhere between the flats."""
    turns = np.linspace(0.0, 0.5 * np.pi, count + 2)[1:-1]
    return [(4.0 + 2.0 * np.sin(t), 2.0 - 2.0 * np.cos(t)) for t in turns]


def midbody(section, creased, starboard=False):
    """A hull in edit mode of equal sections (k, 2), creases along points `creased` of these."""
    k = len(section)
    sign = -1.0 if starboard else 1.0
    points = [(x, sign * y, z) for x in X for y, z in section]
    faces, creases = [], []
    for i in range(len(X) - 1):
        for j in range(k - 1):
            a = i * k + j
            face = (a, a + 1, a + k + 1, a + k)
            faces.append(face[::-1] if starboard else face)
        creases += [(i * k + j, i * k + k + j) for j in creased]
    mesh = bpy.data.meshes.new("midbody")
    mesh.from_pydata(points, [], faces)
    keys = {tuple(sorted(e.vertices)): e.index for e in mesh.edges}
    part("bridge.blender.blender_versions").set_creases(mesh, [keys[c] for c in creases], [])
    hull = bpy.data.objects.new("midbody", mesh)
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    assert bpy.ops.hull.make_hull(half=not starboard) == {"FINISHED"}
    edit(hull)
    return hull


def select_rows(hull, k, first, last):
    select(hull, "vertex", [i * k + j for i in range(len(X)) for j in range(first, last + 1)])


def deviation(hull, radius, x=12.0, sign=1.0):
    """Of the surface's section from bottom, circle and side, in m."""
    arrays, native = part("bridge.mesh.mesh_arrays"), part("bridge.native").require()
    control = arrays.control_arrays(arrays.read_mesh(hull.data), 1.0)
    surface = native.LimitSurface(native.ControlMesh(*control.arguments()))
    (curve,) = native.sections(surface, [native.plane_across("x", x)], 1e-6)[0]
    y, z = sign * curve.points[:, 1] - (6.0 - radius), curve.points[:, 2] - radius
    circle = np.hypot(y, z) - radius
    return np.abs(np.where(y < 0, -z - radius, np.where(z > 0, y - radius, circle))).max()


BEST = {4: (8.43e-4, 3.10e-4), 5: (3.45e-4, 1.43e-4), 6: (1.664e-4, 7.46e-5)}


@pytest.mark.parametrize("count", [4, 5, 6])
@pytest.mark.parametrize("move_borders", [False, True])
def test_a_bilge_between_creases_is_as_round_as_can_be(count, move_borders):
    section = [*FLAT[::2], *bilge_points(count), *SIDE[::2]]
    hull = midbody(section, (1, count + 2))
    select_rows(hull, len(section), 1, count + 2)
    assert bpy.ops.hull.round_bilge(radius=2.5, move_borders=move_borders) == {"FINISHED"}
    assert deviation(hull, 2.5) == pytest.approx(2.5 * BEST[count][move_borders], rel=5e-3)
    assert part("features.hull.hull_state").state_of(hull).status == ""


def test_the_radius_that_is_there_is_offered():
    section = [*FLAT[::2], *bilge_points(4), *SIDE[::2]]
    hull = midbody(section, (1, 6))
    select_rows(hull, len(section), 1, 6)
    assert part("features.modelling.bilge").present_radius(hull, bpy.context.scene) == 2.0
    bpy.ops.hull.round_bilge(radius=2.75)
    assert part("features.modelling.bilge").present_radius(hull, bpy.context.scene) == 2.75


def test_a_bilge_between_smooth_borders():
    section = [*FLAT, *bilge_points(4), *SIDE]
    hull = midbody(section, ())
    # The borders are the last but one of the flats; those beyond may move.
    hull.data.update()
    before = part("bridge.mesh.mesh_points").read(hull.data)
    select_rows(hull, len(section), 2, 7)
    rounded = part("features.modelling.bilge").round_selected(hull, bpy.context.scene, 1.5, False)
    assert len(rounded) == len(X) and rounded[0].count == 4
    middle = rounded[3]
    assert middle.found == pytest.approx(middle.best, rel=5e-3)
    assert deviation(hull, 1.5) == pytest.approx(middle.best, rel=5e-3)
    assert middle.best < 1.5 * 1e-3
    after = part("bridge.mesh.mesh_points").read(hull.data)
    assert (after[:, 0] == before[:, 0]).all()
    assert (after[:: len(section)] == before[:: len(section)]).all()  # the centre line
    assert (after[9 :: len(section)] == before[9 :: len(section)]).all()  # the rim


def test_whole_rows_are_cut_at_the_flats():
    section = [*FLAT, *bilge_points(4), *SIDE]
    hull = midbody(section, (2, 7))
    select_rows(hull, len(section), 0, 9)
    (first, *_) = part("features.modelling.bilge").round_selected(
        hull, bpy.context.scene, 2.0, False
    )
    assert first.count == 4 and deviation(hull, 2.0) == pytest.approx(2 * 8.43e-4, rel=5e-3)


def test_both_sides_of_a_whole_hull():
    section = [*FLAT[::2], *bilge_points(5), *SIDE[::2]]
    hull = midbody(section, (1, 7), starboard=True)
    select_rows(hull, len(section), 1, 7)
    assert bpy.ops.hull.round_bilge(radius=3.0) == {"FINISHED"}
    assert deviation(hull, 3.0, sign=-1.0) == pytest.approx(3.0 * 3.45e-4, rel=5e-3)


def test_a_bottom_with_deadrise():
    rise = np.tan(np.radians(10.0))
    section = [(y, rise * y) for y, _ in FLAT[::2]]
    section += [(y, z + 0.6) for y, z in bilge_points(4)] + SIDE[::2]
    hull = midbody(section, (1, 6))
    select_rows(hull, len(section), 1, 6)
    rounded = part("features.modelling.bilge").round_selected(hull, bpy.context.scene, 2.0, False)
    native = part("bridge.native").require()
    assert rounded[3].best == pytest.approx(2 * native.bilge_arc(4, np.radians(80)).deviation)
    assert rounded[3].found == pytest.approx(rounded[3].best, rel=1e-2)
    points = part("bridge.mesh.mesh_points").read(hull.data).reshape(len(X), -1, 3)
    np.testing.assert_allclose(points[:, :3, 2], rise * points[:, :3, 1], atol=1e-6)


@pytest.mark.parametrize(
    "rows, radius, match",
    [
        ((1, 6), 6.5, "too large"),
        ((2, 5), 2.0, "five to ten points"),
        ((1, 3), 2.0, "five to ten points"),
    ],
)
def test_what_cannot_be_is_said(rows, radius, match):
    section = [*FLAT[::2], *bilge_points(4), *SIDE[::2]]
    hull = midbody(section, (1, 6))
    before = part("bridge.mesh.mesh_points").read(hull.data)
    select_rows(hull, len(section), *rows)
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.hull.round_bilge(radius=radius)
    assert (part("bridge.mesh.mesh_points").read(hull.data) == before).all()


@pytest.mark.parametrize("creased", [(), (6,), (5, 6)])
def test_a_row_that_is_flat_all_along_has_no_bilge(creased):
    section = [(y, 0.0) for y in np.linspace(0.0, 6.0, 7)]
    hull = midbody(section, creased)
    select_rows(hull, len(section), 0, 6)
    with pytest.raises(RuntimeError, match="points? between the borders of the flats"):
        bpy.ops.hull.round_bilge(radius=1.0)


def test_locked_points_and_nothing_selected():
    section = [*FLAT[::2], *bilge_points(4), *SIDE[::2]]
    hull = midbody(section, (1, 6))
    with pytest.raises(RuntimeError, match="Select the points of a section"):
        bpy.ops.hull.round_bilge(radius=2.0)
    select(hull, "vertex", [3])
    bpy.ops.hull.lock_points()
    select_rows(hull, len(section), 1, 6)
    with pytest.raises(RuntimeError, match="1 points of the bilge are locked"):
        bpy.ops.hull.round_bilge(radius=2.0)


def test_flats_that_are_kept_stay_flat():
    section = [*FLAT[::2], *bilge_points(4), *SIDE[::2]]
    hull = midbody(section, (1, 6))
    bm = bmesh.from_edit_mesh(hull.data)
    select(hull, "face", [f.index for f in bm.faces if f.calc_center_median().y < 3.0])
    bpy.ops.hull.make_flat(kind="BOTTOM")
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    bpy.ops.mesh.select_all(action="DESELECT")
    select_rows(hull, len(section), 1, 6)
    bpy.ops.hull.round_bilge(radius=2.5)
    assert deviation(hull, 2.5) == pytest.approx(2.5 * 8.43e-4, rel=5e-3)
    (region,) = part("features.constraints.flats").regions(hull)
    points = part("bridge.mesh.mesh_points").read(hull.data, region.points)
    assert (points[:, 2] == 0.0).all() and np.isclose(points[:, 1], 3.5).any()
