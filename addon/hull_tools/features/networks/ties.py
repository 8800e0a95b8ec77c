# SPDX-License-Identifier: GPL-3.0-or-later
"""What moves along when points of curves move: points of other curves that were in the same place.

Nothing of ties is stored. Points in one place are tied; where one of them has moved since the
network was last looked at, the others follow, each within its plane.
"""

import numpy as np

from . import planes


class Tied:
    """before, now: (n, 3) points of curves by name, the very same array where a curve has not
    changed; planes: by name, (normal, offset) or None. first: names of curves that may have
    changed, in the order in which they have the say where several moved."""

    def __init__(self, before, now, planes_by_name, first, distance):
        self._before, self._planes = before, planes_by_name
        self._now, self._changed = dict(now), {}
        self._names = list(dict.fromkeys(first))
        self._distance = distance

    def moved(self):
        """Points by name of the curves that are to have others, with what is tied moved along, all
        in their planes."""
        for name in self._names:
            if self._planes[name] is not None:
                self._changed[name] = planes.onto(self._now[name], [self._planes[name]])
                self._now[name] = self._changed[name]
        done = set()
        for name in self._names:
            for index in self._moved_points(name):
                if (name, index) not in done:
                    done |= self._bring_along(name, index)
        return self._changed

    def _moved_points(self, name):
        before, now = self._before.get(name), self._now[name]
        if before is None or len(before) != len(now):
            return ()
        # Only what has moved further than Blender's rounding counts.
        least = 4.0 * np.spacing(np.abs(now).max().astype(np.float32))
        return np.flatnonzero(np.abs(now - before).max(axis=1) > least).tolist()

    def _bring_along(self, name, index):
        """Moves what was where a point was to where it is now; returns pairs (name, number)."""
        if self._has_left_another(name, index):
            return {(name, index)}
        group = self._at(self._before[name][index], name, index)
        place = self._now[name][index][None]
        wanted = [self._planes[one] for one, _ in group if self._planes[one] is not None]
        target = planes.onto(place, wanted)
        if target is None:  # as of two stations: they have no place in common any longer
            return {(name, index)}
        for one, number in group:
            if one not in self._changed:
                self._changed[one] = self._now[one] = self._now[one].copy()
            self._changed[one][number] = target[0]
        return set(group)

    def _has_left_another(self, name, index):
        """Whether a point leaves another one of its curve behind, as one that was extruded: what
        was tied is tied to that."""
        before, now = self._before[name], self._now[name]
        was_there = np.abs(before - before[index]).max(axis=1) <= self._distance
        stays = np.abs(now - before).max(axis=1) <= self._distance
        was_there[index] = False
        return bool((was_there & stays).any())

    def _at(self, place, name, index):
        """Pairs (name, number) of points that were in a place: of each other curve the nearest."""
        group = [(name, index)]
        for one, before in self._before.items():
            if one == name or len(before) != len(self._now[one]):
                continue
            distances = np.abs(before - place).max(axis=1)
            nearest = int(distances.argmin())
            if distances[nearest] <= self._distance:
                group.append((one, nearest))
        return group
