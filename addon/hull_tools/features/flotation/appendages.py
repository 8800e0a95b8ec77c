# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that are joined to a hull or cut out of it, as the native module takes them."""

import numpy as np

from ...bridge import native

_MOST_REACH = 10.0  # of the hull's size: beyond it, nothing is an appendage of this hull


def native_bodies(bodies, scale, hull_points):
    """A list of hull_native.Appendage of AppendageBody; scale: metres of Blender's unit;
    hull_points (n, 3): the hull's control points, m. ValueError names the appendage that is none,
    or is out of all proportion to the hull: to join such a one would take without end."""
    low, high = np.min(hull_points, axis=0), np.max(hull_points, axis=0)
    most = _MOST_REACH * np.max(high - low)
    for body in bodies:
        places = scale * np.array(body.points) - 0.5 * (low + high)
        lengths = scale * np.array([0.0, *body.sizes])
        if not max(np.abs(places).max(), np.abs(lengths).max()) <= most:
            raise ValueError(
                f"{body.name} reaches more than {_MOST_REACH:.0f} times the hull's size: change its"
                " numbers or its place"
            )
    return [native_body(body, scale) for body in bodies]


def native_body(body, scale):
    """The hull_native.Appendage of an AppendageBody."""
    if body.is_uneven:
        raise ValueError(
            f"{body.name} is scaled unevenly or mirrored: clear its scale (Alt S), set its numbers"
        )
    hull_native = native.require()
    how = {"name": body.name, "cut": body.is_cut, "mirrored": body.is_mirrored}
    points = [[scale * value for value in point] for point in body.points]
    sizes = [scale * size for size in body.sizes]
    try:
        if body.shape == "CYLINDER":
            return hull_native.cylinder(*points, sizes[0], end_radius=sizes[1], **how)
        if body.shape == "BULB":
            return hull_native.bulb(body.section, *points, *sizes, **how)
        return hull_native.foil(
            body.section,
            *points,
            sizes[0],
            tip_chord=sizes[1],
            chord_direction=body.directions[0],
            thickness_direction=body.directions[1],
            root_thickness=body.ratios[0],
            tip_thickness=body.ratios[1],
            **how,
        )
    except ValueError as error:
        raise ValueError(f"{body.name}: {error}") from error
