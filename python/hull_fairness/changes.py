# SPDX-License-Identifier: GPL-3.0-or-later
"""What a change of a hull's form did to the marks on its lines: which are new, which are gone.

A mark goes with the surface: where sections are shifted an inflection of a waterline is shifted,
too. So a mark of the changed hull is looked for on the hull before, at the place of the surface
with the same parameters. It is an old one where that hull has a mark of its kind within REACH, on a
line of its kind, that a finer EYE sees; each of these stands for one. Between the lines that are
judged there are others: a mark is old, too, that is there on the line through its place. So is a
dip where that line bends the other way between two inflections that are gone: where it bent to
both sides it still bends less, which is the same wave, not as deep.

Marks that extend along a line, as a flat bottom does, are as far apart as they are where they are
nearest: the middle of a flat goes half as far as its end.

Stretching a hull keeps inflections, but not dips, kinks and waves: other lights are mirrored at the
same place then. So of these the hull before has all marks that its images have which are stretched
along an axis by STRETCHES.
"""

from copy import copy
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from .inflections import DIP, INFLECTION
from .lines import PLANES, found_through, judged, with_reasons
from .native import hull_native as hn

# Of the beam: a mark that wanders along the surface by no more is the same.
REACH = 0.1
EYE = 0.75
STRETCHES = (7.0 / 8.0, 9.0 / 8.0)
_NO_LENGTH = 1e-300


@dataclass(frozen=True)
class Placed:
    """A Found mark of a Line; on the hull before its place (3,), and places (k, 3) along it, m."""

    line: object
    found: object
    place: tuple
    extent: np.ndarray

    @property
    def kind(self):
        return self.line.kind, self.found.mark


@dataclass(frozen=True)
class MarkChange:
    """[Placed] of marks that are new, and of those that are gone."""

    new: list
    gone: list


class Known:
    """The marks of a LimitSurface, by which those of the changed one are told new from old; beam
    in m; progress: as `judged` takes it. It keeps to the surface as it is when made, so that the
    changed one may be the same after set_points()."""

    def __init__(self, surface, beam, progress=None):
        self.surface = surface = copy(surface)
        self.beam, self.reach = beam, REACH * beam
        parts = _parts(progress, 1 + 3 * len(STRETCHES))
        lines = judged(surface, beam, progress=next(parts), eye=EYE)
        self.marks = placed(lines, surface, surface)
        self._seen = {}  # places by kind
        for one in self.marks + self._of_images(beam, parts):
            self._seen.setdefault(one.kind, []).append(one.extent)

    def _of_images(self, beam, parts):
        mesh, found = self.surface.mesh, []
        for axis in range(3):
            for stretch in STRETCHES:
                factors = np.where(np.arange(3) == axis, stretch, 1.0)
                points = mesh.points * factors
                image = hn.LimitSurface(mesh.with_points(points), self.surface.scheme)
                lines = judged(image, factors[1] * beam, progress=next(parts), eye=EYE)
                found += [
                    one
                    for one in placed(lines, image, self.surface)
                    if one.found.mark != INFLECTION
                ]
        return found

    def compared(self, lines, changed, wanted=(), share=1.0):
        """The MarkChange to Lines judged on a changed surface. wanted: what the design calls for,
        as in lines, by places on the hull before: of that nothing is new. share: of REACH, how near
        the same mark is. ValueError where the meshes differ in more than their points."""
        now, reach = placed(lines, changed, self.surface), share * self.reach
        pairs = _pairs(self.marks, now, reach)
        was, stays = {a for a, _ in pairs}, {b for _, b in pairs}
        stays |= {i for i, one in enumerate(now) if self._is_seen(one, reach)}
        stays |= self._between_lines(now, stays, reach)
        return MarkChange(
            [now[i] for i in _beyond(now, stays, wanted)],
            [one for i, one in enumerate(self.marks) if i not in was],
        )

    def _is_seen(self, one, reach):
        if one.found.mark == INFLECTION or one.kind not in self._seen:
            return False
        return bool(_apart(np.concatenate(self._seen[one.kind]), one.extent) <= reach)

    def _between_lines(self, now, stays, reach):
        """Indices of marks besides those that stay which are there on the line of the hull before
        through their own place; of a line each of the hull before stands for one."""
        found = set()
        for kind in PLANES:
            left = [i for i, one in enumerate(now) if one.line.kind == kind and i not in stays]
            places = np.array([now[i].place for i in left]).reshape(-1, 3)
            through = found_through(self.surface, self.beam, kind, places, EYE)
            for index, parts in zip(left, through):
                line = now[index].line
                own = [i for i, one in enumerate(now) if one.line is line]
                old = [Placed(line, one, one.point, _along(one)) for part in parts for one in part]
                pairs = _pairs(old, [now[i] for i in own], reach)
                found |= {index} & {own[j] for _, j in pairs}
                gone = {id(one.found) for one in old} - {id(old[i].found) for i, _ in pairs}
                dips = [i for i in own if i not in stays and now[i].found.mark == DIP]
                found |= {index} & _lessened(_waves(parts, gone), now, dips, reach)
        return found


def _waves(parts, gone):
    """[(Found, Found)] of two inflections beside one another in a part, of the [[Found]] of parts,
    that are both gone: ids of Found."""
    return [
        (one, other)
        for part in parts
        for one, other in pairwise(part)
        if one.mark == other.mark == INFLECTION and {id(one), id(other)} <= gone
    ]


def _lessened(waves, now, dips, reach):
    """Of indices of dips of a line the first between each pair of _waves() that bends to the other
    side than what was between them."""
    found = set()
    for wave in waves:
        left = (i for i in dips if _is_left(now[i], *wave, reach))
        found |= {next(left, None)} - {None}
    return found


def _is_left(dip, start, end, reach):
    place, chord = np.subtract(dip.place, start.point), np.subtract(end.point, start.point)
    share = (place @ chord) / max(chord @ chord, _NO_LENGTH)
    is_between = 0.0 < share < 1.0 and np.linalg.norm(place - share * chord) <= reach
    side = np.sign(dip.found.lever.curvatures.sum())
    return bool(is_between and side * _side_beyond(start, chord) < 0.0)


def _side_beyond(inflection, direction):
    """The sign of the bend of a line from an inflection on in a direction."""
    lever = inflection.lever
    own = lever.factors != 0.0  # one of the two sides
    side = np.sign(lever.curvatures[own].sum())
    is_beyond = (lever.points[own].mean(axis=0) - inflection.point) @ direction > 0.0
    return side if is_beyond else -side


def _along(found):
    """The place (1 + k, 3) of a Found mark and those along it."""
    return np.array([found.point, *found.extent])


def _parts(progress, count):
    """What each of `count` parts of the work, one after the other, tells its share to."""
    for number in range(count):
        yield progress and (lambda share, done=number: progress((done + share) / count))


def placed(lines, changed, before):
    """[Placed] of the marks of Lines judged on a LimitSurface `changed`, which has the control mesh
    of `before` but for its points. ValueError where it has not."""
    if changed.cell_count != before.cell_count:
        raise ValueError("The mesh itself was changed: no mark has a place on the hull before")
    found = [(line, mark) for line in lines for mark in line.found]
    if not found:
        return []
    points = [_along(mark) for _, mark in found]
    near = hn.SurfaceTree(changed).closest_points(np.concatenate(points))
    places = before.evaluate(near.cells, near.uv, 0)[0]
    own = np.split(places, np.cumsum(list(map(len, points)))[:-1])
    return [Placed(line, mark, tuple(at[0]), at) for (line, mark), at in zip(found, own)]


def _apart(some, others):
    """The least distance of places (k, 3) from others (l, 3)."""
    return np.linalg.norm(some[:, None] - others, axis=2).min()


def _pairs(old, now, reach):
    """[(index of old, index of now)] of marks that are the same, the nearest first."""
    kinds = {}
    for side, marks in enumerate((old, now)):
        for index, one in enumerate(marks):
            kinds.setdefault(one.kind, ([], []))[side].append(index)
    found = []
    for a, b in kinds.values():
        if a and b:
            apart = np.array([[_apart(old[i].extent, now[j].extent) for j in b] for i in a])
            found += [(apart[i, j], a[i], b[j]) for i, j in np.argwhere(apart <= reach)]
    pairs, taken = [], (set(), set())
    for _, i, j in sorted(found):
        if i not in taken[0] and j not in taken[1]:
            pairs.append((i, j))
            taken[0].add(i)
            taken[1].add(j)
    return pairs


def _beyond(now, stays, wanted):
    """Indices of marks that were not there before and that are not wanted: those that were have
    what is wanted of their line first."""
    lines = {}
    for index, one in enumerate(now):
        lines.setdefault(id(one.line), []).append(index)
    found = []
    for own in lines.values():
        own = sorted(own, key=lambda index: index not in stays)
        marks = [replace(now[i].found, point=now[i].place) for i in own]
        reasons = with_reasons(now[own[0]].line.kind, marks, wanted)
        found += [i for i, mark in zip(own, reasons) if i not in stays and mark.reason is None]
    return sorted(found)
