# SPDX-License-Identifier: GPL-3.0-or-later
"""What of a half hull's mesh is its shell, and what its deck, transom or flat bow."""

from dataclasses import dataclass

import numpy as np

from .beside import normals_of, spread_points
from .borders import bodies
from .half_meshes import HalfMesh
from .triangle_edges import components, edge_table, members

# Patches end at edges where normals turn by more, degrees.
_SHARP = 35.0
# Of a deck's area this share is flat, with normals that are this much upwards; of the depth, how
# far it may be below the top of the hull in the mean.
_FLAT_SHARE, _UPWARDS, _BELOW_TOP = 0.9, 0.75, 0.15
# Of the length: an end's patch is no more curved, and no further from the end; its normals are
# this much along the ship, and in the mean no more athwart; and its area, of the length squared.
_PLANE, _AT_END, _ALONG, _ATHWART, _LEAST_END = 5e-3, 0.15, 0.6, 0.15, 1e-4
# Of the length: a piece that is no further from another lies on it.
_DOUBLE = 1e-4
# Of the length: gaps between patches of one body; a body that is an appendage is shorter. Of the
# shell's area: it is smaller; what is told has more.
_SEAM, _SHORT, _SMALL, _TOLD = 3e-4, 0.4, 0.2, 1e-3
_BINS, _SPREAD = 200, 20_000


@dataclass(frozen=True)
class HullShell:
    """mesh: the HalfMesh of the shell. ends: "aft" and "forward" to (place (3,), normal (3,)) of
    the planes of a transom and a flat bow that have faces. deck_area: m², of what was left out as
    deck. left_out: sentences on what else was."""

    mesh: HalfMesh
    ends: dict
    deck_area: float
    left_out: tuple = ()


def hull_shell(mesh):
    """The HullShell of a HalfMesh."""
    mesh, left_out = _without_appendages(mesh)
    normals, areas = normals_of(mesh.points, mesh.triangles)
    mesh, normals, areas = _without_doubles(mesh, normals, areas)
    patch = _patches(mesh, normals)
    top = _Tops(mesh)
    kept, ends, deck_area = np.ones(len(mesh.triangles), dtype=bool), {}, 0.0
    for which in members(patch):
        if _is_deck(mesh, which, normals, areas, top):
            kept[which] = False
            deck_area += float(areas[which].sum())
            continue
        end = _end_of(mesh, which, normals, areas)
        if end is not None:
            kept[which] = False
            name, area, plane = end
            if name not in ends or ends[name][0] < area:
                ends[name] = (area, plane)
    planes = {name: plane for name, (_, plane) in ends.items()}
    return HullShell(mesh.kept(kept), planes, deck_area, tuple(left_out))


def _without_appendages(mesh):
    """The HalfMesh without bodies that are short and apart from the largest, and sentences."""
    body = bodies(mesh.points, mesh.triangles, _SEAM * mesh.length)
    _, areas = normals_of(mesh.points, mesh.triangles)
    wholes = np.bincount(body, areas)
    kept, told, main = np.ones(len(body), dtype=bool), [], wholes.argmax()
    for number, which in enumerate(members(body)):
        if number == main:
            continue
        low, high = _box(mesh, which)
        if high[0] - low[0] > _SHORT * mesh.length or wholes[number] > _SMALL * wholes.max():
            continue
        kept[which] = False
        if wholes[number] > _TOLD * wholes.max():
            told.append(
                f"A part from x = {low[0]:.2f} to {high[0]:.2f} m and z = {low[2]:.2f} to "
                f"{high[2]:.2f} m is apart from the shell, and was left out."
            )
    return mesh.kept(kept), told


def _patches(mesh, normals):
    table = edge_table(mesh.triangles)
    owners = table.owners[table.counts == 2]
    cosines = (normals[owners[:, 0]] * normals[owners[:, 1]]).sum(axis=1)
    return components(len(mesh.triangles), owners[np.abs(cosines) > np.cos(np.radians(_SHARP))])


class _Tops:
    """The greatest height along the hull, by bins of x; the hull's lowest and highest point."""

    def __init__(self, mesh):
        places, _ = spread_points(mesh.points, mesh.triangles, _SPREAD)
        self.start, self.step = mesh.points[:, 0].min(), mesh.length / _BINS
        self.heights = np.full(_BINS, -np.inf)
        np.maximum.at(self.heights, self.bins(places[:, 0]), places[:, 2])
        self.middle = 0.5 * (places[:, 2].min() + places[:, 2].max())
        self.depth = float(np.ptp(places[:, 2]))
        there = np.flatnonzero(np.isfinite(self.heights))
        self.heights = np.interp(np.arange(_BINS), there, self.heights[there])

    def bins(self, x):
        return np.clip(((x - self.start) / self.step).astype(int), 0, _BINS - 1)


def _is_deck(mesh, which, normals, areas, top):
    whole = areas[which].sum()
    flat = np.abs(normals[which, 2]) > _UPWARDS
    if areas[which][flat].sum() < _FLAT_SHARE * whole:
        return False
    middles = mesh.points[mesh.triangles[which]].mean(axis=1)
    if (areas[which] * middles[:, 2]).sum() < top.middle * whole:
        return False
    below = top.heights[top.bins(middles[:, 0])] - middles[:, 2]
    return (areas[which] * below).sum() < _BELOW_TOP * top.depth * whole


def _end_of(mesh, which, normals, areas):
    """("aft" or "forward", area, (place, normal)) of a patch that is a flat end; None of others."""
    corners = mesh.points[mesh.triangles[which]].reshape(-1, 3)
    if (np.abs(normals[which, 0]) < _ALONG).any() or corners[:, 1].min() > 0.0:
        return None
    place = corners.mean(axis=0)
    normal = (areas[which, None] * normals[which]).sum(axis=0)
    normal /= np.linalg.norm(normal)
    if np.abs((corners - place) @ normal).max() > _PLANE * mesh.length:
        return None
    if abs(normal[1]) > _ATHWART or areas[which].sum() < _LEAST_END * mesh.length**2:
        return None
    low, high = mesh.points[:, 0].min(), mesh.points[:, 0].max()
    for name, away in (("aft", place[0] - low), ("forward", high - place[0])):
        if away < _AT_END * mesh.length:
            return name, float(areas[which].sum()), (place, normal)
    return None


def _without_doubles(mesh, normals, areas):
    """Without pieces that lie on a larger one."""
    table = edge_table(mesh.triangles)
    pieces = members(components(len(mesh.triangles), table.owners[table.counts > 1]))
    pieces.sort(key=lambda which: areas[which].sum())
    lows, highs = np.array([_box(mesh, which) for which in pieces]).transpose(1, 0, 2)
    kept = np.ones(len(mesh.triangles), dtype=bool)
    reach = _DOUBLE * mesh.length
    for i, small in enumerate(pieces):
        is_within = (lows[i] > lows[i + 1 :] - reach) & (highs[i] < highs[i + 1 :] + reach)
        for k in np.flatnonzero(is_within.all(axis=1)) + i + 1:
            if _lies_on(mesh, small, pieces[k], normals, reach):
                kept[small] = False
                break
    return mesh.kept(kept), normals[kept], areas[kept]


def _box(mesh, which):
    corners = mesh.points[mesh.triangles[which]].reshape(-1, 3)
    return corners.min(axis=0), corners.max(axis=0)


def _lies_on(mesh, some, others, normals, reach):
    """Whether the middles of some triangles lie on others."""
    a, b, c = mesh.points[mesh.triangles[others]].transpose(1, 0, 2)
    for middle in mesh.points[mesh.triangles[some]].mean(axis=1):
        off = np.abs(((middle - a) * normals[others]).sum(axis=1))
        inside = off < reach
        for start, end in ((a, b), (b, c), (c, a)):
            side = (np.cross(end - start, middle - start) * normals[others]).sum(axis=1)
            inside &= side > -reach * np.linalg.norm(end - start, axis=1)
        if not inside.any():
            return False
    return True
