# SPDX-License-Identifier: GPL-3.0-or-later
"""Of several ways in which a hull can be brought to what is wanted the one that leaves the fewest
new marks.

Of each the new marks are counted. Then, from the way with the fewest on, new marks are faired out,
until a way leaves none.
"""

from dataclasses import dataclass

import numpy as np

from .lines import judged
from .native import hull_native as hn

# Of the work: counting, and what is left to fairing.
_COUNTS = 0.2


@dataclass(frozen=True, eq=False)
class Tried:
    """A way by its name. refusal: why it leads nowhere, or ""; else moves (n, 3), m, of control
    points, with those by which marks were faired out; made: how many marks were new by itself; new:
    [changes.Placed] that still are; rms: m, by how much fairing shifted the surface."""

    name: str
    refusal: str = ""
    moves: object = None
    made: int = 0
    new: tuple = ()
    rms: float = 0.0


def fewest_marks(known, ways, fair, wanted=(), progress=None):
    """[Tried] of ways from a changes.Known on, the best one first: where as few marks are left, the
    way that made fewer. Those that are not needed were not faired, and refused ones come last.

    ways: {name: callable() → moves (n, 3), m, of control points, or a ValueError with the reason}.
    fair: (LimitSurface, progress) → fair_changes.FairChange of a hull so moved. wanted: as
    Known.compared has it. progress: called with the share done.
    """
    tell = progress or (lambda share: None)
    tried = []
    for name, way in ways.items():
        tried.append(_counted(known, name, way, wanted))
        tell(_COUNTS * len(tried) / len(ways))
    tried.sort(key=_order)
    for number, one in enumerate(tried):
        if one.refusal or not one.new:
            break
        parts = (_COUNTS, number, len(tried))
        tried[number] = _faired(known, one, fair, _part(tell, *parts))
        if not tried[number].new:
            break
    tell(1.0)
    return sorted(tried, key=_order)


def _order(one):
    return bool(one.refusal), len(one.new), one.made


def _counted(known, name, way, wanted):
    try:
        moves = way()
    except ValueError as refused:
        return Tried(name, str(refused))
    surface = _moved(known, moves)
    new = known.compared(judged(surface, known.beam), surface, wanted).new
    return Tried(name, "", moves, len(new), tuple(new))


def _faired(known, one, fair, progress):
    found = fair(_moved(known, one.moves), progress)
    return Tried(
        one.name, "", one.moves + found.moves, one.made, tuple(found.new), float(found.rms)
    )


def _moved(known, moves):
    mesh = known.surface.mesh
    points = mesh.points + np.asarray(moves)
    return hn.LimitSurface(mesh.with_points(points), known.surface.scheme)


def _part(tell, begun, number, count):
    share = (1.0 - begun) / count
    return lambda done: tell(begun + share * (number + done))
