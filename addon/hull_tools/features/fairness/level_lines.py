# SPDX-License-Identifier: GPL-3.0-or-later
"""Reflection lines, isophotes and silhouette: lines of the exact normals. What is off is not
computed."""

from dataclasses import dataclass
from math import pi

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ..flotation.afloat import as_typed_angle
from ..lines import lines

# The switch of each in Object.hull.fairness.
SWITCHES = {
    "isophote": "show_isophotes",
    "reflection": "show_reflections",
    "silhouette": "show_silhouette",
}


@dataclass(frozen=True, eq=False)
class LevelGroup:
    """All lines of one kind; polylines (k, 3) in m. is_mirrored: whether their mirror images belong
    to it too. The other side of a half hull has light and eye of its own for reflection lines and
    isophotes, so that both sides look alike; the silhouette is that of the whole ship."""

    kind: str
    key: tuple
    polylines: list
    is_mirrored: bool


def level_lines(known, surface, settings, geometry_key):
    """LevelGroup by kind that an Object.hull wants, of which known ones are taken that are the same
    still; ValueError for directions of no length."""
    fairness, found = settings.fairness, {}
    for kind, switch in SWITCHES.items():
        if not getattr(fairness, switch):
            continue
        options = _OPTIONS[kind](fairness)
        limits.within(fairness.divisions, "Fineness", *limits.DIVISIONS)
        key = (geometry_key, settings.half, options, fairness.divisions)
        if kind in known and known[kind].key == key:
            found[kind] = known[kind]
            continue
        curves = _polylines(surface, kind, options, fairness.divisions)
        if settings.half and kind == "silhouette":
            # The other side sees the eye as the modelled one sees the eye's mirror image.
            image_eye = tuple(lines.mirror_image(np.array(options[0])).tolist())
            image = _polylines(surface, kind, (image_eye,), fairness.divisions)
            curves += [lines.mirror_image(points) for points in image]
        is_mirrored = settings.half and kind != "silhouette"
        found[kind] = LevelGroup(kind, key, curves, is_mirrored)
    return found


def _direction(vector, name):
    direction = tuple(as_typed(part) for part in vector)
    if not any(abs(part) > 1e-6 for part in direction):
        raise ValueError(f"{name}: 0 0 0 has no direction: give one of its parts another value")
    return direction


def _spacing(angle, name):
    least, most = limits.LEAST_LIGHT_ANGLE, limits.GREATEST_LIGHT_ANGLE
    return limits.within(as_typed_angle(angle), f"Spacing of {name} in rad", least, most)


def _isophote_options(fairness):
    return (
        _direction(fairness.isophote_direction, "Isophotes"),
        _spacing(fairness.isophote_spacing, "isophotes"),
    )


def _reflection_options(fairness):
    return (
        _direction(fairness.line_direction, "Reflection lines along"),
        _direction(fairness.light_direction, "Light of reflection lines"),
        _direction(fairness.eye_direction, "Eye"),
        _spacing(fairness.reflection_spacing, "reflection lines"),
    )


def _silhouette_options(fairness):
    return (_direction(fairness.eye_direction, "Eye"),)


_OPTIONS = {
    "isophote": _isophote_options,
    "reflection": _reflection_options,
    "silhouette": _silhouette_options,
}


def _polylines(surface, kind, options, divisions):
    hull_native = native.require()
    directions = [np.array(part) for part in options if isinstance(part, tuple)]
    if kind == "isophote":
        angles = np.arange(options[1], pi * (1.0 - 1e-9), options[1])
        found = hull_native.isophotes(
            surface, direction=directions[0], angles=angles, divisions=divisions
        )
    elif kind == "reflection":
        along, light, eye = directions
        found = hull_native.reflection_lines(
            surface,
            line_direction=along,
            light_direction=light,
            eye_direction=eye,
            spacing=options[3],
            divisions=divisions,
        )
    else:
        found = hull_native.silhouette(surface, eye_direction=directions[0], divisions=divisions)
    return [curve.points for curve in found]
