# SPDX-License-Identifier: GPL-3.0-or-later
"""High-valence points are reduced: topology sound, creases kept, the rest of the mesh untouched."""

from math import cos, pi, sin

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part, state_of


def dome(valence, triangles=False, rings=3, turn=2.0 * pi):
    """A hull of one smooth bowl about a pole with so many faces around it, of quadrilaterals or
    triangles; `turn` less than a circle leaves it open, with the pole on the border."""
    is_closed = turn > 6.28
    sides = valence * (1 if triangles else 2)
    columns = sides if is_closed else sides + 1
    points = [(0.0, 0.0, 0.0)]
    for ring in range(1, rings + 1):
        for k in range(columns):
            angle = turn * k / sides
            points.append((ring * cos(angle), ring * sin(angle), 0.1 * ring * ring))
    faces = []
    for ring in range(rings):
        for k in range(sides):
            a, b = k, (k + 1) % columns
            if ring:
                low, high = 1 + (ring - 1) * columns, 1 + ring * columns
                faces.append((low + b, low + a, high + a, high + b))
            elif triangles:
                faces.append((0, 1 + a, 1 + b))
            elif k % 2 == 0:
                faces.append((0, 1 + a, 1 + b, 1 + (k + 2) % columns))
    return make(points, [face[::-1] for face in faces])


def make(points, faces):
    mesh = bpy.data.meshes.new("dome")
    mesh.from_pydata(points, [], faces)
    hull = bpy.data.objects.new("dome", mesh)
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    assert bpy.ops.hull.make_hull(half=False) == {"FINISHED"}
    assert not state_of(hull).status, state_of(hull).status
    return hull


def edit(hull, *indices):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.tool_settings.mesh_select_mode = (True, False, False)
    bm = bmesh.from_edit_mesh(hull.data)
    for vertex in bm.verts:
        vertex.select_set(vertex.index in indices)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)
    return bm


def irregularity(bm):
    """The sum over all inner points without creases of the square of how many faces they have
    too many or too few."""
    return sum((len(v.link_faces) - 4) ** 2 for v in bm.verts if not v.is_boundary)


def assert_sound(hull):
    state = part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert not state.ship.check.errors and not state.status, state.ship.check.problems


@pytest.mark.parametrize("valence, wanted", [(6, [4, 4]), (7, [4, 5]), (8, [5, 5])])
def test_a_pole_of_quadrilaterals_is_parted(valence, wanted):
    hull = dome(valence)
    bm = edit(hull, 0)
    before, points, faces = irregularity(bm), len(bm.verts), len(bm.faces)
    assert bpy.ops.hull.reduce_valence() == {"FINISHED"}
    assert (len(bm.verts), len(bm.faces)) == (points + 1, faces + 1)
    bm.verts.ensure_lookup_table()
    assert sorted(len(bm.verts[i].link_faces) for i in (0, -1)) == wanted
    assert irregularity(bm) < before
    assert all(len(face.verts) == 4 for face in bm.faces)
    assert_sound(hull)


def test_a_pole_of_twelve_ends_with_five_at_most():
    hull = dome(12)
    bm = edit(hull, 0)
    bpy.ops.hull.reduce_valence()
    assert max(len(v.link_faces) for v in bm.verts) <= 5
    assert_sound(hull)


@pytest.mark.parametrize("valence, left", [(8, 4), (7, 4), (12, 6), (5, 4)])
def test_a_fan_of_triangles_is_joined(valence, left):
    hull = dome(valence, triangles=True)
    found = part("features.modelling.valence")
    bm = edit(hull, 0)
    points = {tuple(vertex.co) for vertex in bm.verts}
    bm.verts.ensure_lookup_table()
    assert found._join_triangles(bm, bm.verts[0])
    assert len(bm.verts[0].link_faces) == left
    assert {tuple(vertex.co) for vertex in bm.verts} == points
    bmesh.update_edit_mesh(hull.data)
    assert_sound(hull)


def test_a_fan_on_a_border_is_joined_and_its_border_stays():
    hull = dome(6, triangles=True, turn=pi)
    bm = edit(hull, 0)
    before = {tuple(v.co) for v in bm.verts if v.is_boundary}
    bpy.ops.hull.reduce_valence()
    assert {tuple(v.co) for v in bm.verts if v.is_boundary} == before
    bm.verts.ensure_lookup_table()
    assert len(bm.verts[0].link_faces) == 3
    assert_sound(hull)


def test_creases_through_a_point_are_kept():
    hull = dome(10)
    edges = part("bridge.blender.blender_versions")
    bm = edit(hull, 0)
    layer, _ = edges.ensure_crease_layers(bm)
    bm.verts.ensure_lookup_table()
    fan = part("bridge.mesh.vertex_fans").fan(bm, bm.verts[0])
    for place in (0, 5):
        fan.spokes[place][layer] = 1.0
    crease = {tuple(v.co) for place in (0, 5) for v in fan.spokes[place].verts}
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.hull.reduce_valence()
    after = {tuple(v.co) for edge in bm.edges if edge[layer] for v in edge.verts}
    assert after == crease and sum(edge[layer] for edge in bm.edges) == 2
    assert max(len(v.link_faces) for v in bm.verts) < 10
    assert_sound(hull)


def test_faces_of_different_layers_are_not_joined():
    hull = dome(8, triangles=True)
    for name in "ab":
        hull.data.materials.append(bpy.data.materials.new(name))
    for polygon in hull.data.polygons:
        polygon.material_index = polygon.index % 2
    bm = edit(hull, 0)
    bm.verts.ensure_lookup_table()
    assert not part("features.modelling.valence")._join_triangles(bm, bm.verts[0])


@pytest.mark.parametrize("valence", [3, 4, 5])
def test_what_cannot_be_less_is_refused(valence):
    hull = dome(valence)
    bm = edit(hull, 0)
    points = [tuple(vertex.co) for vertex in bm.verts]
    match = "made fewer" if valence == 5 else "Select points"
    with pytest.raises(RuntimeError, match=match):
        bpy.ops.hull.reduce_valence()
    assert [tuple(vertex.co) for vertex in bm.verts] == points


def test_faces_turned_both_ways_are_refused():
    hull = dome(8)
    bm = edit(hull, 0)
    bm.verts.ensure_lookup_table()
    bmesh.ops.reverse_faces(bm, faces=[bm.verts[0].link_faces[2]])
    with pytest.raises(ValueError, match="turned one way"):
        part("features.modelling.valence").reduce_selected(hull, bpy.context.scene)


def test_parting_goes_by_sectors():
    fan = part("bridge.mesh.vertex_fans").Fan
    spokes = [object() for _ in range(8)]
    smooth = fan(None, spokes, [None] * 8, (), False)
    assert smooth.sectors() == [[0, 1, 2, 3, 4, 5, 6, 7, 0]] and smooth.has_too_many()
    dart = fan(None, spokes, [None] * 8, (3,), False)
    assert dart.sectors() == [[3, 4, 5, 6, 7, 0, 1, 2, 3]] and dart.regular_size == 4
    crease = fan(None, spokes, [None] * 8, (1, 3), False)
    assert crease.sectors() == [[1, 2, 3], [3, 4, 5, 6, 7, 0, 1]] and crease.regular_size == 2
    assert crease.sector_size(spokes[5]) == 6 and crease.sector_size(spokes[2]) == 2
    border = fan(None, spokes, [None] * 7, (0, 4, 7), False)
    assert border.sectors() == [[0, 1, 2, 3, 4], [4, 5, 6, 7]] and border.regular_size == 1
    assert fan(None, spokes[:3], [None] * 2, (0, 2), False).regular_size == 2
    assert not fan(None, spokes[:2], [None], (0, 1), False).has_too_many()


def limits_of(hull, bm, *vertices):
    """Where control points end in the surface, by the native module's own numbers."""
    arrays = part("bridge.mesh.mesh_arrays")
    control = arrays.control_arrays(arrays.read_mesh(hull.data), 1.0)
    surface = part("features.hull.hull_state").refresh(hull, bpy.context.scene).ship.surface
    cells = [int(np.flatnonzero(control.face_vertices == vertex.index)[0]) for vertex in vertices]
    return surface.evaluate(np.array(cells), np.zeros((len(cells), 2)))[0]


@pytest.mark.parametrize("valence", [6, 8, 12])
def test_the_surface_stays_near(valence):
    hull = dome(valence)
    before = part("features.hull.hull_state").refresh(hull, bpy.context.scene).ship.surface
    tree = part("bridge.native").require().SurfaceTree(before)
    bm = edit(hull, 0)
    found = part("features.modelling.valence").reduce_selected(hull, bpy.context.scene)
    bm.verts.ensure_lookup_table()
    new = [bm.verts[0], *bm.verts[-found.added :]]
    assert tree.closest_points(limits_of(hull, bm, *new)).distances.max() < 1e-4
    after = part("features.hull.hull_state").refresh(hull, bpy.context.scene).ship.surface
    distances = tree.closest_points(after.tessellate(10).points).distances
    assert distances.max() == pytest.approx(found.change, rel=0.1)
    assert found.change < 0.025  # of a bowl 6 wide and 0.9 deep


def test_points_that_are_not_parted_stay():
    hull = dome(8)
    bm = edit(hull, 0)
    before = [tuple(vertex.co) for vertex in bm.verts]
    bpy.ops.hull.reduce_valence()
    bm.verts.ensure_lookup_table()
    assert [tuple(bm.verts[index].co) for index in range(1, len(before))] == before[1:]
