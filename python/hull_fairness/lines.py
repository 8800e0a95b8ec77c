# SPDX-License-Identifier: GPL-3.0-or-later
"""What is not fair on a hull's lines, found and wanted.

Lines are stations, waterlines and buttocks of the exact surface at even distances, and its creases
and borders: those that lie in a plane judged there, others in plan and in profile; they have
inflections and dips. Reflection lines are the borders of the reflection pictures' bands; they have
kinks and waves. WANTED lists what the design calls for, entries of

    (kind of line, mark, how many a line, {"x": (from, to), ...}, why)

with the kinds and marks of MARKS, and the box in m that the mark is in; a letter left out is
everywhere.
"""

from dataclasses import dataclass, field, replace

import numpy as np

from .inflections import DIP, INFLECTION, SHALLOWEST, marks
from .kinks import KINK, WAVE, turns
from .native import hull_native as hn
from .reflections import comes_into, reflection_lines

_BENDS = (INFLECTION, DIP)
# The marks that a line of each kind may have.
MARKS = {
    **dict.fromkeys(("station", "waterline", "buttock", "feature"), _BENDS),
    "reflection": (KINK, WAVE),
}
# How many planes there are along each axis.
PLANES = {"station": ("x", 48), "waterline": ("z", 20), "buttock": ("y", 12)}
# Of the beam: what is less deep is not seen.
LEAST_DEPTH = 2e-4
# A tangent that turns by less is no knuckle.
KNUCKLE = np.radians(1.0)
# A hull has about as many: planes, light in two views, creases and borders.
_USUAL_LINES = 200
# Of the mesh's size: narrower hulls, which are no ships, are judged as if as broad, since samples
# are set by the beam.
_LEAST_BEAM = 0.01
# Of the beam: the distance of samples. Of the extent of a mark every so many are told.
_STEP = 1.0 / 200.0
_EXTENT_STEP = 10


@dataclass(frozen=True, eq=False)
class Lever:
    """By what a mark goes: `depth`, m, is to first order the sum of factors (n,) · curvatures (n,)
    at points (n, 3) of a line; below `unseen`, m, nothing is seen. frame (2, 3): axes of the plane
    in which the line is judged; is_cut: whether that plane cuts it out of the surface."""

    points: np.ndarray
    curvatures: np.ndarray
    factors: np.ndarray
    depth: float
    unseen: float
    frame: np.ndarray
    is_cut: bool


@dataclass(frozen=True)
class Found:
    """A mark on a line: its kind and place (3,), how much it is, such as "3.1 mm deep", why it is
    wanted or None, and points ((3,), ...) along it where it extends farther than its place; its
    Lever, but for those of reflection lines."""

    mark: str
    point: tuple
    size: str
    reason: object = None
    extent: tuple = ()
    lever: object = field(default=None, repr=False, compare=False)


@dataclass(frozen=True)
class Line:
    """A line with the marks found on it."""

    kind: str
    name: str
    found: list

    @property
    def unwanted(self):
        return [found for found in self.found if found.reason is None]


def _judged_beam(surface, beam):
    """m: what lines of a hull so broad are judged by."""
    return max(beam, _LEAST_BEAM * surface.mesh.size)


def judged(surface, beam, wanted=(), progress=None, within=None, eye=1.0):
    """Every Line of a surface; beam in m. progress: a callable that takes the share done, 0 to 1;
    what it raises ends it. within (low (3,), high (3,)): only the lines that come into this box,
    and what is found in it. eye: what is so much of what is seen counts, too; below 1 it is finer.
    """
    for kind, mark, *_ in wanted:
        if mark not in MARKS.get(kind, ()):
            raise ValueError(f"nothing is a {mark!r} of a {kind!r}: see hull_fairness/lines.py")
    lines, beam = [], _judged_beam(surface, beam)
    for kind, name, found in _all_found(surface, beam, eye, within):
        found = [mark for mark in found if within is None or _is_in(mark.point, within)]
        lines.append(Line(kind, name, with_reasons(kind, found, wanted)))
        if progress is not None:
            progress(min(1.0, len(lines) / _USUAL_LINES))
    return lines


def _is_in(point, box):
    return bool(np.all(box[0] <= np.asarray(point)) and np.all(np.asarray(point) <= box[1]))


def _all_found(surface, beam, eye, within):
    """(kind, name, [Found without reasons]) of each line that comes into a box, or all."""
    for kind, name, curves in _all_curves(surface, _STEP * beam, within):
        own = [curve for curve in curves if comes_into(curve[1], within)]
        is_cut = kind in PLANES
        parts = [part for curve in own for part in _marks(*curve, is_cut, beam, eye)]
        yield kind, name, [mark for part in parts for mark in part]
    for name, parts in reflection_lines(surface, beam, within):
        yield "reflection", name, [mark for part in parts for mark in _turns(part, beam, eye)]


def _all_curves(surface, step, within):
    """(kind, name, [(frame (2, 3), points (n, 3), curvatures, starts)]) of each line."""
    points = surface.tessellate(4).points
    low, high = points.min(axis=0), points.max(axis=0)
    for kind, (axis, count) in PLANES.items():
        column = "xyz".index(axis)
        at = low[column] + (np.arange(count) + 0.5) / count * (high[column] - low[column])
        if within is not None:
            at = at[(within[0][column] <= at) & (at <= within[1][column])]
        for place, curves in zip(at, _cut(surface, column, at, step)):
            yield kind, f"{kind} {axis} = {place:.3f} m", curves
    yield from _features(surface, step, float(np.ptp(points, axis=0).max()))


def _cut(surface, column, at, step):
    """Of each plane across an axis, at places (n,) along it: its curves as _all_curves has them."""
    planes = np.zeros((len(at), 4))
    planes[:, column], planes[:, 3] = 1.0, at
    kept = [i for i in range(3) if i != column]
    for curves in hn.section_fairness(surface, planes, step=step, marks=False):
        yield [(np.eye(3)[kept], *_rest(curve)) for curve in curves]


def found_through(surface, beam, kind, places, eye=1.0):
    """Of each of places (n, 3) the [[Found]] on the line of a kind of PLANES that goes through it,
    in their order along each of its parts between knuckles."""
    column, beam = "xyz".index(PLANES[kind][0]), _judged_beam(surface, beam)
    for curves in _cut(surface, column, np.asarray(places)[:, column], _STEP * beam):
        yield [part for curve in curves for part in _marks(*curve, True, beam, eye)]


def _features(surface, step, size):
    plain = hn.feature_fairness(surface, step=step, marks=False)
    views = [
        (name, kept, hn.feature_fairness(surface, step=step, marks=False, direction=direction))
        for name, kept, direction in (
            ("in plan", (0, 1), (0.0, 0.0, 1.0)),
            ("in profile", (0, 2), (0.0, 1.0, 0.0)),
        )
    ]
    for index, curve in enumerate(plain):
        ends = " to ".join("({:.2f}, {:.2f}, {:.2f})".format(*curve.points[i]) for i in (0, -1))
        name = f"{curve.kind} from {ends}"
        frame = _plane_frame(curve.points, hn.tolerances.IN_PLANE * size)
        if frame is not None:
            yield "feature", name, [(frame, *_rest(curve))]
            continue
        for view, kept, curves in views:
            frame = np.eye(3)[list(kept)]
            yield "feature", f"{name} {view}", [(frame, *_rest(curves[index]))]


def _plane_frame(points, tolerance):
    """Two directions (2, 3) of the plane that points lie in, or None."""
    # A further row, so that a line of two points has three axes as well.
    offsets = np.vstack([points - points.mean(axis=0), np.zeros(3)])
    _, spread, axes = np.linalg.svd(offsets, full_matrices=False)
    return axes[:2] if spread[2] / np.sqrt(len(points)) <= tolerance else None


def _rest(curve):
    return curve.points, curve.curvatures, curve.starts


def _marks(frame, points, curvatures, starts, is_cut, beam, eye):
    """[Found] without reasons, of each part between knuckles."""
    least = eye * LEAST_DEPTH * beam
    flat = points @ frame.T
    for first, last in _parts(flat, starts):
        lengths = np.linalg.norm(np.diff(flat[first:last], axis=0), axis=1)
        lengths = np.concatenate([[0.0], np.cumsum(lengths)])
        if lengths[-1] < least:
            continue
        found = marks(lengths, curvatures[first:last], least, eye * SHALLOWEST)
        own = frame, points[first:last], curvatures[first:last], is_cut
        yield [_found(mark, *own) for mark in found]


def _found(mark, frame, points, curvatures, is_cut):
    """The Found of an inflections.Mark of a part of a line."""
    size = f"{1e3 * mark.depth:.1f} mm deep"
    along = [*range(mark.first, mark.last, _EXTENT_STEP), mark.last]
    extent = tuple(map(tuple, points[along]))
    lever = _lever(mark.lever, points, curvatures, frame, is_cut)
    return Found(mark.kind, tuple(points[mark.index]), size, extent=extent, lever=lever)


def _lever(lever, points, curvatures, frame, is_cut):
    """The Lever in space of an inflections.Lever of a part of a line."""
    own = slice(lever.first, lever.first + len(lever.factors))
    return Lever(
        points[own], curvatures[own], lever.factors, lever.depth, lever.unseen, frame, is_cut
    )


def _turns(part, beam, eye):
    for turn in turns(part, beam, eye):
        size = f"turned by {np.degrees(turn.angle):.0f}°"
        yield Found(turn.kind, tuple(part.points[turn.index]), size)


def _parts(flat, starts):
    """(first, last + 1) of the samples between knuckles."""
    first = 0
    for border in starts[1:-1]:
        before, after = flat[border - 1] - flat[border - 2], flat[border + 1] - flat[border]
        turn = np.arctan2(before[0] * after[1] - before[1] * after[0], before @ after)
        if abs(turn) > KNUCKLE:
            yield first, border
            first = border
    yield first, len(flat)


def with_reasons(kind, marks, wanted):
    """Found of a line of a kind, with why they are wanted."""
    left = [[entry, entry[2]] for entry in wanted if entry[0] == kind]
    return [replace(found, reason=_reason(found, left)) for found in marks]


def _reason(found, left):
    """Why a mark is wanted, by the first entry that has one left; None where none has."""
    for place in left:
        (_, mark, _, box, why), number = place
        inside = all(a <= found.point["xyz".index(axis)] <= b for axis, (a, b) in box.items())
        if mark == found.mark and number > 0 and inside:
            place[1] -= 1
            return why
    return None
