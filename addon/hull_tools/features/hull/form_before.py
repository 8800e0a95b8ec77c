# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface that a hull had before its form was last changed as a whole: by that it is told which
marks the change made.

Forms are kept by the geometry that they were, in their order: a hull to which undo has brought one
of them back is what the change before that one made.
"""

from dataclasses import dataclass, field

from ....hull_fairness import changes
from ...bridge.objects import hull_mesh
from . import hull_state

_MOST = 8


@dataclass(frozen=True, eq=False)
class _Form:
    """geometry: the ship's geometry_key; surface: a hull_native.LimitSurface of its own;
    topology_key: as hull_mesh's HullMesh has it; known: what was found of it by beam, m."""

    geometry: object
    surface: object
    topology_key: object
    known: dict = field(default_factory=dict)


@dataclass
class FormsBefore:
    """_Forms, each before a change of the form, the last one last."""

    forms: list = field(default_factory=list)


def note(obj, surface, known=None):
    """The form of a hull is about to be changed from a surface of its own. known: the
    hull_fairness.changes.Known of it, where that has been found already."""
    state = hull_state.state_of(obj)
    kept, geometry = state.of(FormsBefore), state.ship.geometry_key
    earlier = kept.forms[: _index(kept.forms, geometry)]
    by_beam = {} if known is None else {known.beam: known}
    form = _Form(geometry, surface, hull_mesh.read(obj).topology_key, by_beam)
    kept.forms = [*earlier, form][-_MOST:]


def is_known(obj):
    return _last(obj) is not None


class MarksBefore:
    """The marks of the form before a hull, told as they are asked for first: that takes seconds.
    ValueError where there is no form by which the hull as it is can be judged."""

    def __init__(self, obj, beam):
        self._form, self._beam = _checked(obj), beam

    def known(self, progress):
        """The hull_fairness.changes.Known; progress: called with the share done. May be called in
        another thread than Blender's."""
        found = self._form.known.get(self._beam)
        if found is None:
            found = changes.Known(self._form.surface, self._beam, progress)
            self._form.known[self._beam] = found
        return found


def of_hull(obj):
    """The surface before; ValueError as of MarksBefore."""
    return _checked(obj).surface


def _checked(obj):
    form = _last(obj)
    if form is None:
        raise ValueError("Nothing is known of the hull's form before: transform it first")
    if form.topology_key != hull_mesh.read(obj).topology_key:
        raise ValueError(
            "The mesh itself was changed since the transformation, not its points alone: count "
            "marks without comparing"
        )
    return form


def _last(obj):
    """The _Form before the hull as it is, or None."""
    state = hull_state.state_of(obj)
    if state is None:
        return None
    forms = state.of(FormsBefore).forms
    earlier = forms[: _index(forms, state.ship.geometry_key)]
    return earlier[-1] if earlier else None


def _index(forms, geometry):
    """Where the form of a geometry is among _Forms; behind the last one where it is none."""
    return next((i for i, form in enumerate(forms) if form.geometry == geometry), len(forms))
