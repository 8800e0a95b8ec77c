# SPDX-License-Identifier: GPL-3.0-or-later
"""Opening a hull file of any known format."""

from pathlib import Path

from .bytes_on_disk import read_bytes
from .chines import hull_of_chines, looks_like_chines, read_chines
from .errors import HullFileError
from .freeship import is_freeship, read_freeship, read_stored_sections
from .geometry.reading import is_geometry
from .hull_file import parse_hull_file
from .limits import MAX_FILE_BYTES, MAX_HULL_FILE_BYTES
from .mending import mend


def read_hull(path):
    """The HullData of a FREE!ship (.fbm, .ftm), hull (.hull.json) or chine file (.hul, .xyz, .txt).

    The content decides which reader is used; where it begins like none of them, the extension
    decides which one explains what is missing. Raises HullFileError.
    """
    path = Path(path)
    data = read_bytes(path, MAX_FILE_BYTES)
    begins_json = data[:1024].lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{")
    if is_freeship(data) or path.suffix.lower() in (".fbm", ".ftm") and not begins_json:
        hull = read_freeship(data, path.name)
        hull.name = hull.name or path.stem
        return hull
    if begins_json or path.suffix.lower() == ".json":
        if len(data) > MAX_HULL_FILE_BYTES:
            data = read_bytes(path, MAX_HULL_FILE_BYTES)
        return parse_hull_file(data, path.name)
    if looks_like_chines(data, path.suffix.lower()):
        hull = hull_of_chines(read_chines(data, path.name))
        hull.name = hull.name or path.stem
        return hull
    if is_geometry(data, path.suffix.lower()):
        raise HullFileError(
            f"{path.name}: it is a file of a surface, lines or points, not of a control mesh; "
            "choose it with Hull from File, which lays a hull over them."
        )
    raise HullFileError(
        f"{path.name}: it is neither a FREE!ship file nor a hull file, nor one of chines; choose a "
        "file ending in .fbm, .ftm, .hull.json or .hul, or a surface or table of offsets with Hull "
        "from File."
    )


def read_mended(path):
    """The HullData of such a file, mended to what a surface can be made of, whatever format it has:
    what was done is in its notes. read_hull leaves a hull file (.hull.json) as it is."""
    hull = read_hull(path)
    mend(hull)  # which finds nothing to do in the others
    return hull


def stored_sections(path):
    """The sections that FREE!ship stored in an .fbm or .ftm file: a list of StoredSection."""
    path = Path(path)
    return read_stored_sections(read_bytes(path, MAX_FILE_BYTES), path.name)
