# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines of light that a hull mirrors in its reflection pictures, on the exact surface: the
borders of their bands, from either eye, and how they turn.

A line's turn is the one that somebody on the surface would see who walks along it, in the tangent
plane: that the surface bends below it does not count. It comes from exact tangents, which the
surface's second derivatives give.
"""

from dataclasses import dataclass

import numpy as np

from .lights import BANDS, VIEWS
from .native import hull_native as hn

# Of the beam: how far chords are from a line, and samples from each other.
_CHORD, STEP = 3e-5, 1.0 / 400.0
_SPACING = np.pi / BANDS
# Of the beam: two points of a line that are no nearer are two.
_APART = 1e-9
# The normal's part towards the eye: with less the surface is seen edge-on, within 6°.
_EDGE_ON = 0.1


@dataclass(frozen=True)
class Turning:
    """What is seen of a line, in samples at even lengths: points (n, 3) in m, how far it has turned
    up to each (n,) in rad, and the gradient across it (n,) of the angle of lights, rad/m."""

    points: np.ndarray
    turned: np.ndarray
    gradients: np.ndarray


def comes_into(points, box):
    """Whether one of the points (n, 3) is in a box, or there is no box."""
    return box is None or bool(((box[0] <= points) & (points <= box[1])).all(axis=1).any())


def reflection_lines(surface, beam, within=None):
    """(name, [Turning]) of each light's line from each eye; beam in m. within: see
    lines.judged."""
    for view, (bearing, elevation) in VIEWS.items():
        # A half hull is the side to port.
        across, up = np.radians(-bearing), np.radians(elevation)
        eye = np.array([np.cos(across), np.sin(across), np.tan(up)])
        eye /= np.linalg.norm(eye)
        curves = hn.reflection_lines(
            surface,
            line_direction=np.array([1.0, 0.0, 0.0]),
            light_direction=np.array([0.0, 1.0, 0.0]),
            eye_direction=eye,
            spacing=_SPACING,
            # None is where flat sides and bottoms mirror.
            phase=0.25,
            lines=BANDS,
            chord_tolerance=_CHORD * beam,
        )
        levels = {}
        for curve in curves:
            if not comes_into(curve.points, within):
                continue
            levels.setdefault(int(curve.level), []).extend(_seen_parts(surface, curve, eye, beam))
        for level, parts in sorted(levels.items()):
            if parts:
                yield f"light {level} seen from the {view}", parts


def _seen_parts(surface, curve, eye, beam):
    """The Turning of each part of a curve where the eye sees the surface, and not edge-on."""
    tangents, normals, gradients = _directions(surface, curve, eye)
    apart = np.linalg.norm(np.diff(curve.points, axis=0), axis=1) > _APART * beam
    seen = np.isfinite(gradients) & (normals @ eye > _EDGE_ON) & np.append(apart, True)
    for first, last in runs(seen):
        part = slice(first, last)
        points = curve.points[part]
        lengths = _sums(np.linalg.norm(np.diff(points, axis=0), axis=1))
        at = np.arange(0.0, lengths[-1], STEP * beam)
        turned = _sums(_turns(tangents[part], normals[part]))
        yield Turning(
            np.stack([np.interp(at, lengths, axis) for axis in points.T], axis=1),
            np.interp(at, lengths, turned),
            np.interp(at, lengths, gradients[part]),
        )


def runs(where):
    """(first, last + 1) of each run of True among booleans (n,)."""
    borders = np.flatnonzero(np.diff(np.concatenate([[False], where, [False]]).astype(int)))
    return zip(borders[::2], borders[1::2])


def _sums(steps):
    return np.concatenate([[0.0], np.cumsum(steps)])


def _dot(a, b):
    return np.sum(a * b, axis=1)


def _turns(tangents, normals):
    """Angles (n - 1,) between tangents (n, 3), seen along the normals."""
    middle = normals[1:] + normals[:-1]
    middle /= np.linalg.norm(middle, axis=1)[:, None]
    a, b = tangents[:-1], tangents[1:]
    flat = _dot(a, b) - _dot(a, middle) * _dot(b, middle)
    return np.arctan2(_dot(np.cross(a, b), middle), flat)


def _directions(surface, curve, eye):
    """Unit tangents (n, 3) at a curve's points, unit normals (n, 3), and the gradients (n,) of the
    mirrored light's angle around the ship in rad/m; not finite where there are none."""
    _, xu, xv, xuu, xuv, xvv = surface.evaluate(curve.cells, curve.uv, 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        normal = np.cross(xu, xv)
        area = np.linalg.norm(normal, axis=1)[:, None]
        normal = normal / area
        cosine = (normal @ eye)[:, None]
        ray = 2.0 * cosine * normal - eye
        slopes = []
        for bend in (
            np.cross(xuu, xv) + np.cross(xu, xuv),
            np.cross(xuv, xv) + np.cross(xu, xvv),
        ):
            turn = (bend - _dot(bend, normal)[:, None] * normal) / area
            ray_turn = 2.0 * ((turn @ eye)[:, None] * normal + cosine * turn)
            slopes.append(ray[:, 1] * ray_turn[:, 2] - ray[:, 2] * ray_turn[:, 1])
        fu, fv = np.stack(slopes) / (ray[:, 1] ** 2 + ray[:, 2] ** 2)
        tangents = fv[:, None] * xu - fu[:, None] * xv
        sizes = np.linalg.norm(tangents, axis=1)
        tangents /= sizes[:, None]
    # As the points go, not as the angle rises.
    tangents[_dot(tangents, np.gradient(curve.points, axis=0)) < 0.0] *= -1.0
    return tangents, normal, sizes / area[:, 0]
