# SPDX-License-Identifier: GPL-3.0-or-later
"""The body plan alone: after sections on the left, fore ones on the right, midship on both."""

from functools import cached_property

import numpy as np

from .._core import feature_fairness, section, tolerances
from .._drawing import FigureSheet, text_width
from .drawing_scales import scales
from .figure_form import round_spacing
from .line_labels import LineLabels

# The drawing in mm; around it is room for labels.
_LARGEST = (210.0, 140.0)
_SIDE, _TOP, _FOOT = 34.0, 14.0, 26.0
_SCALES = scales(-1, 4)
_BLACK, _GREY = (0.0, 0.0, 0.0), (0.45, 0.45, 0.45)
_SECTION, _GRID, _WATER = (0.07, 0.20, 0.50), (0.87, 0.88, 0.90), (0.0, 0.42, 0.30)
_KNUCKLE = (0.65, 0.10, 0.06)
_LABEL = 2.6
_MIDSHIP = "10"


def sections_sheet(form):
    """The FigureSheet of a FigureForm."""
    plan = _Plan(form)
    plan.draw_grid()
    plan.draw_features()
    plan.draw_sections()
    plan.draw_foot()
    return plan.sheet


def to_port(points, mirrored):
    """Parts (k, 3) of a polyline (n, 3) to port: of a half hull all of it, on that side."""
    if mirrored:
        return [points if points[:, 1].sum() >= 0.0 else points * (1.0, -1.0, 1.0)]
    y = points[:, 1]
    if y.min() >= 0.0:
        return [points]
    crossed = np.flatnonzero((y[1:] < 0.0) != (y[:-1] < 0.0)) + 1
    share = (y[crossed - 1] / (y[crossed - 1] - y[crossed]))[:, None]
    between = points[crossed - 1] + share * (points[crossed] - points[crossed - 1])
    between[:, 1] = 0.0
    whole = np.insert(points, crossed, between, axis=0)
    at = crossed + np.arange(len(crossed))
    runs = [
        whole[begin : end + 1] for begin, end in zip([0, *at], [*at, len(whole) - 1]) if end > begin
    ]
    return [run for run in runs if run[:, 1].min() >= 0.0 and run[:, 1].max() > 0.0]


class _Plan:
    def __init__(self, form):
        self.form = form
        self.half_beam = form.half_beam
        self.bottom = min(float(form.low[2]), 0.0 if form.given_draft else float(form.low[2]))
        self.top = float(form.high[2])
        size = 2.0 * self.half_beam, self.top - self.bottom
        least = 1e3 * max(size[0] / _LARGEST[0], size[1] / _LARGEST[1])
        self.scale = next((scale for scale in _SCALES if scale >= least), least)
        self.mm = 1e3 / self.scale
        self.width = size[0] * self.mm + 2 * _SIDE
        self.height = size[1] * self.mm + _TOP + _FOOT
        self.middle = form.aft + 0.5 * form.lpp
        self.sheet = FigureSheet(form.title, self.width, self.height)

    def at(self, y, z):
        """Places (n, 2) on the page of breadths, to the right, and heights in m."""
        x = 0.5 * self.width + np.asarray(y) * self.mm
        return np.stack([x, _TOP + (self.top - np.asarray(z)) * self.mm + 0.0 * x], axis=-1)

    def draw_grid(self):
        draft, beam = self.form.given_draft, self.half_beam
        step = self.form.waterline_spacing()
        heights = np.arange(np.ceil(self.bottom / step - 1e-6), self.top / step + 1e-6) * step
        if draft is not None:
            apart = _LABEL / self.mm
            heights = [*(z for z in heights if abs(z - draft) > apart), draft]
        for z in heights:
            is_draft, is_base = z == draft, abs(z) < 1e-9 * step
            ends = self.at([-beam, beam], [z, z]) + [[-13.0, 0.0], [13.0, 0.0]]
            colour = _WATER if is_draft else _BLACK if is_base else _GRID
            self.sheet.line(ends, 0.3 if is_draft or is_base else 0.15, colour)
            name = f"DWL {round(z, 3):g} m" if is_draft else "BL" if is_base else f"{z:g} m"
            for end, align in ((ends[0] - [1.0, 0.0], 1.0), (ends[1] + [1.0, 0.0], 0.0)):
                self.sheet.text(end, name, _LABEL, _GREY if colour is _GRID else colour, align)
        spacing = self.form.buttock_spacing()
        last = int(beam / spacing)
        for part in range(-last, last + 1):
            y = part * spacing
            ends = self.at([y, y], [self.bottom, self.top]) + [[0.0, 2.0], [0.0, -2.0]]
            dashes = (4.0, 1.0, 0.8, 1.0) if part == 0 else (0.0, 0.0, 0.0, 0.0)
            self.sheet.line(ends, 0.15, _GRID if part else _GREY, dashes)

    def draw_features(self):
        """Knuckles and the deck edge, each half of the ship on its side."""
        near = tolerances.ON_CENTRE_PLANE * self.form.surface.mesh.size
        for curve in feature_fairness(self.form.surface, count=120, marks=False):
            if np.abs(curve.points[:, 1]).max() <= near:
                continue
            is_crease = curve.kind == "crease"
            colour, width = (_KNUCKLE, 0.3) if is_crease else (_BLACK, 0.35)
            for points in to_port(curve.points, self.form.body.mirrored):
                for side, kept in (
                    (-1.0, points[:, 0] <= self.middle),
                    (1.0, points[:, 0] >= self.middle),
                ):
                    for run in np.split(points, np.flatnonzero(np.diff(kept.astype(int))) + 1):
                        if len(run) > 1 and (run[0, 0] - self.middle) * side >= 0.0:
                            places = self.at(side * run[:, 1], run[:, 2])
                            self.sheet.line(places, width, colour)

    @cached_property
    def sections(self):
        """(label, side, is midship, lines on the page) of each station on each side it is on."""
        found = []
        for label, x in self.form.stations():
            midship = label == _MIDSHIP
            curves = [
                part
                for curve in section(self.form.surface, "x", x)
                for part in to_port(curve.points, self.form.body.mirrored)
            ]
            for side in (-1.0, 1.0):
                if curves and (midship or (x - self.middle) * side > 0.0):
                    lines = [self.at(side * points[:, 1], points[:, 2]) for points in curves]
                    found.append((label, side, midship, lines))
        return found

    def draw_sections(self):
        for _, _, midship, lines in self.sections:
            for line in lines:
                self.sheet.line(line, 0.5 if midship else 0.25, _SECTION)
        self.labels.draw(self.sheet, _SECTION)

    @cached_property
    def labels(self):
        """LineLabels of the sections."""
        names = LineLabels(_LABEL)
        for side in (-1.0, 1.0):
            own = [
                (label, [_dense(line) for line in lines])
                for label, of, _, lines in self.sections
                if of == side
            ]
            # The ends first: stations about midship that run together share a label.
            for label, lines in own if side < 0 else own[::-1]:
                others = [line for name, of_name in own if name != label for line in of_name]
                longest = max(lines, key=len)
                names.add(label, side, longest, np.concatenate([*others, np.empty((0, 2))]))
        return names

    def draw_foot(self):
        base = self.height - 6.0
        left, right = _SIDE, self.width - _SIDE
        self.sheet.text((left, base - 1.3), self.form.title, 3.6, _BLACK, 0.0, bold=True)
        scale = f"1:{self.scale:.4g}"
        self.sheet.text((right, base - 1.15), scale, 3.2, _BLACK, 1.0)
        start = right - text_width(scale, 3.2) - 6.0
        self._draw_scale(start, base)
        y = _TOP + (self.top - self.bottom) * self.mm + 7.0
        for words, side in (("Aft", -1.0), ("Fore", 1.0)):
            x = self.at(side * 0.5 * self.half_beam, 0.0)[0]
            self.sheet.text((x, y), words, 3.0, _GREY, 0.5)

    def _draw_scale(self, end, base):
        """Four steps of a round number of metres, black and white."""
        step = round_spacing(10.0 / self.mm)
        start = end - 4 * step * self.mm
        for part in range(4):
            x = start + part * step * self.mm
            low, high = np.array([x, base - 2.0]), np.array([x + step * self.mm, base - 0.4])
            corners = [low, (high[0], low[1]), high, (low[0], high[1]), low]
            if part % 2 == 0:
                self.sheet.patch(corners[:4], _BLACK)
            self.sheet.line(corners, 0.15, _BLACK)
        for part in (0, 4):
            at = (start + part * step * self.mm, base - 3.8)
            words = f"{part * step:g}{' m' if part else ''}"
            self.sheet.text(at, words, 2.2, _BLACK, 0.5)


def _dense(line, step=0.5):
    """The polyline with points at that distance in mm at most."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], int(lengths[-1] / step) + 2)
    return np.stack([np.interp(at, lengths, line[:, i]) for i in (0, 1)], axis=1)
