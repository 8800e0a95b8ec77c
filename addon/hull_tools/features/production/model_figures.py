# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told beside the buttons of a hull's model and panels: made as they would be written, and
kept until hull or settings are others."""

from dataclasses import dataclass

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions
from ..flotation import afloat
from ..hull import hull_state
from . import left_out
from .made_models import made_model, made_panels, model_options, panel_options

_MODEL, _PANELS = "model", "panels"


@dataclass(frozen=True)
class Figures:
    """key: what it was made from. rows: (name, value) for the panel; remark: what is amiss."""

    key: tuple
    rows: tuple
    remark: str = ""


class OfHull:
    """The last Figures of a hull, by what they are of."""

    def __init__(self):
        self.figures = {}


class _Making(jobs.JobTask):
    """Keeps Figures of `name` when it is done. make: (hull_native, ShipSource, names of what is
    left out, *options, progress) → what is made. Subclasses: rows(made) and remark(made)."""

    def __init__(self, obj, scene, name, make, *options):
        self.state, hull_native = hull_state.up_to_date(obj, scene), native.require()
        source, names = self.state.ship.source, left_out.names_of(obj)
        self._name, self._key = name, _key(self.state, (*options, names))
        self._job = jobs.Job(lambda progress: make(hull_native, source, names, *options, progress))
        conversions.watch(self)

    def result(self):
        made = super().result()
        kept = self.state.of(OfHull).figures
        kept[self._name] = Figures(self._key, self.rows(made), self.remark(made))
        return made


class ModelMaking(_Making):
    """The model as it would be written, for its figures."""

    text = "Making the model"

    def __init__(self, obj, scene):
        self._shown = units.shown_in(scene)
        super().__init__(obj, scene, _MODEL, made_model, model_options(obj.hull.model))

    def rows(self, made):
        size = made.model.points.max(axis=0) - made.model.points.min(axis=0)
        size, symbol = self._shown.in_unit(size, "mm")
        decimals = 1 if self._shown.is_imperial else 0
        rows = [
            (f"Size {symbol}", " × ".join(f"{one:.{decimals}f}" for one in size)),
            ("Triangles", f"{len(made.model.triangles)}"),
            ("Volume", f"{made.model.volume / 1000.0:.1f} cm³"),
        ]
        if made.hollow is not None:
            rows.append(("Hollows", f"{made.hollow.hollows}"))
        if made.parts is not None:
            rows.append(("Segments", f"{len(made.parts.segments)}"))
            if made.parts.holes:
                rows.append(("Dowels", f"{made.parts.holes // 2}"))
        return tuple(rows)

    def remark(self, made):
        return made.remark()


class PanelMaking(_Making):
    """The panels as they would be written, for their figures."""

    text = "Making panels"

    def __init__(self, obj, scene):
        where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
        self._shown = units.shown_in(scene)
        options = panel_options(obj.hull.panel_mesh)
        super().__init__(obj, scene, _PANELS, made_panels, where, options)

    def rows(self, made):
        mesh = made.mesh
        return (
            ("Panels", f"{len(mesh.panels)}"),
            ("Sides", "Port half" if mesh.half else "Both"),
            ("Wetted", self._shown.text(mesh.area, "m2", 1)),
            ("Exact ∇", self._shown.text(mesh.displaced_volume, "m3", 1)),
            ("Off ∇", made.off),
        )

    def remark(self, made):
        return made.remark


def _key(state, options):
    return (state.ship.geometry_key, options)


def _figures(obj, name, options):
    state = hull_state.state_of(obj)
    if state is None or state.ship.geometry_key is None:
        return None, False
    found = state.of(OfHull).figures.get(name)
    is_current = found is not None and not state.status and found.key == _key(state, options)
    return found, is_current


def model_figures(obj):
    """(the last Figures of a hull's model or None, whether they are of hull and settings as they
    are)."""
    return _figures(obj, _MODEL, (model_options(obj.hull.model), left_out.names_of(obj)))


def panel_figures(obj, scene):
    """The same of its panels."""
    options = panel_options(obj.hull.panel_mesh)
    where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
    return _figures(obj, _PANELS, (where, options, left_out.names_of(obj)))
