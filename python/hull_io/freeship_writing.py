# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing FREE!ship files (`.fbm`), which read back as the same hull in single precision.

They are of version 2.01: each FREE!ship since, and what descends from it, reads that, and no later
one has more of a control mesh.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

from .bytes_on_disk import write_bytes
from .cleanup import creases_of_faces
from .errors import HullFileError
from .freeship import SIGNATURE, VERSIONS
from .freeship_bytes import FreeshipBytes
from .freeship_curves import control_curves
from .freeship_lines import line_positions
from .freeship_losses import losses
from .freeship_plating import plating
from .freeship_points import border_edges, point_kinds
from .freeship_units import FOOT, POUND_PER_CUBIC_FOOT, plating_units
from .hull_data import edge_key, face_edges
from .limits import FURTHEST_POINT, MAX_COUNT, SEA_WATER_DENSITY
from .real_points import real_points
from .shell import shell_face_indices
from .subdivision import subdivided

VERSION = 201
# FREE!ship shows the mesh subdivided once more often than this number.
PRECISION = 3
# What FREE!ship sets for a new model: a grey background, its appendage coefficient, the middle.
_BACKGROUND, _APPENDAGES, _SPLIT = 0xC0C0C0, 1.0, 0.5


def write_freeship(data, path, unit="m"):
    """Write a HullData as a FREE!ship file, whole or not at all; returns sentences about what that
    file does not hold of the hull, or FREE!ship takes otherwise.

    unit: "m" or "ft", in which FREE!ship will show the model; others raise ValueError.
    HullFileError where the hull is none that FREE!ship can have.
    """
    path = Path(path)
    content, remarks = freeship_content(data, unit, path.name)
    write_bytes(path, content)
    return remarks


def freeship_content(data, unit="m", file_name="hull.fbm"):
    """The bytes of the file, and the sentences, as write_freeship tells."""
    if unit not in ("m", "ft"):
        raise ValueError(f'The unit "{unit}" is unknown to FREE!ship: choose "m" or "ft"')
    data = replace(data, points=real_points(data.points))
    _check(data, file_name)
    scale = 1.0 if unit == "m" else FOOT
    in_unit = replace(data, points=data.points / scale)
    sink = FreeshipBytes()
    sink.text(SIGNATURE.decode())
    sink.record("B", VERSIONS.index(VERSION))
    _view(sink)
    lowest = _lowest(in_unit)
    _project(sink, in_unit, scale, lowest)
    _layers(sink, data, plating_units(unit == "ft"))
    _mesh(sink, in_unit)
    for axis, positions in line_positions(data).items():
        _sections(sink, axis, positions / scale)
    sink.record("i", 0)  # markers
    return sink.content(), losses(in_unit, scale, lowest * scale, sink.replaced)


def _check(data, file_name):
    where = f"{file_name}: "
    if not data.faces:
        raise HullFileError(f"{where}the hull has no faces; make some first.")
    if max(len(data.points), len(data.faces)) > MAX_COUNT:
        raise HullFileError(
            f"{where}the hull has more than {MAX_COUNT} points or faces; FREE!ship is for control "
            "meshes, so write those of the hull before it was subdivided."
        )
    if not (np.abs(data.points) <= FURTHEST_POINT * FOOT).all():
        raise HullFileError(
            f"{where}a point lies further than {FURTHEST_POINT * FOOT:.0f} m from the origin, or "
            "nowhere; move it to the hull."
        )


def _view(sink):
    """Precision and what is shown: both sides no, net, edges, points and all kinds of lines yes."""
    sink.record("i", PRECISION)
    sink.record("i" + "?" * 10 + "f", 0, *[True] * 5, *[False] * 2, *[True] * 3, 1.0)
    sink.record("?", False)


def _lowest(data):
    """The lowest point of the shell as FREE!ship subdivides it, which its draft is from."""
    shell = [data.faces[index] for index in shell_face_indices(data)] or data.faces
    single = data.points.astype(np.float32).astype(np.float64)
    corners = [point for point, kind in enumerate(point_kinds(data)) if kind == 3]
    edges = creases_of_faces(data.creases, shell)
    found = subdivided(single, shell, edges, corners, PRECISION + 1)
    return float(found[:, 2].min())


def _project(sink, data, scale, lowest):
    given = data.particulars
    draft = given.draft / scale - lowest if given.draft else 0.0
    is_set = min(given.length_pp, given.beam, draft) > 0.0
    density = given.water_density or SEA_WATER_DENSITY
    sink.text(data.name)
    sink.text("")  # designer
    sink.record("fff?", given.length_pp / scale, given.beam / scale, max(draft, 0.0), is_set)
    sink.record("ff", density if scale == 1.0 else density / POUND_PER_CUBIC_FOOT, _APPENDAGES)
    sink.record("?ii?f?", False, _BACKGROUND, 0 if scale == 1.0 else 1, False, _SPLIT, False)
    sink.text(data.source)  # comment
    sink.text("Hull Tools")


def _layers(sink, data, units):
    """units: m of a unit of thickness, t/m3 of one of density."""
    metre, density_unit = units
    sink.record("i", len(data.layers))
    for index, layer in enumerate(data.layers):
        red, green, blue = (round(255 * min(max(part, 0.0), 1.0)) for part in layer.colour)
        sink.text(layer.name)
        sink.record("ii", index + 1, red | green << 8 | blue << 16)
        # Visible, symmetric, developable; for intersections, in hydrostatics.
        sink.record("???", True, data.half, False)
        sink.record("??", layer.in_hydrostatics, layer.in_hydrostatics)
        thickness, density = plating(layer, data)
        sink.record("ff", density / density_unit, thickness / metre)
        sink.record("?", layer.in_hydrostatics)  # in the lines plan
    sink.record("i", 0)


def _mesh(sink, data):
    locked = set(data.locked)
    sink.record("i", len(data.points))
    for index, (point, kind) in enumerate(zip(data.points.tolist(), point_kinds(data))):
        sink.record("fffi??", *point, kind, False, index in locked)
    creased = {edge_key(*edge) for edge in data.creases} | border_edges(data.faces)
    edges = sorted({edge_key(a, b) for face in data.faces for a, b in face_edges(face)})
    sink.record("i", len(edges))
    for edge in edges:
        sink.record("ii??", *edge, edge in creased, False)
    curves = control_curves(data)
    sink.record("i", len(curves))
    for curve in curves:
        sink.record("i" * (1 + len(curve)) + "?", len(curve), *curve, False)
    sink.record("i", len(data.faces))
    for face, layer in zip(data.faces, data.face_layers):
        sink.record("i" * (1 + len(face)) + "i?", len(face), *face, layer, False)


def _sections(sink, axis, positions):
    """One family: planes across an axis (0 to 2), which FREE!ship cuts the hull by when it opens
    the file; 3 for diagonals."""
    sink.record("i", len(positions))
    for position in positions:
        normal = [float(axis == k) for k in range(3)]
        sink.record("i?ffff?i", axis + 1, False, *normal, -position, False, 0)
