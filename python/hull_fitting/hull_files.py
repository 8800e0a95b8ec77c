# SPDX-License-Identifier: GPL-3.0-or-later
"""A fitted hull as a HullData: layers, deck edge, flats, points kept in their stations."""

import numpy as np

from .beside import Flat, HullData, Kept, Particulars, edge_key, shell_and_transom

# Parts of a face, along its sides, of which the surface's extents are taken.
_PARTS = 8
# Of the length: points of a row are of one x.
_ONE_X = 2e-3


def hull_data(fitted, name, source, particulars):
    """The HullData (a half hull) of a FittedHull. particulars: hull_io's Particulars."""
    mesh = fitted.fit.mesh
    points = np.array(fitted.fit.points)
    in_ends = [set(points_of) for points_of in mesh.ends.values()]
    face_layers = [int(any(set(face) <= end for end in in_ends)) for face in mesh.faces]
    flats = []
    for numbers, normal, offset in fitted.flats:
        there = set(int(n) for n in numbers)
        taken = {face for flat in flats for face in flat.faces}
        faces = [i for i, face in enumerate(mesh.faces) if set(face) <= there and i not in taken]
        if faces:
            flats.append(Flat(faces, tuple(normal), float(offset)))
    deck = {edge_key(*edge) for edge, line in mesh.lines.items() if line == "deck"}
    return HullData(
        name=name,
        points=points,
        faces=[list(face) for face in mesh.faces],
        creases=sorted(edge_key(*edge) for edge in mesh.creases),
        half=True,
        layers=shell_and_transom(),
        face_layers=face_layers,
        particulars=particulars,
        deck_edge=sorted(deck),
        flats=flats,
        kept=Kept(stations=station_points(fitted)),
        source=source,
    )


def station_points(fitted):
    """Control points in rows of one x: three or more, within 0.2 % of the length."""
    fit, within = fitted.fit, _ONE_X * fitted.outline.length
    found = []
    for row, numbers in zip(fit.grid.rows, fit.mesh.numbers):
        there = np.unique(numbers[numbers >= 0])
        if row.x is None or len(there) < 3:
            continue
        x = fit.points[there, 0]
        near = there[np.abs(x - np.median(x)) <= 0.5 * within]
        if len(near) > 2:
            found += near.tolist()
    return sorted(set(int(n) for n in found))


def particulars_of(guess_length_pp, surface, draft):
    """Particulars of a half hull, m; beam and depth are those of its LimitSurface, beyond which
    control points lie."""
    points = np.asarray(surface.tessellate(_PARTS).points)
    return Particulars(
        length_pp=float(guess_length_pp),
        beam=2.0 * float(points[:, 1].max()),
        draft=float(draft),
        depth=float(points[:, 2].max()),
    )
