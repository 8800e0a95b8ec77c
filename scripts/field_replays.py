# SPDX-License-Identifier: GPL-3.0-or-later
"""The frigate of Veelo 2004 (6.1) replayed on the sample `naval_vessel`: its fore ship narrowed by
a shape field at a point, the centre plane protected in different ways. Lengths in m."""

import hull_native as hn
import numpy as np

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


def follow(surface, fields, kept=()):
    """(surface that follows hull_native.ShapeFields, hull_native.Reshaped) of a half hull.

    The centre line stays in its plane, square to it where it is so; kept: control points that stay,
    as do all beyond the fields' extents. ValueError where space would fold.
    """
    mesh, places = surface.mesh, hn.SurfacePlaces(surface)
    shifts, gradients = fields.at(places.positions)
    centre = np.flatnonzero(np.abs(mesh.points[:, 1]) <= hn.tolerances.ON_CENTRE_PLANE * mesh.size)
    tied, directions = hn.square_ties(surface)
    reshape = hn.Reshape(
        surface,
        locked=np.union1d(places.points_beyond(shifts), np.asarray(kept, dtype=np.int64)),
        held_points=centre,
        held_normals=np.tile([0.0, 1.0, 0.0], (len(centre), 1)),
        tied=tied,
        tied_directions=directions,
        places=places,
    )
    result = reshape.solve(shifts, gradients=gradients)
    moved = hn.LimitSurface(mesh.with_points(mesh.points + result.moves), surface.scheme)
    return moved, result


def refined(surface, times):
    """The same surface with its control mesh subdivided exactly."""
    for _ in range(times):
        surface = hn.LimitSurface(surface.refined_mesh(), surface.scheme)
    return surface


def centre_line(surface):
    """Points (n, 3) along the profile of a half hull, from the deck at the stem down and aft: those
    of the borders in the centre plane that end at the foremost point, one after the other."""
    size, lines = surface.mesh.size, []
    for curve in hn.crease_curves(surface):
        (points,) = curve.evaluate(np.linspace(0.0, curve.edge_count, 4 * curve.edge_count + 1))
        if np.abs(points[:, 1]).max() <= hn.tolerances.ON_CENTRE_PLANE * size:
            lines.append(points)
    found = [max((line[i] for line in lines for i in (0, -1)), key=lambda p: p[0] + p[2])]
    while True:
        near = hn.tolerances.SAME_POSITION * size
        ends = [(i, end) for i, line in enumerate(lines) for end in (0, -1)]
        at_end = [e for e in ends if np.linalg.norm(lines[e[0]][e[1]] - found[-1]) <= near]
        if not at_end:
            return np.array(found)
        number, end = at_end[0]
        found.extend(lines.pop(number)[:: 1 if end == 0 else -1][1:])


def point_of_narrowing(surface):
    """(3,) on the waterline POINT_Z at POINT_X."""
    (curves,) = hn.section_fairness(surface, [[0.0, 0.0, 1.0, POINT_Z]], step=0.05, marks=False)
    points = np.concatenate([curve.points for curve in curves])
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
