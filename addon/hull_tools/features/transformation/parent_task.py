# SPDX-License-Identifier: GPL-3.0-or-later
"""Transformations that take a while: tasks that move the control points of a hull as it was when
they began."""

from dataclasses import replace

from ...bridge.background import jobs
from ...bridge.objects import hull_mesh, hull_objects
from ..conversion import conversions
from ..hull import hull_state
from . import parents

_CHANGED = "The hull was changed meanwhile, and stays as it is: transform it again"


class ParentTask(jobs.JobTask):
    """See conversion.conversions. Subclasses begin(work) with what runs in a thread: progress →
    result; parent: the Parent of the hull."""

    def __init__(self, obj, scene):
        conversions.clear_way(obj)
        self.parent = parents.of_hull(obj, scene)
        self.parent.position()  # refused here where there is a heel
        self.state = hull_state.state_of(obj)
        self._name, self._before = obj.name, _mesh_key(obj)

    def begin(self, work):
        self._job = jobs.Job(work)
        conversions.watch(self)

    def result(self):
        """What the work returns, which is waited for; raises what went wrong."""
        return self._job.result()

    def moved(self, scene, moves):
        """Moves the hull's control points; returns the HullState of what it is then. ValueError
        when the hull is no longer what it was."""
        obj = scene.objects.get(self._name)
        if not hull_objects.is_hull(obj) or hull_state.state_of(obj) is not self.state:
            raise ValueError(_CHANGED)
        if _mesh_key(obj) != self._before:
            raise ValueError(_CHANGED)
        return replace(self.parent, obj=obj).write(scene, moves)


def _mesh_key(obj):
    found = hull_mesh.read(obj)
    return found.topology, found.points_digest
