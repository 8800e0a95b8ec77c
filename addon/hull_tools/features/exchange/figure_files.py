# SPDX-License-Identifier: GPL-3.0-or-later
"""The five figures that present a hull, written beside Blender's own work: a task, as those of
file_tasks are."""

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions
from ..hull import hull_state
from .endings import checked_ending


class FigureFiles(jobs.JobTask):
    """Picture with paint, reflections, control mesh, lines plan and sections plan of a hull, named
    after the path, by its ending .png, .pdf, .svg. Appendages are left out. result(): how many
    files there are."""

    text = "Drawing figures"

    def __init__(self, obj, scene, path):
        checked_ending(path, (".png", ".pdf", ".svg"), "a set of figures")
        self.state = hull_state.up_to_date(obj, scene)
        source, hull_native, own = self.state.ship.source.alone, native.require(), obj.hull
        scale, title = units.metres_per_unit(scene), obj.name
        given = {
            name: units.as_typed(value) * scale
            for name, value in (
                ("length", own.length_pp),
                ("beam", own.beam),
                ("draft", own.draft),
                ("depth", own.depth),
            )
        }

        def work(progress):
            body = source.new_body(source.new_surface())
            return len(
                hull_native.write_hull_figures(body, path, title=title, progress=progress, **given)
            )

        self._job = jobs.Job(work)
        conversions.watch(self)
