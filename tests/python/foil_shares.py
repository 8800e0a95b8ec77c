# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a foil lies within a hull, by another way than hull_native's: its volume is an integral
over its section of the straight lines from root to tip, and each line ends where a ray along it
meets the hull."""

import itertools

import hull_native as hn
import numpy as np

_NODES = 6
_RULE, _WEIGHTS = np.polynomial.legendre.leggauss(_NODES)


class SymmetricFoil:
    """A foil of a symmetric section on a plane y = const: `how` as the arguments of hn.foil().

    With the outline x(t), y(t), and lines whose leading edges lie s of the way from root to tip,
    points are at lead + c (x, η y), c the chord there, and dV = h c² y x' dt dη ds, h the distance
    of root and tip across chord and thickness.
    """

    def __init__(self, section, root, tip, root_chord, tip_chord):
        self.how = {"section": section, "root": root, "tip": tip, "root_chord": root_chord}
        self.how["tip_chord"] = tip_chord
        self.root, self.tip = np.array(root), np.array(tip)
        self.chords = np.array([root_chord, tip_chord])
        self.height = abs(self.tip[2] - self.root[2])
        parts = hn.SectionForm(section).spline()
        self.parts = parts[: len(parts) // 2]  # of the upper side

    def body(self, **how):
        return hn.foil(**self.how, **how)

    @property
    def volume(self):
        """m³, by polynomials alone."""
        area = 2.0 * sum(np.dot(y * slope, w) for _, y, slope, w in self._outline(1))
        return self.height * area * self._squares(np.array([1.0]))[0]

    def _squares(self, s):
        """∫ c² from 0 to s."""
        a, b = self.chords[0], self.chords[1] - self.chords[0]
        return a * a * s + a * b * s**2 + b * b * s**3 / 3.0

    def _outline(self, pieces):
        """x, y, -dx/dt and weights of nodes of each part of the upper side, in pieces."""
        t = ((np.arange(pieces)[:, None] + 0.5 * (_RULE + 1.0)) / pieces).ravel()
        weights = np.tile(0.5 * _WEIGHTS / pieces, pieces)
        s = 1.0 - t
        for p in self.parts:
            point = [
                s**3 * a + 3 * s * s * t * b + 3 * s * t * t * c + t**3 * d
                for a, b, c, d in p.T
            ]
            slope = 3.0 * (
                s * s * (p[1, 0] - p[0, 0])
                + 2.0 * s * t * (p[2, 0] - p[1, 0])
                + t * t * (p[3, 0] - p[2, 0])
            )
            yield point[0], point[1], -slope, weights

    def share_within(self, surface, is_half, pieces=1, across=4):
        """m³ within a hull that holds the root and not the tip, and which each line leaves once.
        is_half: the surface is the port half, and the foil on the centre plane."""
        tree, total = hn.SurfaceTree(surface), 0.0
        eta, weights = _across(is_half, across)
        for x, y, slope, own in self._outline(pieces):
            root, tip = self._lines(x, y, eta)
            ends = _only_crossings(tree, root, tip).reshape(len(x), len(eta))
            total += (own * y * slope) @ self._squares(ends) @ weights
        return self.height * total

    def _lines(self, x, y, eta):
        """(n, 3) at root and tip, of the lines x, η."""
        side = np.outer(y, eta).ravel()
        flat = np.stack([-np.repeat(x, len(eta)), side, 0.0 * side], -1)
        return self.root + self.chords[0] * flat, self.tip + self.chords[1] * flat

    def outside_area(self, surface, is_half, pieces=3, along=6):
        """m² of both sides and the tip outside a hull that holds the root, which each line of the
        sides leaves once. For a section whose trailing edge is sharp.

        A side is the lines from root to tip of its outline, P(t, s), with dA = |Pt × Ps| dt ds.
        """
        tree, total = hn.SurfaceTree(surface), 0.0
        nodes = ((np.arange(along)[:, None] + 0.5 * (_RULE + 1.0)) / along).ravel()
        weights = np.tile(0.5 * _WEIGHTS / along, along)
        nets = list(zip(self._outline(pieces), self._rises(pieces)))
        for side, ((x, y, slope, own), rise) in itertools.product(
            (1.0,) if is_half else (-1.0, 1.0), nets
        ):
            flat = np.stack([-x, side * y, 0.0 * x], -1)
            turn = np.stack([slope, side * rise, 0.0 * x], -1)  # of flat by t
            root, tip = (end + c * flat for end, c in zip((self.root, self.tip), self.chords))
            begin = _only_crossings(tree, root, tip)[:, None]
            s = begin + (1.0 - begin) * nodes
            chord = self.chords[0] + s * (self.chords[1] - self.chords[0])
            across = chord[..., None] * turn[:, None]
            faces = np.linalg.norm(np.cross(across, (tip - root)[:, None]), axis=-1)
            total += (2.0 if is_half else 1.0) * own @ ((1.0 - begin) * faces) @ weights
        area = 2.0 * sum(np.dot(y * slope, w) for _, y, slope, w in self._outline(1))
        return total + area * self.chords[1] ** 2

    def _rises(self, pieces):
        """dy/dt at the nodes of _outline()."""
        t = ((np.arange(pieces)[:, None] + 0.5 * (_RULE + 1.0)) / pieces).ravel()
        s = 1.0 - t
        for p in self.parts:
            steps = 3.0 * np.diff(p[:, 1])
            yield s * s * steps[0] + 2.0 * s * t * steps[1] + t * t * steps[2]

    def covered_area(self, surface, is_half, pieces=3, across=16):
        """m² of a hull's surface within the foil, of both sides: where the lines x, η of
        share_within() cross it, with n · P_s dA = h c² y dx dη of the volume they sweep."""
        tree, total = hn.SurfaceTree(surface), 0.0
        eta, weights = _across(is_half, across)
        for x, y, slope, own in self._outline(pieces):
            root, tip = self._lines(x, y, eta)
            hits = tree.ray_hits(root, tip - root)
            s = hits.distances / np.linalg.norm(tip - root, axis=1)
            normals = surface.normals(hits.cells, hits.uv)
            steep = np.abs(np.einsum("ij,ij->i", normals, tip - root))
            chord = self.chords[0] + s * (self.chords[1] - self.chords[0])
            pieces_of = (chord**2 / steep).reshape(len(x), len(eta))
            total += (own * y * slope) @ pieces_of @ weights
        return self.height * total


def _across(is_half, intervals):
    """Nodes and weights of the thickness, from the middle out, or from side to side."""
    begin = 0.0 if is_half else -1.0
    size = (1.0 - begin) / intervals
    nodes = (begin + size * (np.arange(intervals)[:, None] + 0.5 * (_RULE + 1.0))).ravel()
    return nodes, np.tile(0.5 * size * _WEIGHTS, intervals) * (2.0 if is_half else 1.0)


def _only_crossings(tree, begins, ends):
    """Where lines meet a surface, as shares of them; AssertionError where they do so more often
    than once, or not at all."""
    ways = ends - begins
    lengths = np.linalg.norm(ways, axis=1)
    first = tree.ray_hits(begins, ways).distances / lengths
    last = 1.0 - tree.ray_hits(ends, -ways).distances / lengths
    assert np.all(first < 1.0) and np.abs(first - last).max() < 1e-9
    return first
