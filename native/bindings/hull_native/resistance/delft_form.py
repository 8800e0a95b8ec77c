# SPDX-License-Identifier: GPL-3.0-or-later
"""What the regressions of the Delft series ask of a sailing yacht, given or from an exact hull."""

import math
from dataclasses import dataclass, fields, replace

from .. import _core
from .positive_numbers import check_positive
from .side_by_side import is_side_by_side


@dataclass(frozen=True)
class DelftYacht:
    """The canoe body, without keel and rudder, upright.

    length, beam, draft: on the waterline, Lwl, Bwl, Tc. volume: ∇c, m³. prismatic, midship: Cp, Cm,
    on Lwl. lcb, lcf: centres of buoyancy and flotation abaft the waterline's forward end, m.
    side_by_side: hulls beside one another, which the series does not know.
    """

    length: float
    beam: float
    draft: float
    volume: float
    waterplane_area: float
    wetted_surface: float
    prismatic: float
    midship: float
    lcb: float
    lcf: float
    side_by_side: bool = False

    def __post_init__(self):
        names = [each.name for each in fields(self) if each.name != "side_by_side"]
        check_positive(self, "The canoe body's", names)
        for name in ("lcb", "lcf"):
            if not getattr(self, name) < self.length:
                raise ValueError(
                    f"The canoe body's {name} must lie on the waterline, from 0 to "
                    f"{self.length:.4g} m abaft its forward end, not at {getattr(self, name)}."
                )

    @property
    def lcb_percent(self):
        """Forward of the waterline's middle, % of Lwl."""
        return 50.0 - 100.0 * self.lcb / self.length


@dataclass(frozen=True)
class DelftFin:
    """A keel, its bulb, or a rudder. wetted_surface: of both sides, m². chord: its mean. thickness:
    of the chord. A keel's residuary resistance needs its volume, m³, the yacht's draft with it, T,
    and its centre of buoyancy below the canoe body, Zcbk, which may lie above it, as a skeg's."""

    wetted_surface: float
    chord: float
    thickness: float = 0.12
    volume: float | None = None
    total_draft: float | None = None
    centre: float | None = None
    name: str = ""

    def __post_init__(self):
        lengths = ("wetted_surface", "chord", "thickness", "volume", "total_draft")
        check_positive(self, "The keel's or rudder's", lengths)
        if self.centre is not None and not math.isfinite(self.centre):
            raise ValueError(f"The keel's centre must be a number, not {self.centre}.")
        given = [value is not None for value in (self.volume, self.total_draft, self.centre)]
        if any(given) and not all(given):
            raise ValueError("A keel needs volume, total_draft and centre together, or none.")

    @property
    def form_factor(self):
        """1 + k by Hoerner (1965), 1 + 2 t/c + 60 (t/c)⁴."""
        return 1.0 + 2.0 * self.thickness + 60.0 * self.thickness**4


# Of several fins what adds up, and what of their volumes alone is told.
_SUMS, _OF_VOLUMES = ("wetted_surface", "volume"), ("volume", "total_draft", "centre")


def one_fin(fins):
    """The DelftFin that several are together, None of none: surfaces and volumes add up, chord and
    thickness are means by surface, the draft is the deepest, the centre that of the volumes."""
    if not fins:
        return None
    surface = sum(fin.wetted_surface for fin in fins)
    chord, thickness = (
        sum(fin.wetted_surface * getattr(fin, name) for fin in fins) / surface
        for name in ("chord", "thickness")
    )
    heavy = [fin for fin in fins if fin.volume is not None]
    volume = sum(fin.volume for fin in heavy) if heavy else None
    return DelftFin(
        surface,
        chord,
        thickness,
        volume,
        max(fin.total_draft for fin in heavy) if heavy else None,
        sum(fin.volume * fin.centre for fin in heavy) / volume if heavy else None,
        name=", ".join(fin.name for fin in fins),
    )


def given_fins(fins, given, name="keel"):
    """A tuple of DelftFin: `fins` with what is given, by the names of DelftFin's fields, in place
    of what they are together.

    Surfaces and volumes are shared out as theirs are; all else is that of each. Where there are no
    fins it is the one that is given. name: what the fins are, for what is told. ValueError for one
    that lacks its surface or chord, and as DelftFin.
    """
    if not given:
        return tuple(fins)
    together = one_fin(fins)
    if together is None:
        if not {"wetted_surface", "chord"} <= given.keys():
            raise ValueError(
                f"The hull has no {name} joined to it: of one that is given wetted surface and "
                "chord are needed."
            )
        return (DelftFin(**given, name=name),)
    if together.volume is None and not given.keys().isdisjoint(_OF_VOLUMES):
        return (replace(together, **given),)

    def changed(fin):
        left_out = () if fin.volume is not None else _OF_VOLUMES
        values = {each: value for each, value in given.items() if each not in left_out}
        for each in values.keys() & set(_SUMS):
            values[each] *= getattr(fin, each) / getattr(together, each)
        return replace(fin, **values)

    return tuple(map(changed, fins))


def bare_body(body):
    """The HullBody without what is joined to it."""
    if body.appendages is None:
        return body
    return _core.HullBody(
        body.surface, mirrored=body.mirrored, openings=body.openings, tolerance=body.tolerance
    )


def delft_yacht(body, *, draft, trim=0.0, draft_at=0.0, **given):
    """DelftYacht of a HullBody, which is the canoe body: what is joined to it is left out. draft
    (m) at x = draft_at, trim in rad by the stern; what is `given` by the name of its field replaces
    what was measured. ValueError for a hull out of the water and names that are no fields."""
    names = {each.name for each in fields(DelftYacht)}
    for name in given:
        if name not in names:
            raise ValueError(f"{name!r} is no field of DelftYacht; these are: {sorted(names)}.")
    water = _core.hydrostatics(bare_body(body), draft=draft, trim=trim, draft_at=draft_at)
    length, beam = water.waterline_length, water.waterline_beam
    if not (water.displaced_volume > 0.0 and length > 0.0 and beam > 0.0):
        raise ValueError(f"The hull is out of the water at a draft of {draft:.4g} m: set it.")
    largest = water.largest_section.area
    measured = {
        "length": length,
        "beam": beam,
        "draft": water.immersed_draft,
        "volume": water.displaced_volume,
        "waterplane_area": water.waterplane_area,
        "wetted_surface": water.wetted_surface,
        "prismatic": water.displaced_volume / (largest * length),
        "midship": largest / (beam * water.immersed_draft),
        "lcb": water.waterline_forward - water.lcb,
        "lcf": water.waterline_forward - water.lcf,
        "side_by_side": is_side_by_side(bare_body(body), water, draft, trim, draft_at),
    }
    return DelftYacht(**{**measured, **given})
