# SPDX-License-Identifier: GPL-3.0-or-later
"""The most and the least that settings may ask for, and why. They are held where a value is used:
files, drivers and scripts set what a panel would not take."""

from math import pi

from ...hull_io import limits as of_files

# m; the longest ship has half a kilometre.
LONGEST = of_files.LONGEST_DIMENSION
HEAVIEST = of_files.HEAVIEST_LOAD  # t
THICKEST = of_files.THICKEST  # m, of plating
DENSEST = of_files.DENSEST  # t/m³
LARGEST_WIND_AREA = of_files.LARGEST_WIND_AREA  # m²
STRONGEST_WIND = of_files.STRONGEST_WIND  # Pa
LONGEST_ROLL_PERIOD = of_files.LONGEST_ROLL_PERIOD  # s
DENSITIES = (0.5, 2.0)  # t/m³, of what floats a ship
_ROUNDING = 1e-6  # rad: Blender keeps angles in single precision
GREATEST_HEEL = pi + _ROUNDING
FASTEST = 100.0  # kn

# Faces of a surface object, both sides. Blender takes 10 µs and 1.4 kB for each, most of it for the
# normals of its corners, while the window waits.
MOST_SHOWN_FACES = 200_000
# A control mesh is refused of which each change would take longer: its surface has one of these
# faces at least for each corner of a face, and a cell beside an irregular point takes as long as
# some more of them to be made and integrated.
FACES_FOR_IRREGULAR_CELL = 3
# While the hull may be another one at each step of the mouse: each face takes Blender 0.12 µs of
# every step, and their exact normals half a second at a pause.
MOST_MOVING_FACES = 50_000
MOST_SAMPLES = 32
# Of a model that is written: half a gigabyte while it is made.
MOST_MODEL_TRIANGLES = 4_000_000
# Plates that one file has; frames drawn on them.
MOST_PLATES = 600
# Faces of a control mesh that was subdivided, which takes Blender 0.1 ms for each.
MOST_CONTROL_FACES = 16_000

MOST_STATION_SPACES = of_files.MAX_LINE_SPACES
# Of one kind; a lines plan of so many takes a second to find that they run together.
MOST_LINES = 400
# Teeth of a comb closer than this part of the hull are not told apart.
LEAST_TOOTH_DISTANCE = 1.0 / 2000.0
# Finer ones of light lines are not told apart; rad.
LEAST_LIGHT_ANGLE = 0.25 * pi / 180.0 - _ROUNDING
GREATEST_LIGHT_ANGLE = 0.25 * pi + _ROUNDING
DIVISIONS = (2, 32)  # of a cell's side, where light lines are searched

# Rows of a table of hydrostatics; each takes about a millisecond.
MOST_TABLE_ROWS = 1000
DISPLACEMENTS = (2, 50)  # of cross curves
MOST_LOADING_ENTRIES = of_files.MAX_LOADING_ENTRIES
# Kept of one hull, each with a mesh of its own.
MOST_VARIANTS = of_files.MAX_VARIANTS

# Of one hull.
MOST_FIELDS = of_files.MAX_FIELDS
# Control points that follow fields: a sample subdivided exactly twice has up to 2,200; for more, a
# preview takes several seconds to begin.
MOST_FIELD_POINTS = 2500
# That a base curve is shown with; each takes a millisecond of a hull of 400 points whenever the
# curve changes.
MOST_CURVE_POINTS = 1000
FIT_POINTS = (100, 1_000_000)  # each takes a kilobyte
MOST_FIT_LINE_POINTS = 10_000_000  # along edges and curves; each takes a hundred bytes
MOST_TARGETS = of_files.MAX_TARGETS
GREATEST_TARGET = of_files.GREATEST_TARGET
GREATEST_TARGET_STIFFNESS = of_files.GREATEST_TARGET_STIFFNESS
GREATEST_DIMENSION_CHANGE = of_files.GREATEST_DIMENSION_CHANGE
MORPH_WEIGHTS = (-1.0, 2.0)  # of a parent: beyond, nothing of it is left to be told
MORPH_TOLERANCES = (0.001, 10.0)  # per mille of the length
MOST_MORPH_SUBDIVISIONS = 2
MOST_PARENTS = 16
MOST_SERIES_STEPS = 200
# Of one network; each takes a millisecond whenever one of them moves.
MOST_NETWORK_CURVES = 400
NETWORK_HULL_POINTS = (20, 1000)  # of a hull that is laid over one
# Of a sectional area curve that is wanted: handles, and stations that are brought to it.
MOST_AREA_HANDLES, MOST_AREA_STATIONS = 60, 60
AREA_TOLERANCES = (0.001, 20.0)  # percent of the largest section
GREATEST_FAIRNESS, GREATEST_STIFFNESS = 0.1 + _ROUNDING, 10.0


def within(value, name, least, most):
    """The value; ValueError where it is not between two others, or no number."""
    if not least <= value <= most:
        raise ValueError(f"{name} is {value:g}: it must be from {least:g} to {most:g}")
    return value


def at_most(count, name, most):
    """ValueError where there are more than so many."""
    if count > most:
        raise ValueError(f"{count} {name} are more than {most}: take fewer")


def samples(wanted, cells, sides, most_faces=MOST_SHOWN_FACES):
    """How many faces each side of a cell gets in a surface object that shows so many sides: what is
    wanted, where the whole has no more than so many faces then."""
    room = most_faces / max(cells * sides, 1)
    return int(max(min(wanted, MOST_SAMPLES, room**0.5), 1))
