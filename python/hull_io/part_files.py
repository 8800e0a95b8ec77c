# SPDX-License-Identifier: GPL-3.0-or-later
"""Models in parts: named surfaces for CFD in one STL text, and segments of a model for a machine.

All raise HullFileError where a file can't be written, leaving what was there, and ValueError for
what are no parts.
"""

from pathlib import Path

import numpy as np

from .bytes_on_disk import read_bytes, write_bytes, write_files
from .errors import HullFileError
from .face_arrays import checked_faces, lines_of
from .limits import MAX_STL_TEXT_BYTES
from .model_files import bytes_of_3mf
from .panel_files import bytes_of_obj
from .stl import bytes_of_stl

_LETTERS = frozenset("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-")
_FACET = (
    " facet normal %.9g %.9g %.9g\n  outer loop\n"
    + 3 * "   vertex %.9g %.9g %.9g\n"
    + "  endloop\n endfacet"
)


def part_name(name):
    """A name as programs take it for a part: letters, digits, _ and -; what is none of these as
    "_"."""
    text = "".join(letter if letter in _LETTERS else "_" for letter in name.strip())
    return text if text and not text[0].isdigit() else f"part_{text}"


def write_stl_parts(path, points, parts):
    """One STL file as a text with a solid for each of parts, {name: triangles (m, 3)}, of points
    (n, 3), in metres, as snappyHexMesh takes it for regions. Points have nine digits, the same in
    all triangles, so that parts fit together. Names: see part_name(); triangles without area are
    left out, as they have no normal."""
    parts = {name: np.asarray(triangles) for name, triangles in parts.items()}
    if not any(len(triangles) for triangles in parts.values()):
        raise ValueError("There is no triangle to be written.")
    text = []
    for name, triangles in parts.items():
        if part_name(name) != name:
            raise ValueError(
                f'A part\'s name has letters, digits, _ and -, and begins with a letter: "{name}" '
                f'could be "{part_name(name)}".'
            )
        if not len(triangles):
            continue
        places, triangles = checked_faces(points, triangles, 3)
        a, b, c = places[triangles].transpose(1, 0, 2)
        normals = np.cross(b - a, c - a)
        lengths = np.linalg.norm(normals, axis=1)
        kept = lengths > 0.0
        rows = np.hstack([normals / np.where(kept, lengths, 1.0)[:, None], a, b, c])[kept]
        text += [f"solid {name}\n".encode(), lines_of(rows + 0.0, _FACET)]
        text.append(f"endsolid {name}\n".encode())
    write_bytes(Path(path), b"".join(text))


def read_stl_parts(path):
    """{name: corners (m, 3, 3)} of the solids of an STL text; HullFileError where it is none."""
    path = Path(path)
    parts, numbers = {}, None
    for row in read_bytes(path, MAX_STL_TEXT_BYTES).decode("ascii", "replace").splitlines():
        word, _, rest = row.strip().partition(" ")
        if word == "solid":
            numbers = parts.setdefault(rest.strip(), [])
        elif word == "vertex" and numbers is not None:
            try:
                numbers.append([float(number) for number in rest.split()])
            except ValueError as error:
                raise HullFileError(f'{path.name}: "{row}" is no place; write it again.') from error
    if not parts or any(len(p) % 3 or {len(v) for v in p} - {3} for p in parts.values()):
        raise HullFileError(f"{path.name}: it is no STL text of solids; choose another file.")
    return {name: np.reshape(numbers, (-1, 3, 3)) for name, numbers in parts.items()}


def write_segments(path, segments, *, title="Hull"):
    """Segments of a model in mm, (points (n, 3), triangles (m, 3)) each, by the path's ending: .3mf
    has all of them as objects of one file; .stl and .obj are a file each, named with -1, -2, …
    after the path's stem. All files are there, or none has changed. Returns their paths."""
    path = Path(path)
    if not segments:
        raise ValueError("There is no segment to be written.")
    ending = path.suffix.lower()
    if ending == ".3mf":
        objects = [(f"{title} {k}", *one) for k, one in enumerate(segments, 1)]
        write_bytes(path, bytes_of_3mf(objects, title))
        return [path]
    bytes_of = {".stl": bytes_of_stl, ".obj": bytes_of_obj}.get(ending)
    if bytes_of is None:
        raise ValueError(f'Segments are written as .stl, .3mf or .obj, not as "{path.name}".')
    paths = [path.with_name(f"{path.stem}-{k}{path.suffix}") for k in range(1, len(segments) + 1)]
    write_files({one: bytes_of(*segment) for one, segment in zip(paths, segments)})
    return paths
