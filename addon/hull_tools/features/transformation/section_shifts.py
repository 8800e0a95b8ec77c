# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections shifted along the ship to a wanted displacement and centre of buoyancy."""

from dataclasses import dataclass

from ...bridge import native
from . import form_parameters, halves, parents
from .form_parameters import FormParameters, parallel_body

NO_END = "The search did not end: ask for a smaller change, or keep less"


@dataclass(frozen=True)
class Wanted:
    """volume: {name of a measure of hull_native.SectionShift.solve: value}, or empty; lcb: x in m
    or None; part: as SectionShift takes it; parallel: "FREE", "KEEP", or "LENGTH" with
    parallel_length in m. prismatics: halves.Prismatics instead of volume and lcb, of the halves
    that are shifted: "whole" and "fair" stand for both apart."""

    volume: dict
    lcb: object = None
    part: str = "whole"
    parallel: str = "FREE"
    parallel_length: float = 0.0
    prismatics: object = None

    def check(self):
        """ValueError where nothing is wanted."""
        is_anything = self.prismatics is not None or self.volume or self.lcb is not None
        if not (is_anything or self.parallel == "LENGTH"):
            raise ValueError(
                "Ask for a displacement, a centre of buoyancy, or a length of the parallel body"
            )

    @property
    def shifted_part(self):
        is_both = self.prismatics is not None and self.part in ("whole", "fair")
        return "apart" if is_both else self.part


@dataclass(frozen=True)
class Shifted:
    """result: hull_native.SectionsShifted; part: that was shifted, as SectionShift has it;
    prismatics: halves.Prismatics after it where they were wanted."""

    result: object
    before: FormParameters
    after: FormParameters
    part: str
    prismatics: object = None


def prismatics(obj, scene):
    """The halves.Prismatics of a hull as it is; ValueError where they have no meaning."""
    parent = parents.of_hull(obj, scene)
    return halves.prismatics(parent.body, parent.position(), _length(parent))


def _length(parent):
    if not parent.where.length_pp:
        raise ValueError("Give Lpp first: sections are shifted between the perpendiculars")
    return parent.where.length_pp


def shift(obj, scene, wanted):
    """Shifts the sections of a hull to what is Wanted; returns Shifted. ValueError where it is out
    of reach, with what can be reached: nothing moves then."""
    wanted.check()
    parent = parents.of_hull(obj, scene)
    where, position = parent.where, parent.position()
    length, shift = _length(parent), new_shift(parent, wanted)
    before = form_parameters.of_parent(parent)
    if wanted.prismatics is None:
        result = shift.solve(**wanted.volume, lcb=wanted.lcb)
    else:
        solver = halves.HalfSolver(shift, wanted.shifted_part, parent.moved_body, position, length)
        result = solver.solve(wanted.prismatics)
    if wanted.prismatics is None and not result.converged:
        raise ValueError(NO_END)
    state = parent.write(scene, result.moves)
    found = parents.hydrostatics_of(state, where)
    reached = None
    if wanted.prismatics is not None:
        source = state.ship.source
        reached = halves.prismatics(source.bare_body(source.new_surface()), position, length)
    return Shifted(
        result, before, form_parameters.of_hydrostatics(found), wanted.shifted_part, reached
    )


def new_shift(parent, wanted):
    """The hull_native.SectionShift of a parents.Parent for what is Wanted, to be solved."""
    _length(parent)
    position = parent.position()
    return native.require().SectionShift(
        parent.body,
        draft=position["draft"],
        trim=position["trim"],
        **{name: value or 0.0 for name, value in parent.where.project().items()},
        part=wanted.shifted_part,
        **_parallel(parent, wanted),
        kept_ranges=parent.kept_ranges(),
        limits=parent.limits(),
    )


def _parallel(parent, wanted):
    if wanted.parallel == "FREE":
        return {}
    aft, forward = parallel_body(parent)
    if not forward > aft:
        if wanted.parallel == "KEEP":
            return {}
        raise ValueError("There is no parallel middle body: lengthen the hull amidships instead")
    found = {"parallel": (aft, forward)}
    if wanted.parallel == "LENGTH":
        middle, half = 0.5 * (aft + forward), 0.5 * wanted.parallel_length
        found["parallel_wanted"] = (middle - half, middle + half)
    return found
