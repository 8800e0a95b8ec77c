# SPDX-License-Identifier: GPL-3.0-or-later
"""Where tunnels, stern tubes and trunks go through the shell: marks on its plates, and seams of
plates that are let in around them."""

from dataclasses import dataclass

import numpy as np

from ..polylines import middle_of

# Radii that differ by less, of the larger, are those of a cylinder.
_SAME = 1e-9


@dataclass(frozen=True)
class Opening:
    """A circular cylinder from start to end, (3,), with its radius, m."""

    name: str
    start: np.ndarray
    end: np.ndarray
    radius: float

    def curves_at(self, curves, distance=0.0):
        """SurfaceCurves of HullCurves at a distance around it, m: none where it does not meet the
        hull. ValueError where it touches the hull without a certain course."""
        try:
            return curves.on_cylinder(
                self.start,
                direction=self.end - self.start,
                radius=self.radius + distance,
                name=self.name,
            )
        except ValueError as error:
            if "does not meet" in str(error):
                return []
            raise

    def along(self, points):
        """Of points (n, 3): 0 at the start, 1 at the end."""
        way = self.end - self.start
        return (points - self.start) @ way / (way @ way)

    def has(self, point, distance=0.0):
        """Whether a point is between its ends and within it, or at most at a distance around."""
        share = self.along(point)
        off = point - self.start - share * (self.end - self.start)
        return 0.0 <= share <= 1.0 and np.linalg.norm(off) < self.radius + distance


def openings_of(appendages):
    """Openings of the cylinders among Appendages, of those that are mirrored on both sides. Cones,
    foils and bulbs have none."""
    found = []
    for appendage in appendages:
        if appendage.shape != "cylinder":
            continue
        radius, end_radius = 0.5 * np.asarray(appendage.chords)
        if abs(radius - end_radius) > _SAME * max(radius, end_radius):
            continue
        for side in (1.0, -1.0) if appendage.mirrored else (1.0,):
            start, end = np.asarray(appendage.ends) * [1.0, side, 1.0]
            found.append(Opening(appendage.name, start, end, float(radius)))
    return found


def opening_marks(curves, appendages):
    """("OUTLINE", SurfaceCurve) of the openings that cylinders among Appendages have in the shell,
    by their names, made by HullCurves: as plate_drawing() takes marks. Of those that are mirrored
    both sides count.

    Parts of the shell beyond a cylinder's ends are left out, and so are cones, foils and bulbs and
    what does not meet the shell. ValueError, naming it, for a cylinder that touches the shell
    without a certain course.
    """
    return [
        ("OUTLINE", curve)
        for opening in openings_of(appendages)
        for curve in opening.curves_at(curves)
        if _is_between(opening.along(curve.points))
    ]


def _is_between(shares):
    return bool((shares >= 0.0).all() and (shares <= 1.0).all())


def opening_seams(curves, openings, distance):
    """SurfaceCurves around Openings at a distance, m, made by HullCurves, of the parts of the shell
    between their ends."""
    return [
        curve
        for opening in openings
        for curve in opening.curves_at(curves, distance)
        if 0.0 <= opening.along(curve.points).mean() <= 1.0
    ]


def without_parts_inside(curves, seams, rings, openings, distance):
    """Seams cut at the rings of opening_seams(), without their parts within: what is let in around
    an opening interrupts them."""
    left = []
    for seam in seams:
        for piece in curves.pieces(seam, rings):
            middle = middle_of(piece.points)
            if not any(opening.has(middle, distance) for opening in openings):
                left.append(piece)
    return left
