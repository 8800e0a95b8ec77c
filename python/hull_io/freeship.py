# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading FREE!ship files, binary (`.fbm`) and text (`.ftm`), versions 1.00 to 5.00.

Both encodings hold the same values in the same order, so there is one reader over two cursors. What
follows the faces is not needed for a hull and not read, except by `stored_sections`.
"""

import re
from dataclasses import dataclass

import numpy as np

from .cursors import BinaryCursor, TextCursor
from .errors import HullFileError
from .freeship_meaning import hull_from_model
from .freeship_model import Model, StoredLayer
from .freeship_units import FOOT
from .limits import FURTHEST_POINT, MAX_CURVE_POINTS, MAX_FACE_CORNERS

SIGNATURE = b"FREE!ship"
BINARY_START = len(SIGNATURE).to_bytes(4, "little") + SIGNATURE
VERSIONS = (
    *(100, 110, 120, 130, 140, 150, 160, 165, 170, 180, 190, 191, 195, 198, 200, 201, 210, 220),
    *(230, 240, 250, 260, 270, 280, 290, 295, 296, 297, 298, 300, 302, 303, 305, 309, 310, 313),
    *(314, 317, 327, 332, 335, 421, 430, 462, 500),
)
FINEST_PRECISION = 3
NEW_COPY = "open it in FREE!ship, mend this, and save it again"


@dataclass
class StoredSection:
    """A plane section that FREE!ship stored with the model, in metres.

    kind: "free", "station", "buttock", "waterline" or "diagonal". plane: (a, b, c, d), the points
    with a x + b y + c z + d = 0. curves: one (points float64 (m, 3), knuckles bool (m,)) per
    spline; none when FREE!ship had not computed the section.
    """

    kind: str
    plane: tuple
    curves: list


def is_freeship(data):
    """Whether bytes begin as a FREE!ship file of either encoding does."""
    return data.startswith(BINARY_START) or _text_start(data)


def _text_start(data):
    return data[:64].split(b"\n", 1)[0].strip() == SIGNATURE


def read_freeship(data, file_name):
    """A HullData from the bytes of a FREE!ship file; HullFileError when that can't be."""
    cursor, version = _open(data, file_name)
    return hull_from_model(_read_model(cursor, version), f"FREE!ship {version / 100:.2f}")


def read_stored_sections(data, file_name):
    """The stations, buttocks, waterlines and diagonals stored in a FREE!ship file, as a list."""
    cursor, version = _open(data, file_name)
    model = _read_model(cursor, version)
    scale = FOOT if model.imperial else 1.0
    families = ["stations", "buttocks", "waterlines"] + ["diagonals"] * (version >= 180)
    return [section for family in families for section in _sections(cursor, version, family, scale)]


def _open(data, file_name):
    """A cursor past the signature and the version, and the version."""
    if data.startswith(BINARY_START):
        cursor = BinaryCursor(data, file_name)
        cursor.text()
        cursor.element = "the version"
        (index,) = cursor.record("B")
        if index >= len(VERSIONS):
            raise cursor.error(
                f"version number {index} is unknown", "save it as version 5 or older"
            )
        return cursor, VERSIONS[index]
    if not _text_start(data):
        raise HullFileError(
            f"{file_name}: it does not begin with '{SIGNATURE.decode()}', so it is no FREE!ship "
            "file; choose an .fbm or .ftm file that FREE!ship saved."
        )
    cursor = TextCursor(data, file_name)
    cursor.text()
    cursor.element = "the version"
    words = cursor.text().strip()
    number = re.fullmatch(r"(\d{1,3})(?:[.,](\d{1,2}))?\D*", words)
    version = int(number[1]) * 100 + int((number[2] or "0").ljust(2, "0")) if number else 0
    if not VERSIONS[0] <= version <= VERSIONS[-1]:
        raise cursor.error(f"version '{words[:20]}' is unknown", "save it as version 5 or older")
    return cursor, version


def _read_model(cursor, version):
    levels = _levels(cursor, version)
    settings = _project(cursor, version)
    layers = _layers(cursor, version)
    points, corners, locked = _points(cursor, version)
    edges = _edges(cursor, len(points))
    curves = _control_curves(cursor, len(points)) if version >= 195 else []
    faces, face_layers = _faces(cursor, len(points), len(layers))
    return Model(
        **settings,
        levels=levels,
        layers=layers,
        points=points,
        corners=corners,
        locked=locked,
        edges=edges,
        curves=curves,
        faces=faces,
        face_layers=face_layers,
    )


def _levels(cursor, version):
    """How often the mesh is subdivided, from the precision that the view settings begin with."""
    cursor.element = "the view settings"
    precision, *_ = cursor.record("i" + "i" + "?" * 10 + "f")
    for since, layout in ((195, "?"), (210, "f"), (220, "??????"), (250, "?")):
        if version >= since:
            cursor.record(layout)
    return 1 + min(max(precision, 0), FINEST_PRECISION)


def _project(cursor, version):
    cursor.element = "the project settings"
    name = cursor.text()
    cursor.text()
    length, beam, draft, dimensions_set, density, *_, units, _, _, _ = cursor.record("fff?ff?ii?f?")
    if units not in (0, 1):
        raise cursor.error(f"the unit of length is number {units}, neither metres nor feet")
    cursor.text()
    cursor.text()
    if version >= 210:
        _, preview = cursor.record("i?")
        if preview:
            cursor.skip_image()
    if version >= 230:
        cursor.record("?")
    if version >= 250:
        _skip_hydrostatics_settings(cursor)
    for since, layout in ((317, "?"), (332, "?"), (500, "i")):
        if version >= since:
            cursor.record(layout)
    return {
        "name": name.strip(),
        "length": length,
        "beam": beam,
        "draft": draft,
        "dimensions_set": dimensions_set,
        "water_density": density,
        "imperial": units == 1,
    }


def _skip_hydrostatics_settings(cursor):
    cursor.record("ffff")
    cursor.record("f" * cursor.count("displacements", "f"))
    cursor.record("fff?")
    cursor.record("f" * cursor.count("angles", "f"))
    cursor.record("f" * cursor.count("stability drafts", "f"))
    cursor.record("?f")


def _layers(cursor, version):
    layout = "ii???"
    layout += "??" if version >= 180 else ""
    layout += "ff" if version >= 191 else ""
    layout += "?" if version >= 201 else ""
    layout += "i" if version >= 260 else ""
    layers = []
    for index in range(cursor.count("layers", layout)):
        cursor.element = f"layer {index}"
        name = cursor.text()
        _, colour, _, symmetric, developable, *rest = cursor.record(layout)
        in_hydrostatics = rest[1] if version >= 180 else True
        plating = rest[2:4] if version >= 191 else (0.0, 0.0)
        layers.append(
            StoredLayer(name.strip(), colour, symmetric, in_hydrostatics, developable, *plating)
        )
    cursor.element = "the active layer"
    cursor.record("i")
    return layers


def _points(cursor, version):
    tags = "i?" + ("?" if version >= 198 else "")
    count = cursor.count("points", "fff" + tags)
    if count == 0:
        raise cursor.error("the model has no points", NEW_COPY)
    points = np.empty((count, 3))
    corners, locked = [], []
    for index in range(count):
        cursor.element = f"point {index}"
        x, y, z = cursor.record("fff")
        if not all(abs(value) <= FURTHEST_POINT for value in (x, y, z)):
            raise cursor.error(f"its position ({x:g}, {y:g}, {z:g}) can't be a ship's", NEW_COPY)
        points[index] = x, y, z
        kind, _, *is_locked = cursor.record(tags)
        if kind == 3:
            corners.append(index)
        if any(is_locked):
            locked.append(index)
    return points, corners, locked


def _edges(cursor, point_count):
    edges = []
    for index in range(cursor.count("edges", "ii??")):
        cursor.element = f"edge {index}"
        start, end, crease, _ = cursor.record("ii??")
        edge = (0 if start == -1 else start, 0 if end == -1 else end, crease)
        _check_points(cursor, edge[:2], point_count)
        edges.append(edge)
    return edges


def _check_points(cursor, indices, point_count):
    for point in indices:
        if not 0 <= point < point_count:
            raise cursor.error(f"it uses point {point}, but the points are 0 to {point_count - 1}")


def _control_curves(cursor, point_count):
    curves, points_left = [], MAX_CURVE_POINTS
    for index in range(cursor.count("control curves", "i?")):
        size = cursor.count(f"points of control curve {index}", "i", points_left)
        points_left -= size
        cursor.element = f"control curve {index}"
        *curve, _ = cursor.record("i" * size + "?")
        _check_points(cursor, curve, point_count)
        curves.append(curve)
    return curves


def _faces(cursor, point_count, layer_count):
    count = cursor.count("faces", "ii?")
    if count == 0:
        raise cursor.error("the model has no faces", NEW_COPY)
    faces, face_layers = [], []
    corners_left = MAX_FACE_CORNERS
    for index in range(count):
        size = cursor.count(f"points of face {index}", "i", corners_left)
        corners_left -= size
        cursor.element = f"face {index}"
        *face, layer, _ = cursor.record("i" * size + "i?")
        _check_points(cursor, face, point_count)
        if not 0 <= layer < layer_count:
            raise cursor.error(f"it is in layer {layer}, but there are {layer_count} layers")
        faces.append(face)
        face_layers.append(layer)
    return faces, face_layers


SECTION_KINDS = ("free", "station", "buttock", "waterline", "diagonal")


def _sections(cursor, version, family, scale):
    head = "i" + ("?" if version >= 191 else "") + "ffff" + "?"
    sections = []
    for index in range(cursor.count(family, head + "i")):
        cursor.element = f"section {index} of the {family}"
        kind, *_, a, b, c, d, _ = cursor.record(head)
        if not 0 <= kind < len(SECTION_KINDS):
            raise cursor.error(f"a section of kind {kind} is unknown")
        fixed_axis = kind - 1 if 1 <= kind <= 3 and version >= 160 else None
        curves = [
            _spline(cursor, fixed_axis, d, scale)
            for _ in range(cursor.count(f"curves of section {index} of the {family}", "i"))
        ]
        sections.append(StoredSection(SECTION_KINDS[kind], (a, b, c, d * scale), curves))
    return sections


def _spline(cursor, fixed_axis, d, scale):
    """One stored curve; `fixed_axis` is the axis whose coordinate is left out, being -d."""
    layout = "fff?" if fixed_axis is None else "ff?"
    rows = [cursor.record(layout) for _ in range(cursor.count("points of a curve", layout))]
    points = np.array([row[:-1] for row in rows], dtype=np.float64)
    points = points.reshape(len(rows), len(layout) - 1)
    if not np.isfinite(points).all():
        raise cursor.error("a point of a curve is not a finite number")
    if fixed_axis is not None:
        points = np.insert(points, fixed_axis, -d, axis=1)
    return points * scale, np.array([row[-1] for row in rows], dtype=bool)
