# SPDX-License-Identifier: GPL-3.0-or-later
"""What the ship weighs without load: the shell by thickness and density of its layers' plating,
from the exact surface, and a list of all else."""

from dataclasses import dataclass

import numpy as np

from ...bridge import limits, native
from ...bridge.blender.units import as_typed
from ...bridge.objects import hull_mesh, hull_objects
from . import centres

IS_LIVE = False

SHELL = "Shell"


@dataclass(frozen=True)
class Plate:
    """thickness in m, density in t/m³; slots: of the materials."""

    name: str
    thickness: float
    density: float
    slots: tuple


@dataclass(frozen=True)
class Inputs:
    """items: tuples (name, mass in t, (LCG, TCG, VCG) in m). slots: the material slot of each of
    the shell's faces, as bytes of int32, where plates have not all faces alike."""

    plates: tuple
    items: tuple
    slots: bytes


@dataclass(frozen=True)
class Part:
    """area: m² of plating, of both sides; None of what is none."""

    name: str
    mass_t: float
    centre: tuple
    area: object = None


@dataclass(frozen=True)
class Result:
    parts: tuple

    @property
    def total(self):
        return total("Ship", self.parts)


def inputs(settings, metres_per_unit):
    own = settings.weights
    limits.at_most(len(own.items), "weights", limits.MOST_LOADING_ENTRIES)
    items = tuple(centres.named_mass(one, metres_per_unit) for one in own.items)
    plates = tuple(_plates(settings, metres_per_unit))
    slots = b""
    if any(plate.slots for plate in plates):
        slots = hull_mesh.shell_slots(settings.id_data).tobytes()
    return Inputs(plates, items, slots)


def _plates(settings, metres_per_unit):
    """The plating of layers that have their own, and of the rest; those of no thickness are left
    out."""
    own = settings.weights
    taken = []
    for layer in settings.layers:
        if not layer.in_hydrostatics or not (layer.thickness or layer.density):
            continue
        slots = tuple(
            index
            for index, slot in enumerate(settings.id_data.material_slots)
            if slot.material == layer.material and slot.material and index not in taken
        )
        if not slots:
            continue
        taken += slots
        thickness, density = layer.thickness or own.thickness, layer.density or own.density
        name = hull_objects.layer_name(layer)
        yield _plate(name, thickness, density, slots, metres_per_unit)
    yield _plate(SHELL, own.thickness, own.density, tuple(-1 - slot for slot in taken),
                 metres_per_unit)  # fmt: skip


def _plate(name, thickness, density, slots, metres_per_unit):
    """Slots below zero are those that the rest has not, counted from -1."""
    thickness = limits.within(
        as_typed(thickness) * metres_per_unit, f"{name}: thickness in m", 0.0, limits.THICKEST
    )
    density = limits.within(as_typed(density), f"{name}: density in t/m³", 0.0, limits.DENSEST)
    return Plate(name, thickness, density, slots)


def compute(ship, given):
    """The Result: plates that weigh something, then the list."""
    return Result((*_shell(ship, given), *(Part(*item) for item in given.items)))


def _shell(ship, given):
    plates = [plate for plate in given.plates if plate.thickness * plate.density > 0.0]
    if not plates:
        return
    surface, sides = ship.body.surface, 2.0 if ship.body.mirrored else 1.0
    areas = native.require().surface_areas(surface)
    slots = np.frombuffer(given.slots, dtype=np.int32)
    if len(slots):
        slots = np.repeat(slots, surface.mesh.face_sizes)
    for plate in plates:
        area, centre = areas.of(_cells(plate, slots, surface.cell_count))
        if area == 0.0:
            continue
        if ship.body.mirrored:
            centre = centre * (1.0, 0.0, 1.0)
        mass = sides * area * plate.thickness * plate.density
        yield Part(plate.name, mass, tuple(centre.tolist()), sides * area)


def _cells(plate, slots, count):
    """The mask of the cells of a plate."""
    if not len(slots):
        return np.ones(count, dtype=bool)
    if plate.name == SHELL and all(slot < 0 for slot in plate.slots):
        return ~np.isin(slots, [-1 - slot for slot in plate.slots])
    return np.isin(slots, plate.slots)


def total(name, parts):
    """The Part of all parts; its centre is 0 where they weigh nothing."""
    mass = sum(part.mass_t for part in parts)
    moments = [
        sum(part.mass_t * part.centre[axis] for part in parts) for axis in range(3)
    ]  # fmt: skip
    return Part(name, mass, tuple(moment / mass for moment in moments) if mass else (0.0,) * 3)


def header(result):
    return ["weight", "area [m2]", "mass [t]", "LCG [m]", "TCG [m]", "VCG [m]"]


def rows(result):
    for part in (*result.parts, result.total):
        yield [part.name, part.area, part.mass_t, *part.centre]
