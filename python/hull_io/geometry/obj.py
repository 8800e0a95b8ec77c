# SPDX-License-Identifier: GPL-3.0-or-later
"""OBJ files: a mesh for each object or group, faces of any corners as triangles, lines as
curves."""

import numpy as np

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_GEOMETRY_POINTS
from ..table_text import decoded
from .values import Geometry, GeometryMesh, polyline


def read_obj(data, name):
    """The Geometry of the bytes of a file. HullFileError with line and remedy."""
    return _Reader(name).read(decoded(data))


class _Reader:
    def __init__(self, name):
        self.name = name
        self.points, self.lines, self.others = [], [], set()
        self.triangles, self.group = {}, ""
        self.corners = 0

    def error(self, line, problem):
        return HullFileError(
            f"{self.name}: line {line}: {problem}; write the file again, or use another copy."
        )

    def read(self, text):
        for number, line in enumerate(text.splitlines(), 1):
            words = line.split()
            if words:
                self._take(number, words[0], words[1:])
        points = np.array(self.points, dtype=float).reshape(-1, 3)
        meshes = tuple(_mesh(points, parts, group) for group, parts in self.triangles.items())
        curves = [polyline(points[line], name=group, group=group) for group, line in self.lines]
        curves = tuple(curve for curve in curves if curve is not None)
        rest = points if not meshes and not curves else np.empty((0, 3))
        left_out = tuple(f"'{word}' is not read, and left out." for word in sorted(self.others))
        found = Geometry(self.name, "OBJ", None, curves, meshes, rest, left_out)
        if found.is_empty:
            raise HullFileError(f"{self.name}: there is no face in it; choose an OBJ file.")
        return found

    def _take(self, number, word, rest):
        if word == "v":
            self._add_point(number, rest)
        elif word == "f":
            face = self._indices(number, rest)
            if len(face) < 3:
                raise self.error(number, "a face has fewer than three corners")
            fan = self.triangles.setdefault(self.group, [])
            fan += [(face[0], b, c) for b, c in zip(face[1:], face[2:])]
        elif word == "l":
            self.lines.append((self.group, self._indices(number, rest)))
        elif word in ("o", "g"):
            self.group = " ".join(rest)[:100]
        elif word in ("curv", "curv2", "surf"):
            self.others.add(word)

    def _add_point(self, number, words):
        try:
            point = tuple(map(float, words[:3]))
        except ValueError:
            point = ()
        if len(point) != 3 or not all(abs(value) <= FURTHEST_POINT for value in point):
            raise self.error(number, f"three numbers within {FURTHEST_POINT:.0f} are wanted")
        if len(self.points) == MAX_GEOMETRY_POINTS:
            raise self.error(number, f"there are more than {MAX_GEOMETRY_POINTS} points")
        self.points.append(point)

    def _indices(self, number, words):
        """Numbers of points, from 0; in the file from 1, or backwards from -1."""
        self.corners += len(words)
        if self.corners > 6 * MAX_GEOMETRY_POINTS:
            raise self.error(number, "there are too many corners of faces")
        indices = []
        for word in words:
            try:
                index = int(word.split("/")[0][:12])
            except ValueError:
                raise self.error(number, f"'{word[:20]}' is no number of a point") from None
            index = index - 1 if index > 0 else len(self.points) + index
            if not 0 <= index < len(self.points):
                raise self.error(number, f"'{word[:20]}' is no point that stands before it")
            indices.append(index)
        return indices


def _mesh(points, triangles, group):
    """With the points that it uses, and without triangles that are a line."""
    triangles = np.array(triangles)
    used, numbers = np.unique(triangles, return_inverse=True)
    triangles = numbers.reshape(-1, 3)
    corners = points[used]
    triangles = triangles[(triangles != np.roll(triangles, -1, axis=1)).all(axis=1)]
    return GeometryMesh(corners, triangles, group, group)
