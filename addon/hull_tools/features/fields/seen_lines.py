# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of equal intensity of a shape field on a hull's surface."""

from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.objects import field_rows
from ..surface import shown_surface
from . import bases, isolines, prepared

# The surface's points of which distances are asked for are no more than about these.
_MOST_POINTS = 20_000
# What lines of equal distance do not depend on.
_NOT_OF_DISTANCES = frozenset(
    """rna_type name use role colour falloff shift axes becomes falloff_end shift_end""".split()
)


@dataclass(frozen=True, eq=False)
class Lines:
    """Of equal intensity on the hull as it is shown. levels: of isolines.INTENSITIES, an array
    (m, 2, 3) of segments each, m."""

    levels: list
    is_mirrored: bool


@dataclass
class Known:
    """What lines are made from, kept for the next ones: the _Shape that is shown, that without a
    preview, and the _Distances of the latter's points."""

    shown: object = None
    at_start: object = None
    distances: object = None


def samples_of(obj, surface):
    """How many faces along each side of a cell lines go through."""
    most = int(np.sqrt(_MOST_POINTS / max(surface.cell_count, 1)))
    return max(min(shown_surface.samples_of(obj, surface), most), 1)


def values_of(row):
    """All of a field that distances from its base depend on."""
    names = (one.identifier for one in row.bl_rna.properties)
    return tuple(_value(getattr(row, name)) for name in names if name not in _NOT_OF_DISTANCES)


def _value(found):
    if hasattr(found, "matrix_world"):
        return (found.name_full, *(tuple(line) for line in found.matrix_world))
    if isinstance(found, (str, int, float)) or found is None:
        return found
    try:
        return tuple(_value(part) for part in found)
    except TypeError:  # an entry of a list
        return tuple(found.items())


class _Shape:
    """The points of a surface's quadrilaterals, which follow it."""

    def __init__(self, surface, samples):
        self.surface, self.samples = surface, samples
        self.triangles = isolines.triangles_of(surface.tessellate(samples).quads)
        self._points = native.require().ShownPoints(surface, samples, mirrored=False)

    def points(self):
        """(n, 3) m."""
        self._points.update()
        return np.array(self._points.coordinates, dtype=np.float64)


class _Distances:
    """Distances of points from a field's base, as parts of the extent; where points stay they are
    kept. key: of the base and the extent."""

    def __init__(self, key):
        self.key, self._points, self._values = key, None, None

    def at(self, points, fields):
        """(n,) at points (n, 3), m, for the one field of hull_native.ShapeFields."""
        if self._points is None or self._points.shape != points.shape:
            self._values, changed = np.empty(len(points)), np.ones(len(points), dtype=bool)
        else:
            changed = (self._points != points).any(axis=1)
        if changed.any():
            self._values[changed] = fields.deltas(0, points[changed])
        self._points = points
        return self._values


def found(obj, base, known, shown, ground):
    """The Lines of the field of a seen_bases.Base, None of one that has no meaning. shown: the
    LimitSurface that is shown; ground: the prepared.Ground without a preview. Of distances along
    the surface there are none without a preview: they take too long while points are dragged."""
    row, at_start = obj.hull.fields.fields[base.number], ground.surface
    if field_rows.goes_along_surface(row) and not isinstance(ground, prepared.Prepared):
        return None
    try:
        field_of_row = bases.shape_field(row, obj, ground)
    except ValueError:
        return None
    fields = native.require().ShapeFields([field_of_row], mirrored=True)
    samples = samples_of(obj, shown)
    known.shown = points = _shape(known.shown, shown, samples)
    known.at_start = _shape(known.at_start, at_start, samples) if at_start is not shown else points
    key = (values_of(row), base.digest, ground.scale)
    if known.distances is None or known.distances.key != key:
        known.distances = _Distances(key)
    values = known.distances.at(known.at_start.points(), fields)
    levels = _levels(row)
    places, triangles = points.points(), points.triangles
    segments = [isolines.segments(places, triangles, values, level) for level in levels]
    return Lines(segments, ground.is_half)


def _levels(row):
    """Distances, as parts of the extent, of isolines.INTENSITIES; where the falloff varies that of
    the extent alone, as the others are different at every place."""
    levels = isolines.distances_of(isolines.INTENSITIES, float(row.falloff))
    if row.base == "FACES":
        levels = isolines.from_a_rim(levels)
    if field_rows.varies(row) and row.falloff_end != row.falloff:
        levels = np.where(np.array(isolines.INTENSITIES) == 0.0, levels, np.nan)
    return levels


def _shape(before, surface, samples):
    if before is not None and before.surface is surface and before.samples == samples:
        return before
    return _Shape(surface, samples)
