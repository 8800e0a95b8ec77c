# SPDX-License-Identifier: GPL-3.0-or-later
"""Control nets in a colour of their own: Blender draws them as black as stations.

What is selected stays in Blender's colours of what is selected; in edit mode knuckles, borders and
the deck edge stay in those of tagged edges, too.
"""

import weakref

import bmesh
import gpu
import numpy as np

from ..bridge.blender import blender_versions, preferences
from ..bridge.mesh import face_sides
from ..features.hull import tags
from . import buffers, line_arrays
from .lines import batch_of_strokes
from .view import Handler, hulls_in_view

_WIDTH = 1.6  # dots: a little wider than Blender's own line, which it hides
# By HullState: (key of what is drawn, (GPUBatch of lines, of points)).
_batches = weakref.WeakKeyDictionary()
_untagged = weakref.WeakKeyDictionary()  # by features.hull.tags.Tags: edges (k, 2)


def edges_of(mesh):
    """(k, 2) all edges of a hull_native.ControlMesh."""
    sides = face_sides.ends_of_sides(mesh.face_sizes, mesh.face_vertices)
    return np.unique(np.sort(sides, axis=1), axis=0)


def edited_edges(bm, in_vertices, state):
    """(k, 2) the edges of a hull's shell that its net's colour is for while the hull is edited as a
    BMesh: those without tags that are neither hidden nor selected, nor in vertices' select mode on
    the way to a selected vertex. None where the mesh is not that of the HullState."""
    known = None if state.status else tags.of_state(state)
    if known is None or known.vertex_ids[-1] >= len(bm.verts):
        return None
    if known not in _untagged:
        mesh = state.ship.surface.mesh
        tagged = np.sort(np.concatenate(list(known.edges.values())), axis=1)
        _untagged[known] = _without(edges_of(mesh), tagged, len(mesh.points))
    edges = _untagged[known]
    selected, hidden = (
        np.array([getattr(vertex, name) for vertex in bm.verts], dtype=bool)[known.vertex_ids][
            edges
        ]
        for name in ("select", "hide")
    )
    is_selected = selected.any(axis=1) if in_vertices else selected.all(axis=1)
    return edges[~is_selected & ~hidden.any(axis=1)]


def _without(edges, others, count):
    """Edges (k, 2) of points below a count, the lower first, that are not among others."""
    keys = (pairs[:, 0].astype(np.int64) * count + pairs[:, 1] for pairs in (edges, others))
    return edges[~np.isin(*keys)]


def _draw():
    for shown in hulls_in_view():
        drawn = _drawn(shown)
        if drawn is None:
            continue
        lines, points = _batches_of(shown.state, *drawn)
        gpu.state.depth_test_set("NONE" if shown.hull.show_in_front else "LESS_EQUAL")
        with gpu.matrix.push_pop():
            gpu.matrix.load_matrix(shown.to_view())
            if lines is not None:
                _draw_lines(shown, lines)
                _draw_points(shown, points)
        gpu.state.depth_test_set("NONE")


def _draw_lines(shown, batch):
    shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
    shader.bind()
    shader.uniform_float("viewportSize", gpu.state.viewport_get()[2:])
    colour = preferences.colours("net", shown.is_on_light)["net"]
    shader.uniform_float("color", (*colour, 1.0))
    shader.uniform_float("lineWidth", _WIDTH * shown.context.preferences.system.pixel_size)
    batch.draw(shader)


def _draw_points(shown, batch):
    """The points that are edited one by one, as Blender draws them: lines cover its own."""
    context = shown.context
    if shown.hull.mode != "EDIT" or not context.tool_settings.mesh_select_mode[0]:
        return
    theme, shader = context.preferences.themes[0].view_3d, _point_shader()
    shader.bind()
    shader.uniform_float("color", (*theme.vertex, 1.0))
    gpu.state.point_size_set(theme.vertex_size * context.preferences.system.pixel_size)
    batch.draw(shader)
    gpu.state.point_size_set(1.0)


def _point_shader():
    return blender_versions.builtin_shader("UNIFORM_COLOR")


def _drawn(shown):
    """(key, function without arguments → edges (k, 2)) of what is drawn of a HullInView; None where
    it is nothing."""
    hull, state = shown.hull, shown.state
    if hull.mode == "EDIT":
        in_vertices = shown.context.tool_settings.mesh_select_mode[0]
        edges = edited_edges(bmesh.from_edit_mesh(hull.data), in_vertices, state)
        return None if edges is None else (edges.tobytes(), lambda: edges)
    if hull.mode != "OBJECT" or hull.display_type != "WIRE" or hull.select_get():
        return None
    return b"", lambda: edges_of(state.ship.surface.mesh)


def _batches_of(state, key, edges):
    """(lines, points), both None where there are none."""
    key = key, state.ship.geometry_key
    known = _batches.get(state)
    if known is None or known[0] != key:
        points, segments = state.ship.surface.mesh.points.astype(np.float32), edges()
        strokes = line_arrays.Strokes(points, segments.astype(np.int32))
        shader = blender_versions.builtin_shader("POLYLINE_UNIFORM_COLOR")
        lines, ends = batch_of_strokes(strokes, shader), points[np.unique(segments)]
        known = key, (lines, lines and buffers.batch(_point_shader(), "POINTS", pos=ends))
        _batches[state] = known
    return known[1]


_handler = Handler(_draw, "POST_VIEW")
register = _handler.register


def unregister():
    _handler.unregister()
    _batches.clear()
    _untagged.clear()
