# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendages of a hull: mesh objects that are its children and show a body by its settings.

The body is that of the settings, Object.hull.appendage, in the object's own axes, wherever the
object is moved and turned to; the mesh only shows it. A scaled object's lengths are those of the
mesh that is seen; one that is scaled unevenly is no such body.
"""

from dataclasses import dataclass
from math import nan

from mathutils import Vector

from . import hull_objects


@dataclass(frozen=True)
class AppendageBody:
    """name: of the object. shape: "CYLINDER", "FOIL" or "BULB". section: its name, "" for
    cylinders. points, directions: of the shape, (x, y, z) each, in Blender's units; sizes: lengths,
    in these too; ratios: thickness of the chord, zero for the section's own. See `described`."""

    name: str
    shape: str
    section: str
    points: tuple
    directions: tuple
    sizes: tuple
    ratios: tuple
    is_cut: bool
    is_mirrored: bool
    is_uneven: bool = False


_EVEN = 1e-5  # of the scale: single precision


def is_appendage(obj):
    return obj is not None and obj.type == "MESH" and obj.hull.appendage.shape != "NONE"


def of_hull(hull):
    """All appendage objects of a hull, in the order of their names."""
    children = (child for child in hull.children if is_appendage(child))
    return sorted(children, key=lambda child: child.name)


def hull_of(obj):
    """The hull that an appendage belongs to, None if there is none."""
    if not is_appendage(obj) or not hull_objects.is_hull(obj.parent):
        return None
    return obj.parent


def hull_at_hand(obj):
    """The hull of an active object, also while that is one of its appendages; None without any."""
    return hull_of(obj) or hull_objects.hull_of(obj)


def read(hull):
    """AppendageBody of each appendage of a hull that counts, on the hull's axes."""
    counting = (obj for obj in of_hull(hull) if obj.hull.appendage.counts)
    return tuple(described(obj, on_hull(obj)) for obj in counting)


def on_hull(obj):
    """The matrix from an appendage's own axes to its hull's."""
    return obj.matrix_parent_inverse @ obj.matrix_basis


def described(obj, matrix=None):
    """AppendageBody of an appendage object, by default in its own axes.

    Its axes: x forward, y to port, z up. A cylinder runs along z from the origin, `length` up; a
    foil from the leading edge of its root at the origin to the tip `span` below, which is `sweep`
    aft and `lean` to port, its chord aft; a bulb from its nose at the origin aft.
    """
    own = obj.hull.appendage
    points, directions, sizes, ratios = _SHAPES[own.shape](own)
    is_uneven = False
    if matrix is not None:
        turn = matrix.to_3x3()
        scales = [column.length for column in turn.col]
        factor = sum(scales) / 3.0
        is_uneven = turn.determinant() <= 0.0 or max(scales) - min(scales) > _EVEN * factor
        points = [matrix @ Vector(point) for point in points]
        directions = [(turn @ Vector(direction)).normalized() for direction in directions]
        sizes = [factor * size for size in sizes]
    return AppendageBody(
        obj.name,
        own.shape,
        own.section if own.shape != "CYLINDER" else "",
        tuple(map(_like_itself, points)),
        tuple(map(_like_itself, directions)),
        _like_itself(sizes),
        _like_itself(ratios),
        own.is_cut,
        own.is_mirrored,
        is_uneven,
    )


def _like_itself(values):
    """A tuple that equals that of the next time: what is no number is always the same object."""
    return tuple(nan if value != value else value for value in values)


def _cylinder(own):
    ends = [(0.0, 0.0, 0.0), (0.0, 0.0, own.length)]
    return ends, [], [own.radius, own.end_radius or own.radius], []


def _foil(own):
    edges = [(0.0, 0.0, 0.0), (-own.sweep, own.lean, -own.span)]
    directions = [(-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    chords = [own.chord, own.tip_chord or own.chord]
    return edges, directions, chords, [own.thickness, own.tip_thickness]


def _bulb(own):
    return [(0.0, 0.0, 0.0), (-own.length, 0.0, 0.0)], [], [2.0 * own.radius], []


_SHAPES = {"CYLINDER": _cylinder, "FOIL": _foil, "BULB": _bulb}
