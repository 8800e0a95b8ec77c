# SPDX-License-Identifier: GPL-3.0-or-later
"""Keels, rudders, shafts, tunnels: what each is made of, where it is on a hull, how large."""

from dataclasses import dataclass
from functools import cached_property
from math import cos, sin, tan

import bpy
import numpy as np
from mathutils import Euler

from ...bridge import native
from . import appendage_meshes, hull_state

NUMBERS = (
    "x", "y", "z", "chord", "tip_chord", "span", "sweep", "overlap", "radius", "length", "angle"
)  # fmt: skip


# What a section's name may be, for settings.
SECTIONS = (
    "NACA section: four digits (0012, 2412), five (23012, reflexed 23112), either with another "
    "nose and place of the thickness (0012-64); series 63 to 65 (63-012, 63-412) and 63A to 65A "
    "(64A010), the mean line of a = 1 unless it is given (63-412 a=0.8)"
)


@dataclass(frozen=True)
class Kind:
    """asked: names of what it is made by; ratios: of Lpp (x, chords, lengths), of the draft (z,
    span, overlap, radius) or of the beam (y), where nothing else is asked for."""

    name: str
    description: str
    asked: tuple
    usual: dict
    section: str = ""


_FOIL = ("section", "x", "y", "chord", "tip_chord", "span", "sweep", "overlap")

KINDS = {
    "FIN_KEEL": Kind("Fin Keel", "A foil below the hull, on the centre plane", _FOIL,
                     {"x": 0.55, "chord": 0.16, "tip_chord": 0.11, "span": 1.2, "sweep": 0.03,
                      "overlap": 0.3}, "63-012"),
    "BULB_KEEL": Kind("Bulb Keel", "A fin keel with a body of revolution at its tip",
                      (*_FOIL, "length", "radius"),
                      {"x": 0.55, "chord": 0.12, "tip_chord": 0.09, "span": 1.5, "sweep": 0.01,
                       "overlap": 0.3, "length": 0.2, "radius": 0.15}, "63-012"),
    "RUDDER": Kind("Rudder", "A foil below the stern", _FOIL,
                   {"x": 0.03, "chord": 0.035, "tip_chord": 0.03, "span": 0.8, "sweep": 0.0,
                    "overlap": 0.1}, "0018"),
    "SKEG": Kind("Skeg", "A long, thin foil below the afterbody", _FOIL,
                 {"x": 0.2, "chord": 0.18, "tip_chord": 0.12, "span": 0.25, "sweep": 0.04,
                  "overlap": 0.2}, "0006"),
    "SHAFT": Kind("Shaft", "A cylinder from within the hull aft and down",
                  ("x", "y", "length", "radius", "angle", "overlap"),
                  {"x": 0.25, "y": 0.2, "length": 0.12, "radius": 0.03, "angle": 0.06,
                   "overlap": 0.3}),
    "BRACKET": Kind("Shaft Bracket", "A foil from the hull down to a shaft",
                    ("section", "x", "y", "chord", "span", "angle", "overlap"),
                    {"x": 0.12, "y": 0.2, "chord": 0.012, "span": 0.4, "angle": 0.4,
                     "overlap": 0.1}, "0015"),
    "TUNNEL": Kind("Thruster Tunnel", "A cylinder athwartships that is cut out of the hull",
                   ("x", "z", "radius"), {"x": 0.92, "z": 0.4, "radius": 0.15}),
    "CYLINDER": Kind("Cylinder", "An upright cylinder through the bottom, added or cut out",
                     ("x", "y", "span", "radius", "overlap"),
                     {"x": 0.5, "y": 0.0, "span": 0.3, "radius": 0.1, "overlap": 0.3}),
}  # fmt: skip

_OF_LENGTH = ("x", "chord", "tip_chord", "sweep", "length")
_BEYOND = 0.05  # of the beam: tunnels end so far outside the hull


def usual(kind, hull):
    """The numbers of a kind for a hull, in Blender's units, and its section."""
    settings = hull.hull
    size = {name: settings.length_pp for name in _OF_LENGTH}
    size["y"] = settings.beam
    values = {
        name: ratio * (1.0 if name == "angle" else size.get(name, settings.draft))
        for name, ratio in KINDS[kind].usual.items()
    }
    return {**values, "section": KINDS[kind].section}


def add(kind, hull, values, section, scale, collection):
    """The new appendage objects of a kind; values: of NUMBERS, in Blender's units. ValueError where
    the hull is not there, or sizes make no body."""
    before = set(hull.children)
    try:
        return _MAKERS[kind](_Maker(kind, hull, values, section, scale, collection))
    except ValueError:
        # A keel is not left without its bulb.
        for obj in set(hull.children) - before:
            bpy.data.meshes.remove(obj.data)
        raise


@dataclass(frozen=True)
class _Maker:
    kind: str
    hull: object
    values: dict
    section: str
    scale: float
    collection: object

    def __getattr__(self, name):
        if name not in self.values:
            raise AttributeError(name)
        return self.values[name]

    @cached_property
    def base(self):
        return self.bottom(self.x)

    @cached_property
    def _surface(self):
        return hull_state.up_to_date(self.hull, bpy.context.scene).ship.surface

    @cached_property
    def _tree(self):
        return native.require().SurfaceTree(self._surface)

    def bottom(self, x):
        """z of the hull's lowest point over or below (x, y), in Blender's units. ValueError where
        there is no hull."""
        points, y = self._surface.mesh.points, self.y
        # Beside the centre plane, as on it two halves meet.
        beside = 1e-7 * float(np.ptp(points[:, 0]))
        own = (abs(y) if self.hull.hull.half else y) * self.scale
        begin = (x * self.scale, own or beside, points[:, 2].min() - 1.0)
        hits = self._tree.all_ray_hits(begin, (0.0, 0.0, 1.0))
        if len(hits) == 0:
            raise ValueError(
                f"There is no hull over x = {x:.3f}, y = {y:.3f}: choose another place"
            )
        return float(hits.points[0, 2]) / self.scale

    def top(self, chord):
        """The highest of the bottom's heights from x to the chord aft of it."""
        found = [self.base]
        for share in (0.25, 0.5, 0.75, 1.0):
            try:
                found.append(self.bottom(self.x - share * chord))
            except ValueError:
                break  # the hull ends there
        return max(found)

    def made(self, name, place, **values):
        values.setdefault("is_mirrored", place[1] != 0.0)
        return appendage_meshes.add(self.hull, name, place, values, self.collection)

    @property
    def name(self):
        return KINDS[self.kind].name


def _foil(make):
    """From `overlap` above the hull's bottom, where that is highest along the chord, to `span`
    below it at the leading edge."""
    root = make.top(make.chord) + make.overlap
    return make.made(
        make.name,
        (make.x, make.y, root),
        shape="FOIL",
        section=make.section,
        span=root - make.base + make.span,
        sweep=make.sweep,
        chord=make.chord,
        tip_chord=make.tip_chord,
    )


def _fin(make):
    return [_foil(make)]


def _bulb_keel(make):
    fin = _foil(make)
    middle = make.x - make.sweep - 0.5 * make.tip_chord
    # The fin ends within the bulb, on its axis.
    place = (middle + 0.45 * make.length, make.y, make.base - make.span)
    bulb = make.made(
        "Bulb",
        place,
        shape="BULB",
        section="65-012" if make.section.startswith("6") else "0012",
        length=make.length,
        radius=make.radius,
    )
    return [fin, bulb]


def _shaft(make):
    down, aft = sin(make.angle), cos(make.angle)
    place = (make.x + make.overlap * aft, make.y, make.base + make.overlap * down + make.radius)
    obj = make.made(
        make.name, place, shape="CYLINDER", radius=make.radius, length=make.length + make.overlap
    )
    obj.rotation_euler = Euler((0.0, -0.5 * np.pi - make.angle, 0.0))
    return [obj]


def _bracket(make):
    lean = make.angle if make.y > 0.0 else -make.angle
    place = (make.x, make.y - make.overlap * tan(lean), make.base + make.overlap)
    obj = make.made(
        make.name,
        place,
        shape="FOIL",
        section=make.section,
        span=make.span + make.overlap / cos(lean),
        chord=make.chord,
    )
    obj.rotation_euler = Euler((lean, 0.0, 0.0))
    return [obj]


def _tunnel(make):
    beam = make.hull.hull.beam
    reach = (0.5 + _BEYOND) * beam
    obj = make.made(
        make.name,
        (make.x, -reach, make.z),
        shape="CYLINDER",
        radius=make.radius,
        length=2.0 * reach,
        is_cut=True,
        is_mirrored=False,
    )
    obj.rotation_euler = Euler((-0.5 * np.pi, 0.0, 0.0))
    return [obj]


def _cylinder(make):
    return [
        make.made(
            make.name,
            (make.x, make.y, make.base - make.span),
            shape="CYLINDER",
            radius=make.radius,
            length=make.span + make.overlap,
        )
    ]


_MAKERS = {
    "FIN_KEEL": _fin,
    "BULB_KEEL": _bulb_keel,
    "RUDDER": _fin,
    "SKEG": _fin,
    "SHAFT": _shaft,
    "BRACKET": _bracket,
    "TUNNEL": _tunnel,
    "CYLINDER": _cylinder,
}
