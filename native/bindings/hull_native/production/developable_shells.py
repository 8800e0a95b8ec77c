# SPDX-License-Identifier: GPL-3.0-or-later
"""Developable surfaces by their rulings from curves along edges of a control mesh: the strip
between two, cones to a point, cylinders along a direction. Lengths are in metres; there are about
`count` rulings, as many in each span."""

from dataclasses import dataclass

import numpy as np

from .._production import DevelopableStrip

# Where along half an edge the curve is taken, and the cubic's Bézier points through these.
_THIRDS = np.array([0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0])
_TO_BEZIER = np.linalg.inv(
    np.stack([(1 - _THIRDS) ** 3, 3 * _THIRDS * (1 - _THIRDS) ** 2,
              3 * _THIRDS**2 * (1 - _THIRDS), _THIRDS**3], axis=1)
)  # fmt: skip


@dataclass(frozen=True)
class RuledShell:
    """Rulings of a developable surface: first, second (n, 3), their ends."""

    first: np.ndarray
    second: np.ndarray

    @property
    def area(self):
        """m², of the triangles between the rulings."""
        a, b = self.first, self.second
        one = np.cross(a[1:] - a[:-1], b[:-1] - a[:-1])
        other = np.cross(b[1:] - a[1:], b[:-1] - a[1:])
        return 0.5 * float((np.linalg.norm(one, axis=1) + np.linalg.norm(other, axis=1)).sum())


def edge_curve(surface, vertices):
    """Bézier points (8 (k - 1), 3) of the curve of a LimitSurface along edges between control
    points (k,), in order, two cubics an edge: exactly the curve of creases and borders, and
    elsewhere through four points of it. ValueError where two points have no edge between them."""
    vertices = [int(one) for one in vertices]
    if len(vertices) < 2:
        raise ValueError("A curve along edges needs two control points or more.")
    where = _sides(surface.mesh)
    cells, uv = [], []
    for a, b in zip(vertices, vertices[1:]):
        if (a, b) in where:
            (own, beyond), is_turned = where[a, b], False
        elif (b, a) in where:
            (beyond, own), is_turned = where[b, a], True
        else:
            raise ValueError(f"There is no edge between the control points {a} and {b}.")
        # From a corner along its side, and back to the other corner.
        along, back = (_THIRDS, 0.0 * _THIRDS), (0.0 * _THIRDS, 1.0 - _THIRDS)
        if is_turned:
            along, back = (0.0 * _THIRDS, _THIRDS), (1.0 - _THIRDS, 0.0 * _THIRDS)
        cells += [own] * 4 + [beyond] * 4
        uv += [np.stack(along, axis=1), np.stack(back, axis=1)]
    (points,) = surface.evaluate(np.array(cells), np.concatenate(uv))
    return (_TO_BEZIER @ points.reshape(-1, 4, 3)).reshape(-1, 3)


def _sides(mesh):
    """{(a, b): (cell at a, cell at b)} of the sides of all faces, in their direction."""
    found, first = {}, 0
    corners = np.asarray(mesh.face_vertices).tolist()
    for size in np.asarray(mesh.face_sizes).tolist():
        for k in range(size):
            following = first + (k + 1) % size
            found[corners[first + k], corners[following]] = first + k, following
        first += size
    return found


def strip_between(a, b, count=60):
    """The RuledShell of the DevelopableStrip between curves of Bézier points, turned so that they
    run the same way."""
    if np.linalg.norm(a[0] - b[0]) + np.linalg.norm(a[-1] - b[-1]) > (
        np.linalg.norm(a[0] - b[-1]) + np.linalg.norm(a[-1] - b[0])
    ):
        b = b[::-1]
    return RuledShell(*map(np.asarray, DevelopableStrip(a, b, count).ends))


def cone_to(curve, apex, count=60):
    """The RuledShell of the cone from a curve of Bézier points to an apex (3,), m. ValueError as
    DevelopableStrip.cone()."""
    return RuledShell(*map(np.asarray, DevelopableStrip.cone(curve, apex, count=count).ends))


def cylinder_along(curve, shift, count=60):
    """The RuledShell of the cylinder from a curve of Bézier points along a shift (3,), m, which its
    rulings are as long as. ValueError as DevelopableStrip.cylinder()."""
    length = float(np.linalg.norm(shift))
    if not length > 0.0:
        raise ValueError("A cylinder needs a direction and a length above 0 m.")
    made = DevelopableStrip.cylinder(curve, direction=shift, length=length, count=count)
    return RuledShell(*map(np.asarray, made.ends))
