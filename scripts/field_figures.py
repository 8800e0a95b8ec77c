# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of docs/fields.md: the published examples of shape fields, before and after.

PYTHONPATH=build/release/python:samples python3 scripts/field_figures.py FOLDER

into FOLDER: field-replays.png.
"""

import sys
import tempfile
from pathlib import Path

import numpy as np
import vessels
from field_replays import bulb, centre_line, follow, frigate, refined
from figures import paper
from figures.before_after import AFTER, BEFORE, TITLE, Frame, cuts, paint_both
from hull_fairness import lines

# The page in mm, margins, and the width that is shown in the docs, in dots.
WIDTH, HEIGHT, MARGIN, GAP, SMALL = 250.0, 214.0, 8.0, 8.0, 1400
WANTED = (0.86, 0.28, 0.10)
LABEL, STRETCH = 2.8, 2.5


def inflections(surface):
    """Places (n, 3) of inflections of the frigate's fore waterlines that an eye sees."""
    given = vessels.vessel(frigate.NAME).data.particulars
    box = np.array([108.0, -1.0, -5.0]), np.array([150.0, 20.0, 20.0])
    judged = lines.judged(surface, given.beam, within=box)
    found = [mark for line in judged if line.kind == "waterline" for mark in line.found]
    points = [mark.point for mark in found if mark.mark == "inflection"]
    return np.array(points).reshape(-1, 3)


def paint_frigate(context, top):
    """Returns where it ends, in mm from above."""
    before = vessels.vessel(frigate.NAME).surface
    falloff = frigate.STEM_FALLOFF
    width = 0.5 * (WIDTH - 2 * MARGIN - GAP)
    low, high = (108.0, 0.0), (147.0, 7.2)
    heights = None
    for number, (words, protected) in enumerate(
        (
            ("plane protected, falloff 1", frigate.plane_protected(1.0)),
            (f"stem protected, falloff {falloff}", frigate.stem_protected(before, falloff)),
        )
    ):
        after, _ = follow(before, frigate.narrowing(before, protected))
        left = MARGIN + number * (width + GAP)
        frame = Frame(left, top, width / (high[0] - low[0]), low, high, STRETCH)
        frame.title(context, f"Frigate narrowed: {words}")
        marks = inflections(after)
        if heights is None:
            heights = np.unique(np.round(marks[:, 2], 6))[::2]
        paint_both(context, frame, (0, 1), *(cuts(s, "z", heights) for s in (before, after)))
        shown = marks[np.isin(np.round(marks[:, 2], 6), heights)]
        for place in frame.at(shown[:, :2]):
            paper.line(context, [place, place], 1.6, WANTED)
    return frame.bottom


def paint_bulb(context, top):
    """Returns where it ends, in mm from above."""
    plain = refined(vessels.surface_of(bulb.plain_bow()), bulb.SUBDIVIDED)
    *_, last = bulb.steps(plain)
    full = last.surface
    _, wanted = bulb.wanted_profile(plain)
    width = 0.62 * (WIDTH - 2 * MARGIN)
    frame = Frame(MARGIN, top, width / 24.4, (80.0, -0.2), (104.4, 8.6))
    frame.title(context, "Bulb: profile, and buttocks every 0.5 m")
    both = [cuts(surface, "y", np.arange(0.5, 2.6, 0.5)) for surface in (plain, full)]
    paint_both(context, frame, (0, 2), *both)
    for surface, colour in ((plain, BEFORE), (full, AFTER)):
        frame.line(context, centre_line(surface)[:, [0, 2]], 0.45, colour)
    frame.line(context, wanted[:, [0, 2]], 0.25, WANTED, (1.2, 1.6))
    left = MARGIN + width + GAP
    body = Frame(left, top, (WIDTH - MARGIN - left) / 9.0, (0.0, -0.2), (9.0, 5.7))
    body.title(context, "Frames every 1 m forward of x = 86 m")
    places = np.arange(86.0, 104.0, 1.0)
    paint_both(context, body, (1, 2), *(cuts(s, "x", places) for s in (plain, full)))
    top = frame.bottom + 2 * GAP
    plan = Frame(MARGIN, top, (WIDTH - 2 * MARGIN) / 24.4, (80.0, 0.0), (104.4, 5.6))
    plan.title(context, "Waterlines at 0.5, 1, 1.5, 2.2, 3, 4 and 6.2 m")
    heights = (0.5, 1.0, 1.5, 2.2, 3.0, 4.0, 6.2)
    paint_both(context, plan, (0, 1), *(cuts(s, "z", heights) for s in (plain, full)))
    return plan.bottom


def paint(context):
    bottom = paint_frigate(context, MARGIN + TITLE)
    bottom = paint_bulb(context, bottom + 2 * GAP) + GAP
    at = MARGIN
    for words, colour in (
        ("before", BEFORE),
        ("after", AFTER),
        ("wanted profile; dots: inflections", WANTED),
    ):
        paper.line(context, [(at, bottom), (at + 8.0, bottom)], 0.5, colour)
        paper.text(context, (at + 10.0, bottom + 1.0), words, LABEL, align=0.0)
        at += 16.0 + paper.text_width_of(context, words, LABEL)
    words = f"breadths of the frigate {STRETCH:g} times larger"
    paper.text(context, (WIDTH - MARGIN, bottom + 1.0), words, LABEL, paper.GREY, 1.0)


def main():
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        stem = Path(temporary) / "replays"
        paper.draw(stem, WIDTH, HEIGHT, paint)
        paper.make_small(f"{stem}.png", folder / "field-replays.png", SMALL)


if __name__ == "__main__":
    main()
