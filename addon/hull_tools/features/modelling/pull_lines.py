# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking hold of the surface where the mouse is: on a section line if one is near, else where the
eye's ray meets it; and the mark that shows what is held."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from mathutils import Matrix

from ..hull import hull_state
from ..lines import lines
from . import drags

# In pixels at a scale of 1.
_NEAR = 7.0
# Of the size: lines further than this from what the eye sees are behind it.
_BEHIND = 0.02


@dataclass(frozen=True, eq=False)
class Mark:
    """What the 3D view shows of a pull of a hull; points (3,) and radius in m, of the hull."""

    start: tuple
    now: tuple
    text: str
    radius: float = 0.0


@dataclass
class Held:
    """The Mark of one hull that the 3D view shows, or None."""

    mark: object = None


def held(obj, scene):
    """The Held of a hull."""
    return hull_state.refresh(obj, scene).of(Held)


def shown(view_layer):
    """(hull, Mark) of the one that is pulled in a view layer, or None."""
    marks = ((hull, state.of(Held).mark) for hull, state in hull_state.known_hulls(view_layer))
    return next(((hull, mark) for hull, mark in marks if mark is not None), None)


def grip_at(pull, eye, mouse, interface_scale=1.0, takes_lines=True):
    """The Grip of a SurfacePull under the mouse; None where there is no surface.

    eye: Eye; mouse: (2,) pixels in its picture. takes_lines: section lines come first.
    """
    mouse = np.asarray(mouse, dtype=np.float64)
    hit = pull.hit(*eye.ray(mouse))
    if not takes_lines:
        return hit
    on_line = _line_at(pull, eye, mouse, _NEAR * interface_scale, hit)
    return hit if on_line is None else on_line


@dataclass(frozen=True, eq=False)
class Eye:
    """How a 3D view looks at a hull: to_clip, 4 × 4 from the hull's metres to clip space; size of
    the picture in pixels."""

    to_clip: np.ndarray
    size: tuple

    @cached_property
    def from_clip(self):
        """4 × 4, the way back. None of a hull that is scaled to nothing in some direction: a place
        of the picture is many of it, or none."""
        try:
            return np.linalg.inv(self.to_clip)
        except np.linalg.LinAlgError:
            return None

    def ray(self, mouse):
        """(origin (3,), direction (3,)) in m of what is seen at a place of the picture, where there
        is a way back."""
        x, y = 2.0 * np.asarray(mouse, dtype=np.float64) / np.asarray(self.size) - 1.0
        near, far = (self.from_clip @ (x, y, depth, 1.0) for depth in (-1.0, 1.0))
        near, far = near[:3] / near[3], far[:3] / far[3]
        return near, (far - near) / np.linalg.norm(far - near)

    @property
    def direction(self):
        """(3,) the way the eye looks in the middle of its picture."""
        return self.ray(0.5 * np.asarray(self.size))[1]

    @property
    def right(self):
        """(3,) the direction that goes to the right in its picture."""
        middle = 0.5 * np.asarray(self.size)
        way = self.ray(middle + (1.0, 0.0))[0] - self.ray(middle)[0]
        return way / np.linalg.norm(way)


def eye_of(obj, scale, view, region):
    """The Eye of a hull in a region of a 3D view, of which `view` is the RegionView3D; scale:
    metres a unit."""
    to_world = obj.matrix_world @ Matrix.Diagonal((1.0 / scale, 1.0 / scale, 1.0 / scale, 1.0))
    to_clip = np.array(view.perspective_matrix @ to_world, dtype=np.float64)
    return Eye(to_clip, (region.width, region.height))


def _line_at(pull, eye, mouse, reach, hit):
    """The Grip on the section line nearest to the mouse, within reach (pixels) and not behind what
    the eye hits; None without."""
    state = hull_state.state_of(pull.obj)
    if state is None or state.status:
        return None
    behind = _BEHIND * lines.size_of(pull.surface)
    best, found = reach, None
    for plane, curve, is_image in _shown_curves(state):
        points = lines.mirror_image(curve.points) if is_image else curve.points
        places = drags.in_picture(eye.to_clip, eye.size, points)
        distance, index, part = drags.nearest_on_polyline(places, mouse)
        if distance >= best:
            continue
        point = (1.0 - part) * points[index] + part * points[index + 1]
        if hit is None or np.linalg.norm(point - hit.point) <= behind:
            best, found = distance, (plane, curve, index, part, is_image)
    return None if found is None else _grip_on(pull, *found)


def _shown_curves(state):
    """(plane, hull_native.SectionCurve, whether it is the mirror image that is shown)."""
    for group in state.lines.groups.values():
        for section in group.sections:
            for is_image in (False, True) if group.is_mirrored else (section.cut.flip,):
                for curve in section.curves:
                    if len(curve.points) > 1:
                        yield section.cut.plane, curve, is_image


def _grip_on(pull, plane, curve, index, part, is_image):
    cells, uv = curve.cells, curve.uv
    if cells[index] == cells[index + 1]:
        between = (1.0 - part) * uv[index] + part * uv[index + 1]
        cell, place = int(cells[index]), pull.on_plane(int(cells[index]), between, plane)
    else:
        nearest = index + int(part > 0.5)
        cell, place = int(cells[nearest]), uv[nearest]
    normal = np.array(plane[:3])
    if is_image:
        normal = lines.mirror_image(normal)
    return pull.grip(cell, place, is_image, normal)
