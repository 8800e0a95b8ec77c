# SPDX-License-Identifier: GPL-3.0-or-later
"""While a mesh is under construction a quiet line says why the surface is that of before."""

import bmesh
import bpy
from addon_under_test import add_hull, mesh_points, part, state_of


def line_of(hull):
    return part("overlays.status").status_line(hull)


def update(hull):
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()


def test_errors_come_and_go_with_the_mesh():
    hull = add_hull()
    assert line_of(hull) == "" and line_of(None) == ""
    before, surface = mesh_points(hull.hull.surface_object), state_of(hull).ship.surface
    lines = {kind: group.polylines for kind, group in state_of(hull).lines.groups.items()}
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(hull.data)
    bm.verts.ensure_lookup_table()
    aft, forward = bm.verts[2], bm.verts[6]
    fins = [bm.verts.new((5.0, 4.0, z)) for z in (0.0, 2.0)]
    for fin in fins:
        bm.faces.new((aft, forward, fin))
    update(hull)
    text = line_of(hull)
    assert text.startswith("The surface waits for the mesh: ") and state_of(hull).status in text
    assert state_of(hull).ship.surface is surface
    assert mesh_points(hull.hull.surface_object).tolist() == before.tolist()
    assert {k: g.polylines for k, g in state_of(hull).lines.groups.items()}.keys() == lines.keys()
    bmesh.ops.delete(bm, geom=fins)
    update(hull)
    assert line_of(hull) == ""
    assert mesh_points(hull.hull.surface_object).tolist() == before.tolist()


def test_a_long_text_ends_at_a_word():
    shortened = part("overlays.status").shortened
    assert shortened("a mesh", 6, len) == "a mesh"
    assert shortened("an edge of three faces", 12, len) == "an edge of…"
    assert shortened("unbreakable", 3, len) == "unbreakable…"
