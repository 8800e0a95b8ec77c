# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of docs/tags.md of tied points."""

import bpy
import numpy as np
from addon_under_test import part
from close_views import coaster_close_by
from expect import edited_points


def tied_points(window):
    """A coaster amidships in edit mode: points of the deck's edge on the line between two others,
    and two at the bilge that go with one of them."""
    hull = yield from coaster_close_by(window, (62.0, 0.0, 150.0), (40.0, 6.0, 4.0), 44.0)
    with window.in_view():
        _tie(hull)
        part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
        bpy.ops.mesh.select_all(action="DESELECT")
    yield


def _tie(hull):
    ties, kinds = part("features.constraints.ties"), part("bridge.mesh.point_ties").KINDS
    points = edited_points(hull)

    def nearest(*place):
        return int(np.abs(points - place).sum(axis=1).argmin())

    deck = np.flatnonzero((points[:, 2] > 7.0) & (points[:, 1] > 6.0))
    row = deck[np.argsort(points[deck, 0])]
    row = row[(points[row, 0] > 18.0) & (points[row, 0] < 56.0)]
    ends = [(row[0], row[-1])] * (len(row) - 2)
    ties.tie_points(hull, kinds.index("LINE"), row[1:-1], np.array(ends))
    head = nearest(*(points[row[-1]] - (0.0, 0.0, 3.5)))
    feet = [nearest(*(points[row[-1]] - (0.0, low, 6.0))) for low in (0.3, 1.5)]
    feet = [foot for foot in dict.fromkeys(feet) if foot != head and foot not in row]
    ties.tie_points(
        hull, kinds.index("ANCHOR"), np.array(feet), np.array([(head, head)] * len(feet))
    )
