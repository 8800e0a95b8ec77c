# SPDX-License-Identifier: GPL-3.0-or-later
"""What a view shows of the coaster's stations and what it hides, against rays from the exact
surface towards the eye, past surface, mirror image and deck: all but within NEAR of an outline."""

import math

import hull_native as hn
import numpy as np
import pytest
from production_hulls import body_of

STATIONS = (2.0, 10.0, 30.0, 50.0, 66.0, 74.0, 79.0, 82.0, 84.0)
# m, of a hull of 89 m: three times the tolerance of the view's triangles. Rays so far to all sides
# of one another tell alike, else an outline is there.
NEAR = 0.027
MIRROR = np.array([1.0, -1.0, 1.0])


class Coaster:
    """Its surface and its deck's edge (n, 3)."""

    def __init__(self):
        _, self.body = body_of("coaster")
        self.surface = self.body.surface
        self.tree = hn.SurfaceTree(self.surface)
        borders = hn.HullCurves(self.surface, 1e-3).borders()
        edge = max(borders, key=lambda c: c.points[:, 1].mean()).points
        self.deck = edge[np.argsort(edge[:, 0], kind="stable")]
        size = self.surface.mesh.size
        points = hn.closed_model(self.body, 1e-4 * size).points
        self.middle = 0.5 * (points.min(axis=0) + points.max(axis=0))

    def normals(self, points):
        """And how far points (n, 3) of both sides are from the surface."""
        side = np.where(points[:, 1:2] < 0.0, MIRROR, 1.0)
        found = self.tree.closest_points(points * side)
        return self.surface.normals(found.cells, found.uv) * side, found.distances

    def hides(self, origins, eye):
        """Whether rays from origins (n, 3) to the eye meet surface, mirror image or deck."""
        ways = np.tile(eye, (len(origins), 1))
        hidden = np.isfinite(self.tree.ray_hits(origins, ways).distances)
        hidden |= np.isfinite(self.tree.ray_hits(origins * MIRROR, ways * MIRROR).distances)
        for k in np.flatnonzero(~hidden) if eye[2] > 0.0 else ():
            hidden[k] = self.deck_hides(origins[k], eye)
        return hidden

    def deck_hides(self, origin, eye):
        """The deck is level from edge to edge: where does the ray pass its height?"""
        ray = origin + np.linspace(0.0, 60.0, 3001)[:, None] * eye
        x, breadth, height = self.deck.T
        above = ray[:, 2] - np.interp(ray[:, 0], x, height, left=np.nan, right=np.nan)
        k = np.flatnonzero((above[:-1] < 0.0) & (above[1:] >= 0.0))
        return bool(np.any(np.abs(ray[k, 1]) < np.interp(ray[k, 0], x, breadth)))

    def drawn(self, axes):
        """(points (n, 3) in the middles of the chords of stations, whether each is shown) of a view
        with what is hidden dashed: in a station's plane a place on paper is one of space."""
        options = {"axes": axes, "knuckles": False, "hidden": True}
        outlines = [line for _, line in hn.view_drawing(self.body, **options).lines]
        known = {np.asarray(line).tobytes() for line in outlines}
        points, shown = [], []
        for layer, line in hn.view_drawing(self.body, stations=STATIONS, **options).lines:
            if layer == "OUTLINE" or np.asarray(line).tobytes() in known:
                continue
            flat = np.asarray(line) / 1000.0 + self.middle @ axes[:2].T
            places = []
            for x in STATIONS:
                rest = np.linalg.solve(axes[:2, 1:], (flat - x * axes[:2, 0]).T).T
                lifted = np.insert(rest, 0, x, axis=1)
                places.append((self.normals(lifted)[1].max(), lifted))
            off, lifted = min(places, key=lambda one: one[0])
            assert off < NEAR / 3.0
            points.append(0.5 * (lifted[1:] + lifted[:-1]))
            shown.append(np.full(len(lifted) - 1, layer == "FRAMES"))
        return np.vstack(points), np.concatenate(shown)


@pytest.mark.parametrize("azimuth, elevation", [(-40.0, -15.0), (-40.0, 15.0), (-150.0, 35.0)])
def test_lines_are_seen_where_rays_reach_the_eye(azimuth, elevation):
    """At the stem and behind the deck's edge stretches of 0.4 m and 0.1 m were shown that are
    hidden, when lines were moved to the eye by so much as spares what is seen at small angles."""
    coaster = Coaster()
    axes = hn.view_axes(math.radians(azimuth), math.radians(elevation))
    right, up, eye = axes
    points, shown = coaster.drawn(axes)
    normals, _ = coaster.normals(points)
    facing = normals @ eye
    told = []
    for way in (0.0 * right, right, -right, up, -up):
        origins = points + 2.0 * NEAR * normals + NEAR * way
        told.append((facing > 0.0) & ~coaster.hides(origins, eye))
    is_clear = (np.array(told) == told[0]).all(axis=0) & (np.abs(facing) > 0.05)
    assert is_clear.mean() > 0.94
    assert min((shown & is_clear).sum(), (~shown & is_clear).sum()) > 300
    wrong = is_clear & (shown != told[0])
    assert not wrong.any(), points[wrong]
