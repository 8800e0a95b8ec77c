# SPDX-License-Identifier: GPL-3.0-or-later
"""Labels of lines in a drawing: above their upper ends, on the lines, or beside the ends, where
there is room; one for several lines that end at one place and have no room on them."""

import numpy as np

from .._drawing import text_width

# Over the letters' height: the room around a label, and how near lines may come to it.
_ROOM, _NEAR = 0.35, 0.1
# Where along a line a label may stand.
_PLACES = np.linspace(0.06, 0.94, 45)
# Labels of ends that are so near, over the letters' height, are one.
_TOGETHER = 1.0
# From the end of a line, over the letters' height, outwards and upwards to the near end of its
# label's middle line.
_ABOVE, _BESIDE = (0.45, 0.95), (0.7, -0.9)


class LineLabels:
    """Finds places for labels as they are added, and draws them."""

    def __init__(self, height):
        self.height = height
        # Of `ends` first, in their order, then those of `on_lines`.
        self.boxes = []
        self.ends = []
        self.on_lines = []

    def add(self, label, side, points, others):
        """A label of a line through points (n, 2), to be right (side 1) or left of its upper end;
        others (n, 2): the points of lines that it must not cover. Where there is no room, none."""
        end = points[np.argmin(points[:, 1] - 1e-3 * side * points[:, 0])]
        if not self._sharing(side, end):
            if self._stands([label], side, [end], _ABOVE, others):
                return
        if self._stands_on(label, points, others) or self._joins(label, side, end, others):
            return
        self._stands([label], side, [end], _BESIDE, others)

    def _stands_on(self, label, points, others):
        """Whether there is room for a label on its line."""
        width = text_width(label, self.height)
        for middle in self._along(points):
            box = self._box(middle, width)
            if self._is_free(box) and not _covers(self._box(middle, width, _NEAR), others):
                self.on_lines.append((label, middle))
                self.boxes.append(box)
                return True
        return False

    def _sharing(self, side, end):
        """The indices of the labels at the same place."""
        return [
            i
            for i, (_, of, ends, _) in enumerate(self.ends)
            if of == side and np.hypot(*(ends[0] - end)) < _TOGETHER * self.height
        ]

    def _joins(self, label, side, end, others):
        """Whether a label could be made one with another at the same place."""
        for i in self._sharing(side, end):
            before = self.ends.pop(i), self.boxes.pop(i)
            names, _, ends, way = before[0]
            if self._stands([*names, label], side, [*ends, end], way, others, i):
                return True
            self.ends.insert(i, before[0])
            self.boxes.insert(i, before[1])
        return False

    def _stands(self, names, side, ends, way, others, place=None):
        """Whether there is room for one label of these names on that way from the lines' ends."""
        width = text_width(_together(names, side), self.height)
        middle = self._start(side, ends, way) + [side * 0.5 * width, 0.0]
        box = self._box(middle, width)
        if not self._is_free(box) or _covers(self._box(middle, width, _NEAR), others):
            return False
        place = len(self.ends) if place is None else place
        self.ends.insert(place, (names, side, ends, way))
        self.boxes.insert(place, box)
        return True

    def _start(self, side, ends, way):
        """Where a label begins: above the first end, beside the outermost one."""
        end = ends[0] if way is _ABOVE else max(ends, key=lambda end: side * end[0])
        return end + np.array([side * way[0], -way[1]]) * self.height

    def _along(self, points):
        """Places on a line, the upper ones first."""
        lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
        at = _PLACES if points[0, 1] < points[-1, 1] else _PLACES[::-1]
        return [[np.interp(a * lengths[-1], lengths, points[:, i]) for i in (0, 1)] for a in at]

    def _box(self, middle, width, room=_ROOM):
        half = np.array([0.5 * width, 0.5 * self.height]) + room * self.height
        return np.asarray(middle) - half, np.asarray(middle) + half

    def _is_free(self, box):
        low, high = box
        return not any((low < top).all() and (bottom < high).all() for bottom, top in self.boxes)

    def draw(self, sheet, colour):
        for label, middle in self.on_lines:
            sheet.text(middle, label, self.height, colour, 0.5, blank=True)
        for names, side, ends, way in self.ends:
            align = 0.0 if side > 0.0 else 1.0
            words = _together(names, side)
            sheet.text(self._start(side, ends, way), words, self.height, colour, align)


def _covers(box, points):
    low, high = box
    return bool(((points > low) & (points < high)).all(axis=1).any())


def _together(names, side):
    """One name for names that were added from the ends of the ship to the middle."""
    if len(names) == 1:
        return names[0]
    aft, fore = (names[-1], names[0]) if side > 0.0 else (names[0], names[-1])
    return f"{aft}–{fore}"
