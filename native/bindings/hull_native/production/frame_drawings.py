# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of frames: the hull's section inside the shell's thickness."""

import numpy as np

from .._core import SurfaceTree, sections
from .._drawing import ShopDrawing

# Rounds to the point whose inner side is in the frame's plane, and what is left, of the size.
_ROUNDS, _LEFT = 40, 1e-10
# How near the inner side may be to the shell, of the thickness less than that, and of the size.
_NEAR, _BESIDE = 1e-3, 1e-6
# Of the thickness: points of the inner side that are so far from the frame's plane are not in it.
_OFF_PLANE = 0.1


def inside_points(surface, tree, points, cells, uv, thickness):
    """Points (k, 3) in the plane x = const. of `points`, at `thickness` (m) from the surface inward
    along its normals: the section of the inner side of a shell that lies inside the surface."""
    if thickness == 0.0:
        return points
    wanted = points[:, 0]
    feet, normals = points, surface.normals(cells, uv)
    for _ in range(_ROUNDS):
        inner = feet - thickness * normals
        off = wanted - inner[:, 0]
        if np.abs(off).max() <= _LEFT * tree_size(surface):
            break
        # Along the surface where x changes most.
        slope = 1.0 - normals[:, 0] ** 2
        step = np.where(slope > 1e-6, off / np.maximum(slope, 1e-6), 0.0)
        way = np.array([1.0, 0.0, 0.0]) - normals[:, :1] * normals
        found = tree.closest_points(feet + step[:, None] * way)
        feet, normals = found.points, surface.normals(found.cells, found.uv)
    return feet - thickness * normals


def tree_size(surface):
    """The diagonal of the box around the control points, m."""
    points = np.asarray(surface.mesh.points)
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def frame_lines(surface, x, *, thickness=0.0, tolerance=None, tree=None):
    """(outer, inner): lists of (k, 2) arrays, (y, z) in m, of the section at x and of the inner
    side of the shell's thickness (m) there, without places that have no inner side in the frame's
    plane, as beside ends of the hull. ValueError where the frame is off the hull, for a
    thickness below 0, and for one that leaves no room within the frame: no point of the inner side
    is as far as that from all of the shell, on the frame's own side of the centre plane. tree: the
    surface's SurfaceTree, for many frames; ValueError for one that is not of it as it is."""
    if not np.isfinite(x):
        raise ValueError(f"A frame's x must be a finite number of metres, not {x:g}.")
    if not (np.isfinite(thickness) and thickness >= 0.0):
        raise ValueError(f"The shell's thickness must be 0 m or more, not {thickness:g}.")
    (cut,) = sections(surface, [[1.0, 0.0, 0.0, x]], tolerance)
    if not cut:
        raise ValueError(f"A frame at x = {x:g} m is off the hull.")
    outer, inner, has_room = [], [], False
    if tree is None:
        tree = SurfaceTree(surface) if thickness > 0.0 else None
    else:
        _require_of(surface, tree, cut, x)
    for curve in cut:
        for stretch in curve.stretches:
            first = stretch.first
            at = slice(first, first + len(stretch.points))
            outer.append(stretch.points[:, 1:])
            if thickness > 0.0:
                # Within a stretch, so that normals at its ends are its own.
                cells, uv = curve.cells[at], curve.uv[at]
                points = inside_points(surface, tree, stretch.points, cells, uv, thickness)
                has_room = has_room or _is_inside(surface, tree, points, x, thickness)
                in_plane = np.abs(points[:, 0] - x) < _OFF_PLANE * thickness
                if in_plane.sum() > 1:
                    inner.append(points[in_plane, 1:])
    if thickness > 0.0 and not has_room:
        raise ValueError(
            f"The frame at x = {x:g} m has no room for a shell {thickness:g} m thick: give its "
            "thickness in metres, or another frame."
        )
    return outer, inner


def _require_of(surface, tree, cut, x):
    points = np.concatenate([curve.points for curve in cut])
    if tree.closest_points(points).distances.max() > _BESIDE * tree_size(surface):
        raise ValueError(
            f"The tree is not of the surface as it is at x = {x:g} m: the surface's points were "
            "set since, or it is another's. Call its refit() first."
        )


def _is_inside(surface, tree, points, x, thickness):
    """Whether any of points (k, 3) of the inner side is in the plane at x, on the same side of the
    centre plane as a half hull, and no nearer to the shell than the thickness, m."""
    slack = _BESIDE * tree_size(surface)
    y = surface.mesh.points[:, 1]
    is_port, is_starboard = y.min() > -slack, y.max() < slack
    kept = np.abs(points[:, 0] - x) < _NEAR * thickness + slack
    if is_port or is_starboard:
        kept &= (1.0 if is_port else -1.0) * points[:, 1] > 0.0
    points = points[kept]
    if not len(points):
        return False
    apart = tree.closest_points(points).distances
    return bool((apart > (1.0 - _NEAR) * thickness - slack).any())


def frame_drawing(
    surface, x, *, name, mirrored, thickness=0.0, waterlines=(), marks=(), tolerance=2e-4, tree=None
):
    """The ShopDrawing of the frame at x (m), seen from aft, port to the left: the inner side of the
    shell where it has a thickness (m) as the frame's outline, the section itself, base line and
    centre line. mirrored: the surface is the port half, and both sides are drawn.

    waterlines: heights (m) that are drawn across. marks: curves (SurfaceCurve) such as seams,
    drawn where they cross the frame. tolerance: how far chords may be from the curves, m.
    ValueError as frame_lines(), for heights that are not finite, and for marks that are not on the
    surface as it is.
    """
    for curve in marks:
        if not curve.is_on(surface):
            raise ValueError(
                f'The mark "{curve.name}" is not on the surface as it is: make the curve anew.'
            )
    if not np.isfinite(np.asarray(waterlines, dtype=float)).all():
        raise ValueError("The heights of waterlines on a frame's drawing must be finite numbers.")
    outer, inner = frame_lines(surface, x, thickness=thickness, tolerance=tolerance, tree=tree)
    sides = (1.0, -1.0) if mirrored else (1.0,)
    rows = [("x", f"{x:.3f} m")]
    if thickness > 0.0:
        rows.append(("Shell thickness", f"{1000.0 * thickness:g} mm"))
    drawing = ShopDrawing(f"Frame {name}", rows)
    points = np.concatenate(outer)
    breadth, low, high = np.abs(points[:, 0]).max(), points[:, 1].min(), points[:, 1].max()

    def put(layer, line, side=1.0):
        drawing.add_line(layer, 1000.0 * np.asarray(line) * [-side, 1.0])

    for side in sides:
        for line in inner or outer:
            put("OUTLINE", line, side)
        for line in outer if inner else ():
            put("BASE", line, side)
        for curve in marks:
            for at in crossings(curve, x):
                _put_mark(drawing, at, curve.name, side)
    reach = breadth + 0.15
    put("BASE", [[0.0, min(low, 0.0) - 0.1], [0.0, high + 0.15]])
    put("BASE", [[-reach, 0.0], [reach, 0.0]])
    drawing.add_text("BL", (1000.0 * reach, 12.0), size=6.0)
    drawing.add_text("CL", (0.0, 1000.0 * high + 165.0), size=6.0)
    for z in waterlines:
        if low < z < high and abs(z) > 1e-9:
            put("WATERLINES", [[-reach, z], [reach, z]])
            drawing.add_text(f"WL {z:g}", (1000.0 * reach, 1000.0 * z + 12.0), size=6.0)
    return drawing


def crossings(curve, x):
    """Points (k, 2), (y, z), where a SurfaceCurve crosses the plane x, on its chords."""
    points = curve.points
    found = []
    for a, b in zip(points[:-1], points[1:]):
        if (a[0] < x) != (b[0] < x):
            found.append((a + (x - a[0]) / (b[0] - a[0]) * (b - a))[1:])
    return found


def _put_mark(drawing, at, name, side):
    y, z = -1000.0 * side * at[0], 1000.0 * at[1]
    drawing.add_line("SEAMS", [(y - 15.0, z), (y + 15.0, z)])
    drawing.add_line("SEAMS", [(y, z - 15.0), (y, z + 15.0)])
    if name:
        drawing.add_text(name, (y, z + 25.0), size=5.0)
