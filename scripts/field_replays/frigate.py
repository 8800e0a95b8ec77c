# SPDX-License-Identifier: GPL-3.0-or-later
"""The frigate of Veelo 2004 (6.1) on the sample `naval_vessel`: its fore ship narrowed by
a shape field at a point, the centre plane protected in different ways. Lengths in m."""

import hull_native as hn
import numpy as np

from . import centre_line, waterline

NAME = "naval_vessel"
# By how much each side is narrower at the point, and the field there.
NARROWER, EXTENT, FALLOFF = 0.5, 45.0, 0.5
POINT_X, POINT_Z = 124.0, 5.3
# Extents of what is protected: from the plane y = 0, the stem and the keel.
FROM_PLANE, FROM_STEM, FROM_KEEL = 6.0, 26.0, 10.0
# The recommended falloff along the stem, and that along the keel.
STEM_FALLOFF, KEEL_FALLOFF = 0.35, 0.5
# Under the dome's nose, where the stem ends; from KEEL_END aft the keel is out of all reach.
FOOT_X, KEEL_END = 142.8, 20.0


def point_of_narrowing(surface):
    """(3,) on the waterline POINT_Z at POINT_X."""
    points = waterline(surface, POINT_Z)
    return points[np.argmin(np.abs(points[:, 0] - POINT_X))]


def plane_protected(falloff):
    """As published: the plane y = 0 keeps its y."""
    return [
        hn.ShapeField.at_plane(
            (0.0, 0.0, 0.0),
            (0.0, 1.0, 0.0),
            extent=FROM_PLANE,
            falloff=falloff,
            protects=True,
            axes="y",
        )
    ]


def stem_protected(surface, falloff):
    """As recommended there: the contour itself keeps its y, stem and dome with one falloff, the
    keel with another one and a smaller extent. Two curves, since the points that are as near to one
    as to the other are within both extents: the closest of one curve would jump there."""
    line = centre_line(surface)
    line = line[line[:, 0] > KEEL_END]
    foot = np.argmax((line[:, 2] < 0.0) & (line[:, 0] < FOOT_X))
    return [
        hn.ShapeField.along(
            hn.FieldCurve(points), extent=extent, falloff=kappa, protects=True, axes="y"
        )
        for points, extent, kappa in (
            (line[: foot + 1], FROM_STEM, falloff),
            (line[foot:], FROM_KEEL, KEEL_FALLOFF),
        )
    ]


def narrowing(surface, protected):
    """The hull_native.ShapeFields by which the point moves inboard by NARROWER, whatever the
    protecting fields leave of its shift."""
    point = point_of_narrowing(surface)

    def fields(shift):
        moved = hn.ShapeField.at_point(point, (0, shift, 0), extent=EXTENT, falloff=FALLOFF)
        return hn.ShapeFields([moved, *protected])

    left = fields(1.0).at([point])[0][0, 1]
    return fields(-NARROWER / left)


def knuckle(surface):
    """Number in crease_curves() of the longest crease."""
    curves = hn.crease_curves(surface)
    lengths = [hn.FieldCurve.of_crease(c).length * (c.kind == "crease") for c in curves]
    return int(np.argmax(lengths))
