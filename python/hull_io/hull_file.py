# SPDX-License-Identifier: GPL-3.0-or-later
"""The project's own file of a hull: JSON, `NAME.hull.json`, metres and t/m3.

    {"format": "hull", "version": 1, "name": "...", "source": "...", "units": "m", "half": true,
     "particulars": {"length_pp": m, "beam": m, "draft": m, "depth": m, "water_density": t/m3},
     "points": [[x, y, z], ...], "faces": [[point, point, point, ...], ...],
     "creases": [[point, point], ...], "corners": [point, ...],
     "layers": [{"name": "...", "in_hydrostatics": true, "colour": [r, g, b]}, ...],
     "face_layers": [layer, ...],
     "scheme": "biermann" or "catmull_clark", "deck_edge": [[point, point], ...],
     "shown_rows": [[point, point], ...],
     "curves" as hull_curves,
     "flats": [{"faces": [face, ...], "normal": [x, y, z], "offset": m}, ...],
     "developables" as hull_developables,
     "locked" and "kept" as hull_points, "ties" and "groups" as hull_ties, "lines" as hull_lines
     tells,
     and what hull_loading tells of: "afloat", "load", "load_cases", "openings", "wind";
     "weights" as hull_weights and "resistance" as hull_resistance tells;
     "targets" and "area_target" as hull_targets tells, "fields" as hull_fields,
     "appendages" as hull_appendages and "plating" as hull_plating tells,
     "variants" as hull_variants tells}

format, version, units, half, points and faces are required. Without layers all faces are the shell;
without face_layers all are in the first layer. A particular that is left out is 0: not given.
Without a deck_edge it is the border; shown_rows are edges of rows of points that are shown with
combs; flats tells of the faces that are kept in a plane. Nothing is mended on reading: a mistake is
refused with the key and index where it stands; a hull that is to be mended as those of other
programs are, as Blender's import does, is read by reading.read_mended.
"""

import json
from pathlib import Path

from . import hull_appendages, hull_content, hull_fields, hull_plating, hull_targets, hull_variants
from .bytes_on_disk import read_bytes, write_bytes
from .checked_json import CheckedJson, shown
from .errors import HullFileError
from .limits import MAX_HULL_FILE_BYTES

REQUIRED = ("format", "version", "units", *hull_content.REQUIRED)
OPTIONAL = (
    *hull_content.OPTIONAL,
    *hull_targets.KEYS,
    hull_fields.KEY,
    hull_appendages.KEY,
    hull_plating.KEY,
    hull_variants.KEY,
)
# Lists of single numbers, which stand in one line.
_IN_ONE_LINE = ("corners", "face_layers")


def read_hull_file(path):
    """The HullData of a hull file; raises HullFileError."""
    path = Path(path)
    return parse_hull_file(read_bytes(path, MAX_HULL_FILE_BYTES), path.name)


def parse_hull_file(data, file_name):
    """The HullData in the bytes of a hull file; raises HullFileError naming key and index."""
    check = CheckedJson(file_name)
    content = check.parse(data)
    _check_header(check, content)
    hull = hull_content.parsed(check, content, file_name.split(".")[0])
    for name, value in hull_targets.parsed(check, content).items():
        setattr(hull, name, value)
    hull.fields = hull_fields.parsed(check, content, len(hull.faces))
    hull.appendages = hull_appendages.parsed(check, content)
    hull.plating = hull_plating.parsed(check, content)
    hull.variants = hull_variants.parsed(check, content)
    return hull


def _check_header(check, content):
    if content.get("format") != "hull":
        raise check.error("format", 'it is not "hull"', "choose a hull file")
    version = content.get("version")
    if version != 1 or isinstance(version, bool):
        raise check.error("version", f"{shown(version)} is unknown", "only version 1 can be read")
    check.object(content, "the file", REQUIRED + OPTIONAL)
    if "units" not in content:
        raise check.error("units", "it is missing", "add it; see a sample for the form")
    if content["units"] != "m":
        raise check.error(
            "units", f'{shown(content["units"])} is not "m"', "write all lengths in metres"
        )


def write_hull_file(data, path):
    """Write a HullData as a hull file, whole or not at all; reading it gives an equal HullData, one
    without a name with that of the file.

    Coordinates keep every digit. `units` and `notes` are not kept: they belong to the file that the
    hull was imported from. What could not be read again is not written. Raises HullFileError.
    """
    path = Path(path)
    own = hull_content.entries(data)
    entries = {
        "format": "hull",
        "version": 1,
        "name": own.pop("name"),
        "source": own.pop("source"),
        "units": "m",
        **own,
        **hull_targets.entries(data),
        **hull_fields.entries(data),
        **hull_appendages.entries(data),
        **hull_plating.entries(data),
        **hull_variants.entries(data),
    }
    lines = [_entry(key, value) for key, value in entries.items()]
    content = ("{\n" + ",\n".join(lines) + "\n}\n").encode("utf-8")
    _check_size(len(content), data, path.name)
    parse_hull_file(content, path.name)
    write_bytes(path, content)


def _check_size(size, data, name):
    if size > MAX_HULL_FILE_BYTES:
        remedy = "remove some of its variants" if data.variants else "take a coarser control mesh"
        raise HullFileError(
            f"{name}: the hull takes {size / 2**20:.1f} MB, and a hull file has at most "
            f"{MAX_HULL_FILE_BYTES / 2**20:.0f}; {remedy}."
        )


def _entry(key, value):
    """An entry; of a list each part in a line, so that a difference of two files can be read."""
    if not isinstance(value, list) or key in _IN_ONE_LINE:
        return f"{json.dumps(key)}: {json.dumps(value)}"
    return f"{json.dumps(key)}: [\n" + ",\n".join(json.dumps(part) for part in value) + "\n]"
