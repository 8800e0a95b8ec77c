# SPDX-License-Identifier: GPL-3.0-or-later
"""HullData brought to main dimensions while bilge, bulb or knuckles keep their shape."""

import numpy as np

from .scaling import follow, to_dimensions
from .shell import shell_arrays
from .stretching import stretch_to

# What can be kept, as hull_native.kept_ranges has it.
KEPT = ("bilge", "bulb", "knuckles")


def to_dimensions_keeping(data, native, keep, *, length_pp=None, beam=None, draft=None, depth=None):
    """(a new HullData, the hull_native.MappedSurface) of one brought to main dimensions in m, of
    which what is named in keep, of KEPT, keeps its shape; None for the surface where factors alone
    do that. The rest as to_dimensions.

    native: the module hull_native. ValueError as stretch_to and hull_native.kept_ranges.
    """
    unknown = set(keep) - set(KEPT)
    if unknown:
        raise ValueError(f"{', '.join(KEPT)} can be kept, not {', '.join(sorted(unknown))}")
    given = {"length": length_pp, "beam": beam, "draft": draft, "depth": depth}
    plain = to_dimensions(data, length_pp=length_pp, beam=beam, draft=draft, depth=depth)
    shell, now = shell_arrays(data), data.particulars
    mesh = native.ControlMesh(*shell.arguments())
    surface = native.LimitSurface(mesh, data.scheme)
    body = native.HullBody(surface, mirrored=data.half)
    kept = native.kept_ranges(
        body, draft=now.draft, length_pp=now.length_pp or None, depth=now.depth or None,
        **{name: True for name in keep},
    )  # fmt: skip
    stretch = stretch_to(now, kept, *native.surface_ends(surface), **given)
    if stretch is None:
        return plain, None
    number = {old: new for new, old in enumerate(shell.point_indices.tolist())}
    flats = [_flat_points(data, flat, number) for flat in data.flats]
    mapped = native.map_surface(
        surface, stretch, locked=_numbers(data.locked, number), flats=flats,
        **_held(data, surface, flats, number, native),
    )  # fmt: skip
    made = follow(data, stretch)
    made.points[shell.point_indices] = mapped.points
    for flat, (normal, offset) in zip(made.flats, mapped.planes):
        flat.normal, flat.offset = tuple(normal.tolist()), offset
    for name, value in zip(("length_pp", "beam", "draft", "depth"), given.values()):
        if value is not None:
            setattr(made.particulars, name, float(value))
    return made, mapped


def _numbers(points, number):
    return [number[point] for point in points if point in number]


def _flat_points(data, flat, number):
    points = sorted({point for face in flat.faces for point in data.faces[face]})
    own = np.array(_numbers(points, number), dtype=np.int64)
    return own, np.array(flat.normal), flat.offset


def _held(data, surface, flats, number, native):
    """held_points and held_normals of map_surface."""
    kept = (data.kept.stations, data.kept.buttocks, data.kept.waterlines)
    pairs = [flat[:2] for flat in flats]
    pairs += [(_numbers(own, number), axis) for own, axis in zip(kept, np.eye(3))]
    if data.half:
        points = surface.mesh.points
        near = native.tolerances.ON_CENTRE_PLANE * surface.mesh.size
        pairs.append((np.flatnonzero(np.abs(points[:, 1]) <= near), np.eye(3)[1]))
    return {
        "held_points": np.concatenate([np.asarray(own, dtype=np.int64) for own, _ in pairs]),
        "held_normals": np.concatenate(
            [np.tile(np.asarray(normal), (len(own), 1)) for own, normal in pairs]
        ),
    }
