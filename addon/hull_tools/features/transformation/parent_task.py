# SPDX-License-Identifier: GPL-3.0-or-later
"""Transformations that take a while: tasks that move the control points of a hull as it was when
they began."""

from dataclasses import replace

from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions
from ..flotation import afloat
from ..hull.as_it_was import AsItWas
from . import parents


class ParentTask(jobs.JobTask):
    """See conversion.conversions. Subclasses begin(work) with what runs in a thread: progress →
    result; parent: the Parent of the hull."""

    def __init__(self, obj, scene):
        conversions.clear_way(obj)
        self.parent = parents.of_hull(obj, scene)
        self.parent.position()  # refused here where there is a heel
        self._before = AsItWas(obj, scene, "transform it again")
        self.state = self._before.state

    def begin(self, work):
        self._job = jobs.Job(work)
        conversions.watch(self)

    def moved(self, scene, moves, known=None):
        """Moves the hull's control points; returns the HullState of what it is then. ValueError
        when the hull is no longer what it was. known: see Parent.write."""
        return replace(self.parent, obj=self.unchanged(scene)).write(scene, moves, known)

    def unchanged(self, scene):
        """The hull; ValueError when it is no longer what it was, or lies in the water otherwise."""
        obj = self._before.checked(scene)
        if afloat.afloat(obj.hull, units.metres_per_unit(scene)) != self.parent.where:
            raise ValueError(
                "Water or main dimensions were changed meanwhile, and the hull stays as it is: "
                "transform it again"
            )
        return obj
