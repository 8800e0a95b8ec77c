# SPDX-License-Identifier: GPL-3.0-or-later
"""The body plan alone: after sections on the left, fore ones on the right, midship on both."""

import hull_native as hn
import numpy as np

from . import paper
from .labels import Labels
from .lines_plan import round_spacing, stations

# The drawing in mm; around it is room for labels.
LARGEST = (210.0, 140.0)
SIDE, TOP, FOOT = 34.0, 14.0, 26.0
SCALES = [f * 10**n for n in range(4) for f in (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5)]
SECTION, GRID, WATER = (0.07, 0.20, 0.50), (0.87, 0.88, 0.90), (0.0, 0.42, 0.30)
KNUCKLE = (0.65, 0.10, 0.06)
LABEL = 2.6


def draw(vessel, stem):
    """Writes `stem`.pdf and .png."""
    plan = _Plan(vessel)

    def paint(context):
        plan.paint_grid(context)
        plan.paint_features(context)
        plan.paint_sections(context)
        plan.paint_foot(context)

    paper.draw(stem, plan.width, plan.height, paint)


class _Plan:
    def __init__(self, vessel):
        self.vessel, self.given = vessel, vessel.data.particulars
        points = vessel.surface.tessellate(6).points
        self.half_beam = float(np.abs(points[:, 1]).max())
        self.bottom = min(float(points[:, 2].min()), 0.0)
        self.top = max(float(points[:, 2].max()), self.given.draft)
        size = 2.0 * self.half_beam, self.top - self.bottom
        least = 1e3 * max(size[0] / LARGEST[0], size[1] / LARGEST[1])
        self.scale = min(scale for scale in SCALES if scale >= least)
        self.mm = 1e3 / self.scale
        self.width = size[0] * self.mm + 2 * SIDE
        self.height = size[1] * self.mm + TOP + FOOT
        self.middle = 0.5 * self.given.length_pp

    def at(self, y, z):
        """Places (n, 2) on the page of breadths, to the right, and heights in m."""
        x = 0.5 * self.width + np.asarray(y) * self.mm
        return np.stack([x, TOP + (self.top - np.asarray(z)) * self.mm + 0.0 * x], axis=-1)

    def paint_grid(self, context):
        draft, beam = self.given.draft, self.half_beam
        step = round_spacing(draft / 4.0)
        heights = np.arange(np.ceil(self.bottom / step - 1e-6), self.top / step + 1e-6) * step
        apart = LABEL / self.mm
        heights = [*(z for z in heights if abs(z - draft) > apart), draft]
        for z in heights:
            is_draft, is_base = abs(z - draft) < 1e-9, abs(z) < 1e-9
            ends = self.at([-beam, beam], [z, z]) + [[-13.0, 0.0], [13.0, 0.0]]
            colour = WATER if is_draft else paper.BLACK if is_base else GRID
            paper.line(context, ends, 0.3 if is_draft or is_base else 0.15, colour)
            name = f"DWL {z:g} m" if is_draft else "BL" if is_base else f"{z:g} m"
            for end, align in ((ends[0] - [1.0, 0.0], 1.0), (ends[1] + [1.0, 0.0], 0.0)):
                paper.text(
                    context,
                    end + [0.0, 0.35 * LABEL],
                    name,
                    LABEL,
                    colour if colour is not GRID else paper.GREY,
                    align,
                )
        spacing = round_spacing(self.given.beam / 8.0)
        last = int(beam / spacing)
        for part in range(-last, last + 1):
            y = part * spacing
            ends = self.at([y, y], [self.bottom, self.top]) + [[0.0, 2.0], [0.0, -2.0]]
            dashes = (4.0, 1.0, 0.8, 1.0) if part == 0 else ()
            paper.line(context, ends, 0.15, paper.GREY if part == 0 else GRID, dashes)

    def paint_features(self, context):
        """Knuckles and the deck edge, each half of the ship on its side."""
        for curve in hn.feature_fairness(self.vessel.surface, count=120, marks=False):
            points = curve.points
            if np.abs(points[:, 1]).max() < 1e-6 * self.half_beam:
                continue
            colour, width = (KNUCKLE, 0.3) if curve.kind == "crease" else (paper.BLACK, 0.35)
            for side, kept in (
                (-1.0, points[:, 0] <= self.middle),
                (1.0, points[:, 0] >= self.middle),
            ):
                for run in np.split(points, np.flatnonzero(np.diff(kept.astype(int))) + 1):
                    if len(run) > 1 and (run[0, 0] - self.middle) * side >= 0.0:
                        paper.line(context, self.at(side * run[:, 1], run[:, 2]), width, colour)

    def sections(self):
        """(label, side, is midship, lines on the page) of each station on each side it is on."""
        for label, x in stations(self.vessel):
            midship = label == "10"
            curves = [c.points for c in hn.section(self.vessel.surface, "x", x)]
            for side in (-1.0, 1.0):
                if curves and (midship or (x - self.middle) * side > 0.0):
                    lines = [self.at(side * points[:, 1], points[:, 2]) for points in curves]
                    yield label, side, midship, lines

    def paint_sections(self, context):
        sections = list(self.sections())
        for _, _, midship, lines in sections:
            for line in lines:
                paper.line(context, line, 0.5 if midship else 0.25, SECTION)
        names = Labels(context, LABEL)
        for side in (-1.0, 1.0):
            own = [
                (label, [_dense(line) for line in lines])
                for label, of, _, lines in sections
                if of == side
            ]
            # The ends first: stations about midship that run together share a label.
            for label, lines in own if side < 0 else own[::-1]:
                others = [line for name, of_name in own if name != label for line in of_name]
                longest = max(lines, key=len)
                names.add(label, side, longest, np.concatenate([*others, np.empty((0, 2))]))
        names.paint(SECTION)

    def paint_foot(self, context):
        base = self.height - 6.0
        left, right = SIDE, self.width - SIDE
        paper.text(context, (left, base), self.vessel.data.name, 3.6, align=0.0, bold=True)
        scale = f"1:{self.scale:g}"
        paper.text(context, (right, base), scale, 3.2, align=1.0)
        step = max(s for s in (0.1, 0.2, 0.5, 1, 2, 5, 10, 20) if s * self.mm <= 14.0)
        start = right - paper.text_width(context, scale) - 6.0 - 4 * step * self.mm
        for part in range(4):
            x = start + part * step * self.mm
            context.rectangle(x, base - 2.0, step * self.mm, 1.6)
            context.set_source_rgb(*(paper.BLACK if part % 2 == 0 else (1.0, 1.0, 1.0)))
            context.fill_preserve()
            context.set_source_rgb(*paper.BLACK)
            context.set_line_width(0.15)
            context.set_dash(())
            context.stroke()
        for part in (0, 4):
            unit = " m" if part else ""
            at = (start + part * step * self.mm, base - 3.0)
            paper.text(context, at, f"{part * step:g}{unit}", 2.2)
        y = TOP + (self.top - self.bottom) * self.mm + 8.0
        for words, side in (("Aft", -1.0), ("Fore", 1.0)):
            at = self.at(side * 0.5 * self.half_beam, 0.0)
            paper.text(context, (at[0], y), words, 3.0, paper.GREY)


def _dense(line, step=0.5):
    """The polyline with points at that distance in mm at most."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], int(lengths[-1] / step) + 2)
    return np.stack([np.interp(at, lengths, line[:, i]) for i in (0, 1)], axis=1)
