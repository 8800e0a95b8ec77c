# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull's control mesh and particulars as every importer delivers them.

Lengths are metres and densities t/m3, whatever the file's own units were. Axes: x forward from
the after perpendicular, y to port, z up from the baseline. A half hull lies at y >= 0 and is
mirrored on y = 0. The *shell* is the faces whose layer counts in hydrostatics; only it goes to the
surface, the hydrostatics and the exports.
"""

from dataclasses import dataclass, field

import numpy as np

from .real_points import real_array
from .ship_data import Afloat, Load, Resistance, Weights
from .wanted import Targets


@dataclass
class Layer:
    """A named group of faces. `colour` is sRGB (red, green, blue), each 0 to 1.

    thickness, in m, and density, in t/m3, of its plating; 0: those of the hull's Weights."""

    name: str = ""
    in_hydrostatics: bool = True
    colour: tuple = (0.75, 0.75, 0.75)
    thickness: float = 0.0
    density: float = 0.0


@dataclass
class Particulars:
    """Main dimensions in m and water density in t/m3. 0 means: the file does not say."""

    length_pp: float = 0.0
    beam: float = 0.0
    draft: float = 0.0
    depth: float = 0.0
    water_density: float = 0.0


@dataclass
class CutPlane:
    """A plane to cut the hull by: through a point in m, across a normal of any length."""

    name: str
    normal: tuple
    point: tuple
    shown: bool = True


@dataclass
class Flat:
    """Faces, by index, that are kept in a plane: normal · point = offset in m, a unit normal."""

    faces: list
    normal: tuple
    offset: float


@dataclass
class Developable:
    """Faces, by index, between two knuckles, that are a developable region: warp, the most of any
    ruling in degrees per metre; distance, how far the knuckles may move for it, m; keep, whether
    they do so while points are moved."""

    faces: list
    warp: float = 1.0
    distance: float = 0.05
    keep: bool = True


# The planes that points are kept in, as hull files name them, across x, y and z.
KEPT_IN = ("stations", "buttocks", "waterlines")


@dataclass
class Kept:
    """Points, by index, that stay in their station (at their x), buttock (y), waterline (z)."""

    stations: list = field(default_factory=list)
    buttocks: list = field(default_factory=list)
    waterlines: list = field(default_factory=list)


@dataclass
class Tie:
    """A point, by index, that follows others, to, as hull_ties tells of each kind. distance: m."""

    kind: str
    point: int
    to: tuple
    share: float = 0.0
    distance: tuple = (0.0, 0.0, 0.0)


@dataclass
class PointGroup:
    """Points, by index, that go by a name."""

    name: str
    points: list


# The kinds of lines that can be shown, as hull files name them.
LINE_KINDS = (
    "stations",
    "waterlines",
    "buttocks",
    "diagonals",
    "planes",
    "design_waterline",
    "flats",
    "features",
)


@dataclass
class LineChoice:
    """Which lines are shown and drawn, and where they lie. Lengths in m.

    Lists are texts as number_lists reads them; one that is not blank counts before the spacing.
    station_count: spaces that the stations part Lpp into; 0, as a spacing of 0, is none.
    stations_in: "metres" or "frames", what the list of stations is given in.
    """

    shown: tuple = LINE_KINDS
    station_count: int = 20
    waterline_spacing: float = 0.0
    buttock_spacing: float = 0.0
    stations: str = ""
    stations_in: str = "metres"
    waterlines: str = ""
    buttocks: str = ""
    diagonals: str = ""
    frame_spacing: float = 0.0
    planes: list = field(default_factory=list)


@dataclass
class FieldEnd:
    """What a ShapeField is at the fore end of its base, or its upper one."""

    extent: float
    falloff: float = 0.6
    shift: tuple = (0.0, 0.0, 0.0)


@dataclass
class ShapeField:
    """A field that shifts or protects what is near its base, in m and the hull's axes.

    role: "move" or "protect". base: "point", "crease" (that nearest to the place), "plane" (through
    the place, square to the axis), "section" (of such a plane, nearest to the place), "line"
    (points, closed or not) or "faces" (by index). extent: how far it works; falloff: 0 to 1; shift:
    of the base; axes: of "xyz", those it has a say in. becomes: points of the curve that the base
    becomes, without any its shift says where it goes. end: a FieldEnd where it varies along the
    base; all else is at its aft or lower end then. along_surface: whether distances from the base
    are measured along the hull's surface.
    """

    name: str
    extent: float
    role: str = "move"
    on: bool = True
    colour: tuple = (0.9, 0.5, 0.1)
    base: str = "point"
    place: tuple = (0.0, 0.0, 0.0)
    axis: str = "x"
    line: list = field(default_factory=list)
    closed: bool = False
    falloff: float = 0.6
    shift: tuple = (0.0, 0.0, 0.0)
    axes: str = "xyz"
    faces: list = field(default_factory=list)
    becomes: list = field(default_factory=list)
    end: object = None
    along_surface: bool = False


@dataclass
class HullData:
    """One hull, as read.

    points: float64 (n, 3). faces: lists of point indices, each of 3 or more distinct points.
    creases: pairs (a, b), a < b, each an edge of some face. corners: point indices. face_layers:
    one index into layers per face. scheme: "biermann" or "catmull_clark". deck_edge: pairs as
    creases, the edges that are marked so; shown_rows: those of rows that are shown, with those of
    curves: ControlCurve. flats: Flat, developables: Developable, no face in two of either. locked:
    point indices that tools do not move; kept: those that they move in a plane only; ties: Tie, one
    a point; groups: PointGroup. lines: a LineChoice, None where the file does not say. targets:
    wanted.Targets; area_target: a wanted.AreaTarget, None without one. fields: ShapeField.
    appendages: Appendage. plating: a plating_data.Plating, None where nothing is said of plates.
    variants: Variant, whose hulls have no variants, targets, fields, appendages or plating of their
    own. units: the file's own unit of length, "m" or "ft". source: where the hull comes from.
    notes: what the reader had to mend, one sentence each, for the user.
    """

    name: str
    points: np.ndarray
    faces: list
    creases: list = field(default_factory=list)
    corners: list = field(default_factory=list)
    half: bool = False
    layers: list = field(default_factory=lambda: [Layer()])
    face_layers: list = field(default_factory=list)
    particulars: Particulars = field(default_factory=Particulars)
    scheme: str = "biermann"
    deck_edge: list = field(default_factory=list)
    shown_rows: list = field(default_factory=list)
    curves: list = field(default_factory=list)
    flats: list = field(default_factory=list)
    developables: list = field(default_factory=list)
    locked: list = field(default_factory=list)
    kept: Kept = field(default_factory=Kept)
    ties: list = field(default_factory=list)
    groups: list = field(default_factory=list)
    afloat: Afloat = field(default_factory=Afloat)
    load: Load = field(default_factory=Load)
    load_cases: list = field(default_factory=list)
    weights: Weights = field(default_factory=Weights)
    downflooding_points: list = field(default_factory=list)
    wind: object = None
    resistance: Resistance = field(default_factory=Resistance)
    lines: object = None
    targets: Targets = field(default_factory=Targets)
    area_target: object = None
    fields: list = field(default_factory=list)
    appendages: list = field(default_factory=list)
    plating: object = None
    variants: list = field(default_factory=list)
    units: str = "m"
    source: str = ""
    notes: list = field(default_factory=list)

    def __post_init__(self):
        self.points = real_array(self.points).reshape(-1, 3)
        if not self.face_layers:
            self.face_layers = [0] * len(self.faces)


@dataclass
class Variant:
    """A hull that was kept: a HullData with the variant's name, and what sets it apart."""

    hull: HullData
    note: str = ""


def face_edges(face):
    """The directed edges (a, b) of a face, in order; the last one closes it."""
    return zip(face, face[1:] + face[:1])


def shell_and_transom():
    """The layers of a hull that is made here: new ones each time, for they may be changed."""
    return [Layer("Shell", True, (0.55, 0.17, 0.14)), Layer("Transom", True, (0.7, 0.7, 0.68))]


def edge_key(a, b):
    """An edge's name, the same in both directions."""
    return (a, b) if a < b else (b, a)
