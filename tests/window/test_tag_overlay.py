# SPDX-License-Identifier: GPL-3.0-or-later
"""Tags over the 3D view, by the colours that are seen in it."""

import tempfile
from pathlib import Path

import bmesh
import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import bilge_point, editing_a_hull, hull_at_hand, select
from window import FROM_PORT

# Parts of 255 by which a pixel may differ from a colour, each of three.
_NEAR = 12
_FEW = 20  # pixels that may have it by chance


def seen(window, name, group="tags", is_on_light=True):
    """How many pixels of the 3D view have the colour of a tag, or of another group's kind."""
    return int(mask(window, name, group, is_on_light).sum())


def mask(window, name, group, is_on_light):
    """(rows, columns) which pixels of the 3D view have it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "window.png"
        window.screenshot(path)
        image = bpy.data.images.load(str(path))
        width, height = image.size
        pixels = np.array(image.pixels[:]).reshape(height, width, 4)[:, :, :3]
        bpy.data.images.remove(image)
    region = window.region()
    view = pixels[region.y : region.y + region.height, region.x : region.x + region.width]
    colour = np.array(part("bridge.blender.preferences").colour(group, name, is_on_light))
    return np.abs(view - colour).max(axis=2) <= _NEAR / 255.0


def editing_without_lines(window):
    """Only control mesh, surface and tags are to be seen; tags are large."""
    chosen = part("bridge.blender.preferences").of_addon()
    chosen.tag_width, chosen.mark_size = 9.0, 15.0
    hull = editing_a_hull(window)
    window.space.overlay.show_edge_crease = False
    window.space.region_3d.view_distance *= 0.6
    lines = part("features.lines.lines")
    for switch in lines.SWITCHES.values():
        setattr(hull.hull.lines, switch, False)
    return hull


def test_tags_are_seen_in_edit_mode_only(window):
    hull = editing_without_lines(window)
    yield
    kinds = ("knuckle", "border", "irregular")
    counts = [seen(window, kind) for kind in kinds]
    assert min(counts) > 5 * _FEW
    hull.hull.tags.show = False
    window.area.tag_redraw()
    yield
    assert all(seen(window, kind) < _FEW for kind in kinds)
    hull.hull.tags.show = True
    window.press("TAB")
    yield
    assert hull.mode == "OBJECT"
    assert all(seen(window, kind) < _FEW for kind in kinds)


def test_a_switch_takes_its_kind_away(window):
    hull = editing_without_lines(window)
    hull.hull.tags.show_border = False
    yield
    assert seen(window, "border") < _FEW < seen(window, "knuckle")


def test_what_is_hidden_has_no_tags(window):
    editing_without_lines(window)
    yield
    assert seen(window, "border") > 5 * _FEW
    window.press("A")
    window.press("H")
    yield
    assert seen(window, "border") < _FEW


def test_tags_follow_the_mouse_and_undo(window):
    hull = editing_without_lines(window)
    index, place = bilge_point(hull)
    select(hull, index)
    bpy.ops.hull.tag_corner()
    bpy.ops.ed.undo_push(message="corner")
    yield
    before = seen(window, "problem")
    assert before > 5 * _FEW  # without creases it is one, with a ring around it
    window.press("G")
    window.move_by(0, 2000)
    yield
    assert seen(window, "problem") < _FEW
    window.press("ESC")
    yield
    assert seen(window, "problem") == before
    window.undo()
    yield
    assert seen(window, "problem") < _FEW


def test_a_mesh_with_errors_shows_where(window):
    hull = editing_without_lines(window)
    bm = bmesh.from_edit_mesh(hull.data)
    edge = next(edge for edge in bm.edges if len(edge.link_faces) == 2)
    bm.faces.new([*edge.verts, bm.verts.new(edge.verts[0].co * 1.01)])
    bmesh.update_edit_mesh(hull.data)
    window.look(hull, FROM_PORT)
    yield
    hull = hull_at_hand()
    assert state_of(hull).status
    assert seen(window, "problem") > _FEW and seen(window, "border") > 5 * _FEW
