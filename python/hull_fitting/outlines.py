# SPDX-License-Identifier: GPL-3.0-or-later
"""The HullOutline of a shell of triangles: contour, deck edge and ends, found from its borders."""

import numpy as np

from .beside import HullOutline, find_ends
from .borders import border_edges, joined, joined_lines, without_spurs
from .knuckle_lines import knuckle_lines

# Of the length: seams are no wider, and a line goes on over gaps that are no wider.
_SEAM, _GAP = 3e-4, 1.5e-2
# Of the length: the border is on the plane of an end; contour and deck edge end there together; an
# end without faces has no more.
_ON_PLANE, _TOGETHER, _OPEN_REACH = 3e-4, 2e-2, 0.05
# An edge of the border across the ship has no more than this along it; a transom has this of the
# depth.
_ACROSS, _TRANSOM_DEPTH = 0.5, 0.05
# Of the breadth: an opening at the centre plane is no wider.
_NARROW = 0.15


def shell_outline(shell):
    """The HullOutline (without network) of a HullShell; ValueError that tells what it
    has not."""
    mesh = shell.mesh
    length = mesh.length
    central, rims = border_edges(mesh.points, mesh.triangles, _SEAM * length)
    reach = _GAP * length
    rims = joined_lines(mesh.points, rims, reach)
    contour = joined_lines(mesh.points, central, reach) + _bridges(rims, mesh)
    contour = _longest(joined(contour, reach), mesh, "centre plane")
    rim = _longest(rims, mesh, "deck")
    if contour[0, 0] > contour[-1, 0]:
        contour = contour[::-1]
    if np.linalg.norm(rim[0] - contour[0]) > np.linalg.norm(rim[-1] - contour[0]):
        rim = rim[::-1]
    for name, number in (("aft", 0), ("forward", -1)):
        gap = np.linalg.norm(rim[number] - contour[number])
        if gap > _TOGETHER * length:
            place = ", ".join(f"{c:.2f}" for c in contour[number])
            raise ValueError(
                f"At the {name} end the border of the shell comes no nearer than {gap:.2f} m to "
                f"the profile's end at ({place}) m: give the shell whole, up to one deck edge."
            )
    rim[0], rim[-1] = contour[0], contour[-1]
    aft, deck = _split(rim, shell.ends.get("aft"), length, np.ptp(mesh.points[:, 2]))
    fore, deck = _split(deck[::-1], shell.ends.get("forward"), length, np.ptp(mesh.points[:, 2]))
    used = mesh.points[np.unique(mesh.triangles)]
    outline = HullOutline(
        None, length, used.min(axis=0), used.max(axis=0), None, contour, deck[::-1], aft, fore
    )
    for name, line in (("aft", aft), ("forward", fore)):
        if name in shell.ends and line is not None:
            outline.ends[name] = end_lines(line, shell.ends[name])
    outline.knuckles = knuckle_lines(mesh)
    find_ends(outline)
    return outline


def _bridges(rims, mesh):
    """Lines in the centre plane over openings there, such as of a stern post that is blunt."""
    breadth = mesh.points[:, 1].max()
    return [
        rim[[0, -1]]
        for rim in rims
        if rim[0, 1] == 0.0 and rim[-1, 1] == 0.0 and rim[:, 1].max() < _NARROW * breadth
    ]


def _longest(lines, mesh, what):
    lines = [line for line in lines if np.ptp(line[:, 0]) > 0.5 * mesh.length]
    if not lines:
        raise ValueError(
            f"No border of the shell runs along the {what} from end to end: give a hull that ends "
            f"there, or is closed there by a flat deck."
        )
    lines = [without_spurs(line, _SEAM * mesh.length) for line in lines]
    return max(lines, key=lambda line: float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum()))


def _split(rim, plane, length, depth):
    """(line of a flat end from below upwards or None, the rest) of a border from the end on."""
    if plane is not None:
        place, normal = plane
        is_on = np.abs((rim - place) @ normal) < _ON_PLANE * length
    else:
        way = np.diff(rim, axis=0)
        across = np.abs(way[:, 0]) < _ACROSS * np.linalg.norm(way, axis=1)
        is_on = np.append(True, across) & (np.abs(rim[:, 0] - rim[0, 0]) < _OPEN_REACH * length)
    count = len(rim) if is_on.all() else int(np.argmin(is_on))
    if count < 2 or rim[count - 1, 2] - rim[0, 2] < _TRANSOM_DEPTH * depth:
        return None, rim
    return rim[:count], rim[count - 1 :]


def end_lines(line, plane):
    """Of a flat end with faces: its line in the centre plane, upwards, and its upper border,
    inwards."""
    place, normal = plane
    top = line[-1] * [1.0, 0.0, 1.0]
    top[0] = place[0] - (top[2] - place[2]) * normal[2] / normal[0]
    return np.array([line[0], top]), np.array([line[-1], top])
