# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels, bulbs and rudders that are joined to a hull, as the Delft series' regressions ask for
them."""

import math
from dataclasses import dataclass

import numpy as np

from .. import _core
from .delft_form import DelftFin, bare_body

_RUDDERS = 0.25  # of the waterline from aft: what lies there is a rudder
_LEAST = 1e-9  # of the hull's volume: what adds no more lies within it
_BESIDE = 1e-7  # of the hull's length: rays run beside the centre plane, where two halves meet


@dataclass(frozen=True)
class DelftFins:
    """keels, rudders: tuples of DelftFin. left_out: names of what is joined and neither."""

    keels: tuple = ()
    rudders: tuple = ()
    left_out: tuple = ()


def delft_fins(body, *, draft, trim=0.0, draft_at=0.0):
    """DelftFins of the foils and bulbs that are joined to a HullBody.

    Those in the after quarter of the waterline are rudders, all others keels. Of each: what it adds
    to wetted surface and volume below the water, one after the other, so that a bulb's share is
    counted once; its mean chord and thickness outside the hull; and of keels the depth of their
    lowest point and of their centre. Cylinders, what is cut out, and what lies within the hull or
    above the water are left out. draft (m) at x = draft_at, trim in rad by the stern. ValueError
    as HullBody.join().
    """
    where = {"draft": draft, "trim": trim, "draft_at": draft_at}
    search = _Search(body, where)
    keels, rudders, left_out = [], [], []
    for appendage in body.appendages or ():
        found = search.fin(appendage)
        if found is None:
            left_out.append(appendage.name)
            continue
        fin, x = found
        (rudders if search.is_aft(x) else keels).append(fin)
    return DelftFins(tuple(keels), tuple(rudders), tuple(left_out))


class _Search:
    """Bodies are joined one after the other, and each is what the ship has more by it."""

    def __init__(self, body, where):
        self.where, self.joined, self.tree = where, [], None
        self.canoe, self.body = bare_body(body), bare_body(body)
        self.water = self.alone = _core.hydrostatics(self.canoe, **where)

    def is_aft(self, x):
        aft, forward = self.alone.waterline_aft, self.alone.waterline_forward
        return x < aft + _RUDDERS * (forward - aft)

    def depth(self, points):
        """m below the water, of points (n, 3)."""
        x, z = np.asarray(points)[..., 0], np.asarray(points)[..., 2]
        trim = self.where["trim"]
        level = self.where["draft"] + (self.where["draft_at"] - x) * math.tan(trim)
        return (level - z) * math.cos(trim)

    def fin(self, appendage):
        """(DelftFin, x of its centre) of an Appendage, None for what is no fin in the water."""
        if appendage.cut or appendage.shape == "cylinder":
            return None
        before = self.water
        self.body.join([*self.joined, appendage])
        after = _core.hydrostatics(self.body, **self.where)
        volume = after.displaced_volume - before.displaced_volume
        area = after.wetted_surface - before.wetted_surface
        if not (volume > _LEAST * self.alone.displaced_volume and area > 0.0):
            return None
        self.joined.append(appendage)
        self.water = after
        x, z = (
            (after.displaced_volume * b - before.displaced_volume * a) / volume
            for a, b in ((before.lcb, after.lcb), (before.kb, after.kb))
        )
        chord, thickness = self.mean_chord(appendage)
        deepest = float(self.depth(appendage.grid(4)[0]).max())
        centre = float(self.depth((x, 0.0, z))) - self.alone.immersed_draft
        return (
            DelftFin(area, chord, thickness, volume, deepest, centre, name=appendage.name),
            x,
        )

    def mean_chord(self, appendage):
        """(chord, thickness) in the middle between the hull and the tip."""
        begin = 0.0 if appendage.shape == "bulb" else self.share_within(appendage)
        share = 0.5 * (begin + 1.0)
        chord, thickness = (
            (1.0 - share) * ends[0] + share * ends[1]
            for ends in (appendage.chords, appendage.thicknesses)
        )
        return chord, thickness

    def share_within(self, foil):
        """The share of a foil's span, from its root, that the line through the middles of its
        chords has within the hull: 0 for one that does not meet it."""
        if self.tree is None:
            self.tree = _core.SurfaceTree(self.canoe.surface)
        points = self.canoe.surface.mesh.points
        root, tip = (
            end + 0.5 * chord * foil.chord_direction for end, chord in zip(foil.ends, foil.chords)
        )
        if self.canoe.mirrored:
            beside = _BESIDE * float(np.ptp(points[:, 0]))
            side = -1.0 if root[1] < 0.0 else 1.0
            root, tip = ((x, max(side * y, beside), z) for x, y, z in (root, tip))
        way = np.subtract(root, tip)
        length = float(np.linalg.norm(way))
        hits = self.tree.all_ray_hits(tuple(tip), tuple(way / length))
        within = [d for d in hits.distances if d < length]
        return 1.0 - min(within) / length if within else 0.0
