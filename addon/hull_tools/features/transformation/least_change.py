# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to a wanted displacement and centre of buoyancy by the least change: the surface
shifts and bends the least, sections change their form."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.mesh.mesh_check import on_centre_plane
from ..constraints import held_points
from . import form_parameters, parents
from .parent_task import ParentTask

# What hull_native.FORM_NUMBERS has for measures of displacement.
_NUMBERS = {
    "block": "project.block",
    "prismatic": "project.prismatic",
    "volume": "displaced_volume",
    "displacement_t": "displacement_t",
}
# Of the hull's length from either end: what is at the ends.
_ENDS = 0.02
_UNITS = {"volume": " m³", "displacement_t": " t"}
_NAMES = {"block": "Cb", "prismatic": "Cp", "volume": "∇", "displacement_t": "Δ"}


@dataclass(frozen=True)
class Asked:
    """volume: {one of block, prismatic, volume, displacement_t: value}, m³ or t, or empty; lcb: x
    in m or None. What stays: parallel, the parallel middle body; heights, those of points on the
    centre plane; length, the x of points at the ends; profile, deck, side, see
    held_points.of_outline. stiffness: as hull_native.reach_targets has it.

    Whole outlines that stay pinch what moves beside them: the fewest marks come by these defaults.
    """

    volume: dict
    lcb: object = None
    parallel: bool = True
    heights: bool = True
    length: bool = True
    profile: bool = False
    deck: bool = False
    side: bool = True
    stiffness: float = 1.0

    def targets(self):
        """The hull_native.FormTargets; ValueError where there are none, or what is wanted is no
        number."""
        wanted = [(_NUMBERS[name], _NAMES[name], value) for name, value in self.volume.items()]
        wanted += [("lcb", "LCB", self.lcb)] if self.lcb is not None else []
        if not wanted:
            raise ValueError("Ask for a displacement or a centre of buoyancy")
        most = limits.GREATEST_TARGET
        return [
            native.require().FormTarget(number, limits.within(value, f"{name} wanted", -most, most))
            for number, name, value in wanted
        ]


@dataclass(frozen=True)
class Changed:
    """after: form_parameters.FormParameters; rms: of the surface's shift, m."""

    after: form_parameters.FormParameters
    rms: float


class LeastMoves:
    """The moves that bring a parents.Parent to what is Asked; all of Blender's is read here."""

    def __init__(self, parent, asked):
        self.parent, self._asked, self._targets = parent, asked, asked.targets()
        limits.within(asked.stiffness, "Fairness", 0.0, limits.GREATEST_TARGET_STIFFNESS)
        for name in asked.volume:
            parent.where.check_given(_NUMBERS[name], _NAMES[name])
        self._position = parent.position()
        self._arguments = self._holds()

    def _holds(self):
        parent, asked = self.parent, self._asked
        found = parent.reach_arguments(asked.profile, asked.deck, asked.side, ends="in plane")
        points = parent.control.points
        x, low, high = points[:, 0], *parent.ends
        if asked.parallel:
            aft, forward = form_parameters.parallel_body(parent)
            inside = (x >= aft) & (x <= forward) & (forward > aft)
            found["locked"] = np.union1d(found["locked"], np.flatnonzero(inside))
        margin = _ENDS * (high - low)
        holds = (
            (asked.heights, on_centre_plane(points), 2),
            (asked.length, (x <= low + margin) | (x >= high - margin), 0),
        )
        for is_wanted, are_held, axis in holds:
            held = np.flatnonzero(are_held & is_wanted)
            normals = np.tile(np.eye(3)[axis], (len(held), 1))
            found["held_points"] = np.concatenate([found["held_points"], held])
            found["held_normals"] = np.concatenate([found["held_normals"], normals])
        return found

    def reached(self, progress):
        """The hull_native.TargetsReached; ValueError with what can be reached where not all is
        met."""
        parent = self.parent
        reached, beam_binds = held_points.solver(self._asked.side)(
            parent.surface,
            self._targets,
            progress=progress,
            mirrored=parent.body.mirrored,
            openings=parent.body.openings,
            stiffness=self._asked.stiffness,
            **self._position,
            **parent.where.project(),
            **self._arguments,
        )
        if reached.status != "met":
            raise ValueError(self._refusal(reached, beam_binds))
        return reached

    def _refusal(self, reached, beam_binds):
        names = [(_NAMES[name], _UNITS.get(name, "")) for name in self._asked.volume]
        names += [("LCB", " m from the after perpendicular")] if self._asked.lcb is not None else []
        nearest = ", ".join(
            f"{name} {value:.6g}{unit}" for (name, unit), value in zip(names, reached.reached)
        )
        why = (
            "the surface would fold beyond" if reached.status == "folded" else "held by what stays"
        )
        why += " and the greatest beam" if beam_binds else ""
        return (
            f"Not all can be met: the nearest is {nearest}; {why}. Let outlines or the parallel "
            "body move, unlock points, or ask for less"
        )


class LeastChange(ParentTask):
    """The task of bringing a hull as it is now to what is Asked; see conversion.conversions."""

    text = "Changing displacement and LCB"

    def __init__(self, obj, scene, asked):
        asked.targets()  # what is wrong with them is told before all else
        super().__init__(obj, scene)
        self.begin(LeastMoves(self.parent, asked).reached)

    def write(self, scene):
        """Moves the hull's control points; returns Changed. ValueError when the hull is no longer
        what it was."""
        reached, where = self.result(), self.parent.where
        state = self.moved(scene, reached.moves)
        after = form_parameters.of_hydrostatics(parents.hydrostatics_of(state, where))
        return Changed(after, reached.rms)
