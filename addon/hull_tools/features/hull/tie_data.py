# SPDX-License-Identifier: GPL-3.0-or-later
"""Ties and named groups of a hull's points in Blender, and in hull_io's HullData."""

from ....hull_io.hull_data import PointGroup, Tie
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ..constraints import ties

# Kinds whose numbers are distances; of the others the first is a share.
_WITH_DISTANCE = ("ANCHOR", "LEVEL", "MIRROR")


def take_ties(mesh, scale):
    """The list of Tie of a Blender mesh; scale: metres of Blender's unit."""
    found = []
    for kind, point, to, numbers in ties.stored_ties(mesh):
        parts = tuple(units.as_stored(part) for part in numbers)
        if kind in _WITH_DISTANCE:
            distance = tuple(part * scale for part in parts)
            found.append(Tie(kind.lower(), point, to, distance=distance))
        else:
            found.append(Tie(kind.lower(), point, to, share=parts[0]))
    return sorted(found, key=lambda tie: tie.point)


def give_ties(mesh, given, scale):
    """Ties points of a Blender mesh that is not in edit mode."""
    stored = []
    for tie in given:
        kind = tie.kind.upper()
        distance = tuple(part / scale for part in tie.distance)
        numbers = distance if kind in _WITH_DISTANCE else (tie.share, 0.0, 0.0)
        stored.append((kind, tie.point, tie.to, numbers))
    ties.store_ties(mesh, stored)


def take_groups(obj):
    """The list of PointGroup of a hull or a variant: its vertex groups."""
    return [
        PointGroup(group.name, mesh_points.of_group(obj.data, group.index).tolist())
        for group in getattr(obj, "vertex_groups", ())
    ]


def give_groups(obj, given):
    """Makes vertex groups of an object that is not in edit mode."""
    for group in given if hasattr(obj, "vertex_groups") else ():
        obj.vertex_groups.new(name=group.name).add(group.points, 1.0, "REPLACE")
