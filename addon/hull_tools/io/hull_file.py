# SPDX-License-Identifier: GPL-3.0-or-later
"""The project's own file of a hull: JSON, `NAME.hull.json`, metres and t/m3.

    {"format": "hull", "version": 1, "name": "...", "source": "...", "units": "m", "half": true,
     "particulars": {"length_pp": m, "beam": m, "draft": m, "depth": m, "water_density": t/m3},
     "points": [[x, y, z], ...], "faces": [[point, point, point, ...], ...],
     "creases": [[point, point], ...], "corners": [point, ...],
     "layers": [{"name": "...", "in_hydrostatics": true, "colour": [r, g, b]}, ...],
     "face_layers": [layer, ...]}

format, version, units, half, points and faces are required. Without layers all faces are the shell;
without face_layers all are in the first layer. A particular that is left out is 0: not given.
Nothing is mended on reading: a mistake is refused with the key and index where it stands.
"""

import json
import math
from pathlib import Path

import numpy as np

from .bytes_on_disk import read_bytes, write_bytes
from .cleanup import creases_of_faces
from .errors import HullFileError
from .hull_data import HullData, Layer, Particulars, edge_key, face_edges
from .limits import FURTHEST_POINT, LONGEST_DIMENSION, LONGEST_TEXT, MAX_COUNT, MAX_HULL_FILE_BYTES

KEYS = {
    *("format", "version", "name", "source", "units", "half", "particulars", "points", "faces"),
    *("creases", "corners", "layers", "face_layers"),
}
PARTICULARS = tuple(vars(Particulars()))


def read_hull_file(path):
    """The HullData of a hull file; raises HullFileError."""
    path = Path(path)
    return parse_hull_file(read_bytes(path, MAX_HULL_FILE_BYTES), path.name)


def parse_hull_file(data, file_name):
    """The HullData in the bytes of a hull file; raises HullFileError naming key and index."""
    return _Parser(file_name).hull(data)


class _Parser:
    """Checks every value before it is used; remembers only the file's name, for the errors."""

    def __init__(self, file_name):
        self.file_name = file_name

    def error(self, where, problem, remedy):
        return HullFileError(f"{self.file_name}: {where}: {problem}; {remedy}.")

    def hull(self, data):
        content = self._json(data)
        self._header(content)
        points = self._points(content["points"])
        faces = self._faces(content["faces"], len(points))
        layers = self._layers(content.get("layers", [{}]))
        name = self._text(content.get("name", ""), "name")
        return HullData(
            name=name or self.file_name.split(".")[0],
            points=points,
            faces=faces,
            creases=self._creases(content.get("creases", []), faces, len(points)),
            corners=self._corners(content.get("corners", []), len(points)),
            half=self._flag(content["half"], "half"),
            layers=layers,
            face_layers=self._face_layers(content, len(faces), len(layers)),
            particulars=self._particulars(content.get("particulars", {})),
            units="m",
            source=self._text(content.get("source", ""), "source"),
        )

    def _json(self, data):
        try:
            text = data.decode("utf-8-sig")
            content = json.loads(text, parse_constant=self._refuse_constant)
        except UnicodeDecodeError as error:
            raise self.error(
                f"byte {error.start}", "it is not UTF-8 text", "save it as UTF-8"
            ) from None
        except json.JSONDecodeError as error:
            raise self.error(
                f"line {error.lineno}, column {error.colno}",
                f"it is not JSON ({error.msg[0].lower()}{error.msg[1:]})",
                "mend it there or use another copy",
            ) from None
        except RecursionError:
            raise self.error(
                "the file", "lists are nested too deep", "it is no hull file; choose another"
            ) from None
        except HullFileError:
            raise
        except ValueError:
            raise self.error(
                "the file", "a number has too many digits", "write it with fewer digits"
            ) from None
        if not isinstance(content, dict):
            raise self.error("the file", "it holds no object { }", "see a sample for the form")
        return content

    def _refuse_constant(self, word):
        raise self.error("the file", f"{word} is not a number", "write a finite number")

    def _header(self, content):
        if content.get("format") != "hull":
            raise self.error("format", 'it is not "hull"', "choose a hull file")
        version = content.get("version")
        if version != 1 or isinstance(version, bool):
            raise self.error(
                "version", f"{self._shown(version)} can't be read", "only version 1 is known"
            )
        for key in ("units", "half", "points", "faces"):
            if key not in content:
                raise self.error(key, "it is missing", "add it; see a sample for the form")
        if content["units"] != "m":
            raise self.error(
                "units", f"{self._shown(content['units'])} is not \"m\"", "write lengths in metres"
            )
        for key in content:
            if key not in KEYS:
                raise self.error(
                    self._shown(key), "this key is unknown", "take it out or correct its spelling"
                )

    @staticmethod
    def _shown(value):
        """A value for a message, cut to a readable length."""
        text = json.dumps(value) if isinstance(value, (str, int, float)) else type(value).__name__
        return text if len(text) <= 40 else text[:37] + "..."

    def _list(self, value, where, length=None):
        if not isinstance(value, list):
            raise self.error(where, f"{self._shown(value)} is no list", "write a list [ ]")
        if length is not None and len(value) != length:
            raise self.error(
                where, f"it has {len(value)} entries, not {length}", f"write {length} entries"
            )
        return value

    def _check_length(self, value, key):
        if not 0 < len(value) <= MAX_COUNT:
            raise self.error(
                key, f"it has {len(value)} entries", f"a hull has 1 to {MAX_COUNT} {key}"
            )

    def _object(self, value, where, keys):
        if not isinstance(value, dict):
            raise self.error(where, f"{self._shown(value)} is no object", "write an object { }")
        for key in value:
            if key not in keys:
                raise self.error(
                    f"{where}.{key[:40]}",
                    "this key is unknown",
                    "take it out or correct its spelling",
                )
        return value

    def _number(self, value, where, lowest, highest):
        number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not number or not lowest <= value <= highest or not math.isfinite(value):
            raise self.error(
                where,
                f"{self._shown(value)} is not a number from {lowest:g} to {highest:g}",
                "correct it",
            )
        return float(value)

    def _index(self, value, where, count, of):
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < count:
            raise self.error(
                where,
                f"{self._shown(value)} is no index of a {of}",
                f"{of}s are 0 to {count - 1}" if count else f"there are no {of}s",
            )
        return value

    def _flag(self, value, where):
        if not isinstance(value, bool):
            raise self.error(where, f"{self._shown(value)} is not true or false", "write one")
        return value

    def _text(self, value, where):
        if not isinstance(value, str) or len(value) > LONGEST_TEXT:
            raise self.error(
                where,
                f"it is no text of at most {LONGEST_TEXT} characters",
                'write a short text " "',
            )
        return value

    def _points(self, value):
        points = self._list(value, "points")
        self._check_length(points, "points")
        for index, point in enumerate(points):
            for axis, number in zip("xyz", self._list(point, f"points[{index}]", 3)):
                where = f"points[{index}].{axis}"
                self._number(number, where, -FURTHEST_POINT, FURTHEST_POINT)
        return np.array(points, dtype=np.float64)

    def _faces(self, value, point_count):
        faces = self._list(value, "faces")
        self._check_length(faces, "faces")
        seen = {}
        for index, face in enumerate(faces):
            where = f"faces[{index}]"
            for place, point in enumerate(self._list(face, where)):
                self._index(point, f"{where}[{place}]", point_count, "point")
            distinct = frozenset(face)
            if len(face) < 3 or len(distinct) < len(face):
                raise self.error(
                    where,
                    f"it has {len(distinct)} different points of {len(face)}",
                    "a face needs 3 or more points, each once",
                )
            earlier = seen.setdefault(distinct, index)
            if earlier != index:
                raise self.error(where, f"it has the points of faces[{earlier}]", "take one out")
        return faces

    def _creases(self, value, faces, point_count):
        edges = {edge_key(a, b) for face in faces for a, b in face_edges(face)}
        creases = self._list(value, "creases")
        for index, crease in enumerate(creases):
            where = f"creases[{index}]"
            for place, point in enumerate(self._list(crease, where, 2)):
                self._index(point, f"{where}[{place}]", point_count, "point")
            if edge_key(*crease) not in edges:
                raise self.error(
                    where, f"{crease[0]} - {crease[1]} is no edge of a face", "take it out"
                )
        return creases_of_faces(creases, faces)

    def _corners(self, value, point_count):
        corners = self._list(value, "corners")
        for index, point in enumerate(corners):
            self._index(point, f"corners[{index}]", point_count, "point")
        return sorted(set(corners))

    def _layers(self, value):
        if not self._list(value, "layers"):
            raise self.error("layers", "the list is empty", "leave it out or add a layer")
        layers = []
        for index, entry in enumerate(value):
            where = f"layers[{index}]"
            entry = self._object(entry, where, ("name", "in_hydrostatics", "colour"))
            layer = Layer(
                name=self._text(entry.get("name", f"Layer {index}"), f"{where}.name"),
                in_hydrostatics=self._flag(
                    entry.get("in_hydrostatics", True), f"{where}.in_hydrostatics"
                ),
            )
            if "colour" in entry:
                colour = self._list(entry["colour"], f"{where}.colour", 3)
                layer.colour = tuple(
                    self._number(part, f"{where}.colour[{place}]", 0.0, 1.0)
                    for place, part in enumerate(colour)
                )
            layers.append(layer)
        return layers

    def _face_layers(self, content, face_count, layer_count):
        if "face_layers" not in content:
            return [0] * face_count
        face_layers = self._list(content["face_layers"], "face_layers", face_count)
        for index, layer in enumerate(face_layers):
            self._index(layer, f"face_layers[{index}]", layer_count, "layer")
        return face_layers

    def _particulars(self, value):
        entries = self._object(value, "particulars", PARTICULARS)
        return Particulars(
            **{
                key: self._number(number, f"particulars.{key}", 0.0, LONGEST_DIMENSION)
                for key, number in entries.items()
            }
        )


def write_hull_file(data, path):
    """Write a HullData as a hull file, whole or not at all; reading it gives an equal HullData.

    Coordinates keep every digit. `units` and `notes` are not kept: they belong to the file that the
    hull was imported from. Raises HullFileError.
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
    ]
    content = ("{\n" + ",\n".join(lines) + "\n}\n").encode("utf-8")
    parse_hull_file(content, path.name)
    write_bytes(path, content)


def _particulars_entry(particulars):
    return {key: float(getattr(particulars, key)) for key in PARTICULARS}


def _layer_entry(layer):
    return {
        "name": layer.name,
        "in_hydrostatics": layer.in_hydrostatics,
        "colour": list(layer.colour),
    }


def _rows(key, values):
    """A list with one entry a line, so that a difference between two files can be read."""
    return f'"{key}": [\n' + ",\n".join(json.dumps(value) for value in values) + "\n]"
