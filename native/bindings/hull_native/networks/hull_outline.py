# SPDX-License-Identifier: GPL-3.0-or-later
"""What a network's regions and borders are to a ship: the shell within its outline, transoms, a bar
along the centre plane, knuckles.

The shell's border is taken for four sides: the contour in the centre plane (or beside a bar), from
aft to forward; the deck edge, from aft to forward; and the two ends, from below upwards, where the
shell ends at a transom or a flat bow. Where an end has none, stern or stem are the part of the
contour that rises to the deck.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass, field

import numpy as np

from .._core import tolerances
from ..polylines import end_to_end, lengths_along, points_at
from .contour_ends import find_ends
from .network_reasons import beside_centre_plane, no_regions, no_shell
from .network_sheets import Sheets

# Of the length: places are the same, in one plane as curves drawn by hand are; the curves reach no
# further beyond the centre plane.
_SAME, _PLANE, _BEYOND = 1e-7, 1e-4, 1e-4
# Of the breadth: a bar along the centre plane is no wider.
_BAR = 0.03
# An end is flat where its normal is this much along the ship; an edge of the border is of an open
# transom where this much of it, at most, is along the ship, and it lies within so much of the
# length from aft.
_ACROSS, _OPEN_END, _OPEN_REACH = 0.7, 0.3, 0.05
# Found creases of fewer edges are no knuckle lines: those that are said to be have any length.
_LEAST_CREASE = 4
# Cosine of the turn below which a knuckle line is another one.
_GOES_ON = 0.94


@dataclass
class HullOutline:
    """The shell of a network and what bounds it; all lines (n, 3) in m."""

    network: object  # None of other geometry
    length: float
    low: np.ndarray
    high: np.ndarray
    in_shell: object  # of the network's regions (n,)
    contour: np.ndarray
    deck: np.ndarray
    aft: object  # line or None
    forward: object  # line or None
    # Of flat ends with faces of their own: "aft" and "forward" to (middle, rim), lines from the
    # contour up and from the deck edge inwards.
    ends: dict = field(default_factory=dict)
    middle: object = None  # the centre line of a bar beside the contour
    knuckles: list = field(default_factory=list)
    # Along the contour, m: where the stem begins (None at a flat bow), where the stern post ends in
    # the keel and where the contour arches above it (None without).
    stem: object = None
    post: object = None
    arch: object = None

    @property
    def size(self):
        """The diagonal of the box of all lines, m, as ControlMesh.size has it of points."""
        return float(np.linalg.norm(self.high - self.low))

    @property
    def lengths(self):
        return lengths_along(self.contour)

    def on_contour(self, at):
        return points_at(self.contour, self.lengths, at)


def hull_outline(network):
    """The HullOutline of a CurveNetwork of a half hull. ValueError that names what the network has
    not, or has too many of."""
    if network.region_count == 0:
        raise ValueError(no_regions(network))
    sheets = Sheets(network)
    points = np.concatenate([sheets.points(edge) for edge in range(len(sheets.edges))])
    low, high = points.min(axis=0), points.max(axis=0)
    length = float(high[0] - low[0])
    if low[1] < -_BEYOND * length:
        raise ValueError(
            "The network reaches beyond the centre plane, to y = "
            f"{low[1]:.3f} m: give the curves of the port half, on the side of positive y."
        )
    if reason := beside_centre_plane(low, high):
        raise ValueError(reason)
    kinds = [_kind(sheets, sheet, low, high) for sheet in range(sheets.sheet_of.max() + 1)]
    in_shell = np.array([kinds[sheet] == "shell" for sheet in sheets.sheet_of])
    if not in_shell.any():
        raise ValueError(no_shell(kinds))
    parts = _border(sheets, kinds, in_shell, low, high)
    outline = HullOutline(
        network, length, low, high, in_shell, parts["contour"][::-1], parts["deck"],
        parts.get("aft"), parts["forward"][::-1] if "forward" in parts else None,
    )  # fmt: skip
    outline.middle = _bar_middle(sheets, kinds, outline)
    for end in ("aft", "forward"):
        if end in kinds:
            outline.ends[end] = _end_lines(sheets, kinds, end, outline)
    outline.knuckles = _knuckles(sheets, in_shell, length)
    find_ends(outline)
    return outline


def _in_centre_plane(low, high):
    return tolerances.ON_CENTRE_PLANE * np.linalg.norm(high - low)


def _kind(sheets, sheet, low, high):
    points = np.concatenate([sheets.points(edge) for edge in sheets.edges_of(sheet)])
    middle = points.mean(axis=0)
    normal = np.linalg.svd(points - middle, full_matrices=False)[2][2]
    size = high[0] - low[0]
    if np.abs((points - middle) @ normal).max() < _PLANE * size and abs(normal[0]) > _ACROSS:
        return "aft" if middle[0] < 0.5 * (low[0] + high[0]) else "forward"
    is_central = np.abs(points[:, 1]).min() < _in_centre_plane(low, high)
    is_narrow = points[:, 1].max() < _BAR * high[1]
    return "bar" if is_central and is_narrow else "shell"


def _border(sheets, kinds, in_shell, low, high):
    """The shell's border as lines by name, each running with the shell to its left."""
    border = []
    for edge, regions in sheets.regions.items():
        inside = [(region, is_along) for region, is_along in regions if in_shell[region]]
        if len(inside) != 1:
            continue
        beside = [kinds[sheets.sheet_of[r]] for r, _ in regions if not in_shell[r]]
        is_along = inside[0][1]
        points = sheets.points(edge)[:: 1 if is_along else -1]
        nodes = sheets.edges[edge][:: 1 if is_along else -1]
        border.append((*nodes, _side_of(points, beside, low, high), points))
    loop = _one_loop(border)
    # From where one side ends.
    starts = [i for i in range(len(loop)) if loop[i][2] != loop[i - 1][2]] or [0]
    loop = loop[starts[0] :] + loop[: starts[0]]
    parts = []
    for _, _, side, points in loop:
        if parts and parts[-1][0] == side:
            parts[-1][1] = np.concatenate([parts[-1][1], points[1:]])
        else:
            parts.append([side, points])
    counts = Counter(side for side, _ in parts)
    if counts["contour"] != 1 or counts["deck"] != 1 or max(counts.values()) > 1:
        names = {"contour": "centre plane", "deck": "deck edge"}
        told = ", ".join(
            f"{names.get(side, side + ' end')} from ({', '.join(f'{c:.2f}' for c in line[0])}) m"
            for side, line in parts
        )
        raise ValueError(
            "The network's border must be one line in the centre plane and one along the deck, "
            f"between a stern and a bow; it is: {told}. Leave out what does not belong to the "
            "shell, or give the border's curves whole."
        )
    return dict(parts)


def _side_of(points, beside, low, high):
    if beside:
        return {"bar": "contour"}.get(beside[0], beside[0])
    if np.abs(points[:, 1]).max() < _in_centre_plane(low, high):
        return "contour"
    way = points[-1] - points[0]
    is_across = abs(way[0]) < _OPEN_END * np.linalg.norm(way)
    is_aft = points[:, 0].max() < low[0] + _OPEN_REACH * (high[0] - low[0])
    return "aft" if is_across and is_aft else "deck"


def _one_loop(border):
    after = defaultdict(list)
    for part in border:
        after[part[0]].append(part)
    loop = [border[0]]
    while loop[-1][1] != loop[0][0]:
        following = after[loop[-1][1]]
        if len(following) != 1:
            break
        loop.append(following[0])
    if len(loop) != len(border) or loop[-1][1] != loop[0][0]:
        place = ", ".join(f"{c:.2f}" for c in loop[-1][3][-1])
        raise ValueError(
            f"The network's shell has more than one border, as near ({place}) m: give a network of "
            "one body without openings, the appendages apart."
        )
    return loop


def _bar_middle(sheets, kinds, outline):
    edges = [
        edge
        for edge, regions in sheets.regions.items()
        if len(regions) == 1 and kinds[sheets.sheet_of[regions[0][0]]] == "bar"
    ]
    lines = [sheets.points(edge) for edge in edges]
    near = tolerances.ON_CENTRE_PLANE * outline.size
    lines = [line for line in lines if np.abs(line[:, 1]).max() < near]
    if not lines:
        return None
    line = max(end_to_end(lines, _SAME * outline.length), key=len)
    is_backward = np.linalg.norm(line[0] - outline.contour[0]) > np.linalg.norm(
        line[-1] - outline.contour[0]
    )
    return line[::-1] if is_backward else line


def _end_lines(sheets, kinds, end, outline):
    """Of a flat end: its line in the centre plane, upwards, and its upper border, inwards."""
    middle, rim = [], []
    for edge, regions in sheets.regions.items():
        if len(regions) != 1 or kinds[sheets.sheet_of[regions[0][0]]] != end:
            continue
        points = sheets.points(edge)
        is_middle = np.abs(points[:, 1]).max() < tolerances.ON_CENTRE_PLANE * outline.size
        (middle if is_middle else rim).append(points)
    lines = []
    for parts, axis, what in ((middle, 2, "centre plane"), (rim, 1, "deck")):
        joined = end_to_end(parts, _SAME * outline.length, -2.0)
        if len(joined) != 1:
            raise ValueError(
                f"The flat end {end} has {len(joined)} borders along the {what}; give one."
            )
        line = joined[0]
        lines.append(line if (line[0, axis] < line[-1, axis]) == (axis == 2) else line[::-1])
    return tuple(lines)


def _knuckles(sheets, in_shell, length):
    runs = defaultdict(list)
    for edge, regions in sorted(sheets.regions.items()):
        if not sheets.is_crease[edge] or len(regions) < 2:
            continue
        if not all(in_shell[region] for region, _ in regions):
            continue
        of_curve = runs[sheets.curve_of[edge]]
        if of_curve and sheets.edges[of_curve[-1][-1]][1] == sheets.edges[edge][0]:
            of_curve[-1].append(edge)
        else:
            of_curve.append([edge])
    lines = []
    for of_curve in runs.values():
        for run in of_curve:
            if len(run) < _LEAST_CREASE and not sheets.is_known[run[0]]:
                continue
            lines.append(
                np.concatenate(
                    [sheets.points(run[0])[:1], *(sheets.points(edge)[1:] for edge in run)]
                )
            )
    return end_to_end(lines, _SAME * length, _GOES_ON)
