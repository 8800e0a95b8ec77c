# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of a hull and panels of its wetted part, as Object.hull.model and panel_mesh ask for them:
made in threads."""

from dataclasses import dataclass

from ...bridge import limits
from ...bridge.blender.units import as_typed
from ...bridge.counts import counted
from . import left_out

_MILLIMETRES = 1000.0
# Depth of a dowel's hole, of its diameter.
_DOWEL_DEPTH = 3.0


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

    @property
    def off(self):
        """By how much their volume is off the exact one, as a text; of a sheet, which has none, a
        dash."""
        exact = self.mesh.displaced_volume
        return f"{100.0 * (self.mesh.volumes.mean() / exact - 1.0):+.2f} %" if exact else "–"

    def told(self):
        """One text about them."""
        sides = "of the port half" if self.mesh.half else "of both sides"
        return f"{len(self.mesh.panels)} panels {sides}, volume {self.off}"


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
