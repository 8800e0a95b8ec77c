# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles from STL files, binary or text, as shapes to which hulls are fitted, and into them.

Files are not trusted: counts are held against the bytes that there are, and numbers must be finite
and near enough. A binary file may begin with "solid" as a text does; its length tells it apart.
"""

from pathlib import Path

import numpy as np

from .bytes_on_disk import read_bytes, write_bytes
from .errors import HullFileError
from .limits import FURTHEST_POINT, MAX_STL_BYTES, MAX_STL_TEXT_BYTES
from .real_points import real_points

_HEADER = 84
_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_REMEDY = "write it again as binary STL, or use another copy"


def read_stl(path):
    """(points (n, 3) double, triangles (m, 3)) in the file's unit; corners at the same place are
    one point, and triangles that are a line or a point are left out. HullFileError where there is
    nothing to read."""
    path = Path(path)
    return parse_stl(read_bytes(path, MAX_STL_BYTES), path.name)


def parse_stl(data, name):
    """The same of a file's bytes; name: of the file, for messages."""
    corners = _binary_corners(data)
    if corners is None:
        corners = _text_corners(data, name)
    if not np.isfinite(corners).all() or np.abs(corners).max(initial=0.0) > FURTHEST_POINT:
        raise HullFileError(
            f"{name}: a corner of a triangle is no place within {FURTHEST_POINT:.0f}; "
            f"{_REMEDY}."
        )
    points, indices = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    triangles = indices.reshape(-1, 3)
    following = np.roll(triangles, -1, axis=1)
    triangles = triangles[(triangles != following).all(axis=1)]
    if not len(triangles):
        raise HullFileError(f"{name}: there is no triangle in it; choose an STL file.")
    return points.astype(np.float64), triangles


def write_stl(path, points, triangles):
    """A binary STL file of points (n, 3), m, and triangles (m, 3). Its numbers have single
    precision: on 100 m they are within 4 µm. HullFileError where it can't be written; ValueError
    for points that are no places within reach, and triangles of other points."""
    write_bytes(Path(path), bytes_of_stl(points, triangles))


def bytes_of_stl(points, triangles):
    """The bytes of such a file."""
    points, triangles = real_points(points), np.asarray(triangles)
    if not np.isfinite(points).all() or np.abs(points).max(initial=0.0) > FURTHEST_POINT:
        raise ValueError(f"A point is no place within {FURTHEST_POINT:.0f} m: check the units.")
    if triangles.size and not (0 <= triangles.min() and triangles.max() < len(points)):
        raise ValueError(f"A triangle has other corners than points 0 to {len(points) - 1}.")
    records = np.zeros(len(triangles), dtype=_RECORD)
    records["corners"] = points[triangles.reshape(-1, 3)]
    a, b, c = records["corners"].astype(float).transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    records["normal"] = normals / np.where(lengths > 0.0, lengths, 1.0)[:, None]
    # admesh prints it up to a zero, wherever that is.
    header = b"Hull Tools".ljust(_HEADER - 4, b"\0") + len(triangles).to_bytes(4, "little")
    return header + records.tobytes()


def _binary_corners(data):
    """(m, 3, 3), or None where the length is not that of a binary file."""
    if len(data) < _HEADER:
        return None
    count = int.from_bytes(data[80:_HEADER], "little")
    if len(data) != _HEADER + count * _RECORD.itemsize:
        return None
    return np.frombuffer(data, _RECORD, count, _HEADER)["corners"].astype(np.float64)


def _text_corners(data, name):
    if not data[:512].lstrip().lower().startswith(b"solid"):
        raise HullFileError(
            f"{name}: it is neither a binary STL file of full length nor a text that begins with "
            f"'solid'; {_REMEDY}."
        )
    if len(data) > MAX_STL_TEXT_BYTES:
        raise HullFileError(
            f"{name}: as a text it has {len(data) / 2**20:.0f} MB, more than the "
            f"{MAX_STL_TEXT_BYTES / 2**20:.0f} MB that are read; write it as binary STL."
        )
    numbers = []
    for number, line in enumerate(data.splitlines(), 1):
        words = line.split()
        if not words or words[0].lower() != b"vertex":
            continue
        try:
            x, y, z = map(float, words[1:])
        except ValueError as error:
            raise HullFileError(
                f"{name}: line {number}: three numbers are wanted after 'vertex'; {_REMEDY}."
            ) from error
        numbers.append((x, y, z))
    if len(numbers) % 3:
        raise HullFileError(
            f"{name}: it has {len(numbers)} corners, which is not three for each triangle; the "
            f"file is cut short: {_REMEDY}."
        )
    # Binary files have single precision: corners that are one there are one here.
    return np.array(numbers, dtype=np.float32).astype(np.float64).reshape(-1, 3, 3)
