# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of a network that are one smooth surface together."""

from collections import defaultdict

import numpy as np

# Points on an edge of the network.
_EDGE_PARTS = 8


class Sheets:
    """Regions joined over edges along which the surface is smooth."""

    def __init__(self, network):
        self.network = network
        self.edges = np.asarray(network.edges)
        self.curve_of = np.asarray(network.edge_curves)
        self.regions = defaultdict(list)  # of edges: (region, whether it is gone along)
        self.sides = [network.sides(region) for region in range(network.region_count)]
        for region, sides in enumerate(self.sides):
            for side in sides:
                for edge, is_along in side:
                    self.regions[edge].append((region, is_along))
        known = [curve.kind == "knuckle" for curve in network.curves]
        creases = set(np.asarray(network.crease_edges).tolist())
        self.is_known = [known[curve] for curve in self.curve_of]
        self.is_crease = [
            len(self.regions[edge]) < 2 or edge in creases or self.is_known[edge]
            for edge in range(len(self.edges))
        ]
        self.sheet_of = self._joined()

    def _joined(self):
        sheet_of = np.full(len(self.sides), -1)
        for first in range(len(self.sides)):
            if sheet_of[first] >= 0:
                continue
            sheet = sheet_of.max() + 1
            sheet_of[first], todo = sheet, [first]
            while todo:
                for side in self.sides[todo.pop()]:
                    for edge, _ in side:
                        if self.is_crease[edge]:
                            continue
                        for other, _ in self.regions[edge]:
                            if sheet_of[other] < 0:
                                sheet_of[other] = sheet
                                todo.append(other)
        return sheet_of

    def edges_of(self, sheet):
        regions = np.flatnonzero(self.sheet_of == sheet)
        return {edge for region in regions for side in self.sides[region] for edge, _ in side}

    def points(self, edge):
        return self.network.edge_points(int(edge), _EDGE_PARTS)
