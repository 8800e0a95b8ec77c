# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull shown as its shape fields make it while they are changed: surface, lines and numbers
follow as they do when points are moved. Where the points were is kept with the mesh."""

from dataclasses import dataclass, replace

import numpy as np

from ...bridge.blender import units
from ...bridge.mesh import mesh_points, start_points
from ...bridge.objects import curve_lines, field_faces, field_rows, hull_mesh, hull_objects
from ..hull import hull_state
from ..modelling import exact_subdivision
from . import field_list, prepared, shaping

_FOREIGN = (
    "Points or faces were changed while the fields are previewed: Apply keeps the hull as it is, "
    "or undo"
)


@dataclass
class Preview:
    """Of a hull that is previewed. applied: the shaping.Applied that is shown, None where fields
    shift nothing; problem: why the hull does not show the fields as they are, or ""."""

    applied: object = None
    problem: str = ""
    key: tuple = None  # what the hull was shown for
    shown: bytes = None  # the digest of its points then, which undo takes back alone
    own: object = None  # the Prepared


def of_hull(obj):
    """The Preview of a hull, None where it is not previewed."""
    state = hull_state.state_of(obj)
    return state.of(Preview) if state is not None and obj.hull.fields.is_previewed else None


def begin(obj, scene):
    """Shows the hull as its fields make it from now on, as they are changed."""
    hull_state.up_to_date(obj, scene)
    found = hull_mesh.read(obj)
    start_points.keep(obj.data, found.data.points)
    start_points.set_shown(obj.data, found.points_digest)
    obj.hull.fields.is_previewed = True
    of_hull(obj).key = None  # of a preview before, which showed the same
    follow(obj, scene)


def follow(obj, scene):
    """Brings the mesh of a hull that is previewed up to date with its fields, where they changed.
    What cannot be leaves it as it is, with a problem."""
    preview = of_hull(obj)
    if preview is None:
        return
    start = start_points.read(obj.data)
    if start is None:  # the mesh is another one now
        obj.hull.fields.is_previewed = False
        return
    found, scale = hull_mesh.read(obj), units.metres_per_unit(scene)
    if not start_points.are_as_shown(obj.data, found.points_digest):
        preview.problem, preview.key = _FOREIGN, None
        return
    key = (_values(obj), start.tobytes(), found.topology_key, scale)
    if (preview.key, preview.shown) == (key, found.points_digest):
        return
    preview.key, preview.shown, preview.problem = key, found.points_digest, ""
    try:
        at_start = found.with_points(replace(found.data, points=start))
        preview.own = prepared.of_hull(obj, at_start, scale, preview.own)
        preview.applied = _solved(obj, preview.own)
    except ValueError as error:
        preview.problem = str(error)
        return
    _show(obj, scene, start, preview)


def end(obj, scene, is_kept):
    """Ends the preview; is_kept: the hull stays as it is shown, else all its points are where they
    were before, bit by bit. ValueError where points were changed by something else since then and
    would be lost."""
    start, found = start_points.read(obj.data), hull_mesh.read(obj)
    if start is not None and not is_kept:
        if not start_points.are_as_shown(obj.data, found.points_digest):
            raise ValueError(_FOREIGN)
        mesh_points.write(obj.data, np.arange(len(start)), start)
    start_points.forget(obj.data)
    obj.hull.fields.is_previewed = False
    hull_state.follow_edit(obj, scene, is_by_hand=False)


def _solved(obj, own):
    try:
        rows = field_list.in_use(obj)
    except ValueError:  # none shifts: the hull is shown as it was
        return None
    return shaping.solve(obj, rows, own)


def _show(obj, scene, start, preview):
    points = start.astype(np.float64)
    if preview.applied is not None:
        which, places = shaping.moved_points(preview.applied.result.moves, preview.own)
        points[which] = places
    mesh_points.write(obj.data, np.arange(len(points)), points)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    preview.shown = hull_mesh.read(obj).points_digest
    start_points.set_shown(obj.data, preview.shown)


def subdivide(obj, scene):
    """Subdivides the start of a hull that is previewed exactly, so that it has more control points
    to follow its fields, and previews it again; returns the exact_subdivision.Subdivided.
    ValueError where that cannot be: the preview stays then."""
    end(obj, scene, is_kept=False)
    try:
        return exact_subdivision.subdivide(obj, scene)
    finally:
        begin(obj, scene)


def based_on(changed, objects):
    """The hulls among objects that are previewed with fields whose curves are among changed
    ones."""
    curves = {obj for obj in changed if obj.type == "CURVE"}
    if not curves:  # as at nearly every change
        return []
    hulls = [obj for obj in hull_objects.hulls(objects) if obj.hull.fields.is_previewed]
    return [obj for obj in hulls if any(map(curves.intersection, _curves_of(obj)))]


def _curves_of(obj):
    return ({field.curve, field.becomes} for field in obj.hull.fields.fields)


def _values(obj):
    """All of the fields that a preview goes by; curves and faces by what they are now."""
    return tuple(_values_of(field, obj) for field in obj.hull.fields.fields)


def _values_of(field, obj):
    return (
        *(field.use, field.role, field.base, tuple(field.place), field.axis, field.extent),
        *(field.falloff, tuple(field.shift), tuple(field.axes), field.varies, field.extent_end),
        *(field.falloff_end, tuple(field.shift_end), field_rows.goes_along_surface(field)),
        _points_of(field.curve, obj) if field.base == "CURVE" else None,
        _points_of(field.becomes, obj) if field_rows.becomes_another(field) else None,
        field_faces.of_field(obj, field).tobytes() if field.base == "FACES" else None,
    )


def _points_of(curve, obj):
    """Equal for a curve object that shows the same; of one that is no line its name."""
    if curve is None:
        return None
    try:
        points, is_closed = curve_lines.points_of(curve, obj)
    except ValueError:
        return curve.name_full
    return points.tobytes(), is_closed
