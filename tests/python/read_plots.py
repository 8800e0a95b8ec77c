# SPDX-License-Identifier: GPL-3.0-or-later
"""What a plot shows, read from its page by the ticks of its axes as one reads it."""

import numpy as np


def _numbers(labels, along):
    """[(place along the axis in mm, number)] of labels that are numbers, in order."""
    found = []
    for label in labels:
        text = label["text"].replace("−", "-")
        if text.lstrip("-").replace(".", "", 1).isdigit():
            found.append((label["centre"][along], float(text)))
    return sorted(found)


def read_curves(sheet):
    """[(dashes in mm, points (n, 2) in the units of the axes)] of what runs through the diagram of
    a PlotSheet above its grid, in the order drawn: curves, and lines across."""
    left, top, right, bottom = sheet.diagram
    ticks = {0: [], 1: []}
    drawn = []
    for points, _, width, dashes in sheet.strokes:
        points = np.asarray(points)
        low, high = points.min(axis=0), points.max(axis=0)
        if abs(low[1] - bottom) < 1e-6 and high[1] > bottom + 0.5 and len(points) == 2:
            ticks[0].append(low[0])
        elif abs(high[0] - left) < 1e-6 and low[0] < left - 0.5 and len(points) == 2:
            ticks[1].append(low[1])
        elif (width > 0.3 or dashes) and low[1] >= top - 1e-6 and high[1] <= bottom + 1e-6:
            drawn.append((tuple(dashes), points))
    below = [one for one in sheet.labels if bottom + 1.0 < one["centre"][1] < bottom + 5.0]
    beside = [
        one
        for one in sheet.labels
        if one["centre"][0] < left and top - 1.0 < one["centre"][1] < bottom + 1.0
    ]
    scales = []
    for along, labels in ((0, below), (1, beside)):
        numbers = [number for _, number in _numbers(labels, along)]
        at = sorted(ticks[along])
        assert len(at) == len(numbers) >= 2
        scales.append(np.polyfit(at, numbers, 1))
    return [
        (dashes, np.stack([np.polyval(s, points[:, k]) for k, s in enumerate(scales)], axis=1))
        for dashes, points in drawn
    ]
