# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendage objects of a hull, and hull_io's Appendage: to files, from files, and scaled with their
hull."""

import numpy as np
from mathutils import Matrix, Vector

from ....hull_io.scaling import CHANGES, FOLLOWING
from ....hull_io.ship_data import Appendage
from ...bridge.blender.units import as_stored
from ...bridge.objects import appendages
from ..flotation.appendages import native_body
from . import appendage_meshes

_PLACE = "appendages."


def take_appendages(hull, scale):
    """The list of Appendage of a hull; scale: metres of Blender's unit. ValueError for an object
    that is no body."""
    return [_taken(obj, scale) for obj in appendages.of_hull(hull)]


def _taken(obj, scale):
    body = appendages.described(obj, appendages.on_hull(obj))
    native_body(body, scale)
    points = [tuple(as_stored(part) * scale for part in point) for point in body.points]
    sizes = tuple(as_stored(size) * scale for size in body.sizes)
    made = Appendage(
        body.name,
        body.shape.lower(),
        *points,
        sizes if len(sizes) == 2 else sizes * 2,
        section=body.section,
        on=obj.hull.appendage.counts,
        cut=body.is_cut,
        mirrored=body.is_mirrored,
    )
    if body.directions:
        made.chord_direction, made.thickness_direction = (
            tuple(as_stored(part) for part in direction) for direction in body.directions
        )
        made.thicknesses = tuple(as_stored(part) for part in body.ratios)
    return made


def give_appendages(hull, given, scale, collection):
    """New objects of a hull for a list of Appendage. ValueError for what is no body, and then there
    are those before it."""
    for appendage in given:
        place, values = _settings(appendage, scale)
        values.update(
            counts=appendage.on, is_cut=appendage.cut, is_mirrored=appendage.mirrored,
            section=appendage.section,
        )  # fmt: skip
        obj = appendage_meshes.add(hull, appendage.name, place.translation, values, collection)
        obj.rotation_euler = place.to_euler()


def follow(hull, scale):
    """Gives a hull's appendages what a hull_io.scale.Scale in Blender's units makes of them;
    objects that are no bodies stay as they are."""
    for obj in appendages.of_hull(hull):
        try:
            appendage = _taken(obj, 1.0)
        except ValueError:
            continue
        for path, change in FOLLOWING.items():
            if path.startswith(_PLACE):
                name = path[len(_PLACE) :]
                setattr(
                    appendage, name, CHANGES[change](scale, appendage, getattr(appendage, name))
                )
        place, values = _settings(appendage, 1.0)
        for name, value in values.items():
            setattr(obj.hull.appendage, name, value)
        obj.scale = (1.0, 1.0, 1.0)
        obj.matrix_parent_inverse.identity()
        obj.location = place.translation
        _turn(obj, place)


def _turn(obj, place):
    """Gives an object the rotation of a matrix, in the way that its own is told."""
    if obj.rotation_mode == "QUATERNION":
        obj.rotation_quaternion = place.to_quaternion()
    elif obj.rotation_mode == "AXIS_ANGLE":
        axis, angle = place.to_quaternion().to_axis_angle()
        obj.rotation_axis_angle = (angle, *axis)
    else:
        obj.rotation_euler = place.to_euler(obj.rotation_mode)


def _settings(appendage, scale):
    """(matrix on the hull, values of Object.hull.appendage) by the form of an Appendage."""
    start, end = (Vector(point) / scale for point in (appendage.start, appendage.end))
    sizes = [size / scale for size in appendage.sizes]
    way = end - start
    if appendage.shape == "cylinder":
        turn = _turn_to(way, 2)
        values = {"length": way.length, "radius": sizes[0], "end_radius": sizes[1]}
    elif appendage.shape == "bulb":
        turn = _turn_to(-way, 0)
        values = {"length": way.length, "radius": 0.5 * sizes[0]}
    else:
        forward = -Vector(appendage.chord_direction).normalized()
        across = Vector(appendage.thickness_direction)
        across = (across - across.dot(forward) * forward).normalized()
        turn = Matrix((forward, across, forward.cross(across))).transposed()
        values = {
            "sweep": -way.dot(turn.col[0]),
            "lean": way.dot(turn.col[1]),
            "span": -way.dot(turn.col[2]),
            "chord": sizes[0],
            "tip_chord": sizes[1],
            "thickness": appendage.thicknesses[0],
            "tip_thickness": appendage.thicknesses[1],
        }
    values["shape"] = appendage.shape.upper()
    return Matrix.Translation(start) @ turn.to_4x4(), values


def _turn_to(way, axis):
    """The rotation whose axis 0 (x) or 2 (z) runs along a way, the next one level where it can."""
    along = way.normalized()
    up = Vector((0.0, 0.0, 1.0)) if axis == 0 else Vector((1.0, 0.0, 0.0))
    if abs(along.dot(up)) > 1.0 - 1e-6:
        up = Vector((0.0, 1.0, 0.0))
    columns = [None] * 3
    columns[axis] = along
    columns[(axis + 1) % 3] = up.cross(along).normalized()
    columns[(axis + 2) % 3] = along.cross(columns[(axis + 1) % 3])
    return Matrix(np.array(columns).tolist()).transposed()
