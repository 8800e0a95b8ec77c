# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to main dimensions while features keep their shape, beside Blender's own work: on
hulls of a thousand points with triangles that takes seconds."""

from ...bridge.background import jobs
from ..conversion import conversions
from ..hull.as_it_was import AsItWas
from . import dimensions


class KeepingTask(jobs.JobTask):
    """See conversion.conversions; asked: a dimensions.Asked. result(): what write() takes."""

    text = "Scaling"

    def __init__(self, obj, scene, asked):
        conversions.clear_way(obj)
        self._start = dimensions.Start(obj, scene, asked)
        self._before = AsItWas(obj, scene, "scale it again")
        self.state = self._before.state
        self._job = jobs.Job(self._start.find)
        conversions.watch(self)

    def write(self, scene):
        """Scales the hull; returns the dimensions.Brought. ValueError when it is no longer what it
        was."""
        kept = self.result()
        return self._start.write(self._before.checked(scene), scene, kept)
