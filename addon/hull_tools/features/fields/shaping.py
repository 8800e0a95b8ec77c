# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls changed by their shape fields."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ..constraints import move_limits
from ..lines import lines
from ..transformation import parents, reports
from . import bases, field_list

# Of the largest shift: residuals beyond it show that the control points are too far apart.
_COARSE = 0.1


@dataclass(frozen=True, eq=False)
class Applied:
    """result: the hull_native.Reshaped; largest_shift: that was wanted of the surface, m."""

    result: object
    largest_shift: float

    @property
    def is_followed(self):
        """Whether the control points could follow what was wanted."""
        return self.result.largest <= _COARSE * self.largest_shift


def apply(obj, scene):
    """Moves a hull's control points so that its surface follows its shape fields; returns
    Applied. ValueError where it cannot be, with the place where it would fold:
    nothing moves then."""
    rows = field_list.in_use(obj)
    parent = parents.of_hull(obj, scene)
    applied = _solve(obj, rows, parent)
    parent.write(scene, applied.result.moves)
    return applied


def summary(applied):
    """What came of fields, as a sentence."""
    text = f"Fields applied: {reports.residual(applied.result)}"
    if applied.is_followed:
        return text
    x, y, z = applied.result.largest_place
    return (
        f"{text}, at x {x:.2f}, y {y:.2f}, z {z:.2f} m: the control points are too far apart to "
        "follow. Undo, then Subdivide Exactly or insert a row there, or take a larger extent"
    )


def _solve(obj, rows, parent):
    hull_native, surface = native.require(), parent.surface
    fields = hull_native.ShapeFields(
        [bases.shape_field(row, obj, surface, parent.scale) for row in rows],
        mirrored=parent.body.mirrored,
    )
    size = lines.size_of(surface)
    found = move_limits.of_hull(obj, parent.control.vertex_ids, parent.control.points, size)
    places = hull_native.SurfacePlaces(surface)
    shifts, gradients = fields.at(places.positions)
    if not shifts.any():
        raise ValueError("The fields shift nothing of the hull: place them nearer or give a shift")
    kept = [places.points_beyond(shifts)]
    kept += [_protected(row, surface, parent.scale) for row in rows]
    found = found.with_locked(np.concatenate(kept))
    reshape = hull_native.Reshape(surface, **found.reshape_arguments(surface), places=places)
    result = reshape.solve(shifts, gradients=gradients)
    if result.folded_place is not None:
        x, y, z = result.folded_place
        raise ValueError(
            f"The surface would fold at x {x:.2f}, y {y:.2f}, z {z:.2f} m: shift less, or make "
            "extent or falloff larger"
        )
    return Applied(result, float(np.linalg.norm(shifts, axis=1).max()))


def _protected(row, surface, scale):
    """Control points of a crease that is kept exactly: it depends on no others."""
    if row.role != "PROTECT" or row.base != "CREASE" or not all(row.axes):
        return np.empty(0, dtype=np.int64)
    return np.asarray(bases.base_crease(row, surface, scale).vertices, dtype=np.int64)
