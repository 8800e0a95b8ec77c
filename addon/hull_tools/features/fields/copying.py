# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields of one hull given to another one, in proportion."""

import numpy as np
from mathutils.kdtree import KDTree

from ....hull_io.scale import Scale
from ...bridge import limits
from ...bridge.mesh import mesh_arrays, mesh_points
from ...bridge.objects import curve_lines, field_faces
from ..dimensions import following
from . import field_list


def copy(source, obj):
    """Adds all fields of a hull to another one: what is at a part of the one's length, breadth and
    height is at the same part of the other's. Curve objects are copied; faces are those that are
    nearest to theirs. Returns how many. ValueError where they are too many, and for hulls without
    extent."""
    rows = source.hull.fields.fields
    limits.at_most(len(rows) + len(obj.hull.fields.fields), "fields", limits.MOST_FIELDS)
    scale = _between(source, obj)
    lines = [_lines_of(row, source) for row in rows]  # all, before anything is added
    for row, own_lines in zip(rows, lines):
        made = field_list.copied(row, obj, row.name)
        following.follow_entry(made, "fields.fields.", scale)
        for name, (points, is_closed) in own_lines.items():
            title = getattr(row, name).name
            setattr(made, name, curve_lines.made(title, scale.points(points), is_closed, obj))
        faces = field_faces.of_field(source, row)
        field_faces.give(obj, made, _faces_like(faces, source, obj, scale))
    return len(rows)


def _lines_of(row, source):
    """(points (n, 3), whether closed) of the curve objects of a row, by its settings."""
    curves = {name: getattr(row, name) for name in ("curve", "becomes")}
    return {
        name: curve_lines.points_of(curve, source)
        for name, curve in curves.items()
        if curve is not None
    }


def _between(source, obj):
    """The Scale that takes the box around one hull's points to that around another's; breadths go
    by the greatest distances from the centre plane."""
    own, other = mesh_points.read(source.data), mesh_points.read(obj.data)
    if not (len(own) and len(other)):
        raise ValueError("A hull without points has no proportions")
    own, other = own.astype(np.float64), other.astype(np.float64)
    size, wanted = np.ptp(own, axis=0), np.ptp(other, axis=0)
    size[1], wanted[1] = np.abs(own[:, 1]).max(), np.abs(other[:, 1]).max()
    if not (size.min() > 0.0 and wanted.min() > 0.0):
        raise ValueError("A hull that is flat has no proportions")
    factors = wanted / size
    shift = other.min(axis=0) - factors * own.min(axis=0)
    shift[1] = 0.0
    return Scale(tuple(factors.tolist()), tuple(shift.tolist()))


def _faces_like(faces, source, obj, scale):
    """(k,) the faces of a hull to which one of these of another hull is nearer than all others."""
    if not len(faces):
        return faces
    middles = scale.points(_middles(source))
    tree = KDTree(len(middles))
    for index, middle in enumerate(middles):
        tree.insert(middle, index)
    tree.balance()
    nearest = [tree.find(middle)[1] for middle in _middles(obj)]
    return np.flatnonzero(np.isin(nearest, faces))


def _middles(obj):
    """(f, 3) mean points of a hull's faces."""
    data = mesh_arrays.read_mesh(obj.data)
    ends = np.cumsum(data.face_sizes) - data.face_sizes
    sums = np.add.reduceat(data.points[data.face_vertices].astype(np.float64), ends)
    return sums / data.face_sizes[:, None]
