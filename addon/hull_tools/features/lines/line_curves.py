# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines as Blender's curves, to render and to model by: one object for each kind, thin tubes of its
colour, in a collection of the hull's own. They stay as they are when the hull changes.

A cubic B-spline is a chain of Bézier curves, which Blender has; its own B-splines have no knots of
their own.
"""

import bpy
import numpy as np

from ...bridge import native
from ..surface import materials
from . import lines

# The tubes' radius as a part of the hull's length: a pencil line seen from a ship's length away.
_LINE_RADIUS = 6e-4

# Of the kinds of lines, in lists and files.
LAYER_NAMES = {
    "station": "stations",
    "waterline": "waterlines",
    "buttock": "buttocks",
    "diagonal": "diagonals",
    "plane": "planes",
    "draft": "design waterline",
    "flat": "flats",
    "feature": "knuckles and borders",
}


def make_curves(obj, surface, groups, metres_per_unit, as_splines):
    """Makes curves of these lines.Group of a hull's surface in place of those that there are.

    as_splines: as Bézier curves within the tolerance of splines; else as polylines. Returns how
    many curves there are.
    """
    radius = _LINE_RADIUS * lines.size_of(surface)
    # All of them first: where one cannot be had the curves that there are stay.
    found = [(group, chains_of(surface, group, as_splines)) for group in groups]
    collection = _emptied_collection(obj)
    count = 0
    for group, chains in found:
        if not chains:
            continue
        name = f"{obj.name} {LAYER_NAMES[group.kind]}"
        curve = new_curve(name, chains, radius, metres_per_unit, as_splines)
        curve.materials.append(materials.line_material(group.kind))
        shown = bpy.data.objects.new(curve.name, curve)
        shown.parent = obj
        collection.objects.link(shown)
        count += len(chains)
    return count


def chains_of(surface, group, as_splines):
    """The lines of a group, both sides of the hull, in m: points (k, 3), or as_splines (k, 3, 3)
    left handle, point and right handle."""
    chains = _splines_of(surface, group) if as_splines else _polylines_of(group)
    if group.is_mirrored:
        on_plane = native.require().tolerances.ON_CENTRE_PLANE
        return _with_images(chains, on_plane * surface.mesh.size)
    return chains


def new_curve(name, chains, radius, metres_per_unit, as_splines):
    """A curve of chains_of a group: tubes of this radius in m."""
    curve = bpy.data.curves.new(name, "CURVE")
    curve.dimensions = "3D"
    curve.bevel_resolution = 1
    curve.bevel_depth = radius / metres_per_unit
    write_chains(curve, chains, metres_per_unit, as_splines)
    return curve


def write_chains(curve, chains, metres_per_unit, as_splines):
    """Gives a curve these chains_of a group in place of what it had."""
    curve.splines.clear()
    for points in chains:
        _add_chain(curve, points / metres_per_unit, as_splines)


def _emptied_collection(obj):
    """The collection of a hull's curves, in that of the hull, without those of before."""
    collection = obj.hull.lines.curves
    if collection is None or _belongs_to_another(collection, obj):
        collection = bpy.data.collections.new(f"{obj.name} lines")
        obj.hull.lines.curves = collection
    if not _is_in_a_scene(collection):
        obj.users_collection[0].children.link(collection)
    for old in [one for one in collection.objects if one.parent == obj and one.type == "CURVE"]:
        curve = old.data
        bpy.data.objects.remove(old)
        if not curve.users:
            bpy.data.curves.remove(curve)
    return collection


def _is_in_a_scene(collection):
    return any(collection in scene.collection.children_recursive for scene in bpy.data.scenes)


def _belongs_to_another(collection, obj):
    """A copy of a hull points to the first one's collection."""
    return collection.library is not None or any(
        other is not obj and other.hull.lines.curves == collection
        for other in bpy.data.objects
        if other.type == "MESH" and other.hull.is_hull
    )


def _polylines_of(group):
    return list(group.polylines)


def _with_images(chains, tolerance):
    images = [lines.mirror_image(points) for points in chains if _is_off(points, tolerance)]
    return chains + images


def _is_off(points, tolerance):
    return lines.is_off_centre(points.reshape(-1, 3), tolerance)


def _splines_of(surface, group):
    """Chains (k, 3, 3) of left handle, point and right handle, in m."""
    hull_native = native.require()
    chains = []
    if group.sections:
        found = hull_native.section_splines(
            surface,
            np.array([section.cut.plane for section in group.sections]),
            flat_tolerance=lines.flat_tolerance(surface),
        )
        for section, branches in zip(group.sections, found):
            for spline in (one for branch in branches for one in branch.splines):
                knots = bezier_knots(spline.knots, spline.control_points)
                chains += section.parts(knots[:, 1], knots)
    chains += [cubic_knots(one.cubics) for one in lines.flat_borders(surface, group.kind)]
    if group.kind == "feature":
        chains += [
            bezier_knots(curve.knots, curve.control_points)
            for curve in hull_native.crease_curves(surface)
        ]
    return chains


def cubic_knots(cubics):
    """(left handle, point, right handle) of a chain of Bézier cubics (m, 4, 3), (m + 1, 3, 3)."""
    points = np.concatenate([cubics[:, 0], cubics[-1:, 3]])
    before = np.concatenate([cubics[:1, 0], cubics[:, 2]])
    after = np.concatenate([cubics[:, 1], cubics[-1:, 3]])
    return np.stack([before, points, after], axis=1)


def bezier_knots(knots, control_points):
    """(left handle, point, right handle) at the knots of a cubic B-spline, (k, 3, 3), of Bézier
    curves that are the same curve."""
    inner = np.unique(knots[3:-3])
    points = _de_boor(knots, control_points, 3, inner)
    # The derivative is a quadratic B-spline; it is continuous where a knot is simple.
    spans = knots[4:-1] - knots[1:-4]
    slopes = 3.0 * np.diff(control_points, axis=0) / np.where(spans > 0.0, spans, 1.0)[:, None]
    slopes = _de_boor(knots[1:-1], slopes, 2, inner)
    steps = np.diff(inner)[:, None] / 3.0
    before, after = np.concatenate([steps[:1], steps]), np.concatenate([steps, steps[-1:]])
    return np.stack([points - before * slopes, points, points + after * slopes], axis=1)


def _de_boor(knots, control_points, degree, parameters):
    """Points of a B-spline at parameters within its range, by de Boor's algorithm."""
    last = len(control_points) - 1
    spans = np.clip(np.searchsorted(knots, parameters, side="right") - 1, degree, last)
    corners = [control_points[spans - degree + j] for j in range(degree + 1)]
    for level in range(1, degree + 1):
        for j in range(degree, level - 1, -1):
            low = knots[spans - degree + j]
            high = knots[spans + 1 + j - level]
            part = ((parameters - low) / (high - low))[:, None]
            corners[j] = (1.0 - part) * corners[j - 1] + part * corners[j]
    return corners[degree]


def _add_chain(curve, points, as_splines):
    if as_splines:
        _add_bezier(curve, points)
    else:
        _add_polyline(curve, points)


def _add_polyline(curve, points):
    is_closed = len(points) > 2 and np.array_equal(points[0], points[-1])
    points = points[:-1] if is_closed else points
    spline = curve.splines.new("POLY")
    spline.points.add(len(points) - 1)
    co = np.ones((len(points), 4), dtype=np.float32)
    co[:, :3] = points
    spline.points.foreach_set("co", co.reshape(-1))
    spline.use_cyclic_u = is_closed
    spline.use_smooth = True


def _add_bezier(curve, knots):
    spline = curve.splines.new("BEZIER")
    spline.bezier_points.add(len(knots) - 1)
    # Free first: other handles would move when their points do.
    for name in ("handle_left_type", "handle_right_type"):
        spline.bezier_points.foreach_set(name, [0] * len(knots))
    for index, name in enumerate(("handle_left", "co", "handle_right")):
        co = np.ascontiguousarray(knots[:, index], dtype=np.float32)
        spline.bezier_points.foreach_set(name, co.reshape(-1))
    spline.use_smooth = True
