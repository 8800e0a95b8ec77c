# SPDX-License-Identifier: GPL-3.0-or-later
"""One hull beside another: differences of hydrostatics and of sectional areas.

Lengths are in metres, angles in radians. The first hull is the one that is looked at, the second
the one that it is compared with: a difference is the first's value less the second's.
"""

from dataclasses import dataclass
from operator import attrgetter
from typing import Optional

import numpy as np

from .._core import SEA_WATER_DENSITY, Hydrostatics, hydrostatics, section_areas, tolerances

# What is measured along the ship from x = 0: as a part of Lpp.
_ALONG = (
    "lcb",
    "lcf",
    "lateral_x",
    "wind_x",
    "waterline_aft",
    "waterline_forward",
    "midship_section.position",
    "largest_section.position",
)
# What says nothing without Lpp.
_OF_LENGTH = (
    "lcb_percent",
    "lcf_percent",
    "mtc",
    "midship_section.position",
    "midship_section.area",
)
# In percent already.
_PERCENTS = ("lcb_percent", "lcf_percent")
# Not of the form: where the hull lies, and what integration says of itself.
_LEFT_OUT = {
    "draft",
    "trim",
    "heel",
    "draft_at",
    "volume_error",
    "volume_from_breadths",
    "wetted_surface_error",
}

_STATIONS = 161
_CLOSER = 33  # stations between the neighbours of the one with the largest difference


@dataclass(frozen=True)
class ComparedHull:
    """A hull_native.HullBody and how it lies, as the arguments of `hydrostatics`; trim and heel in
    rad. length_pp, beam: None where they are not given. draft_at: None is half of length_pp, or
    x = 0 m without."""

    body: object
    draft: float
    trim: float = 0.0
    heel: float = 0.0
    draft_at: Optional[float] = None
    length_pp: Optional[float] = None
    beam: Optional[float] = None
    water_density: float = SEA_WATER_DENSITY

    def position(self):
        at = self.draft_at
        if at is None:
            at = 0.5 * (self.length_pp or 0.0)
        return {"draft": self.draft, "trim": self.trim, "heel": self.heel, "draft_at": at}

    def hydrostatics(self):
        """ValueError where nothing is under water."""
        found = hydrostatics(
            self.body,
            **self.position(),
            length_pp=self.length_pp,
            beam=self.beam,
            water_density=self.water_density,
        )
        if found.displaced_volume <= 0.0:
            raise ValueError(f"Nothing is under water at a draft of {self.draft:.3f} m.")
        return found

    def areas(self, stations):
        return section_areas(self.body, np.asarray(stations, dtype=float), **self.position()).areas


@dataclass(frozen=True)
class Difference:
    """quantity: path of a number in hull_native.Hydrostatics, in its unit. value, other: of both
    hulls, None where it is undefined, and so is what follows from it.

    percent: of the other's value; for what is measured along the ship of the other's Lpp, as the
    value itself says nothing there. None for what is in percent already.
    """

    quantity: str
    value: float
    other: float
    percent: float

    @property
    def difference(self):
        return None if None in (self.value, self.other) else self.value - self.other


@dataclass(frozen=True, eq=False)
class AreaDifference:
    """Immersed sectional areas of both hulls in m² at stations (n,) in m. largest: the difference
    that is largest in size anywhere on the ship, at largest_at."""

    stations: np.ndarray
    areas: np.ndarray
    other_areas: np.ndarray
    largest: float
    largest_at: float

    @property
    def differences(self):
        return self.areas - self.other_areas


@dataclass(frozen=True, eq=False)
class Comparison:
    """rows: a Difference each, in the order of `quantities`; areas: an AreaDifference."""

    rows: tuple
    areas: AreaDifference


def quantities():
    """The numbers of hull_native.Hydrostatics that tell of the form, as paths: "kb",
    "project.block", ..."""
    found = []
    for name, prop in vars(Hydrostatics).items():
        if name.startswith("_") or name in _LEFT_OUT or not isinstance(prop, property):
            continue
        if name in ("project", "immersed"):
            parts = ("block", "prismatic", "midship", "waterplane", "vertical_prismatic")
            found += [f"{name}.{part}" for part in parts]
        elif name.endswith("_section"):
            found += [f"{name}.{part}" for part in ("position", "area")]
        else:
            found.append(name)
    return tuple(found)


def compare_hulls(hull, other, *, stations=None, paths=None):
    """The Comparison of two ComparedHull.

    stations: (n,) x in m where sectional areas are compared; by default 21 between the ends of
    both hulls. paths: which of `quantities` are compared, all by default. At one draft: give both
    the same. ValueError where one of them has nothing under water, or an argument is wrong, and
    for trims about places that are not alike, as one has Lpp and the other has not.
    """
    has_length = [bool(one.length_pp) for one in (hull, other)]
    is_open = any(one.trim and one.draft_at is None for one in (hull, other))
    if is_open and has_length[0] != has_length[1]:
        raise ValueError(
            "The draft of a trimmed hull is that at half of its Lpp, which one of these has not: "
            "give draft_at, or Lpp of both."
        )
    found, others = hull.hydrostatics(), other.hydrostatics()
    rows = tuple(difference(path, found, others, other.length_pp) for path in paths or quantities())
    return Comparison(rows, compare_areas(hull, other, stations=stations))


def difference(path, found, others, length_pp=None):
    """The Difference of a number in the hull_native.Hydrostatics of two hulls; length_pp: the
    other's."""
    value, other = _defined(path, found), _defined(path, others)
    return Difference(path, value, other, _percent(path, value, other, length_pp))


def _defined(path, found):
    value = attrgetter(path)(found)
    if path in _OF_LENGTH and found.midship_section.position == 0.0:  # half of no Lpp
        return None
    is_ratio = path.startswith(("project.", "immersed.")) or "angle" in path
    return None if is_ratio and value == 0.0 else value


def _percent(path, value, other, length_pp):
    if value is None or other is None or path in _PERCENTS:
        return None
    whole = length_pp if path in _ALONG else abs(other)
    # A centre on the centre plane is there but for rounding.
    if not whole or whole < 1e-9 * max(abs(value), abs(other), 1.0):
        return None
    return 100.0 * (value - other) / whole


def compare_areas(hull, other, *, stations=None):
    """The AreaDifference of two ComparedHull; stations as compare_hulls."""
    points = [one.body.surface.mesh.points[:, 0] for one in (hull, other)]
    low, high = min(x.min() for x in points), max(x.max() for x in points)
    # So far inside the ends a transom still has its area.
    margin = tolerances.SAME_POSITION * (high - low)
    wanted = np.linspace(low, high, 21) if stations is None else np.asarray(stations, dtype=float)
    fine = np.linspace(low + margin, high - margin, _STATIONS)
    places, differences = _largest(hull, other, fine)
    step = fine[1] - fine[0]
    closer = np.linspace(
        max(places - step, low + margin), min(places + step, high - margin), _CLOSER
    )
    finer = _largest(hull, other, closer)
    if abs(finer[1]) > abs(differences):
        places, differences = finer
    return AreaDifference(
        wanted, hull.areas(wanted), other.areas(wanted), float(differences), float(places)
    )


def _largest(hull, other, stations):
    """(x, difference) of the station where the areas differ most."""
    found = hull.areas(stations) - other.areas(stations)
    worst = int(np.abs(found).argmax())
    return stations[worst], found[worst]
