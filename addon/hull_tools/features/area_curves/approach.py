# SPDX-License-Identifier: GPL-3.0-or-later
"""By what moves of its control points a hull comes to its target area curve. Nothing of Blender's:
it runs in a thread."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ..constraints import held_points
from ..curves_of_form import sectional_areas
from ..flotation import ship
from . import target_curve

# Stations are brought to their area from here on, in parts of the curve's length from its ends.
_FROM_ENDS = 0.01
# How often the way that can be gone is halved.
_WAY_STEPS = 5


@dataclass(frozen=True)
class Asked:
    """by: "LEAST" change, "SHIFT" or "INFLATE" sections; way: the part of the way from the present
    curve to the target, 0 to 1; tolerance: in parts of the largest area wanted; stations: how many
    are brought to their area by the least change; profile, deck, side: what stays then, see
    held_points.of_outline."""

    by: str = "LEAST"
    way: float = 1.0
    tolerance: float = 2e-3
    stations: int = 21
    profile: bool = True
    deck: bool = True
    side: bool = True

    def checked(self):
        limits.within(self.way, "The way", 1e-3, 1.0)
        least, most = limits.AREA_TOLERANCES
        limits.within(self.tolerance, "The tolerance", 1e-2 * least, 1e-2 * most)
        limits.within(self.stations, "The number of stations", 3, limits.MOST_AREA_STATIONS)
        return self


@dataclass(frozen=True, eq=False)
class Moved:
    """moves (n, 3) of the control points, m; status: "met", or why it ended before; rms: of the
    surface's shift where that is what was kept least, else None; areas: sectional_areas.Areas."""

    moves: np.ndarray
    status: str
    rms: object
    areas: object


class Approach:
    """The way of the hull of a transformation.parents.Parent to a target_curve.TargetCurve, as
    Asked. areas: sectional_areas.Areas of the hull as it is. ValueError where the target lies
    elsewhere."""

    def __init__(self, parent, curve, asked):
        self.parent, self.curve, self.asked = parent, curve, asked
        self.areas = self._areas_of(parent.body)
        # All that is asked of Blender, before the work runs in a thread.
        if asked.by == "LEAST":
            self._holds = parent.reach_arguments(asked.profile, asked.deck, asked.side)
        else:
            self._limits = parent.limits(keeps_ranges=True)
        aft, forward = curve.ends
        if not (aft < self.areas.positions[-1] and forward > self.areas.positions[0]):
            raise ValueError(
                f"The target curve lies from x = {aft:.6g} to {forward:.6g} m, where the hull is "
                "not: scale it to the hull's length"
            )

    def run(self, progress):
        """The Moved; ValueError with the remedy. Tells progress(share), and lets through what that
        raises."""
        found = (self._least if self.asked.by == "LEAST" else self._matched)(progress)
        before, after = self.difference(self.areas), self.difference(found.areas)
        # Not the largest one: a jump of areas, as at a rudder, may have moved by a little.
        if after.rms > max(before.rms, self.asked.tolerance):
            raise ValueError(
                "The hull would be farther from the target than it is, by "
                f"{100.0 * after.largest:+.1f} % at x = {after.at:.4g} m: choose more stations, "
                "another way, or a smoother target"
            )
        return found

    def wanted(self, way=None):
        """The target_curve.PartWay to the target, by default as far as is asked for."""
        way = self.asked.way if way is None else way
        return target_curve.PartWay(self.areas.positions, self.areas.areas, self.curve, way)

    def difference(self, areas):
        """The target_curve.Difference of sectional_areas.Areas from what is wanted."""
        return target_curve.difference(areas.positions, areas.areas, self.wanted())

    # Of all changes the least

    def _least(self, progress):
        reached = self._reached(self.asked.way, progress)
        if reached.status == "folded":
            place = reached.folded_place
            place = "" if place is None else f" at x = {place[0]:.4g} m"
            raise ValueError(
                f"On the way to the target the surface would fold{place}. "
                + self._reachable(progress, self._is_reached)
            )
        if reached.status != "met" and not np.abs(reached.moves).max() > 0.0:
            raise ValueError(
                "The control points cannot bring the hull nearer to the target: unlock some, let "
                "more of the outlines move, or subdivide the mesh"
            )
        return Moved(reached.moves, reached.status, reached.rms, self._areas_after(reached.moves))

    def _reached(self, way, progress):
        parent = self.parent
        reached, _ = held_points.solver(self.asked.side)(
            parent.surface,
            self._stations(way),
            progress=progress,
            mirrored=parent.body.mirrored,
            openings=parent.body.openings,
            **parent.position(),
            **parent.where.project(),
            **self._holds,
        )
        return reached

    def _is_reached(self, way, tell):
        return self._reached(way, tell).status == "met"

    def _stations(self, way):
        """hull_native.FormTarget of the stations where both hull and target are."""
        found, (aft, forward) = self.areas, self.curve.ends
        low, high = max(aft, found.positions[0]), min(forward, found.positions[-1])
        margin = _FROM_ENDS * (high - low)
        places = np.linspace(low + margin, high - margin, self.asked.stations)
        areas = self.wanted(way).at(places)
        tolerance = self.asked.tolerance * float(areas.max())
        return [
            native.require().FormTarget("section_area", area, tolerance=tolerance, station=x)
            for x, area in zip(places, areas)
        ]

    # By shifts, or by inflating

    def _matched(self, progress):
        try:
            found = self._match(self.asked.way)
        except ValueError as error:
            raise ValueError(f"{error} {self._reachable(progress, self._is_matched)}") from error
        progress(0.9)
        if not np.abs(found.moves).max() > 0.0:
            raise ValueError(
                "The control points cannot bring the hull nearer to the target so: choose Least "
                "change"
            )
        status = "met" if found.converged else "unsettled"
        return Moved(found.moves, status, None, self._areas_after(found.moves))

    def _match(self, way):
        return native.require().match_areas(
            self.parent.body,
            *self.wanted(way).drawn(),
            by=self.asked.by.lower(),
            tolerance=self.asked.tolerance,
            limits=self._limits,
            **self.parent.position(),
        )

    def _is_matched(self, way, tell):
        tell(0.0)
        try:
            self._match(way)
        except ValueError:
            return False
        return True

    # What can be had, and what it gives

    def _reachable(self, progress, is_reached):
        """How far on the way to the target one can go, by is_reached(way, progress), as a
        sentence."""
        low, high = 0.0, self.asked.way
        for step in range(_WAY_STEPS):
            done, middle = step / _WAY_STEPS, 0.5 * (low + high)
            found = is_reached(middle, lambda share, done=done: progress(done))
            low, high = (middle, high) if found else (low, middle)
        other = "let outlines move" if self.asked.by == "LEAST" else "choose Least change"
        if low == 0.0:
            return f"Nothing of the way can be gone so: {other}"
        return f"Some {100.0 * low:.0f} % of the way can be gone so; or {other}"

    def _areas_after(self, moves):
        return self._areas_of(self.parent.moved_body(moves))

    def _areas_of(self, body):
        return sectional_areas.compute(ship.Ship(body, ()), self.parent.where).areas
