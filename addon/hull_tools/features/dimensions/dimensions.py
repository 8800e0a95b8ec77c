# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull brought to main dimensions by scaling; scales that Blender applied followed."""

from dataclasses import dataclass, replace

import numpy as np

from ....hull_io import moving, scaling
from ...bridge import limits
from ...bridge.blender import units
from ...bridge.blender.units import as_typed
from ...bridge.mesh import mesh_points
from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_objects
from ..hull import form_before, hull_state
from . import following, keeping

# Scales nearer to one are the rounding of single precision.
_NOTICED = 1e-5


@dataclass(frozen=True)
class Dimensions:
    """Of a hull, in m. Lpp, beam, draft and depth are its particulars; length, breadth and height
    are the extents of its surface, the height from z = 0; None without a surface."""

    length_pp: float
    beam: float
    draft: float
    depth: float
    length: object = None
    breadth: object = None
    height: object = None


def present(obj, scene):
    """The Dimensions of a hull as it is."""
    scale, settings = units.metres_per_unit(scene), obj.hull
    given = [
        as_typed(getattr(settings, name)) * scale
        for name in ("length_pp", "beam", "draft", "depth")
    ]
    state = hull_state.state_of(obj)
    extents = None if state is None else state.plausible.extents
    if extents is None:
        return Dimensions(*given)
    return Dimensions(*given, extents.length, extents.beam(settings.half), extents.high[2])


@dataclass(frozen=True)
class Brought:
    """How a hull was brought to dimensions: by three factors; kept: the keeping.Kept of what kept
    its shape meanwhile, None where factors were all."""

    factors: tuple
    kept: object = None


@dataclass(frozen=True)
class Asked:
    """Dimensions in m that a hull is to have, None of one that stays, or follows. With a depth
    heights go by that, and a draft is where the hull floats; else they go by the draft. of_surface:
    length, beam and depth are extents of the surface, not particulars. keep: which of
    hull_io.keeping.KEPT keep their shape."""

    length: object = None
    beam: object = None
    draft: object = None
    depth: object = None
    of_surface: bool = False
    keep: tuple = ()

    def dimensions(self):
        """By the names of scaling.factors."""
        return {name: getattr(self, name) for name in ("length", "beam", "draft", "depth")}

    def particulars(self):
        """By the names of Object.hull, those that are given; m."""
        given = {"draft": self.draft}
        if not self.of_surface:
            given.update(length_pp=self.length, beam=self.beam, depth=self.depth)
        return {name: value for name, value in given.items() if value is not None}


class Start:
    """A hull as it is before it is scaled to what is Asked; nothing changes before write().
    ValueError where that cannot be.

    find(progress), for any thread: what keeps its shape, which write() takes.
    """

    def __init__(self, obj, scene, asked):
        self._asked, self._present = asked, present(obj, scene)
        now = self._present
        if asked.of_surface:
            if now.length is None:
                raise ValueError("The hull has no surface to be measured: look at Mesh Check")
            now = Dimensions(now.length, now.breadth, now.draft, now.height)
        if asked.draft is not None:
            scaling.factors(Dimensions(1.0, 1.0, 1.0, 1.0), draft=asked.draft)
        wanted = asked.dimensions()
        self._factors = scaling.factors(now, **wanted)
        for name, value in wanted.items():
            if value is not None:
                limits.within(value, f"{name.capitalize()} in m", 0.0, limits.LONGEST)
        self.find = lambda progress: None
        if asked.keep:
            self.find = keeping.search(obj, scene, now, asked.keep, wanted, asked.of_surface)

    def write(self, obj, scene, kept):
        """Scales the hull, and with it all that belongs to it; returns a Brought. ValueError where
        it has other dimensions by now."""
        if present(obj, scene) != self._present:
            raise ValueError("The hull's dimensions were changed meanwhile: scale it again")
        _keep_form(obj, scene)
        if kept is None:
            scale_hull(obj, scene, self._factors)
        else:
            keeping.apply(obj, scene, kept)
            _forget_scale(obj)
        for name, value in self._asked.particulars().items():
            setattr(obj.hull, name, value / units.metres_per_unit(scene))
        hull_state.follow_edit(obj, scene, is_by_hand=False)
        return Brought(self._factors, kept)


def set_dimensions(obj, scene, **asked):
    """Scales a hull to what is Asked; returns a Brought. ValueError where that cannot be: nothing
    changes then."""
    start = Start(obj, scene, Asked(**asked))
    return start.write(obj, scene, start.find(None))


def _keep_form(obj, scene):
    """Where it has a surface it is the form before."""
    state = hull_state.refresh(obj, scene)
    if not state.status:
        form_before.note(obj, state.ship.source.new_surface())


def scale_hull(obj, scene, factors):
    """Multiplies x, y and z of a hull's points by three factors, and all that belongs to it
    follows. ValueError as hull_io.scale.Scale."""
    _move(obj, scene, scaling.Scale(tuple(map(float, factors))))


def put_keel_on_base_line(obj, scene, draft_stays=True):
    """Moves a hull up or down so that its keel amidships is at z = 0, with all that lies in space
    with it; returns how far up, m.

    draft_stays: draft, depth, heights of centres and the like were measured from the keel, and keep
    their values; else they go along, and the water stays where it is at the hull. ValueError when
    it has no surface, or is there.
    """
    found = hull_state.up_to_date(obj, scene).plausible.extents
    if abs(found.keel) <= _NOTICED * (found.high[2] - found.low[2]):
        raise ValueError("The keel is on the base line already")
    lift = -found.keel / units.metres_per_unit(scene)
    _move(obj, scene, moving.upwards(lift, draft_stays))
    return -found.keel


def _move(obj, scene, scale):
    """Points, and all that belongs to a hull, go as a Scale in Blender's units takes them."""
    check_single_user(obj.data)
    metres = units.metres_per_unit(scene)
    metric = replace(scale, shift=tuple(metres * part for part in scale.shift))
    points = mesh_points.read(obj.data)
    mesh_points.write(obj.data, np.arange(len(points)), scale.points(points))
    following.follow(obj, scale, metric)
    _forget_scale(obj)
    hull_state.follow_edit(obj, scene, is_by_hand=False)


def _forget_scale(obj):
    state = hull_state.state_of(obj)
    if state is not None:
        state.scaling.forget()


def unapplied(obj):
    """The three factors by which an object is scaled in Blender and nothing else; None where it is
    not, or is turned or mirrored too."""
    factors = np.array(obj.matrix_basis.to_3x3())
    diagonal = np.diag(factors)
    if np.abs(factors - np.diag(diagonal)).max() > _NOTICED or diagonal.min() <= 0.0:
        return None
    return None if np.abs(diagonal - 1.0).max() <= _NOTICED else tuple(diagonal.tolist())


def noticed(obj):
    """The hull_io.scale.Scale in Blender's units by which Blender scaled the mesh of a hull
    since its particulars were as they are; None without."""
    state = hull_state.state_of(obj)
    return None if state is None else state.scaling.noticed()


def text_of(factors):
    """Three factors as a sentence about the hull."""
    words = ("lengthwise", "in breadth", "in height")
    if np.ptp(factors) <= _NOTICED:
        return f"The hull was scaled by {factors[0]:.6g}"
    parts = [
        f"{factor:.6g} {word}"
        for factor, word in zip(factors, words)
        if abs(factor - 1.0) > _NOTICED
    ]
    return f"The hull was scaled by {' and '.join(parts)}"


def follow_scale(obj, scene):
    """Lets all that belongs to a hull follow a scale that Blender gave it, applied or not; returns
    the factors. ValueError where there is none."""
    factors = unapplied(obj)
    if factors is not None:
        _apply(obj, scene, factors)
        return factors
    scale = noticed(obj)
    if scale is None:
        raise ValueError("The hull was not scaled since its particulars were given")
    metres = units.metres_per_unit(scene)
    metric = scaling.Scale(scale.factors, tuple(metres * part for part in scale.shift))
    following.follow(obj, scale, metric)
    _forget_scale(obj)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    return scale.factors


def _apply(obj, scene, factors):
    """Takes the scale of an object into its mesh, and all that belongs to the hull follows."""
    reason = hull_objects.locked(obj)
    if reason:
        raise ValueError(reason)
    check_single_user(obj.data)
    scale = scaling.Scale(factors)  # refused while the object has its own still
    obj.scale = obj.delta_scale = (1.0, 1.0, 1.0)
    _move(obj, scene, scale)
