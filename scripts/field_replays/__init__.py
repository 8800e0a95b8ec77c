# SPDX-License-Identifier: GPL-3.0-or-later
"""The published examples of shape fields (Veelo 2004, 6.1 and 6.2) replayed: a frigate's fore ship
narrowed, a bulb made of a plain bow. Lengths in m."""

import hull_native as hn
import numpy as np


def follow(surface, fields, kept=(), with_profile=False):
    """(surface that follows hull_native.ShapeFields, hull_native.Reshaped) of a half hull.

    The centre line stays in its plane, square to it where it is so; kept: control points that stay,
    as do all beyond the fields' extents. with_profile: the profile follows as nearly as its own
    control points can, and the rest of the surface then. ValueError where space would fold.
    """
    mesh, places = surface.mesh, hn.SurfacePlaces(surface)
    shifts, gradients = fields.at(places.positions)
    locked = np.union1d(places.points_beyond(shifts), np.asarray(kept, dtype=np.int64))
    led, moves = _profile_moves(surface, fields, locked) if with_profile else ((), ())
    centre = np.flatnonzero(np.abs(mesh.points[:, 1]) <= hn.tolerances.ON_CENTRE_PLANE * mesh.size)
    held = np.setdiff1d(centre, led)
    tied, directions = hn.square_ties(surface)
    reshape = hn.Reshape(
        surface,
        locked=locked,
        held_points=held,
        held_normals=np.tile([0.0, 1.0, 0.0], (len(held), 1)),
        tied=tied,
        tied_directions=directions,
        prescribed=led,
        places=places,
    )
    result = reshape.solve(shifts, gradients=gradients, prescribed=moves)
    moved = hn.LimitSurface(mesh.with_points(mesh.points + result.moves), surface.scheme)
    return moved, result


def _profile_moves(surface, fields, locked):
    """(control points (p,) of the profile that do not stay, their moves (p, 3))."""
    number = profile_number(surface)
    curve = hn.crease_curves(surface)[number]
    t = np.linspace(0.0, curve.edge_count, 8 * curve.edge_count + 1)
    shifts, _ = fields.at(curve.evaluate(t)[0])
    points, moves, *_ = hn.crease_moves(surface, number, t, shifts)
    free = ~np.isin(points, locked)
    return np.asarray(points)[free], moves[free]


def refined(surface, times):
    """The same surface with its control mesh subdivided exactly."""
    for _ in range(times):
        surface = hn.LimitSurface(surface.refined_mesh(), surface.scheme)
    return surface


def profile_number(surface):
    """Number in crease_curves() of the longest border in the centre plane: stem and keel."""
    curves = hn.crease_curves(surface)
    return max(_in_centre_plane(surface), key=lambda i: curves[i].edge_count)


def _in_centre_plane(surface):
    """Numbers in crease_curves() of the borders there."""
    nearest = hn.tolerances.ON_CENTRE_PLANE * surface.mesh.size
    return [
        i
        for i, curve in enumerate(hn.crease_curves(surface))
        if np.abs(curve.control_points[:, 1]).max() <= nearest
    ]


def waterline(surface, z, step=0.05):
    """Points (n, 3) of a half hull's waterline at a height, from the bow aft."""
    (curves,) = hn.section_fairness(surface, [[0.0, 0.0, 1.0, z]], step=step, marks=False)
    points = np.concatenate([curve.points for curve in curves])
    return points[np.argsort(-points[:, 0])]


def centre_line(surface):
    """Points (n, 3) along the profile of a half hull, from the deck at the stem down and aft: those
    of the borders in the centre plane that end at the foremost point, one after the other."""
    size, curves = surface.mesh.size, hn.crease_curves(surface)
    lines = []
    for curve in (curves[i] for i in _in_centre_plane(surface)):
        t = np.linspace(0.0, curve.edge_count, 4 * curve.edge_count + 1)
        lines.append(curve.evaluate(t)[0])
    found = [max((line[i] for line in lines for i in (0, -1)), key=lambda p: p[0] + p[2])]
    while True:
        near = hn.tolerances.SAME_POSITION * size
        ends = [(i, end) for i, line in enumerate(lines) for end in (0, -1)]
        at_end = [e for e in ends if np.linalg.norm(lines[e[0]][e[1]] - found[-1]) <= near]
        if not at_end:
            return np.array(found)
        number, end = at_end[0]
        found.extend(lines.pop(number)[:: 1 if end == 0 else -1][1:])
