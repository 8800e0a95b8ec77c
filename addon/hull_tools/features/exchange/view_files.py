# SPDX-License-Identifier: GPL-3.0-or-later
"""Views without hidden lines, curvature along a section, and all lines in space, written beside
Blender's own work: tasks, as those of file_tasks are."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions
from ..hull import hull_state
from ..lines import line_places, lines
from ..variants import other_hull
from . import cad_curves
from .endings import checked_ending

# Of the hull's size: how far curves in space are from the surface's.
_TOLERANCE = 1e-6
_PAPERS_MM = (390.0, 270.0)  # what an A3 sheet has for a view


@dataclass(frozen=True)
class View:
    """axes: rows (3, 3) to the right, up and towards the eye in the hull's own directions.
    distance: of the eye from the hull's middle in m, None: in parallel rays."""

    axes: np.ndarray
    distance: float = None


class ViewFile(jobs.JobTask):
    """The hull as it is seen with the lines of Object.hull.lines, by the name's ending: .pdf on one
    sheet of A3, .svg at the same scale, .dxf at true size. hidden: what is behind is dashed."""

    text = "Drawing the view"

    def __init__(self, obj, scene, path, view, hidden):
        ending = checked_ending(path, (".pdf", ".svg", ".dxf"), "a view")
        self.state = hull_state.up_to_date(obj, scene)
        source, hull_native = self.state.ship.source, native.require()
        scale, title = units.metres_per_unit(scene), obj.name
        places = line_places.line_places(obj.hull, scale)
        cuts = places.positions(self.state.ship.surface.mesh.points)
        given = dict(zip(("stations", "waterlines", "buttocks"), cuts))

        def work(progress):
            drawing = hull_native.view_drawing(
                source.bare_body(source.new_surface()),
                axes=view.axes,
                distance=view.distance,
                hidden=hidden,
                title=title,
                progress=lambda share: progress(0.95 * share),
                **given,
            )
            if ending == ".pdf":
                hull_native.write_shop_booklet([drawing], path, paper="A3")
            else:
                drawing.write(path, scale=_scale_of(drawing) if ending == ".svg" else 1.0)

        self._job = jobs.Job(work)
        conversions.watch(self)


def _scale_of(drawing):
    """1, 1 / 2, 1 / 5, 1 / 10, …: the largest at which a drawing fits."""
    points = np.vstack([line for _, line in drawing.lines])
    needed = (np.ptp(points, axis=0) / _PAPERS_MM).max()
    steps = (f * 10.0**n for n in range(9) for f in (1.0, 2.0, 5.0))
    return 1.0 / next(step for step in steps if step >= needed)


class CurvatureFile(jobs.JobTask):
    """The curvature over the girth of a section across axis "x", "y", "z" at a place in m, with a
    circle of radius m (0: none) and, if wanted, the hull that this one is compared with; by the
    name's ending .pdf, .svg, .png."""

    text = "Drawing the curvature"

    def __init__(self, obj, scene, path, *, axis, position, radius, with_other):
        checked_ending(path, (".pdf", ".svg", ".png"), "a diagram")
        self.state = hull_state.up_to_date(obj, scene)
        source, hull_native, name = self.state.ship.source, native.require(), obj.name
        other = other_hull.of(obj, units.metres_per_unit(scene)) if with_other else None
        shown = hull_native.PlotUnits(units.shown_in(scene).plot_sizes())

        def work(progress):
            others = [] if other is None else [(other.name, other.source.new_surface())]
            progress(0.3)
            plot = hull_native.curvature_plot(
                source.new_surface(),
                axis,
                position,
                radius=radius or None,
                others=others,
                name=name,
                units=shown,
            )
            progress(0.9)
            hull_native.write_plot(plot, path)

        self._job = jobs.Job(work)
        conversions.watch(self)


class CurvesFile(jobs.JobTask):
    """All lines of the lines plan, knuckles and borders of both sides as splines in space, in a DXF
    file in m or mm at true size. result(): how many there are."""

    text = "Writing lines"

    def __init__(self, obj, scene, path, unit):
        checked_ending(path, (".dxf",), "lines in space")
        self.state = hull_state.up_to_date(obj, scene)
        source, hull_native = self.state.ship.source, native.require()
        points = self.state.ship.surface.mesh.points
        kinds = ("station", "waterline", "buttock", "diagonal", "plane", "draft", "feature")
        found = lines.cuts_of_kinds(obj.hull, points, units.metres_per_unit(scene), kinds)
        cuts = {kind: cad_curves.own_cuts(found[kind], obj.hull.half) for kind in found}
        wanted = cad_curves.LinesWanted(cuts, _TOLERANCE, False, True)
        is_half = obj.hull.half

        def work(progress):
            surface = source.new_surface()
            # Curves in the centre plane have no mirror image.
            near = hull_native.tolerances.ON_CENTRE_PLANE * surface.mesh.size
            curves = []
            for _, layer, knots, control in cad_curves.curves(
                surface, wanted, lambda share: progress(0.9 * share)
            ):
                layer = layer.replace(" ", "_").upper()
                curves.append((layer, knots, control))
                if is_half and np.abs(control[:, 1]).max() > near:
                    curves.append((layer, knots, control * (1.0, -1.0, 1.0)))
            hull_native.write_curves_dxf(curves, path, unit=unit)
            return len(curves)

        self._job = jobs.Job(work)
        conversions.watch(self)
