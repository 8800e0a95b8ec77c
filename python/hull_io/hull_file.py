# SPDX-License-Identifier: GPL-3.0-or-later
"""The project's own file of a hull: JSON, `NAME.hull.json`, metres and t/m3.

    {"format": "hull", "version": 1, "name": "...", "source": "...", "units": "m", "half": true,
     "particulars": {"length_pp": m, "beam": m, "draft": m, "depth": m, "water_density": t/m3},
     "points": [[x, y, z], ...], "faces": [[point, point, point, ...], ...],
     "creases": [[point, point], ...], "corners": [point, ...],
     "layers": [{"name": "...", "in_hydrostatics": true, "colour": [r, g, b]}, ...],
     "face_layers": [layer, ...],
     "scheme": "biermann" or "catmull_clark", "deck_edge": [[point, point], ...],
     "flats": [{"faces": [face, ...], "normal": [x, y, z], "offset": m}, ...],
     "locked" and "kept" as hull_points tells, "lines" as hull_lines tells,
     and what hull_loading tells of: "afloat", "load", "load_cases", "openings", "wind"}

format, version, units, half, points and faces are required. Without layers all faces are the shell;
without face_layers all are in the first layer. A particular that is left out is 0: not given.
Without a deck_edge it is the border; flats tells of the faces that are kept in a plane. Nothing is
mended on reading: a mistake is refused with the key and index where it stands.
"""

import json
from pathlib import Path

import numpy as np

from . import hull_flats, hull_lines, hull_loading, hull_points
from .bytes_on_disk import read_bytes, write_bytes
from .checked_json import CheckedJson, shown
from .cleanup import creases_of_faces
from .hull_data import HullData, Layer, Particulars, edge_key, face_edges
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, MAX_COUNT, MAX_HULL_FILE_BYTES

REQUIRED = ("format", "version", "units", "half", "points", "faces")
OPTIONAL = (
    "name",
    "source",
    "particulars",
    "creases",
    "corners",
    "layers",
    "face_layers",
    "scheme",
    "deck_edge",
    hull_flats.KEY,
    *hull_points.KEYS,
    hull_lines.KEY,
    *hull_loading.KEYS,
)
PARTICULARS = tuple(vars(Particulars()))
SCHEMES = ("biermann", "catmull_clark")


def read_hull_file(path):
    """The HullData of a hull file; raises HullFileError."""
    path = Path(path)
    return parse_hull_file(read_bytes(path, MAX_HULL_FILE_BYTES), path.name)


def parse_hull_file(data, file_name):
    """The HullData in the bytes of a hull file; raises HullFileError naming key and index."""
    check = CheckedJson(file_name)
    content = check.parse(data)
    _check_header(check, content)
    points = _points(check, content["points"])
    faces = _faces(check, content["faces"], len(points))
    layers = _layers(check, content.get("layers", [{}]))
    return HullData(
        name=check.text(content.get("name", ""), "name") or file_name.split(".")[0],
        points=points,
        faces=faces,
        creases=_edges(check, content, "creases", faces, len(points)),
        corners=_corners(check, content.get("corners", []), len(points)),
        half=check.flag(content["half"], "half"),
        layers=layers,
        face_layers=_face_layers(check, content.get("face_layers"), len(faces), len(layers)),
        particulars=_particulars(check, content.get("particulars", {})),
        scheme=_scheme(check, content.get("scheme", SCHEMES[0])),
        deck_edge=_edges(check, content, "deck_edge", faces, len(points)),
        flats=hull_flats.parsed(check, content, len(faces)),
        **hull_points.parsed(check, content, len(points)),
        lines=hull_lines.parsed(check, content),
        **hull_loading.parsed(check, content),
        units="m",
        source=check.text(content.get("source", ""), "source"),
    )


def _check_header(check, content):
    if content.get("format") != "hull":
        raise check.error("format", 'it is not "hull"', "choose a hull file")
    version = content.get("version")
    if version != 1 or isinstance(version, bool):
        raise check.error("version", f"{shown(version)} is unknown", "only version 1 can be read")
    check.object(content, "the file", REQUIRED + OPTIONAL)
    for key in REQUIRED:
        if key not in content:
            raise check.error(key, "it is missing", "add it; see a sample for the form")
    if content["units"] != "m":
        raise check.error(
            "units", f'{shown(content["units"])} is not "m"', "write all lengths in metres"
        )


def _check_length(check, value, key):
    if not 0 < len(value) <= MAX_COUNT:
        raise check.error(key, f"it has {len(value)} entries", f"a hull has 1 to {MAX_COUNT} {key}")


def _points(check, value):
    points = check.list(value, "points")
    _check_length(check, points, "points")
    for index, point in enumerate(points):
        for axis, number in zip("xyz", check.list(point, f"points[{index}]", 3)):
            check.number(number, f"points[{index}].{axis}", -FURTHEST_POINT, FURTHEST_POINT)
    return np.array(points, dtype=np.float64)


def _faces(check, value, point_count):
    faces = check.list(value, "faces")
    _check_length(check, faces, "faces")
    seen = {}
    for index, face in enumerate(faces):
        where = f"faces[{index}]"
        _check_point_indices(check, check.list(face, where), where, point_count)
        distinct = frozenset(face)
        if len(face) < 3 or len(distinct) < len(face):
            raise check.error(
                where,
                f"{len(face)} points, {len(distinct)} of them different, make no face",
                "a face needs 3 or more points, each once",
            )
        earlier = seen.setdefault(distinct, index)
        if earlier != index:
            raise check.error(where, f"it has the points of faces[{earlier}]", "take one out")
    return faces


def _check_point_indices(check, indices, where, point_count):
    for place, point in enumerate(indices):
        check.index(point, f"{where}[{place}]", point_count, "point")


def _edges(check, content, key, faces, point_count):
    """Pairs of points under a key, each an edge of a face."""
    known = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
    edges = check.list(content.get(key, []), key)
    for index, edge in enumerate(edges):
        where = f"{key}[{index}]"
        _check_point_indices(check, check.list(edge, where, 2), where, point_count)
        if edge_key(*edge) not in known:
            raise check.error(where, f"{edge} is no edge of a face", "take it out")
    return creases_of_faces(edges, faces)


def _scheme(check, value):
    if value not in SCHEMES:
        raise check.error(
            "scheme", f"{shown(value)} is unknown", f'write "{SCHEMES[0]}" or "{SCHEMES[1]}"'
        )
    return value


def _corners(check, value, point_count):
    corners = check.list(value, "corners")
    _check_point_indices(check, corners, "corners", point_count)
    return sorted(set(corners))


def _layers(check, value):
    entries = check.list(value, "layers")
    _check_length(check, entries, "layers")
    return [_layer(check, entry, index) for index, entry in enumerate(entries)]


def _layer(check, entry, index):
    where = f"layers[{index}]"
    check.object(entry, where, ("name", "in_hydrostatics", "colour"))
    layer = Layer(
        name=check.text(entry.get("name", f"Layer {index}"), f"{where}.name"),
        in_hydrostatics=check.flag(entry.get("in_hydrostatics", True), f"{where}.in_hydrostatics"),
    )
    if "colour" in entry:
        colour = check.list(entry["colour"], f"{where}.colour", 3)
        layer.colour = tuple(check.number(part, f"{where}.colour", 0.0, 1.0) for part in colour)
    return layer


def _face_layers(check, value, face_count, layer_count):
    if value is None:
        return [0] * face_count
    face_layers = check.list(value, "face_layers", face_count)
    for index, layer in enumerate(face_layers):
        check.index(layer, f"face_layers[{index}]", layer_count, "layer")
    return face_layers


def _particulars(check, value):
    entries = check.object(value, "particulars", PARTICULARS)
    return Particulars(
        **{
            key: check.number(number, f"particulars.{key}", 0.0, LONGEST_DIMENSION)
            for key, number in entries.items()
        }
    )


def write_hull_file(data, path):
    """Write a HullData as a hull file, whole or not at all; reading it gives an equal HullData.

    Coordinates keep every digit. `units` and `notes` are not kept: they belong to the file that the
    hull was imported from. What could not be read again is not written. Raises HullFileError.
    """
    path = Path(path)
    lines = [
        '"format": "hull"',
        '"version": 1',
        f'"name": {json.dumps(data.name)}',
        f'"source": {json.dumps(data.source)}',
        '"units": "m"',
        f'"half": {json.dumps(bool(data.half))}',
        f'"particulars": {json.dumps(_particulars_entry(data.particulars))}',
        _rows("points", data.points.tolist()),
        _rows("faces", [[int(point) for point in face] for face in data.faces]),
        _rows("creases", [[int(a), int(b)] for a, b in data.creases]),
        f'"corners": {json.dumps([int(point) for point in data.corners])}',
        _rows("layers", [_layer_entry(layer) for layer in data.layers]),
        f'"face_layers": {json.dumps([int(layer) for layer in data.face_layers])}',
        f'"scheme": {json.dumps(data.scheme)}',
        _rows("deck_edge", [[int(a), int(b)] for a, b in data.deck_edge]),
        *(_entry(key, value) for key, value in hull_flats.entries(data).items()),
        *(_entry(key, value) for key, value in hull_points.entries(data).items()),
        *(_entry(key, value) for key, value in hull_lines.entries(data).items()),
        *(_entry(key, value) for key, value in hull_loading.entries(data).items()),
    ]
    content = ("{\n" + ",\n".join(lines) + "\n}\n").encode("utf-8")
    parse_hull_file(content, path.name)
    write_bytes(path, content)


def _particulars_entry(particulars):
    return {key: float(getattr(particulars, key)) for key in PARTICULARS}


def _layer_entry(layer):
    return {
        "name": layer.name,
        "in_hydrostatics": bool(layer.in_hydrostatics),
        "colour": [float(part) for part in layer.colour],
    }


def _entry(key, value):
    return _rows(key, value) if isinstance(value, list) else f'"{key}": {json.dumps(value)}'


def _rows(key, values):
    """A list with one entry a line, so that a difference between two files can be read."""
    return f'"{key}": [\n' + ",\n".join(json.dumps(value) for value in values) + "\n]"
