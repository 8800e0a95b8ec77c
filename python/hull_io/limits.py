# SPDX-License-Identifier: GPL-3.0-or-later
"""What no honest hull file exceeds: held against every file before memory is spent on it; and what
is meant where none says it."""

MAX_FILE_BYTES = 64 * 2**20
# A JSON text takes up to 40 times its size in memory.
MAX_HULL_FILE_BYTES = 8 * 2**20
# Points, faces, edges, layers and so on: a control mesh has some hundreds.
MAX_COUNT = 250_000
# All corners of all faces together.
MAX_FACE_CORNERS = 1_500_000
# All points of all control curves together.
MAX_CURVE_POINTS = 1_000_000
# In the file's unit of length, along any axis.
FURTHEST_POINT = 1e6
# Length, beam, draft and depth in metres.
LONGEST_DIMENSION = 1e4
LONGEST_TEXT = 10_000
# In tonnes.
HEAVIEST_LOAD = 1e8
# Wind on a ship: m2 of wind and keel areas, pascals (a hurricane has some 3,000), seconds.
LARGEST_WIND_AREA = 1e6
STRONGEST_WIND = 1e5
LONGEST_ROLL_PERIOD = 1e3
FASTEST_KN = 1000.0
# Plating: m and t/m3 (uranium has 19).
THICKEST = 10.0
DENSEST = 25.0
# Load cases, openings, wind areas, each of which takes some milliseconds; a booklet has dozens.
MAX_LOADING_ENTRIES = 200
# Planes to cut a hull by, and spaces between stations.
MAX_CUT_PLANES = 1000
MAX_LINE_SPACES = 200
MAX_LISTED = 1000  # positions in a list, a range or by a spacing: more are a slip of the keyboard
# Of a hull: numbers that are wanted of it (a sectional area curve takes 21), their size in their
# own unit, what bending costs, how far dimensions may go, in percent; hulls kept beside it.
MAX_TARGETS = 60
# Shape fields, and points of a line that one is based on.
MAX_FIELDS = 32
MAX_LINE_POINTS = 10_000
GREATEST_TARGET = 1e9
GREATEST_TARGET_STIFFNESS = 10.0
GREATEST_DIMENSION_CHANGE = 50.0
MAX_VARIANTS = 200
# Triangles of a shape to fit to: 50 bytes each; a text takes twenty times its size in memory.
MAX_STL_BYTES = 256 * 2**20
MAX_STL_TEXT_BYTES = 64 * 2**20
# Of a sectional area curve; the curve of a hull that is shown has a hundred stations.
MAX_AREA_TABLE_BYTES = 2**20
MAX_AREA_TABLE_ROWS = 500
# m2; the largest ships have some two thousand.
LARGEST_SECTION = 1e5
# Of geometry that is to become a hull: tables and lists of points as text, values of a table,
# points and triangles of all curves and meshes, curves.
MAX_TABLE_BYTES = 64 * 2**20
MAX_OFFSETS = 200_000
MAX_GEOMETRY_POINTS = 5_000_000
MAX_GEOMETRY_CURVES = 100_000
MAX_GEOMETRY_BYTES = 256 * 2**20
# Of the process that reads STEP and IGES: address space, of which libraries take the half of the
# first, and seconds of computing.
CAD_MEMORY_BYTES = 10**9
CAD_MEMORY_PER_BYTE = 60
CAD_SECONDS = 4
CAD_SECONDS_PER_MB = 3.0

# t/m3, where nobody gives another: hull_native.SEA_WATER_DENSITY, which files are written without.
SEA_WATER_DENSITY = 1.025
# m/s2, the standard one: hull_native.GRAVITY.
GRAVITY = 9.80665
