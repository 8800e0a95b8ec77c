# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of any layouts made parents of one family: one control mesh laid onto each of them.

Lengths are in metres.
"""

from dataclasses import dataclass

from .._core import LimitSurface
from .._morphing import HullFamily, fit_layout


@dataclass(frozen=True)
class CommonLayout:
    """Hulls of one topology, in the order in which they were given, and their HullFamily; the
    LayoutFit of each, None for the one whose layout it is."""

    parents: list
    family: object
    fits: list
    subdivisions: int


def common_layout(hulls, *, layout=0, pairs=None, apart=None, progress=None, **options):
    """The CommonLayout of LimitSurfaces, two or more.

    layout: the number of the hull whose control mesh the others get, or a LimitSurface of its own,
    such as a new hull of a type, which is then laid onto all of them. pairs: {number of a hull:
    pairs (p, 2) of features of the layout and of this hull}; apart likewise, of pairs that are not
    made. tolerance and most_subdivisions as fit_layout() has them, of each hull: if one needs the
    layout subdivided, all are, exactly. progress: a callable that takes the share done, 0 to 1;
    what it raises ends it. ValueError, with the number of the hull, from 1 on, where one can't be
    fitted.
    """
    if len(hulls) < 2:
        raise ValueError("A family needs two hulls or more.")
    own = layout if isinstance(layout, int) else None
    if own is not None and not 0 <= own < len(hulls):
        raise ValueError(f"There is no hull {own} whose layout could be taken.")
    shape = layout if own is None else hulls[own]
    fits = []
    for number, hull in enumerate(hulls):
        told = _share(progress, number, len(hulls))
        named = {
            "pairs": (pairs or {}).get(number, []),
            "apart": (apart or {}).get(number, []),
        }
        is_own = number == own
        fits.append(None if is_own else _fitted(shape, hull, number, told, **named, **options))
    subdivisions = max(fit.subdivisions for fit in fits if fit is not None)
    parents = [
        _subdivided(shape, subdivisions)
        if fit is None
        else _subdivided(fit.second, subdivisions - fit.subdivisions)
        for fit in fits
    ]
    return CommonLayout(parents, HullFamily(parents), fits, subdivisions)


def _fitted(layout, hull, number, progress, **options):
    try:
        return fit_layout(layout, hull, progress=progress, **options)
    except ValueError as error:
        raise ValueError(f"Hull {number + 1} has no part in the family. {error}") from None


def _subdivided(surface, times):
    for _ in range(times):
        surface = LimitSurface(surface.refined_mesh(), surface.scheme)
    return surface


def _share(progress, number, count):
    if progress is None:
        return None
    return lambda share: progress((number + share) / count)
