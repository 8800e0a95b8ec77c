# SPDX-License-Identifier: GPL-3.0-or-later
"""Butts where knuckles fade out within the shell: from there on one plate lies on both sides."""

import numpy as np

from .._core import crease_curves, plane_across
from .._production import LARGEST_KNUCKLE

# Of the mesh's size: what meets, meets in a control vertex.
_SAME_PLACE = 1e-9
_SAMPLES = 32  # of an edge
_HALVINGS = 20  # of the way from a sharp place to the end
# Of the mesh's size: several of the curves' chord tolerance, by which they meet one another.
_NEAR = 1e-4


def closing_butts(surface, curves, seams):
    """Curves, by HullCurves of a surface, across those of its knuckles that end on no other line:
    from seam to seam, where the angle has fallen to what a plate may go over."""
    ends = _free_ends(surface)
    near = _NEAR * surface.mesh.size
    sound = _sound(curves, seams, near) if ends else []
    return [
        _butt(curves, sound, chain, (end, _faded(surface, chain, inner, end)), near)
        for chain, inner, end in ends
    ]


def _free_ends(surface):
    """(CreaseCurve, last sharp place t, end t) of each end of a knuckle that is on no other line,
    and on no other part of its own."""
    chains = crease_curves(surface)
    sharp = [(chain, _sharp_places(surface, chain)) for chain in chains]
    corners = np.array([
        corner
        for chain, places in sharp
        if len(places) or chain.kind == "border"
        for corner in chain.evaluate(np.arange(chain.edge_count + 1.0))[0]
    ])  # fmt: skip
    found = []
    for chain, places in sharp:
        if not len(places) or chain.closed:
            continue
        for inner, end in ((places[0], 0.0), (places[-1], float(chain.edge_count))):
            apart = np.linalg.norm(corners - _place(chain, end), axis=1)
            if np.count_nonzero(apart <= _SAME_PLACE * surface.mesh.size) == 1:
                found.append((chain, inner, end))
    return found


def _sharp_places(surface, chain):
    """The samples t of a crease, rising, where no plate goes over it; none of a border."""
    if chain.kind == "border":
        return np.empty(0)
    t = np.linspace(0.0, chain.edge_count, _SAMPLES * chain.edge_count + 1)
    return t[_angles(surface, chain, t) > LARGEST_KNUCKLE]


def _sound(curves, seams, near):
    """Those seams that end on borders and knuckles: another one's end may be left out."""
    lines = [*curves.borders(), *curves.knuckles()]
    return [
        seam
        for seam in seams
        if all(min(_distance(line, end) for line in lines) <= near for end in seam.points[[0, -1]])
    ]


def _distance(curve, place):
    """Of a place from a SurfaceCurve's chords, m."""
    start, along = curve.points[:-1], np.diff(curve.points, axis=0)
    square = np.maximum((along**2).sum(axis=1), np.finfo(float).tiny)
    share = np.clip(((place - start) * along).sum(axis=1) / square, 0.0, 1.0)
    return np.linalg.norm(start + share[:, None] * along - place, axis=1).min()


def _place(chain, t):
    return chain.evaluate(np.array([t]))[0][0]


def _faded(surface, chain, inner, outer):
    """The place t of a chain, between one where it is sharp and its end, from which on a plate
    may go over it."""
    for _ in range(_HALVINGS):
        middle = 0.5 * (inner + outer)
        if _angles(surface, chain, np.array([middle]))[0] > LARGEST_KNUCKLE:
            inner = middle
        else:
            outer = middle
    return outer


def _angles(surface, chain, t):
    """(k,) between the normals on both sides of a crease at t (k,), rad."""
    one, other = (surface.normals(*side(t)) for side in (chain.left, chain.right))
    return np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), (one * other).sum(axis=1))


def _butt(curves, seams, chain, ends, near):
    """Of the section across the chain through its place t the part from seam to seam there. ends:
    the chain's end, and t."""
    tip, place = (_place(chain, t) for t in ends)
    axis = int(np.argmax(np.abs(chain.evaluate(np.array(ends[1:]), 1)[1][0])))
    plane, name = plane_across("xyz"[axis], place[axis]), f"Butt {place[axis]:.2f}"
    others = [
        seam
        for seam in seams
        if np.linalg.norm(seam.points[[0, -1]] - tip, axis=1).min() > near  # the knuckle itself
    ]
    pieces = [p for branch in curves.in_plane(plane, name) for p in curves.pieces(branch, others)]
    return min(pieces, key=lambda piece: _distance(piece, place))
