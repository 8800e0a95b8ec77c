# SPDX-License-Identifier: GPL-3.0-or-later
"""What is marked on a hull's plates, and how thick they are, as its settings say: gathered from
Blender first, made of plates in threads."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.blender.units import as_typed
from ...bridge.objects import hull_mesh
from ..lines.line_places import line_places
from . import plate_rules

# Of a plate's area: what lies on another layer and is less counts for nothing.
_SMALL = 0.01


@dataclass(frozen=True)
class Marks:
    """table: hull_native.FrameTable, None: frames are evenly spaced by spacing (m) from x = 0, 0
    for none. waterlines, buttocks: heights and distances, m."""

    table: object
    spacing: float
    waterlines: tuple = ()
    buttocks: tuple = ()

    def frames(self, low, high):
        """The FrameTable from x = low to high, None without frames. ValueError for too many."""
        if self.table is not None or self.spacing <= 0.0:
            return self.table
        if (high - low) / self.spacing > limits.MOST_PLATES:
            raise ValueError("There would be too many frames; space them wider")
        first, last = int(low / self.spacing) - 1, int(high / self.spacing) + 1
        ranges = [(min(first, 0), max(last, 1), self.spacing)]
        return native.require().frame_table(ranges)

    def of(self, curves, low, high):
        """(layer, SurfaceCurve) for plate_drawing() from x = low to high, by HullCurves."""
        hull_native, table = native.require(), self.frames(low, high)
        found = [] if table is None else hull_native.frame_marks(curves, table, low, high)
        marks = [("FRAMES", curve) for curve in found]
        for layer, axis, places, word in (
            ("WATERLINES", "z", self.waterlines, "WL"),
            ("BUTTOCKS", "y", self.buttocks, "BL"),
        ):
            names = [f"{word} {round(place, 3):g}" for place in places]
            for curve in hull_native.plane_marks(curves, axis, places, names):
                marks.append((layer, curve))
        return marks


def marks_of(obj, scene, points, spacing):
    """The Marks of a hull with control points (n, 3), m. ValueError as line_places()."""
    settings, waterlines, buttocks = obj.hull.plates, (), ()
    if settings.mark_waterlines or settings.mark_buttocks:
        places = line_places(obj.hull, units.metres_per_unit(scene))
        _, waterlines, buttocks = places.positions(points)
    return Marks(
        plate_rules.frame_table(obj, scene),
        spacing,
        tuple(waterlines) if settings.mark_waterlines else (),
        tuple(buttocks) if settings.mark_buttocks else (),
    )


@dataclass(frozen=True)
class Thickness:
    """of_all: m, of plates where no layer has its own. slots (n,): material slot of each face of
    the shell; of_slots: {slot: m} of layers that have one."""

    of_all: float
    slots: np.ndarray = None
    of_slots: tuple = ()

    def of(self, plates, surface):
        """(list of m, the number of plates that lie on layers of different thickness): each plate
        has that of its largest part."""
        found, mixed = dict(self.of_slots), 0
        sizes = surface.mesh.face_sizes
        if not found or len(self.slots) != len(sizes):
            return [self.of_all] * len(plates), 0
        of_cells = np.array([found.get(slot, self.of_all) for slot in self.slots.tolist()])
        of_cells, chosen = np.repeat(of_cells, sizes), []
        for plate in plates:
            cells, areas = plate.cells
            kinds, which = np.unique(of_cells[cells], return_inverse=True)
            parts = np.bincount(which, areas)
            chosen.append(float(kinds[parts.argmax()]))
            mixed += int((parts > _SMALL * parts.sum()).sum() > 1)
        return chosen, mixed


def thickness_of(obj, scene, of_all):
    """The Thickness of a hull's plates by its layers, else of_all, m."""
    scale, found = units.metres_per_unit(scene), {}
    for layer in obj.hull.layers:
        if not (layer.in_hydrostatics and layer.thickness > 0.0):
            continue
        thickness = as_typed(layer.thickness) * scale
        limits.within(thickness, "A layer's thickness in m", 0.0, limits.THICKEST)
        for slot, one in enumerate(obj.material_slots):
            if layer.material is not None and one.material == layer.material:
                found[slot] = thickness
    slots = hull_mesh.shell_slots(obj) if found else None
    return Thickness(of_all, slots, tuple(found.items()))
