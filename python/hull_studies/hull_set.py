# SPDX-License-Identifier: GPL-3.0-or-later
"""The hulls of a study as arrays of one topology: what workers get, and all that they need of it.

Hulls of other layouts get the first one's (hull_native.common_layout); that is done once, here, and
not by each worker.
"""

import hashlib
from dataclasses import dataclass, fields, replace
from functools import cached_property

import hull_io
import hull_native as hn
import numpy as np

from .changes import column_names
from .making import DIMENSIONS, Maker


@dataclass(frozen=True, eq=False)
class HullSet:
    """Plain arrays, so that it can be pickled. parents: (p, n, 3) control points, m; dimensions:
    (p, 4) Lpp, beam, draft and depth; mirrored: whether all are port halves. locked (l,),
    held_points (h,), held_normals (h, 3): as of hull_native.Reshape; flats_across: control points
    of each flat that is not along the ship."""

    face_sizes: np.ndarray
    face_vertices: np.ndarray
    creases: np.ndarray
    corners: np.ndarray
    scheme: str
    mirrored: bool
    parents: np.ndarray
    dimensions: np.ndarray
    water_density: float
    locked: np.ndarray
    held_points: np.ndarray
    held_normals: np.ndarray
    flats_across: list

    @cached_property
    def digest(self):
        """Of all of it: what has the same one gives the same rows."""
        digest = hashlib.sha256()
        for one in fields(self):
            held = getattr(self, one.name)
            for part in held if isinstance(held, list) else [held]:
                array = np.ascontiguousarray(part)
                told = f"{one.name} {array.dtype.str} {array.shape} "
                digest.update(told.encode() + array.tobytes())
        return digest.hexdigest()


def hull_set(study, progress=None):
    """The HullSet of a Study. ValueError, with the hull's number from 1 on, for one that can't be
    read, is another kind of half, has other bodies than the first, or can't be made. progress: told
    the share that is done, from 0 to 1, where hulls must be laid onto others."""
    data = hull_io.read_hull(study.hulls[0])
    first = _of_file(data)
    surfaces, dimensions, kinds = [_surface(first)], [first.dimensions[0]], []
    for number, source in enumerate(study.hulls[1:], start=2):
        try:
            found = _made(first, source) if isinstance(source, list) else _read(source)
        except ValueError as error:
            raise ValueError(f"Hull {number} of the study can't be made. {error}") from None
        kinds.append(found.mirrored)
        surfaces.append(_surface(found))
        dimensions.append(found.dimensions[0])
    _check_halves(first.mirrored, kinds)
    first = replace(first, dimensions=np.array(dimensions))
    if len(surfaces) == 1 or not hn.family_differences(surfaces):
        parents = np.array([one.mesh.points for one in surfaces])
        return replace(first, parents=parents)
    return _laid_out(first, hn.common_layout(surfaces, progress=progress))


def _surface(hulls):
    arrays = (hulls.face_sizes, hulls.face_vertices, hulls.creases, hulls.corners)
    return hn.LimitSurface(hn.ControlMesh(hulls.parents[0], *arrays), hulls.scheme)


def _read(path):
    return _of_file(hull_io.read_hull(path))


def _made(first, changes):
    """Of the first hull by changes of its own."""
    maker = Maker(first)
    water = {"draft": None, "trim": None, "water_density": None, "openings": "closed"}
    form, told = maker.made(changes, column_names(changes), water)
    if told.misses:
        raise ValueError(" ".join(told.misses))
    dimensions = np.array([[getattr(form, name) for name in DIMENSIONS]])
    return replace(first, parents=form.points[None], dimensions=dimensions)


def _check_halves(half, others):
    for number, other in enumerate(others, start=2):
        if other != half:
            names = {True: "a half", False: "a hull of both sides"}
            raise ValueError(
                f"Hull {number} of the study is {names[other]}, the first is {names[half]}: mirror "
                "the half, or split the whole."
            )


def _of_file(data):
    """The HullSet of one HullData."""
    shell, ship = hull_io.shell_arrays(data), data.particulars
    number = {old: new for new, old in enumerate(shell.point_indices.tolist())}
    flats = [_flat(data, flat, number) for flat in data.flats]
    along = [flat for flat in flats if flat[1][0] == 0.0]
    axes = np.eye(3)
    kept = (data.kept.stations, data.kept.buttocks, data.kept.waterlines)
    held = [*along, *((_numbered(own, number), axis) for own, axis in zip(kept, axes))]
    if data.half:
        size = float(np.linalg.norm(np.ptp(shell.points, axis=0)))
        near = hn.tolerances.ON_CENTRE_PLANE * size
        held.append((np.flatnonzero(np.abs(shell.points[:, 1]) <= near), axes[1]))
    points, normals = _joined(held)
    return HullSet(
        face_sizes=shell.face_sizes,
        face_vertices=shell.face_vertices,
        creases=shell.creases,
        corners=shell.corners,
        scheme=data.scheme,
        mirrored=data.half,
        parents=shell.points[None],
        dimensions=np.array([[getattr(ship, name) for name in DIMENSIONS]]),
        water_density=ship.water_density or hn.SEA_WATER_DENSITY,
        locked=_numbered(data.locked, number),
        held_points=points,
        held_normals=normals,
        flats_across=[points for points, normal in flats if normal[0] != 0.0],
    )


def _numbered(points, number):
    return np.array([number[point] for point in points if point in number], dtype=np.int64)


def _flat(data, flat, number):
    points = sorted({point for face in flat.faces for point in data.faces[face]})
    return _numbered(points, number), np.array(flat.normal, dtype=np.float64)


def _joined(held):
    """held_points and held_normals of [(points, normal)]."""
    points = [np.asarray(own, dtype=np.int64) for own, _ in held]
    normals = [np.tile(np.asarray(normal, dtype=np.float64), (len(own), 1)) for own, normal in held]
    empty = np.empty(0, dtype=np.int64), np.empty((0, 3))
    return np.concatenate([empty[0], *points]), np.concatenate([empty[1], *normals])


def _laid_out(first, layout):
    """Of hulls that were laid onto one another. What holds then is what is flat in each of them,
    and the centre plane: locked and kept points are the first file's alone."""
    surface = layout.parents[0]
    mesh = surface.mesh
    held = []
    for fit in layout.fits:
        if fit is not None and len(fit.second.mesh.points) == len(mesh.points):
            held += [(points, _normal(mesh.points[points])) for points in fit.flats]
    along = [(points, normal) for points, normal in held if abs(normal[0]) < 1e-6]
    if first.mirrored:
        near = hn.tolerances.ON_CENTRE_PLANE * mesh.size
        along.append((np.flatnonzero(np.abs(mesh.points[:, 1]) <= near), np.eye(3)[1]))
    points, normals = _joined(along)
    return replace(
        first,
        face_sizes=mesh.face_sizes,
        face_vertices=mesh.face_vertices,
        creases=mesh.creases,
        corners=np.flatnonzero(mesh.vertex_kinds >= 3),
        parents=np.array([one.mesh.points for one in layout.parents]),
        locked=np.empty(0, dtype=np.int64),
        held_points=points,
        held_normals=normals,
        flats_across=[own for own, normal in held if abs(normal[0]) >= 1e-6],
    )


def _normal(points):
    """Of the plane that points (k, 3) are in."""
    return np.linalg.svd(points - points.mean(axis=0))[2][2]
