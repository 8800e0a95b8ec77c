# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to main dimensions while their bilge, bulb or knuckles keep their shape."""

from dataclasses import dataclass

import numpy as np

from ....hull_io import stretching
from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_points
from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_mesh
from ..constraints import flats, move_limits, ties
from ..flotation import ship
from . import following


@dataclass(frozen=True, eq=False)
class Kept:
    """stretch: hull_io.stretching.Stretch in m; surface: hull_native.MappedSurface; radii: of the
    bilge, before and after, m, None where it is not kept."""

    stretch: object
    surface: object
    radii: object


def search(obj, scene, now, keep, wanted, of_surface):
    """A function of progress, for any thread, that returns the Kept of a hull that is brought to
    what is wanted, as hull_io.stretching.stretch_to takes it, and keeps what is named in keep; None
    where factors alone do that; ValueError where it cannot be. now: the Dimensions that the hull
    has. Nothing moves yet."""
    hull_native, scale = native.require(), units.metres_per_unit(scene)
    found = hull_mesh.read(obj)
    control = found.control(scale)
    source = ship.source_of(found, control)
    surface = source.new_surface()
    body = source.new_body(surface)
    named = {name: True for name in keep}
    own_flats, own_limits = _flats(obj, control, scale), _limits(obj, control)

    def found(progress):
        ranges = hull_native.kept_ranges(
            body, draft=now.draft, length_pp=now.length_pp or None, depth=now.depth or None, **named
        )
        low, high = hull_native.surface_ends(surface)
        stretch = stretching.stretch_to(now, ranges, low, high, of_surface=of_surface, **wanted)
        if stretch is None:
            return None
        mapped = hull_native.map_surface(
            surface, stretch, flats=own_flats, progress=progress, **own_limits
        )
        radii = _radii(body, now.draft, stretch, mapped.points) if "bilge" in named else None
        return Kept(stretch, mapped, radii)

    return found


def _radii(body, draft, stretch, points):
    """The bilge radius of a hull_native.HullBody, and the one with other control points (n, 3),
    which it has then; m."""
    hull_native = native.require()
    before = hull_native.bilge_of(body, draft)
    body.surface.set_points(points)
    body.update()
    try:
        after = hull_native.bilge_of(body, draft, float(stretch.place(0, before.x))).radius
    except ValueError:
        after = None  # no arc any longer: that is told, too
    return before.radius, after


def _flats(obj, control, scale):
    """As map_surface takes them, in the order of flats.regions()."""
    return [
        (
            np.flatnonzero(np.isin(control.vertex_ids, region.points)),
            region.plane[:3],
            region.plane[3] * scale,
        )
        for region in flats.regions(obj)
    ]


def _limits(obj, control):
    return move_limits.of_hull(obj, control.vertex_ids, control.points).of_planes()


def apply(obj, scene, kept):
    """Brings a hull, and all that belongs to it, where a Kept has it."""
    check_single_user(obj.data)
    scale = units.metres_per_unit(scene)
    in_units = kept.stretch.in_units(scale)
    vertex_ids = hull_mesh.read(obj).control(scale).vertex_ids
    points = in_units.points(mesh_points.read(obj.data))
    points[vertex_ids] = kept.surface.points / scale
    regions = flats.regions(obj)
    mesh_points.write(obj.data, np.arange(len(points)), points)
    ties.go_along(obj)
    following.follow(obj, in_units, kept.stretch)
    for region, (normal, offset) in zip(regions, kept.surface.planes):
        flats.store_plane(obj, region.number, (*normal, offset / scale))
