# SPDX-License-Identifier: GPL-3.0-or-later
"""Cameras that show the hull as large as the picture allows, and the turntable.

A camera that sees in perspective stands exactly so far away that the hull just fits; an
orthographic one has exactly the scale at which it does.
"""

from math import cos, radians, sin, tau

import bpy
import numpy as np
from mathutils import Matrix, Vector

from . import place, water_look
from .views import TURNTABLE, VIEWS

_SENSOR = 36.0  # mm, of the picture's longer side
# Room around the hull: each side of the frame is this much longer than the hull needs.
_ROOM = 1.08
_CLIP = (1e-3, 2000.0)  # lengths
_HALVINGS = 50
_TURNS, _LEVELS = 48, 64
_PIVOT = "Studio turntable"
# How a camera stood when it was framed; one that the user has moved is his.
_STANDS = "hull_studio_stands"


def add_cameras(here):
    """Cameras of all VIEWS, not framed yet; that of the turntable on an empty that turns."""
    for name, view in VIEWS.items():
        camera = _new_camera(here, view)
        if name == TURNTABLE:
            camera.parent = here.add(_PIVOT, None)
            camera.parent.empty_display_size = 0.1 * here.length


def follow(here):
    """Frames those cameras anew that stand where they were put."""
    for name, view in VIEWS.items():
        camera = camera_of(here.collection, view)
        if camera is not None and list(camera.get(_STANDS, _stand(camera))) == _stand(camera):
            frame(here, camera, name)


def _new_camera(here, view):
    lens = bpy.data.cameras.new(view.label)
    lens.type = "PERSP" if view.lens else "ORTHO"
    lens.sensor_width = _SENSOR
    lens.lens = view.lens or 50.0
    lens.clip_start, lens.clip_end = (part * here.length for part in _CLIP)
    lens.display_size = 0.05 * here.length
    camera = here.add(view.label, lens)
    return camera


def camera_of(collection, view):
    """The camera of one of VIEWS in a studio's collection, None if it is gone."""
    cameras = (obj for obj in collection.objects if obj.type == "CAMERA")
    return next((obj for obj in cameras if obj.get(place.MARK) == view.label), None)


def frame(here, camera, name):
    """Turns a camera and puts it where the hull just fits the picture; whichever side it shows of
    it, for the turntable's."""
    view = VIEWS[name]
    points = _swept(here) if name == TURNTABLE else here.points
    if view.below and here.in_water:
        wet = points[points[:, 2] <= here.draft]
        points = wet if len(wet) else points
    place_of = _perspective if view.lens else _orthographic
    camera.matrix_basis = place_of(here, camera.data, points, _axes(view))
    pivot = here.find(_PIVOT)
    if pivot is not None and camera.parent == pivot:
        pivot.location = here.centre
    camera[_STANDS] = _stand(camera)


def _stand(camera):
    """Numbers of how a camera stands and what it shows."""
    lens = camera.data
    places = [part for row in camera.matrix_basis for part in row]
    return [*places, lens.ortho_scale, lens.shift_y, lens.lens]


def width_at(here, camera):
    """How wide the picture is where the hull is, along the picture's longer side."""
    if camera.data.type == "ORTHO":
        return camera.data.ortho_scale
    away = camera.matrix_basis.to_3x3().col[2]
    centre = Vector((0.0, 0.0, 0.0)) if camera.parent != here.hull else Vector(here.centre)
    distance = (camera.matrix_basis.translation - centre).dot(away)
    return distance * _SENSOR / camera.data.lens


def _swept(here):
    """Points around all that the hull passes while it turns, from its centre."""
    offsets = here.points - here.centre
    reach, heights = np.hypot(offsets[:, 0], offsets[:, 1]), offsets[:, 2]
    ends = np.linspace(heights.min(), heights.max(), _LEVELS + 1)
    level = np.clip(np.searchsorted(ends, heights) - 1, 0, _LEVELS - 1)
    widest = np.zeros(_LEVELS)
    np.maximum.at(widest, level, reach)
    reach, heights = np.repeat(widest, 2), np.stack([ends[:-1], ends[1:]], axis=1).reshape(-1)
    turns = np.linspace(0.0, tau, _TURNS, endpoint=False)
    rings = [np.stack([reach * cos(t), reach * sin(t), heights], axis=1) for t in turns]
    return np.concatenate(rings)


def turn(here, frames):
    """Has the turntable's camera go round the hull once in so many frames, from frame 1, evenly."""
    pivot = here.find(_PIVOT)
    if pivot is None or camera_of(here.collection, VIEWS[TURNTABLE]).parent is not pivot:
        raise ValueError("The turntable is not as it was set up: set up the studio anew")
    _forget_turn(pivot)
    pivot.rotation_mode = "XYZ"
    for frame_number, angle in ((1, 0.0), (frames + 1, tau)):
        pivot.rotation_euler = (0.0, 0.0, angle)
        pivot.keyframe_insert("rotation_euler", index=2, frame=frame_number)
    pivot.rotation_euler = (0.0, 0.0, 0.0)
    for curve in pivot.animation_data.action.fcurves:
        for key in curve.keyframe_points:
            key.interpolation = "LINEAR"


def _forget_turn(pivot):
    action = None if pivot.animation_data is None else pivot.animation_data.action
    pivot.animation_data_clear()
    if action is not None and not action.users:
        bpy.data.actions.remove(action)


def _axes(view):
    """(3, 3) rows: to the right in the picture, up in it, and from the hull to the camera."""
    bearing, elevation = radians(view.bearing), radians(view.elevation)
    right = np.array([-sin(bearing), cos(bearing), 0.0])
    outwards = np.array(
        [cos(elevation) * cos(bearing), cos(elevation) * sin(bearing), sin(elevation)]
    )
    return np.stack([right, np.cross(outwards, right), outwards])


def _half_widths(scene):
    """Half the picture's width and height, of a picture whose longer side is 1."""
    render = scene.render
    width = render.resolution_x * render.pixel_aspect_x
    height = render.resolution_y * render.pixel_aspect_y
    return 0.5 * width / max(width, height), 0.5 * height / max(width, height)


def _perspective(here, lens, points, axes):
    """The camera sees a point where it is off the middle by no more than the tangent of half its
    angle, times how far away it is: the distance is the least at which all points do."""
    across, up, away = (points @ axis for axis in axes)
    distance = away.max() + _CLIP[0] * here.length
    for coordinate, half in zip((across, up), _half_widths(here.scene)):
        tangent = half * _SENSOR / lens.lens / _ROOM
        first, last = (coordinate + tangent * away).max(), (tangent * away - coordinate).max()
        distance = max(distance, (first + last) / (2.0 * tangent))
    middles = [_middle(coordinate, distance - away) for coordinate in (across, up)]
    return _matrix(axes, np.array([*middles, distance]))


def _middle(coordinate, distances):
    """Where a camera stands so that the outermost points on both sides are as far from the
    picture's middle."""
    low, high = coordinate.min(), coordinate.max()
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        seen = (coordinate - middle) / distances
        if seen.max() + seen.min() > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _orthographic(here, lens, points, axes):
    coordinates = points @ axes.T
    low, high = coordinates.min(axis=0), coordinates.max(axis=0)
    widths = _half_widths(here.scene)
    lens.ortho_scale = max(_ROOM * (high - low)[i] / (2.0 * widths[i]) for i in range(2))
    middle = 0.5 * (low + high)
    # A camera that looks level stands above the water, and sees what is below by its lens' shift.
    stands_at = np.array([middle[0], middle[1], high[2] + here.length])
    stands_at[1] = high[1] if abs(axes[2][2]) < water_look.LEVEL else middle[1]
    lens.shift_y = (middle[1] - stands_at[1]) / lens.ortho_scale
    return _matrix(axes, stands_at)


def _matrix(axes, place_in_axes):
    matrix = Matrix(axes.T.tolist()).to_4x4()
    matrix.translation = Vector(axes.T @ place_in_axes)
    return matrix
