# SPDX-License-Identifier: GPL-3.0-or-later
"""Files made at once from a hull as it is now: hull file, lines plan, tables and plots of its
analyses, the report of its conversion."""

from dataclasses import replace
from pathlib import Path

from ....hull_io import write_hull_file
from ....hull_io.bytes_on_disk import write_bytes
from ...bridge import native
from ...bridge.blender import units
from .. import analyses
from ..conversion import conversions
from ..flotation import afloat, hydrostatics
from ..hull import hull_saving, hull_state
from ..lines import lines_plan
from . import tables


def _up_to_date(obj, scene):
    """The hull's HullState; ValueError with the reason when the mesh has no surface as it is."""
    state = hull_state.up_to_date(obj, scene)
    return state


def export_lines_drawing(obj, scene, path):
    """Draws the lines plan that Object.hull.plan asks for; SVG, PDF, PNG or DXF by the name's
    ending."""
    state = _up_to_date(obj, scene)
    scale = units.metres_per_unit(scene)
    native.require().write_lines_drawing(
        state.ship.surface,
        path,
        title=obj.name,
        particulars=_particulars(obj.hull, state.ship.body, scale),
        **lines_plan.drawing_options(obj.hull, state.ship.surface, scale),
    )


def _particulars(settings, body, scale):
    """Pairs (name, value) for the title block; what is not given is left out."""
    given = {
        "Length between perpendiculars": settings.length_pp,
        "Beam": settings.beam,
        "Depth": settings.depth,
        "Draft": settings.draft,
    }
    pairs = [
        (name, f"{units.as_typed(value) * scale:.2f} m") for name, value in given.items() if value
    ]
    try:
        where = replace(afloat.afloat(settings, scale), trim_m=0.0, heel=0.0)
        found = hydrostatics.described(hydrostatics.computed(body, where), where)
    except ValueError:
        return pairs  # afloat at no such draft: the drawing is good without
    pairs.append(("Displaced volume", f"{found.displaced_volume:.1f} m³"))
    pairs.append(("Displacement", f"{found.displacement_t:.1f} t"))
    return pairs


def export_hull_file(obj, scene, path):
    """Writes the hull as a hull file (.hull.json), which reads back as the same hull."""
    write_hull_file(hull_saving.hull_data(obj, scene), path)


def export_table(obj, scene, name, path):
    """Writes the table of one of analyses.ANALYSES as CSV."""
    result = analyses.result_of(obj, scene, name)
    analysis = analyses.ANALYSES[name]
    tables.write_table(path, analysis.header(result), analysis.rows(result))


def export_plot(obj, scene, name, path):
    """Draws one of analyses.PLOTTED on paper; SVG, PDF or PNG by the file name's ending."""
    result = analyses.result_of(obj, scene, name)
    native.require().write_plot(analyses.PLOTTED[name].plot(result, obj.name), path)


def export_report(obj, path):
    """Writes how far the patches of the last conversion are from the surface, which must be of the
    hull as it is; as JSON if the file's name ends so, else as text."""
    report = conversions.report_of(obj)
    content = report.json() if path.lower().endswith(".json") else report.text()
    write_bytes(Path(path), content.encode())
