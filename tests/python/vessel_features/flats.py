# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts that are plane: bottom, side, transom, bar; and the parallel middle body."""

import numpy as np

from .form import SAME
from .knuckles import between_planes


def flat(form, normal, offset, along, across=(0.0, 0.0), upright=(0.0, 0.0)):
    """A plane part of the surface, exactly: as long as that part of the length at least, and that
    reaches from one to the other half breadth (parts of half the beam) and height (of the depth).
    """
    given = form.given
    regions = form.in_plane(normal, offset)
    assert regions, f"nothing is in the plane {normal} at {offset:.3f} m"
    normals = np.array([region.plane[:3] for region in regions])
    assert (normals @ np.array(normal) > 0.0).all(), f"a flat looks away from {normal}"
    points = np.vstack([border.points(16) for region in regions for border in region.borders])
    low, high = points.min(axis=0), points.max(axis=0)
    length = (high[0] - low[0]) / given.length_pp
    assert length >= along, f"the flat is {length:.2f} of the length"
    for column, (first, last), unit in (
        (1, across, 0.5 * given.beam),
        (2, upright, given.depth),
    ):
        margin = SAME * form.size
        reaches = low[column] <= first * unit + margin and high[column] >= last * unit - margin
        assert reaches or first == last, f"from {low[column]:.2f} to {high[column]:.2f} m"


def flat_bottom(form, along, outwards):
    """In the base plane, from the centre plane or the bar outwards."""
    flat(form, (0.0, 0.0, -1.0), 0.0, along, across=(0.05, outwards))


def flat_bottom_in_knuckle(form, along, outwards):
    """The same, bounded outwards by a knuckle in the base plane for half as long at least."""
    flat_bottom(form, along, outwards)
    points = np.vstack([knuckle.points for knuckle in form.knuckles])
    x, y, z = points.T
    edge = x[(np.abs(z) < SAME * form.size) & (y > 0.05 * form.given.beam)]
    length = np.ptp(edge) / form.given.length_pp if len(edge) else 0.0
    assert length > 0.5 * along, f"a knuckle bounds the flat over {length:.2f} of the length"


def flat_side(form, along, low, high):
    """In the plane of the largest half breadth, between heights as parts of the depth."""
    flat(form, (0.0, 1.0, 0.0), 0.5 * form.given.beam, along, upright=(low, high))


def sides_of_three_planes(form, along):
    """Flare below, vertical, tumblehome above, each plane, between two knuckles."""
    leans = []
    for part in form.data.flats:
        normal = np.array(part.normal)
        if normal[1] > 0.5:
            flat(form, part.normal, part.offset, along)
            leans.append(np.degrees(np.arcsin(normal[2])))
    assert len(leans) == 3, f"{len(leans)} planes at the side"
    low, middle, high = sorted(leans)
    assert low < -3.0 and abs(middle) < 1e-9 and high > 3.0, f"they lean by {leans} degrees"
    for angle in (-low, high):
        between_planes(form, angle, within=0.1)


def mostly_flat(form, least):
    """That part of the surface, or more, is flat: its radii of curvature exceed ten beams."""
    surface = form.surface
    places = (np.stack(np.meshgrid(range(4), range(4)), axis=-1).reshape(-1, 2) + 0.5) / 4
    cells = np.repeat(np.arange(surface.cell_count), len(places))
    uv = np.tile(places, (surface.cell_count, 1))
    _, along_u, along_v = surface.evaluate(cells, uv, 1)
    areas = np.linalg.norm(np.cross(along_u, along_v), axis=1)
    bent = surface.curvature(cells, uv)
    plane = np.maximum(np.abs(bent.maximum), np.abs(bent.minimum)) < 0.1 / form.given.beam
    share = areas[plane].sum() / areas.sum()
    assert share > least, f"{share:.2f} of the surface is flat"


def flat_bar(form, half_width):
    """A strip about the whole centre plane of one half width within a knuckle, from the transom to
    the stem's head; there it may end in one point, over two control edges."""
    chains = [knuckle for knuckle in form.knuckles if _runs_along_bar(knuckle, half_width)]
    assert chains, "no knuckle beside the centre plane"
    points = np.vstack([knuckle.points for knuckle in chains])
    assert np.ptp(points[:, 0]) > form.given.length_pp, f"{np.ptp(points[:, 0]):.1f} m long"
    assert points[:, 0].min() - form.low[0] < SAME * form.size, "the bar ends before the transom"
    for knuckle in chains:
        start, end = form.on_centre(knuckle.points[[0, -1]])
        kept = (knuckle.t >= 2 * start) & (knuckle.t <= knuckle.curve.edge_count - 2 * end)
        away = np.abs(knuckle.points[kept, 1] - half_width).max()
        assert away < SAME, f"the bar's half width differs by {away:.1e} m"


def _runs_along_bar(knuckle, half_width):
    """Whether it keeps beside the centre plane; a chain across the bar does not."""
    return np.mean(np.abs(knuckle.points[:, 1] - half_width) < 0.01 * half_width) > 0.5


def parallel_middle_body(form, first, last):
    """Equal stations between two parts of the length."""
    given = form.given
    heights = np.linspace(1e-4, 0.999, 120) * given.depth
    offsets = np.linspace(1e-4, 0.95, 60) * 0.5 * given.beam
    stations = np.linspace(first, last, 7) * given.length_pp
    found = np.array([np.r_[form.breadths(x, heights), form.bottoms(x, offsets)] for x in stations])
    # Where one has no such point, none has.
    assert (np.isnan(found) == np.isnan(found[0])).all(), "stations are not of one width"
    away = np.nanmax(np.abs(found - found[0]))
    assert away < SAME * form.size, f"stations differ by {away:.3f} m"


def round_bilge(form, radius, x):
    """A quarter of a circle of that radius between bottom and side, within 3 % of it."""
    centre_y, centre_z = 0.5 * form.given.beam - radius, radius
    angles = np.radians(np.linspace(10.0, 80.0, 29))
    heights = centre_z - radius * np.sin(angles)
    breadths = form.breadths(x, heights)
    found = np.hypot(breadths - centre_y, heights - centre_z)
    away = np.abs(found - radius).max()
    assert away < 0.03 * radius, f"{away:.3f} m from a circle of {radius} m"
