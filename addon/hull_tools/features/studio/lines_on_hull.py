# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections and waterlines drawn on the hull as thin tubes."""

from ...bridge import limits
from ..lines import line_curves, lines
from . import paint, place

# Of the picture's width: a line of one and a half points of one that has 1600.
_RADIUS = 4.5e-4
_LEAST_POINTS = 1.0
# Where the hull has no spacing of its own.
_WATERLINES_TO_DRAFT = 4
_STATIONS = 20


def wanted_cuts(hull, state, choice, metres_per_unit):
    """What to draw, as lines.groups takes it: "SECTIONS" for stations and waterlines, "SHOWN" for
    the kinds that are shown in the 3D view, "NONE"."""
    if choice == "NONE":
        return {}
    points = state.ship.surface.mesh.points
    if choice == "SHOWN":
        return lines.wanted_cuts(hull.hull, points, metres_per_unit)
    kinds = ("station", "waterline", "draft", "feature")
    wanted = lines.cuts_of_kinds(hull.hull, points, metres_per_unit, kinds)
    wanted["station"] = wanted["station"] or _even_stations(points)
    wanted["waterline"] = wanted["waterline"] or _even_waterlines(wanted["draft"], points)
    return wanted


def find(hull, state, wanted):
    """The lines.Groups of wanted_cuts."""
    return list(
        lines.groups({}, state.ship.surface, wanted, hull.hull.half, state.ship.moved).values()
    )


def waterlines(hull, state, metres_per_unit):
    """Polylines (k, 3) in m of the waterline at the draft, both sides."""
    surface = state.ship.surface
    wanted = lines.cuts_of_kinds(hull.hull, surface.mesh.points, metres_per_unit, ("draft",))
    group = lines.groups({}, surface, wanted, hull.hull.half, state.ship.moved)["draft"]
    return line_curves.chains_of(surface, group, False)


def _even_stations(points):
    low, high = points[:, 0].min(), points[:, 0].max()
    step = (high - low) / _STATIONS
    if not step > 0.0:
        return ()
    return tuple(lines.Cut((1.0, 0.0, 0.0, low + i * step)) for i in range(1, _STATIONS))


def _even_waterlines(draft_cuts, points):
    low, high = points[:, 2].min(), points[:, 2].max()
    top = draft_cuts[0].plane[3] if draft_cuts and draft_cuts[0].plane[3] > low else high
    if (high - low) * _WATERLINES_TO_DRAFT > limits.MOST_LINES * (top - low):
        top = high  # of a draft that is next to nothing, as while it is typed
    step = (top - low) / _WATERLINES_TO_DRAFT
    if not step > 0.0:
        return ()
    count = int((high - low) / step)
    heights = [low + i * step for i in range(1, count + 1)]
    return tuple(lines.Cut((0.0, 0.0, 1.0, z)) for z in heights if abs(z - top) > 1e-3 * step)


def add_lines(here, kinds):
    """Curves of these of lines.KINDS, still empty."""
    for kind in kinds:
        name = _name(kind)
        curve = line_curves.new_curve(name, [], 0.0, here.metres_per_unit, True)
        curve.materials.append(paint.line_paint(kind, here))
        here.add_scenery(name, curve).visible_shadow = False


def follow(here, surface, groups):
    """Draws these lines anew; what is gone stays away."""
    groups = {group.kind: group for group in groups}
    for kind in line_curves.LAYER_NAMES:
        drawn = here.find(_name(kind))
        if drawn is not None:
            group = groups.get(kind)
            chains = [] if group is None else line_curves.chains_of(surface, group, True)
            line_curves.write_chains(drawn.data, chains, here.metres_per_unit, True)


def _name(kind):
    return f"Studio {line_curves.LAYER_NAMES[kind]}"


def draw_thin(here, picture_width):
    """Makes the lines as thin as they should be in a picture so many units wide at the hull."""
    render = here.scene.render
    points = max(render.resolution_x, render.resolution_y) * render.resolution_percentage / 100.0
    radius = max(_RADIUS, 0.5 * _LEAST_POINTS / points)
    for obj in here.collection.objects:
        if obj.type == "CURVE" and obj.get(place.MARK):
            obj.data.bevel_depth = radius * picture_width
