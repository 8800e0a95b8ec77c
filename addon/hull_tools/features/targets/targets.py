# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls changed so that their numbers are as wanted: the task that moves the control points, and
its report."""

import numpy as np

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import held_points, move_limits
from ..conversion import conversions
from ..dimensions import dimensions
from ..hull import form_before, hull_state
from ..hull.as_it_was import AsItWas
from . import asked, reports, rows

# Of a breadth: what single precision leaves.
_ROUNDING = 1e-6


class Solving(jobs.JobTask):
    """The task of bringing a hull as it is now to its targets; see conversion.conversions.
    result(): (hull_native.TargetsReached, whether the greatest beam binds)."""

    text = "Solving for targets"

    def __init__(self, obj, scene):
        self.state = hull_state.up_to_date(obj, scene)
        wanted = rows.in_use(obj)
        conversions.clear_way(obj)
        self.scale = units.metres_per_unit(scene)
        self._before = AsItWas(obj, scene, "solve it again")
        control = hull_mesh.read(obj).control(self.scale)
        self._ids, self._points = control.vertex_ids, control.points
        surface = self._surface = self.state.ship.source.new_surface()
        # Rows and KG may be others when it is written.
        self._told, self._kg = asked.told(obj), rows.kg_of(obj, self.scale)
        self._lies = self._as_it_lies(obj, scene)
        self._targets = [asked.form_target(row, obj, self.scale) for row in wanted]
        _check_breadth(obj, surface, self._targets, self.scale)
        options = _options(obj, surface, control, self.state.ship.source, self.scale)
        solve = held_points.solver(obj.hull.targets.keep_side)
        self._job = jobs.Job(
            lambda progress: solve(surface, self._targets, progress=progress, **options)
        )
        conversions.watch(self)

    def _as_it_lies(self, obj, scene):
        asked_for = [quantity for quantity, _ in self._told]
        return reports.as_it_lies(obj, asked_for), units.metres_per_unit(scene)

    def write(self, scene):
        """Moves the hull's control points to what is reached; returns the reports.Report.
        ValueError when the hull is no longer what it was, or lies in the water otherwise."""
        reached, beam_binds = self.result()
        obj = self._before.checked(scene)
        if self._as_it_lies(obj, scene) != self._lies:
            raise ValueError(
                "Water, KG or main dimensions were changed meanwhile, and the hull stays as it is: "
                "solve it again"
            )
        form_before.note(obj, self._surface)
        found_rows = reports.rows_reached(self._told, reached, self._kg)
        if np.any(np.asarray(reached.scale) != 1.0):
            with rows.kg_stays(obj, self._told):
                dimensions.scale_hull(obj, scene, reached.scale)
        mesh_points.write(obj.data, self._ids, (self._points + reached.moves) / self.scale)
        state = hull_state.follow_edit(obj, scene, is_by_hand=False)
        return reports.note(
            obj, state, reached, found_rows, ["the greatest beam"] if beam_binds else []
        )


def _check_breadth(obj, surface, wanted, scale):
    """ValueError for a waterline that would have to be wider than the hull may become."""
    settings = obj.hull.targets
    if not settings.keep_side or settings.free_beam:
        return
    rows_of_beam = [row.quantity == "BWL" for row in rows.in_use(obj)]
    widest = 2.0 * native.require().half_breadth(surface)
    for target, is_beam in zip(wanted, rows_of_beam):
        if is_beam and target.low > widest * (1.0 + _ROUNDING):
            raise ValueError(
                f"Bwl cannot become {target.low:g} m while the greatest beam, {widest:.6g} m, is "
                "kept: let it go, or free the dimension"
            )


def _options(obj, surface, control, source, scale):
    """The other arguments of hull_native.reach_targets."""
    return {**asked.options(obj, source, scale), **_moves(obj, surface, control)}


def _moves(obj, surface, control):
    """What control points may do, as keyword arguments."""
    settings = obj.hull.targets
    found = move_limits.of_hull(obj, control.vertex_ids, control.points)
    arguments = found.reshape_arguments(surface)
    is_scaled = any(getattr(settings, f"free_{name}") for name in asked.DIMENSIONS)
    if is_scaled and len(found.locked):
        raise ValueError(
            "Locked points cannot stay while a dimension is free: free the points, or keep the "
            "dimensions"
        )
    points, count = control.points, len(control.points)
    stays = np.zeros(count, dtype=bool)
    stays[found.locked] = True
    if settings.moving == "NONE":
        stays[:] = True
    if settings.moving == "SELECTED":
        stays[~np.isin(control.vertex_ids, _selected(obj))] = True
    # Held along all axes, not locked: locked points would not be scaled.
    held = (
        (arguments["held_points"], arguments["held_normals"]),
        held_points.all_ways(np.flatnonzero(stays)),
        held_points.of_outline(
            surface, points, settings.keep_profile, settings.keep_deck, settings.keep_side
        ),
    )
    arguments["locked"] = np.empty(0, dtype=np.int64) if is_scaled else found.locked
    arguments["held_points"] = np.concatenate([points for points, _ in held])
    arguments["held_normals"] = np.concatenate([normals for _, normals in held])
    return arguments


def _selected(obj):
    if not obj.data.is_editmode:
        raise ValueError("Enter edit mode and select the points that may move, or let all move")
    return mesh_points.selected(obj.data)
