# SPDX-License-Identifier: GPL-3.0-or-later
"""Selected rows of faces between two knuckles become developable regions; how developable they
are."""

from dataclasses import dataclass
from math import degrees, inf, radians
from weakref import WeakKeyDictionary

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.counts import counted
from ...bridge.mesh import mesh_points
from ..constraints import developables, move_limits
from ..hull import hull_state
from . import flat_making

# Of each ruled face so many intervals between the rulings that are shown.
_SHOWN = 3
# By the surface, what was found of its regions, with what it was found from.
_known = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class RegionWarp:
    """A developables.Region with its largest warp, degrees/m, infinite where rulings have no
    length; rulings (k, 2, 3), m, and warps (k,) of their faces; problem: why it has none, or ""."""

    region: object
    warp: float
    rulings: np.ndarray
    warps: np.ndarray
    problem: str = ""


def make_developable(obj, scene, warp, distance, keep=True):
    """Moves points of the knuckles beside the selected faces until no ruling between them has more
    warp, degrees/m, while knuckles stay within a distance, Blender's units, of where they are; the
    faces are a region that is kept so. Returns a text.

    ValueError without faces, and for those that are no row between two knuckles.
    """
    state = hull_state.up_to_date(obj, scene)
    scale = units.metres_per_unit(scene)
    faces = flat_making.selected_faces(obj.data)
    control = state.ship.source.control
    own = np.flatnonzero(np.isin(control.face_ids, faces))
    surface = state.ship.source.new_surface()
    row = native.require().RuledRow(surface, own)
    limits = move_limits.of_hull(obj, control.vertex_ids, control.points)
    made = row.develop(
        radians(warp),
        distance * scale,
        locked=limits.locked,
        held_points=limits.held_points,
        held_normals=limits.held_normals,
    )
    shifts = np.linalg.norm(made.points - np.asarray(surface.mesh.points), axis=1)
    moved = np.flatnonzero(shifts > 0.0)
    mesh_points.write(obj.data, control.vertex_ids[moved], made.points[moved] / scale)
    developables.mark(obj, faces, warp * scale, distance, keep)
    hull_state.follow_edit(obj, scene)
    text = f"Warp {_text(made.after)} at most, {_text(made.before)} before"
    if len(moved):
        text += f"; {counted(len(moved), 'point')} moved, knuckles by up to "
        text += units.format_value(scene, made.distance, "m")
    if not made.reached:
        text += f". {warp:.3g}°/m can't be had within that distance: allow more"
    return text


def _text(warp):
    return f"{degrees(warp):.3g}°/m"


def release_selected(obj):
    """The selected faces, or those at selected points, are of no developable region any longer;
    returns how many were."""
    own = flat_making.selected_of(obj, developables.regions(obj))
    if not len(own):
        raise ValueError("None of the selected faces is of a developable region")
    developables.release(obj, own)
    return len(own)


def warps(obj, state):
    """The RegionWarps of a hull by its HullState, none where nothing is known."""
    regions = developables.regions(obj)
    if not regions or state is None or state.ship.surface is None or state.status:
        return []
    key = (
        state.ship.geometry_key,
        tuple((r.number, r.warp, r.distance, r.kept, r.faces.tobytes()) for r in regions),
    )
    known = _known.get(state.ship.surface)
    if known is None or known[0] != key:
        known = key, [_warp_of(region, state) for region in regions]
        _known[state.ship.surface] = known
    return known[1]


def _warp_of(region, state):
    nothing = np.empty((0, 2, 3)), np.empty(0)
    own = np.flatnonzero(np.isin(state.ship.source.control.face_ids, region.faces))
    try:
        row = native.require().RuledRow(state.ship.surface, own)
    except ValueError as error:
        return RegionWarp(region, inf, *nothing, problem=str(error))
    of_faces = np.degrees(row.warps())
    return RegionWarp(region, of_faces.max(), row.rulings(_SHOWN), np.repeat(of_faces, _SHOWN + 1))
