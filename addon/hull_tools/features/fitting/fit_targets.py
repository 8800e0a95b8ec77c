# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull is fitted to, from Blender's objects: points, and lines for its creases, in metres in
the hull's axes. A half hull takes the mirror image of what is on the other side."""

from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Matrix

from ....hull_io import triangles as shapes
from ...bridge import limits
from ...bridge.objects import hull_objects

# Points along lines: no further apart than this part of the hull's length.
_SPACING = 1.0 / 300.0
# Cosine of the largest angle between the centre line of the target and a border there.
_ALONG = 0.7
_WITH_SHAPE = {"MESH", "CURVE", "SURFACE", "META", "FONT"}


@dataclass(frozen=True, eq=False)
class Target:
    """points (k, 3); normals (k, 3), None for points alone; lines: (n, 3) each, for the creases
    that are nearest; centre: the same on the centre plane."""

    points: np.ndarray
    normals: object
    lines: list
    centre: list


def of_hull(obj, scale, length):
    """The Target of a hull's fit settings; length: the hull's, m. ValueError without one."""
    settings = obj.hull.fit
    if settings.target is None:
        raise ValueError("Choose what the hull is fitted to: a mesh object as Target")
    points, triangles, loose = shape_arrays(settings.target, obj, scale)
    lines, centre, normals = _divided(loose, settings.target, length), [], None
    if not len(triangles):
        points = points[:: max(1, len(points) // settings.samples)]
    else:
        if settings.use_edges:
            edges = shapes.feature_edges(points, triangles, settings.edge_angle)
            lines += _divided(edges, settings.target, length)
            if obj.hull.half:
                centre = _divided(shapes.centre_cut(points, triangles), settings.target, length)
        points, normals = shapes.spread_points(points, triangles, settings.samples)
    if not len(points):
        raise ValueError(f'"{settings.target.name}" has no points to fit to: choose another target')
    if settings.lines is not None:
        places, faces, loose = shape_arrays(settings.lines, obj, scale)
        edges = loose if not len(faces) else np.concatenate([loose, _sides(places, faces)])
        lines += _divided(edges, settings.lines, length)
    if obj.hull.half:
        points, normals, lines = _on_port_side(points, normals, lines)
    return Target(points, normals, lines, centre)


def _divided(edges, obj, length):
    """Lines along edges (k, 2, 3) of an object, for a hull of this length."""
    spacing = _SPACING * length
    count = np.ceil(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1) / spacing).sum()
    if count > limits.MOST_FIT_LINE_POINTS:
        raise ValueError(
            f'The edges of "{obj.name}" are {count / len(edges) * _SPACING:.3g} times as long as '
            f"the hull on average, {len(edges)} of them: bring it to the hull's size"
        )
    return shapes.divided(edges, spacing)


def centre_curves(target, curves, reach):
    """What of a target's centre line the borders on the centre plane can follow, as curves of
    hull_native.fit_surface; curves: those of the surface."""
    found = []
    for chain, curve in enumerate(curves):
        if np.abs(curve.control_points[:, 1]).max() > 0.0:
            continue
        t = np.linspace(0.0, curve.edge_count, 1 + 8 * curve.edge_count)
        points, tangents = curve.evaluate(t, 1)
        tangents /= np.maximum(np.linalg.norm(tangents, axis=1), np.finfo(float).tiny)[:, None]
        for line in target.centre:
            away = np.linalg.norm(points - line.mean(axis=0), axis=1)
            near = int(np.argmin(away))
            along = line[-1] - line[0]
            if away[near] > reach or abs(along @ tangents[near]) < _ALONG * np.linalg.norm(along):
                continue
            found.append((line, chain, False))
    return found


def _on_port_side(points, normals, lines):
    is_mirrored = points[:, 1] < 0.0
    points = np.where(is_mirrored[:, None], points * [1.0, -1.0, 1.0], points)
    if normals is not None:
        normals = np.where(is_mirrored[:, None], normals * [1.0, -1.0, 1.0], normals)
    lines = [line * [1.0, -1.0, 1.0] if line[:, 1].mean() < 0.0 else line for line in lines]
    return points, normals, lines


def shape_arrays(obj, hull, scale):
    """(points (n, 3), triangles (m, 3), edges without faces (k, 2, 3)) of an object as the view
    shows it, on the axes of a hull, or with None those of the scene; m. ValueError where it has no
    shape, was deleted, has points that are no numbers, or modifiers that Blender does not
    compute."""
    if obj.type not in _WITH_SHAPE:
        raise ValueError(f'"{obj.name}" has no shape: choose a mesh')
    if not obj.users_scene:  # a setting keeps what was deleted
        raise ValueError(f'"{obj.name}" is in no scene any longer: choose another mesh')
    depsgraph = bpy.context.evaluated_depsgraph_get()
    shown = obj.evaluated_get(depsgraph)
    if not obj.visible_get() and _is_without_modifiers(obj, shown, depsgraph):
        raise ValueError(
            f'The modifiers of "{obj.name}" do not count while it is disabled in viewports, or not '
            "in this view layer: show it in the outliner, or apply them"
        )
    mesh = shown.to_mesh()
    try:
        points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
        mesh.vertices.foreach_get("co", points.reshape(-1))
        mesh.calc_loop_triangles()
        triangles = np.empty((len(mesh.loop_triangles), 3), dtype=np.int32)
        mesh.loop_triangles.foreach_get("vertices", triangles.reshape(-1))
        edges = np.empty((len(mesh.edges), 2), dtype=np.int32)
        mesh.edges.foreach_get("vertices", edges.reshape(-1))
        loops = np.empty(len(mesh.loops), dtype=np.int32)
        mesh.loops.foreach_get("edge_index", loops)
    finally:
        shown.to_mesh_clear()
    frame = Matrix() if hull is None else hull_objects.from_world(hull)
    matrix = np.array(frame @ obj.matrix_world, dtype=np.float64)
    points = scale * (points.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3])
    if not np.isfinite(points).all():
        raise ValueError(f'"{obj.name}" has points without a place: delete them')
    is_loose = np.ones(len(edges), dtype=bool)
    is_loose[loops] = False
    if np.linalg.det(matrix[:3, :3]) < 0.0:
        triangles = triangles[:, ::-1]
    return points, triangles, points[edges[is_loose]]


def _is_without_modifiers(obj, shown, depsgraph):
    """Whether Blender has not computed the modifiers that a mesh object has."""
    if obj.type != "MESH" or not any(modifier.show_viewport for modifier in obj.modifiers):
        return False
    return not shown.is_evaluated or shown.data == obj.data.evaluated_get(depsgraph)


def _sides(points, triangles):
    """(k, 2, 3) all sides of the triangles."""
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    return points[np.unique(np.sort(sides, axis=1), axis=0)]
