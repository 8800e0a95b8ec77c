# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve objects as hull_native.NetworkCurves, in m."""

import numpy as np

from ...bridge import native
from . import planes

_WITH_DIRECTION = ("TANGENT",)
_SLAVES = ("SLAVE_TANGENT", "SLAVE_CURVATURE")


def key_of(obj, read, scale, order):
    """What the definition of a curve object depends on, to be compared. read: its points, weights
    and knuckles, of a KnownCurve. order: the names of all
    curves of the network that are joined, as they are numbered."""
    own = obj.hull.curve
    plane = planes.plane_of(own)
    return (
        obj.name,
        scale,
        read.points.tobytes(),
        read.weights.tobytes(),
        read.knuckles,
        own.kind,
        own.role,
        own.shape,
        own.fullness,
        None if plane is None else (*plane[0], plane[1]),
        _end_key(own, "start", order),
        _end_key(own, "end", order),
    )


def _end_key(own, name, order):
    kind, master = getattr(own, name), getattr(own, f"{name}_master")
    direction = tuple(getattr(own, f"{name}_direction")) if kind in _WITH_DIRECTION else ()
    number = order.get(master.name, -1) if kind in _SLAVES and master is not None else -1
    return kind, direction, number


def network_curve(obj, read, scale, order):
    """The hull_native.NetworkCurve of a curve object; ValueError, naming it, where its settings
    do not make one."""
    own = obj.hull.curve
    points = read.points * scale
    _check_plane(obj)
    plane = planes.plane_of(own)
    kind = "knuckle" if own.role == "KNUCKLE" else own.kind.lower()
    return native.require().NetworkCurve(
        obj.name,
        points,
        kind=kind,
        shape=own.shape.lower(),
        weights=() if own.shape != "FREE" else read.weights,
        knuckles=read.knuckles if own.shape == "FREE" else (),
        fullness=own.fullness,
        plane=None if plane is None else (*plane[0], plane[1] * scale),
        start=_end(obj, "start", points[1] - points[0], order),
        end=_end(obj, "end", points[-1] - points[-2], order),
    )


def _check_plane(obj):
    if obj.hull.curve.plane != "NONE" and planes.plane_of(obj.hull.curve) is None:
        raise ValueError(f'The plane of "{obj.name}" has no normal: give it another one')


def _end(obj, name, along, order):
    """A hull_native.CurveEnd; along: roughly how the curve runs there."""
    own, curve_end = obj.hull.curve, native.require().CurveEnd
    kind = getattr(own, name)
    if kind in _SLAVES:
        master = getattr(own, f"{name}_master")
        if master is None:
            raise ValueError(f'The {name} of "{obj.name}" follows no curve: choose one')
        if master == obj or master.name not in order:
            raise ValueError(
                f'The {name} of "{obj.name}" follows "{master.name}", which is no other curve of '
                "the network: choose another one"
            )
        return curve_end(kind.lower(), master=order[master.name])
    if kind in _WITH_DIRECTION:
        direction = np.array(getattr(own, f"{name}_direction"), dtype=np.float64)
        if not np.linalg.norm(direction) > 1e-6:
            raise ValueError(f'The {name} of "{obj.name}" has no direction: give it another one')
        return curve_end("tangent", direction=direction * (-1.0 if direction @ along < 0 else 1.0))
    return curve_end(kind.lower())
