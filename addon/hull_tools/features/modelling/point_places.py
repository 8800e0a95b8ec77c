# SPDX-License-Identifier: GPL-3.0-or-later
"""Points that are selected in edit mode are put in one plane of the ship, or where numbers say."""

import numpy as np

from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ..hull import hull_state
from ..lines import line_places

# The ship's planes by the axis that they are across.
PLANES = {"STATION": 0, "BUTTOCK": 1, "WATERLINE": 2}
# Where the plane is: at the mean of the points, the one selected last, the nearest of the hull's
# lines, or a position.
PLACES = ("MEAN", "ACTIVE", "NEAREST", "POSITION")


def put_in_plane(obj, scene, plane, place, position=0.0):
    """Moves the selected points along one axis into a plane; returns (position, how many) then.

    plane: of PLANES; place: of PLACES; positions in Blender's units. ValueError without points.
    """
    indices = _selected(obj)
    points = mesh_points.read(obj.data, indices)
    axis = PLANES[plane]
    points[:, axis] = position = float(
        np.float32(_position(obj, scene, points[:, axis], plane, place, position))
    )
    mesh_points.write(obj.data, indices, points)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    return position, len(indices)


def _selected(obj):
    indices = mesh_points.selected(obj.data)
    if not len(indices):
        raise ValueError("Select the points first")
    return indices


def _position(obj, scene, along, plane, place, position):
    if place == "POSITION":
        return position
    if place == "ACTIVE":
        active = mesh_points.active(obj.data)
        if active is None:
            raise ValueError("No point was selected last: select points, that one last")
        return mesh_points.read(obj.data, [active])[0, PLANES[plane]]
    mean = float(along.mean())
    return mean if place == "MEAN" else _nearest_line(obj, scene, plane, mean)


def _nearest_line(obj, scene, plane, mean):
    scale = units.metres_per_unit(scene)
    points = scale * mesh_points.read(obj.data)
    stations, waterlines, buttocks = line_places.line_places(obj.hull, scale).positions(points)
    found = {"STATION": stations, "BUTTOCK": buttocks, "WATERLINE": waterlines}[plane]
    if plane == "BUTTOCK":
        found = [*found, 0.0, *(-position for position in found)]
    if not len(found):
        raise ValueError(f"The hull has no {plane.lower()}s: give their spacing under Sections")
    return min(found, key=lambda known: abs(known - scale * mean)) / scale


def selected_points(obj):
    """[(index, (x, y, z))] of the selected points in Blender's units, from aft forward, then from
    below upwards. ValueError without any."""
    indices = _selected(obj)
    points = mesh_points.read(obj.data, indices)
    order = np.lexsort((points[:, 1], points[:, 2], points[:, 0]))
    return [(int(indices[i]), tuple(points[i].tolist())) for i in order]


def set_points(obj, scene, places):
    """Moves points to places, {index: (x, y, z)} in Blender's units, exactly as it keeps them;
    returns how many are elsewhere then, since their region is kept flat. ValueError for a point
    that is not there, or a place that is no number."""
    if not places:
        raise ValueError("Select the points first")
    indices = np.array(list(places), dtype=np.int64)
    wanted = np.array([places[index] for index in places], dtype=np.float32).reshape(-1, 3)
    count = len(mesh_points.read(obj.data))
    wrong = indices[(indices < 0) | (indices >= count)]
    if len(wrong):
        raise ValueError(f"There is no point {wrong[0]}: the mesh has points 0 to {count - 1}")
    if not np.isfinite(wanted).all():
        index = indices[~np.isfinite(wanted).all(axis=1)][0]
        raise ValueError(f"The place of point {index} is no number: type one for x, y and z")
    mesh_points.write(obj.data, indices, wanted)
    hull_state.follow_edit(obj, scene, is_by_hand=False)
    after = mesh_points.read(obj.data, indices).astype(np.float32)
    return int((after != wanted).any(axis=1).sum())
