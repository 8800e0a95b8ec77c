# SPDX-License-Identifier: GPL-3.0-or-later
"""Opening a file of any format that geometry is read of."""

import gzip
import io
import zlib
from pathlib import Path

from ..bytes_on_disk import read_bytes
from ..chines import looks_like_chines, read_chines
from ..errors import HullFileError
from ..freeship import is_freeship, read_stored_sections
from ..limits import MAX_GEOMETRY_BYTES, MAX_STL_BYTES, MAX_TABLE_BYTES
from ..stl import parse_stl
from ..table_text import decoded
from .cad_files import is_cad, read_cad
from .dxf import read_dxf
from .obj import read_obj
from .offset_curves import read_offsets
from .offset_tables import looks_like_offsets
from .point_lists import read_points
from .polycad import is_polycad, read_polycad
from .values import Geometry, GeometryMesh, polyline

# Of the size, how far triangles of CAD faces may be from them.
CHORD_SHARE = 2e-5
_GZIP = b"\x1f\x8b\x08"
_CAD_ENDINGS = (".step", ".stp", ".iges", ".igs")
_ENDINGS = (*_CAD_ENDINGS, ".stl", ".obj", ".dxf", ".geo", ".csv", ".gz")
_DXF = b"AutoCAD Binary DXF"
_TOLD_IN = 65536  # bytes of a text


def read_geometry(path, chord_share=CHORD_SHARE, progress=None):
    """The Geometry of a file: STEP, IGES, DXF, STL, OBJ, FREE!ship's stored sections, PolyCAD's
    surfaces, chines, a table of offsets or a list of points; packed by gzip all but STEP and IGES.

    What a file is its content tells; the ending counts for OBJ and where the content tells
    nothing. progress: called with the share of the work that is done, for STEP and IGES; what it
    raises ends the reading. HullFileError in one sentence.
    """
    path = Path(path)
    data = read_bytes(path, MAX_GEOMETRY_BYTES)
    if data.startswith(_GZIP):
        data, path = _unpacked(data, path.name), path.with_suffix("")
        if is_cad(data):
            raise HullFileError(f"{path.name}: unpack it first; CAD files are not read packed.")
    ending = path.suffix.lower()
    if is_cad(data) or ending in _CAD_ENDINGS:
        return read_cad(path, chord_share, progress)
    if is_freeship(data) or ending in (".fbm", ".ftm"):
        return _stored_sections(data, path.name)
    if ending == ".stl":
        return _stl(data, path.name)
    if ending == ".obj":
        return read_obj(data, path.name)
    if ending == ".dxf" or data.startswith(_DXF):
        return read_dxf(data, path.name)
    return _text(path, data)


def is_geometry(data, ending):
    """Whether read_geometry would try a file's bytes, by what they begin with or by the ending, in
    lower case. Hull files, FREE!ship's and chines, which are read as hulls too, do not count."""
    if ending in _ENDINGS or data.startswith((_GZIP, _DXF)) or is_cad(data):
        return True
    if b"\0" in data[:4096]:
        return False
    text = decoded(data[:_TOLD_IN])
    return is_polycad(text) or looks_like_offsets(text)


def _unpacked(data, name):
    """Of all members of a packed file, one after the other."""
    try:
        unpacked = gzip.GzipFile(fileobj=io.BytesIO(data)).read(MAX_GEOMETRY_BYTES + 1)
        is_whole = len(unpacked) <= MAX_GEOMETRY_BYTES
    except EOFError:
        is_whole = False
    except (OSError, zlib.error) as error:
        raise HullFileError(f"{name}: it is damaged; use another copy.") from error
    if not is_whole:
        raise HullFileError(
            f"{name}: unpacked it is cut short or larger than is read; use another copy, or write "
            "fewer triangles."
        )
    return unpacked


def _stl(data, name):
    if len(data) > MAX_STL_BYTES:
        raise HullFileError(f"{name}: it is larger than is read; write fewer triangles.")
    points, triangles = parse_stl(data, name)
    return Geometry(name, "STL", None, meshes=(GeometryMesh(points, triangles),))


def _stored_sections(data, name):
    curves = [
        polyline(points, knuckles.nonzero()[0], name=section.kind, kind=kind)
        for section in read_stored_sections(data, name)
        for kind in [section.kind if section.kind != "free" else ""]
        for points, knuckles in section.curves
    ]
    curves = tuple(curve for curve in curves if curve is not None)
    if not curves:
        raise HullFileError(
            f"{name}: no sections are stored in it; compute them in FREE!ship and save it "
            f"again, or "
            "import it as a hull."
        )
    return Geometry(name, "FREE!ship", "m", curves, is_half=True, on_ship_axes=True)


def _chines(data, name):
    found = read_chines(data, name)
    curves = [
        polyline(points, name=f"chine {number}", kind="knuckle")
        for number, points in enumerate(found.curves, 1)
    ]
    curves = tuple(curve for curve in curves if curve is not None)
    return Geometry(name, found.source, "m", curves, is_half=True, on_ship_axes=True)


def _text(path, data):
    if len(data) > MAX_TABLE_BYTES:
        raise HullFileError(
            f"{path.name}: as a text it has more than the {MAX_TABLE_BYTES / 2**20:.0f} MB "
            f"that are "
            "read; thin it out."
        )
    if b"\0" in data[:4096]:
        raise HullFileError(
            f"{path.name}: it is no text and none of the known formats; choose a STEP, IGES, DXF, "
            "STL, OBJ, .fbm or .ftm file, a table of offsets or a list of points."
        )
    if looks_like_chines(data, path.suffix.lower()):
        return _chines(data, path.name)
    text = decoded(data)
    if is_polycad(text):
        return read_polycad(text, path.name)
    if looks_like_offsets(text):
        return read_offsets(text, path.name)
    return read_points(text, path.name)
