# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of a hull as it is now, written when these functions return: lines plan, tables and plots
of its analyses, the report of its conversion."""

from pathlib import Path

from ....hull_io.bytes_on_disk import write_bytes
from ..conversion import conversions
from . import file_tasks


def export_lines_drawing(obj, scene, path):
    """Draws the lines plan that Object.hull.plan asks for; SVG, PDF, PNG or DXF by the name's
    ending."""
    _finish(file_tasks.LinesDrawing(obj, scene, path))


def export_table(obj, scene, name, path):
    """Writes the table of one of analyses.ANALYSES as CSV."""
    _finish(file_tasks.Table(obj, scene, name, path))


def export_plot(obj, scene, name, path):
    """Draws one of analyses.PLOTTED on paper; SVG, PDF or PNG by the file name's ending."""
    _finish(file_tasks.Plot(obj, scene, name, path))


def _finish(task):
    try:
        task.result()
    finally:
        conversions.take_finished()


def export_report(obj, path):
    """Writes how far the patches of the last conversion are from the surface, which must be of the
    hull as it is; as JSON if the file's name ends so, else as text."""
    report = conversions.report_of(obj)
    content = report.json() if path.lower().endswith(".json") else report.text()
    write_bytes(Path(path), content.encode())
