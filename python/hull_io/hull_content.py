# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a hull file that is one hull, the file's own or a variant: parsed and written."""

import numpy as np

from . import (
    hull_curves,
    hull_developables,
    hull_flats,
    hull_lines,
    hull_loading,
    hull_points,
    hull_resistance,
    hull_ties,
    hull_weights,
)
from .checked_json import shown
from .cleanup import creases_of_faces
from .hull_data import HullData, Layer, Particulars, edge_key, face_edges
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, MAX_COUNT
from .real_points import real_points

REQUIRED = ("half", "points", "faces")
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
    "shown_rows",
    hull_curves.KEY,
    hull_flats.KEY,
    hull_developables.KEY,
    *hull_points.KEYS,
    *hull_ties.KEYS,
    hull_lines.KEY,
    *hull_loading.KEYS,
    hull_weights.KEY,
    hull_resistance.KEY,
)
PARTICULARS = tuple(vars(Particulars()))
SCHEMES = ("biermann", "catmull_clark")


def parsed(check, content, name):
    """The HullData of an object with these keys; name: where it has none. Raises HullFileError."""
    for key in REQUIRED:
        if key not in content:
            raise check.error(key, "it is missing", "add it; see a sample for the form")
    points = _points(check, content["points"])
    faces = _faces(check, content["faces"], len(points))
    layers = _layers(check, content.get("layers", [{}]))
    return HullData(
        name=check.text(content.get("name", ""), "name") or name,
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
        shown_rows=_edges(check, content, "shown_rows", faces, len(points)),
        curves=hull_curves.parsed(check, content, faces, len(points)),
        flats=hull_flats.parsed(check, content, len(faces)),
        developables=hull_developables.parsed(check, content, len(faces)),
        **hull_points.parsed(check, content, len(points)),
        **hull_ties.parsed(check, content, len(points)),
        lines=hull_lines.parsed(check, content),
        **hull_loading.parsed(check, content),
        weights=hull_weights.parsed(check, content),
        resistance=hull_resistance.parsed(check, content),
        units="m",
        source=check.text(content.get("source", ""), "source"),
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
    check.object(entry, where, ("name", "in_hydrostatics", "colour", "thickness", "density"))
    layer = Layer(
        name=check.text(entry.get("name", f"Layer {index}"), f"{where}.name"),
        in_hydrostatics=check.flag(entry.get("in_hydrostatics", True), f"{where}.in_hydrostatics"),
        thickness=hull_weights.thickness(check, entry, where),
        density=hull_weights.density(check, entry, where),
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


def entries(data):
    """What a hull file says of a HullData, by its keys, in their order."""
    return {
        "name": data.name,
        "source": data.source,
        "half": bool(data.half),
        "particulars": {key: float(getattr(data.particulars, key)) for key in PARTICULARS},
        "points": real_points(data.points).tolist(),
        "faces": [[int(point) for point in face] for face in data.faces],
        "creases": [[int(a), int(b)] for a, b in data.creases],
        "corners": [int(point) for point in data.corners],
        "layers": [_layer_entry(layer) for layer in data.layers],
        "face_layers": [int(layer) for layer in data.face_layers],
        "scheme": data.scheme,
        "deck_edge": [[int(a), int(b)] for a, b in data.deck_edge],
        **_rows_entry(data),
        **hull_curves.entries(data),
        **hull_flats.entries(data),
        **hull_developables.entries(data),
        **hull_points.entries(data),
        **hull_ties.entries(data),
        **hull_lines.entries(data),
        **hull_loading.entries(data),
        **hull_weights.entries(data),
        **hull_resistance.entries(data),
    }


def _rows_entry(data):
    return {"shown_rows": [[int(a), int(b)] for a, b in data.shown_rows]} if data.shown_rows else {}


def _layer_entry(layer):
    plating = {"thickness": float(layer.thickness), "density": float(layer.density)}
    return {
        "name": layer.name,
        "in_hydrostatics": bool(layer.in_hydrostatics),
        "colour": [float(part) for part in layer.colour],
        **{name: value for name, value in plating.items() if value},
    }
