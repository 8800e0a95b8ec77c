# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls changed by their shape fields."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..hull import hull_state
from ..transformation import reports
from . import base_curves, bases, field_list, led_creases, prepared

# Of the largest shift: residuals beyond it show that the control points are too far apart.
_COARSE = 0.1


@dataclass(frozen=True, eq=False)
class Applied:
    """result: the hull_native.Reshaped; largest_shift: that was wanted of the surface, m;
    crease_distance: of the creases that fields are based on from where they are wanted, m, or
    None."""

    result: object
    largest_shift: float
    crease_distance: float = None

    @property
    def is_followed(self):
        """Whether the control points could follow what was wanted."""
        return self.result.largest <= _COARSE * self.largest_shift


def apply(obj, scene):
    """Moves a hull's control points so that its surface follows its shape fields; returns
    Applied. ValueError where it cannot be, with the place where it would fold:
    nothing moves then."""
    hull_state.up_to_date(obj, scene)
    rows = field_list.in_use(obj)
    own = prepared.of_hull(obj, hull_mesh.read(obj), units.metres_per_unit(scene))
    applied = solve(obj, rows, own)
    if applied is None:
        raise ValueError("The fields shift nothing of the hull: place them nearer or give a shift")
    which, places = moved_points(applied.result.moves, own)
    mesh_points.write(obj.data, which, places)
    hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    return applied


def moved_points(moves, own):
    """(indices (k,) of points of the mesh, their places (k, 3) in Blender's units) after moves
    (n, 3), m, of the control points of a Prepared."""
    moved = np.flatnonzero((moves != 0.0).any(axis=1))
    return own.control.vertex_ids[moved], (own.control.points[moved] + moves[moved]) / own.scale


def summary(applied):
    """What came of fields, as a sentence."""
    text = f"Fields applied: {reports.residual(applied.result)}"
    if applied.crease_distance is not None:
        text += f"; creases off theirs by {units.format_mm(applied.crease_distance)} at most"
    return text if applied.is_followed else f"{text}. {advice(applied)}"


def advice(applied):
    """What to do where control points could not follow, as sentences."""
    x, y, z = applied.result.largest_place
    return (
        f"At x {x:.2f}, y {y:.2f}, z {z:.2f} m the control points are too far apart to follow: "
        "Subdivide Exactly or insert a row there first, or take a larger extent"
    )


def solve(obj, rows, own):
    """What becomes of a hull by these fields, as Applied; None where they shift nothing of it. own:
    the Prepared. ValueError where it cannot be, with the place where it would fold."""
    fields = native.require().ShapeFields(
        [bases.shape_field(row, obj, own) for row in rows], mirrored=True
    )
    shifts, gradients = fields.at(own.field_places)
    if not shifts.any():
        return None
    staying = [own.places.points_beyond(shifts)]
    staying = np.concatenate(staying + [_protected(row, obj, own) for row in rows])
    leading = led_creases.led(rows, fields, own, staying)
    reshape = own.reshape(staying, leading.points)
    result = reshape.solve(shifts, gradients=gradients, prescribed=leading.moves)
    crease_distance = leading.distance
    if result.folded_place is not None and len(leading.points):
        # Points beside a crease may be too far apart to go with it: then it goes with them.
        result = own.reshape(staying, leading.points[:0]).solve(shifts, gradients=gradients)
        crease_distance = led_creases.distance(rows, fields, own, result.moves)
    if result.folded_place is not None:
        x, y, z = result.folded_place
        raise ValueError(
            f"The surface would fold at x {x:.2f}, y {y:.2f}, z {z:.2f} m: shift less, or make "
            "extent or falloff larger"
        )
    largest = float(np.linalg.norm(shifts, axis=1).max())
    return Applied(result, largest, crease_distance)


def _protected(row, obj, own):
    """Control points by which what a row protects stays exactly: of a crease its own, as it depends
    on no others; of faces all that shape them."""
    none = np.empty(0, dtype=np.int64)
    if row.role != "PROTECT" or not all(row.axes):
        return none
    if row.base == "CREASE":
        _, crease = base_curves.base_crease(row, own.surface, own.scale)
        return np.asarray(crease.vertices)
    if row.base != "FACES":
        return none
    is_there = np.isin(own.places.cells, bases.cells_of(obj, row, own.control))
    beyond = own.places.points_beyond(np.where(is_there[:, None], (1.0, 0.0, 0.0), 0.0))
    return np.setdiff1d(np.arange(len(own.control.points)), beyond)
