# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull shown as its shape fields make it while they are changed: surface, lines and numbers
follow as they do when points are moved. Where the points were is kept with the mesh."""

from dataclasses import dataclass, replace

import numpy as np

from ...bridge.blender import units
from ...bridge.mesh import mesh_points, start_points
from ...bridge.objects import hull_mesh
from ..hull import hull_state
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


def _values(obj):
    """All of the fields that a preview goes by; bases that are Blender curves by what they show."""
    return tuple(
        (
            *(field.use, field.role, field.base, tuple(field.place), field.axis, field.extent),
            *(field.falloff, tuple(field.shift), tuple(field.axes)),
            None if field.curve is None else field.curve.name_full,
        )
        for field in obj.hull.fields.fields
    )
