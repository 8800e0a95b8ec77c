# SPDX-License-Identifier: GPL-3.0-or-later
"""Butts where knuckles fade out within the shell: from there on one plate lies on both sides."""

import numpy as np

from ._core import crease_curves, knuckle_angles, plane_across

# Of a knuckle up to which a plate goes over it, as plates() has it.
LARGEST_KNUCKLE = np.radians(0.5)
# Of the mesh's size: what meets, meets in a control vertex.
_SAME_PLACE = 1e-9
_SAMPLES = 32  # of an edge
_HALVINGS = 20  # of the way from a sharp place to the end
# Of the mesh's size: several of the curves' chord tolerance, by which they meet one another.
_NEAR = 1e-4


def closing_butts(surface, curves, seams, largest_knuckle=LARGEST_KNUCKLE):
    """Curves, by HullCurves of a surface, across those of its knuckles that end on no other line:
    from seam to seam, where the angle (rad) has fallen to what a plate may go over."""
    chains = [(number, chain) for number, chain in enumerate(crease_curves(surface))]
    knuckles = {
        number: knuckle_angles(surface, number, samples_per_edge=_SAMPLES)
        for number, chain in chains
        if chain.kind == "crease"
    }
    knuckles = {n: a for n, a in knuckles.items() if _largest(a) > largest_knuckle}
    kept = [chain for n, chain in chains if n in knuckles or chain.kind == "border"]
    near = _NEAR * surface.mesh.size
    sound = _sound(curves, seams, near)
    made = []
    for number, angles in knuckles.items():
        chain = chains[number][1]
        if chain.closed:
            continue
        for end in (0.0, float(chain.edge_count)):
            if not _is_free(chain, end, kept, surface.mesh.size):
                continue
            at = _faded(surface, chain, angles, end, largest_knuckle)
            made.append(_butt(curves, sound, chain, (end, at), near))
    return made


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


def _largest(angles):
    return np.nanmax(np.abs(angles.angles), initial=0.0)


def _place(chain, t):
    return chain.evaluate(np.array([t]))[0][0]


def _is_free(chain, end, kept, size):
    """Whether the chain's end is on no other chain, and on no other part of its own."""
    place, met = _place(chain, end), 0
    for other in kept:
        corners = other.evaluate(np.arange(other.edge_count + 1.0))[0]
        met += (np.linalg.norm(corners - place, axis=1) <= _SAME_PLACE * size).sum()
    return met == 1


def _faded(surface, chain, angles, end, largest):
    """The place t of the chain from which on, to its end, no angle is above the largest."""
    sharp = angles.t[np.abs(angles.angles) > largest]
    inner = sharp.min() if end == 0.0 else sharp.max()
    outer = end
    for _ in range(_HALVINGS):
        middle = 0.5 * (inner + outer)
        if _angle(surface, chain, middle) > largest:
            inner = middle
        else:
            outer = middle
    return outer


def _angle(surface, chain, t):
    """Between the normals on both sides of a crease, rad."""
    at = np.array([t])
    one, other = (surface.normals(*side(at))[0] for side in (chain.left, chain.right))
    return np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)


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
