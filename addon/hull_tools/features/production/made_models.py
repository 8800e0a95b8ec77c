# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of a hull, panels of its wetted part and its surface in parts, as Object.hull.model and
panel_mesh ask for them: made in threads, and the figures of the last ones."""

from dataclasses import dataclass

from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.blender.units import as_typed
from ...bridge.counts import counted
from ..conversion import conversions
from ..flotation import afloat
from ..hull import hull_state
from . import left_out

_MILLIMETRES = 1000.0
# Depth of a dowel's hole, of its diameter.
_DOWEL_DEPTH = 3.0
_MODEL, _PANELS = "model", "panels"


@dataclass(frozen=True)
class ModelOptions:
    """As Object.hull.model has them, mm. wall 0: solid. machine: (x, y, z), None: in one piece."""

    scale: float
    tolerance: float
    wall: float = 0.0
    machine: tuple = None
    dowel: float = 0.0


@dataclass(frozen=True)
class PanelOptions:
    """along: how many of the largest panels the length has; grading: how large they are at the
    water and at the ends, of that."""

    along: int
    grading: float


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


def model_options(settings):
    """The ModelOptions of an Object.hull.model, or of what has the same settings."""
    machine = None
    if settings.in_segments:
        machine = tuple(as_typed(getattr(settings, f"machine_{axis}")) for axis in "xyz")
    return ModelOptions(
        as_typed(settings.scale),
        as_typed(settings.tolerance),
        as_typed(settings.wall),
        machine,
        as_typed(settings.dowel) if machine else 0.0,
    )


def panel_options(settings):
    """The PanelOptions of an Object.hull.panel_mesh, or of what has the same settings."""
    return PanelOptions(settings.along, as_typed(settings.grading))


@dataclass(frozen=True)
class MadeModel:
    """model: hull_native.ClosedModel in mm; hollow: HollowModel or None; parts: ModelSegments or
    None. left_out: left_out.remark."""

    model: object
    hollow: object = None
    parts: object = None
    left_out: str = ""

    def pieces(self):
        """The ClosedModels of all segments, or the model alone, in single precision."""
        if self.parts is None:
            return [self.model]
        return [one.model.scaled(1.0) for one in self.parts.segments]

    def told(self):
        """One text about it."""
        text = f"{len(self.model.triangles)} triangles, {self.model.volume / 1000.0:.1f} cm³"
        if self.hollow is not None:
            text += f", {counted(self.hollow.hollows, 'hollow')}"
        if self.parts is not None:
            text += f", {counted(len(self.parts.segments), 'segment')}"
        return text

    def remark(self):
        """What is amiss with it, or nothing."""
        return ". ".join(text for text in (self.left_out, self._of_segments()) if text)

    def _of_segments(self):
        if self.parts is None:
            return ""
        lost = [k for k, one in enumerate(self.parts.segments, 1) if not one.can_be_made]
        texts = []
        if lost:
            numbers = ", ".join(map(str, lost[:8])) + (" …" if len(lost) > 8 else "")
            texts.append(f"Not all of it can be milled from one side: segments {numbers}")
        if self.parts.bare_joints:
            texts.append(f"{counted(self.parts.bare_joints, 'joint')} without room for a dowel")
        return "; ".join(texts)


def made_model(hull_native, source, names, options, progress):
    """The MadeModel of a state's source, in a thread, without the appendages of these names;
    ValueError with the reason."""
    factor = _MILLIMETRES / options.scale
    body = source.bare_body(source.new_surface())
    progress(0.1)
    model = hull_native.closed_model(
        body, options.tolerance / factor, progress=lambda share: progress(0.1 + 0.2 * share)
    ).scaled(factor)
    _check_count(model)
    hollow = parts = None
    if options.wall > 0.0:
        hollow = hull_native.hollowed(
            model, options.wall, progress=lambda share: progress(0.3 + 0.3 * share)
        )
        model = hollow.model.scaled(1.0)
        _check_count(model)
    if options.machine is not None:
        parts = hull_native.segmented(
            model,
            machine=options.machine,
            dowel=options.dowel,
            dowel_depth=_DOWEL_DEPTH * options.dowel,
            progress=lambda share: progress(0.6 + 0.35 * share),
        )
    progress(0.95)
    return MadeModel(model, hollow, parts, left_out.remark(names, body))


def _check_count(model):
    count = len(model.triangles)
    if count > limits.MOST_MODEL_TRIANGLES:
        raise ValueError(
            f"The model would have {count} triangles, and at most {limits.MOST_MODEL_TRIANGLES} "
            "are written; ask for a larger tolerance, or a thicker wall"
        )


@dataclass(frozen=True)
class MadePanels:
    """mesh: hull_native.PanelMesh. remark: left_out.remark."""

    mesh: object
    remark: str = ""

    def told(self):
        """One text about them."""
        off = self.mesh.volumes.mean() / self.mesh.displaced_volume - 1.0
        sides = "of the port half" if self.mesh.half else "of both sides"
        return f"{len(self.mesh.panels)} panels {sides}, volume {100.0 * off:+.2f} %"


def made_panels(hull_native, source, names, where, options, progress):
    """The MadePanels of a state's source as it floats (afloat.afloat), in a thread, without the
    appendages of these names."""
    surface = source.new_surface()
    body = source.bare_body(surface)
    progress(0.1)
    x = surface.mesh.points[:, 0]
    size = (where.length_pp or float(x.max() - x.min())) / options.along
    mesh = hull_native.wetted_panels(
        body,
        size,
        grading=options.grading,
        origin_x=where.draft_at,
        progress=lambda share: progress(0.1 + 0.8 * share),
        **where.position(),
    )
    return MadePanels(mesh, left_out.remark(names, body))


class _Making(jobs.JobTask):
    """Keeps Figures of `name` when it is done. Subclasses: rows(made) and remark(made)."""

    def __init__(self, state, name, options, work):
        self.state = state
        self._name, self._key = name, _key(state, options)
        self._job = jobs.Job(work)
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
        options = model_options(obj.hull.model)
        state, hull_native = hull_state.up_to_date(obj, scene), native.require()
        source, names = state.ship.source, left_out.names_of(obj)
        super().__init__(
            state,
            _MODEL,
            (options, names),
            lambda progress: made_model(hull_native, source, names, options, progress),
        )

    def rows(self, made):
        size = made.model.points.max(axis=0) - made.model.points.min(axis=0)
        rows = [
            ("Size mm", " × ".join(f"{one:.0f}" for one in size)),
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
        options = panel_options(obj.hull.panel_mesh)
        state, hull_native = hull_state.up_to_date(obj, scene), native.require()
        source, names = state.ship.source, left_out.names_of(obj)
        where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
        self._shown = units.shown_in(scene)
        super().__init__(
            state,
            _PANELS,
            (options, where, names),
            lambda progress: made_panels(hull_native, source, names, where, options, progress),
        )

    def rows(self, made):
        mesh = made.mesh
        off = 100.0 * (mesh.volumes / mesh.displaced_volume - 1.0)
        return (
            ("Panels", f"{len(mesh.panels)}"),
            ("Sides", "Port half" if mesh.half else "Both"),
            ("Wetted", self._shown.text(mesh.area, "m2", 1)),
            ("Exact ∇", self._shown.text(mesh.displaced_volume, "m3", 1)),
            ("Off ∇", f"{off.mean():+.2f} %"),
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
    return _figures(obj, _PANELS, (options, where, left_out.names_of(obj)))
