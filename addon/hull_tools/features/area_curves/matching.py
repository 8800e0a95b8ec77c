# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to their target area curve: the task that moves the control points."""

from dataclasses import dataclass, replace

from ...bridge.background import jobs
from ...bridge.objects import hull_mesh, hull_objects
from ..conversion import conversions
from ..flotation import ship
from ..hull import hull_state
from ..transformation import parents
from . import stored
from .approach import Approach, Asked

_CHANGED = "The hull was changed meanwhile, and stays as it is: transform it again"


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


class Matching(jobs.JobTask):
    """The task of bringing a hull as it is now to its target; see conversion.conversions.
    ValueError where there is no target, or it lies elsewhere."""

    text = "Transforming to the area curve"

    def __init__(self, obj, scene, asked=None):
        self.asked = (asked or Asked()).checked()
        curve = stored.curve(obj, scene)
        conversions.clear_way(obj)
        self.parent = parents.of_hull(obj, scene)
        self.parent.position()  # refused here where there is a heel
        self.state = hull_state.state_of(obj)
        self._name, self._before = obj.name, _mesh_key(obj)
        work = Approach(self.parent, curve, self.asked)
        self._job = jobs.Job(work.run)
        self._work = work
        conversions.watch(self)

    def result(self):
        """The Moved, which is waited for; raises what went wrong."""
        return self._job.result()

    def write(self, scene):
        """Moves the hull's control points; returns the Report. ValueError when the hull is no
        longer what it was."""
        found = self.result()
        obj = scene.objects.get(self._name)
        if not hull_objects.is_hull(obj) or hull_state.state_of(obj) is not self.state:
            raise ValueError(_CHANGED)
        if _mesh_key(obj) != self._before:
            raise ValueError(_CHANGED)
        where, work = self.parent.where, self._work
        before = ship.Ship(self.parent.body, ()).hydrostatics(where)
        state = replace(self.parent, obj=obj).write(scene, found.moves)
        after = state.ship.as_it_is().hydrostatics(where)
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


def _mesh_key(obj):
    found = hull_mesh.read(obj)
    return found.topology, found.points_digest
