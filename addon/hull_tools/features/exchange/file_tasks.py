# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, plots and lines plans written beside Blender's own work: tasks, as conversions are, of a
hull as it is when they are made.

What is cancelled leaves a file of the name as it was.
"""

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from .. import analyses
from ..conversion import conversions
from ..hull import hull_state
from ..lines import lines_plan
from . import table_units, tables, title_block


class LinesDrawing(jobs.JobTask):
    """The lines plan that Object.hull.plan asks for; SVG, PDF, PNG or DXF by the name's ending."""

    text = "Drawing the lines plan"

    def __init__(self, obj, scene, path):
        self.state = hull_state.up_to_date(obj, scene)
        source, scale = self.state.ship.source, units.metres_per_unit(scene)
        shown = units.shown_in(scene)
        options = {
            "title": obj.name,
            "particulars": title_block.particulars(obj.hull, self.state.ship.body, scale, shown),
            "lengths_in": "ft" if shown.is_imperial else "m",
            **lines_plan.drawing_options(obj.hull, self.state.ship.surface, scale),
        }
        write = native.require().write_lines_drawing
        self._job = jobs.Job(
            lambda progress: write(source.new_surface(), path, progress=progress, **options)
        )
        conversions.watch(self)


class AnalysisFile(jobs.JobTask):
    """A file of one of analyses.ANALYSES, which is computed where that was not done yet, and kept.

    Subclasses write it: write(result, path), in the thread.
    """

    # Of the time that computing and writing take together.
    _SHARE_OF_COMPUTING = 0.9

    def __init__(self, obj, scene, name, path):
        self.state = hull_state.up_to_date(obj, scene)
        self.text, self._name, self._title = analyses.WORDS[name][0], name, obj.name
        known, is_current = analyses.last_outcome(obj, scene, name)
        if analyses.ANALYSES[name].IS_LIVE or not is_current:
            known = None  # live ones are not as close as can be
        self._key, source = analyses.key_of(obj, scene, name), self.state.ship.source

        def work(progress):
            outcome = known or analyses.computed(
                name,
                source.new_ship(lambda share: progress(self._SHARE_OF_COMPUTING * share)),
                self._key,
            )
            if outcome.message:
                raise ValueError(outcome.message)
            progress(self._SHARE_OF_COMPUTING)
            self.write(outcome.result, path)
            return outcome

        self._job = jobs.Job(work)
        conversions.watch(self)

    def result(self):
        """Waits until the file is written, and keeps what was computed; raises as all JobTasks."""
        outcome = self._job.result()
        if not analyses.ANALYSES[self._name].IS_LIVE:
            analyses.store(self.state, self._name, self._key, outcome)


class Table(AnalysisFile):
    """As CSV, in the scene's system of units; an analysis may have a table in feet of its own."""

    def __init__(self, obj, scene, name, path):
        self._is_imperial = units.is_imperial(scene)
        super().__init__(obj, scene, name, path)

    def write(self, result, path):
        analysis = analyses.ANALYSES[self._name]
        if self._is_imperial and hasattr(analysis, "in_feet"):
            return tables.write_table(path, *analysis.in_feet(result))
        header, rows = analysis.header(result), analysis.rows(result)
        table_units.write_shown(path, header, rows, self._is_imperial)


class Plot(AnalysisFile):
    """On paper, in the scene's system of units; SVG, PDF or PNG by the file name's ending."""

    def __init__(self, obj, scene, name, path):
        self._shown = units.shown_in(scene)
        super().__init__(obj, scene, name, path)

    def write(self, result, path):
        others = analyses.others_beside(self.state, self._name)
        plot = analyses.plot_of(self._name, result, self._title, others, self._shown)
        native.require().write_plot(plot, path)
