# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to their target area curve: the task that moves the control points."""

from dataclasses import dataclass

from ..flotation import ship
from ..transformation import parents
from ..transformation.parent_task import ParentTask
from . import stored
from .approach import Approach, Asked


@dataclass(frozen=True)
class Report:
    """What came of it. before, after: target_curve.Difference from what was asked for; volume, lcb:
    m³ and x in m, with the changes of both."""

    status: str
    before: object
    after: object
    volume: float
    volume_change: float
    lcb: float
    lcb_change: float
    rms: object


class Matching(ParentTask):
    """The task of bringing a hull as it is now to its target; see conversion.conversions.
    ValueError where there is no target, or it lies elsewhere."""

    text = "Transforming to the area curve"

    def __init__(self, obj, scene, asked=None):
        self.asked = (asked or Asked()).checked()
        curve = stored.curve(obj, scene)
        super().__init__(obj, scene)
        self._work = Approach(self.parent, curve, self.asked)
        self.begin(self._work.run)

    def write(self, scene):
        """Moves the hull's control points; returns the Report. ValueError when the hull is no
        longer what it was."""
        found, where, work = self.result(), self.parent.where, self._work
        before = ship.Ship(self.parent.body, ()).hydrostatics(where)
        after = parents.hydrostatics_of(self.moved(scene, found.moves), where)
        return Report(
            found.status,
            work.difference(work.areas),
            work.difference(found.areas),
            after.displaced_volume,
            after.displaced_volume - before.displaced_volume,
            after.lcb,
            after.lcb - before.lcb,
            found.rms,
        )
