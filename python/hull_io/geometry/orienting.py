# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry brought to a ship's axes."""

from dataclasses import replace

import numpy as np


def oriented(geometry, guess):
    """The Geometry in metres, x forward from the after perpendicular, y to port from the centre
    plane, z up from the base line, by a Guess. A starboard half becomes the port one; triangles
    turn with a reflection, so that what looked outwards does."""
    matrix = guess.matrix()
    origin, scale = np.asarray(guess.origin), guess.metres_per_unit
    is_reflected = np.linalg.det(matrix) < 0.0

    def placed(points):
        return scale * ((points - origin) @ matrix.T)

    return replace(
        geometry,
        unit="m",
        curves=tuple(_placed_curve(curve, placed) for curve in geometry.curves),
        meshes=tuple(
            replace(
                mesh,
                points=placed(mesh.points),
                triangles=mesh.triangles[:, ::-1] if is_reflected else mesh.triangles,
            )
            for mesh in geometry.meshes
        ),
        points=placed(geometry.points),
        is_half=guess.is_half,
        on_ship_axes=True,
    )


def _placed_curve(curve, placed):
    spline = curve.spline
    if spline is not None:
        spline = replace(spline, points=placed(spline.points))
    return replace(curve, points=placed(curve.points), spline=spline)
