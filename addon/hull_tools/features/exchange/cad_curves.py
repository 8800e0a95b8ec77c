# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull's lines as B-spline curves for CAD files."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ..lines import lines
from ..lines.line_curves import LAYER_NAMES, bezier_knots

# Of the hull's length: sections are as close as the patches, but no closer than this.
_LEAST_TOLERANCE = 1e-8
_LARGEST_TOLERANCE = 1e-5

# Extents that have the mirror image of a half hull too.
BOTH_SIDES = ("BOTH", "SOLID")

# Of a curve's size: derivatives that differ by less agree.
_SMOOTH = 1e-9

_AXES = {"station": 0, "buttock": 1, "waterline": 2, "draft": 2}


@dataclass(frozen=True)
class LinesWanted:
    """cuts: lines.Cuts by kind, of which mirror images are made by who writes them. tolerance: of
    the hull's length. has_flats, has_features: whether these are wanted too."""

    cuts: dict
    tolerance: float
    has_flats: bool
    has_features: bool


def wanted(obj, scene, surface):
    """The LinesWanted of a hull's settings, None where they want none; ValueError when its lists
    of positions are wrong."""
    export, shown = obj.hull.export, obj.hull.lines
    if not (export.with_sections or export.with_features):
        return None
    cuts = {}
    if export.with_sections:
        scale = units.metres_per_unit(scene)
        found = lines.wanted_cuts(obj.hull, surface.mesh.points, scale)
        cuts = {kind: own_cuts(found[kind], export.extent not in BOTH_SIDES) for kind in found}
    tolerance = min(max(units.as_typed(export.tolerance), _LEAST_TOLERANCE), _LARGEST_TOLERANCE)
    has_flats = export.with_sections and shown.show_flats
    return LinesWanted(cuts, tolerance, has_flats, export.with_features)


def own_cuts(cuts, is_half_wanted):
    """Each plane once. What stands for its mirror image belongs to both sides only."""
    return tuple({cut.plane: cut for cut in cuts if not (cut.flip and is_half_wanted)}.values())


def curves(surface, wanted, progress):
    """(name, layer, knots, control points (n, 3)) of each curve on a hull_native.LimitSurface. For
    any thread; progress as in patches.convert."""
    found = []
    planes = [
        (_name(kind, cut, number), LAYER_NAMES[kind], cut)
        for kind, cuts in wanted.cuts.items()
        for number, cut in enumerate(cuts, 1)
    ]
    for done, (name, layer, cut) in enumerate(planes):
        progress(done / len(planes))
        splines = _splines(surface, cut, wanted.tolerance)
        found += [(name, layer, *spline) for spline in splines]
    if wanted.has_flats:
        layer = LAYER_NAMES["flat"]
        found += [(layer, layer, *_spline(one.cubics)) for one in lines.flat_borders(surface)]
    if wanted.has_features:
        for curve in native.require().crease_curves(surface):
            name = "knuckle" if curve.kind == "crease" else "border"
            found.append((name, LAYER_NAMES["feature"], curve.knots, curve.control_points))
    return found


def _name(kind, cut, number):
    if kind == "feature":
        return "profile"
    if kind not in _AXES:
        return f"{kind} {number}"
    position = cut.plane[3] * cut.plane[_AXES[kind]]
    return f"{'design waterline' if kind == 'draft' else kind} {position:.3f} m"


def _splines(surface, cut, tolerance):
    """(knots, control points) of the B-splines of a cut."""
    (branches,) = native.require().section_splines(
        surface,
        np.array([cut.plane]),
        tolerance * lines.size_of(surface),
        flat_tolerance=lines.flat_tolerance(surface),
    )
    for spline in (one for branch in branches for one in branch.splines):
        if cut.side == 0 or lines.kept_by(cut, spline.control_points).all():
            yield spline.knots, spline.control_points
            continue
        knots = bezier_knots(spline.knots, spline.control_points)
        for part in lines.Section(lines.Cut(cut.plane, cut.side), []).parts(knots[:, 1], knots):
            yield _spline(_cubics(part))


def _cubics(part):
    """Bézier cubics (m, 4, 3) of a chain of left handle, point and right handle (m + 1, 3, 3)."""
    return np.stack([part[:-1, 1], part[:-1, 2], part[1:, 0], part[1:, 1]], axis=1)


def _spline(cubics):
    """(knots, control points) of the B-spline that is a chain of Bézier cubics (m, 4, 3), with as
    few knots as it is smooth at their ends."""
    ends = np.arange(len(cubics) + 1.0)
    knots = np.repeat(ends, [4, *_multiplicities(cubics), 4])
    points = []
    for i in range(len(knots) - 4):
        piece = int(knots[i])  # the cubic that begins there, which the point i belongs to
        points.append(_blossom(cubics[piece], knots[i + 1 : i + 4] - piece))
    return knots, np.array(points)


def _multiplicities(cubics):
    """Of the inner knots: 1 where the second derivatives agree, 2 where the first do, else 3."""
    size = np.ptp(cubics.reshape(-1, 3), axis=0).max()
    found = np.full(len(cubics) - 1, 3)
    is_smooth = np.ones(len(cubics) - 1, dtype=bool)
    for order, multiplicity in ((1, 2), (2, 1)):
        before = np.diff(cubics[:-1], order, axis=1)[:, -1]
        after = np.diff(cubics[1:], order, axis=1)[:, 0]
        is_smooth &= np.abs(before - after).max(axis=1) <= _SMOOTH * size
        found[is_smooth] = multiplicity
    return found


def _blossom(cubic, at):
    """The polar form of a Bézier cubic (4, 3) over [0, 1] at three parameters."""
    points = cubic
    for t in at:
        points = (1.0 - t) * points[:-1] + t * points[1:]
    return points[0]
