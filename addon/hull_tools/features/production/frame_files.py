# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings of frames and their table, written beside Blender's own work: tasks, as those of
file_tasks are."""

import numpy as np

from ....hull_io.number_lists import numbers
from ...bridge import native
from ...bridge.background import jobs
from ..conversion import conversions
from ..exchange.endings import checked_ending
from ..hull import hull_state
from . import plate_marks, plate_rules
from .plate_files import known_layout, write_rows

_NONE = "There are no frames yet: add a range under Frames"


class FrameFile(jobs.JobTask):
    """Drawings of frames of a hull's table, all that meet the hull or those of a text of numbers
    such as "10 20:30:2": the inner side of a shell of `thickness` (m; 0: the moulded line), with
    seams where there are rules, and waterlines where they are marked. One file, .pdf with a page
    each or .dxf, or, in_sheets, a file each at true size. result(): how many frames."""

    text = "Drawing frames"

    def __init__(self, obj, scene, path, *, frames, thickness, in_sheets, paper):
        native.require().shop_ending(path, apart=in_sheets)
        self.state = hull_state.up_to_date(obj, scene)
        self._source, self._path, self._thickness = self.state.ship.source, path, thickness
        self._apart, self._paper, settings = in_sheets, paper, obj.hull.plates
        points = self.state.ship.surface.mesh.points
        self._marks = plate_marks.marks_of(obj, scene, points, 0.0)
        if self._marks.table is None:
            raise ValueError(_NONE)
        self._numbers = _places(self._marks.table, frames, points)
        self._rules = plate_rules.seam_rules(obj, scene) if self._source.half else []
        self._knuckles = settings.along_knuckles
        self._layout = known_layout(self.state, self._rules, settings)
        self._job = jobs.Job(self._work)
        conversions.watch(self)

    def _work(self, progress):
        hull_native, table, layout = native.require(), self._marks.table, self._layout
        surface = self._source.new_surface() if layout is None else layout.surface
        seams = self._seams(surface)
        progress(0.1)
        tree = hull_native.SurfaceTree(surface) if self._thickness > 0.0 else None
        drawings = []
        for done, k in enumerate(self._numbers):
            progress(0.1 + 0.7 * done / len(self._numbers))
            drawings.append(
                hull_native.frame_drawing(
                    surface,
                    float(table.positions[k]),
                    name=table.names[k],
                    mirrored=self._source.half,
                    thickness=self._thickness,
                    waterlines=self._marks.waterlines,
                    marks=seams,
                    tree=tree,
                )
            )
        names = [table.names[k].replace("−", "-") for k in self._numbers]
        hull_native.write_shop_drawings(
            drawings,
            self._path,
            names=names if self._apart else None,
            paper=self._paper,
            progress=lambda share: progress(0.8 + 0.2 * share),
        )
        return len(drawings)

    def _seams(self, surface):
        """Those that are borders of plates; all of them where these cannot be told."""
        if not self._rules:
            return []
        if self._layout is not None:
            return self._layout.seams
        hull_native = native.require()
        curves, seams = plate_rules.seams_of(self._source, surface, self._rules, self._knuckles)
        try:
            plates = hull_native.plates(surface, seams, left_out=[])
        except ValueError:
            return seams
        return hull_native.used_seams(curves, seams, plates)


def _places(table, text, points):
    """Where in a FrameTable the frames of a text of numbers are, or all that are within control
    points (n, 3), m. ValueError for numbers that it does not have, and where none is left."""
    if not text.strip():
        low, high = points[:, 0].min(), points[:, 0].max()
        inside = (table.positions > low) & (table.positions < high)
        if not inside.any():
            raise ValueError("No frame meets the hull: change the ranges under Frames")
        return np.flatnonzero(inside).tolist()
    found = []
    for number in dict.fromkeys(numbers(text, "Frames")):
        table.position(number)
        found += np.flatnonzero(table.numbers == number).tolist()
    return found


class FrameTableFile(jobs.JobTask):
    """The table of frames as .csv: numbers, names, places, spacings, and breadths, heights and
    girths of the hull. result(): how many frames."""

    text = "Listing frames"

    def __init__(self, obj, scene, path):
        checked_ending(path, (".csv",), "a table of frames")
        self.state = hull_state.up_to_date(obj, scene)
        source, table = self.state.ship.source, plate_rules.frame_table(obj, scene)
        if table is None:
            raise ValueError(_NONE)

        def work(progress):
            surface = source.new_surface()
            progress(0.3)
            rows = native.require().frame_rows(table, surface, mirrored=source.half)
            write_rows(path, rows)
            return len(rows)

        self._job = jobs.Job(work)
        conversions.watch(self)
