# SPDX-License-Identifier: GPL-3.0-or-later
"""What the process that reads STEP and IGES leaves behind, where that is no geometry."""

import io
import json

import hull_io
import numpy as np
import pytest
from hull_io.geometry import cad_files, read_geometry


def archive(**about):
    told = {"unit": "m", "curves": [], "faces": [], "curves_left_out": 0, "faces_left_out": 0}
    arrays = {"about": np.frombuffer(json.dumps(told | about).encode(), dtype=np.uint8)}
    for key in ("curve_knots", "curve_weights", "curve_points", "face_points", "face_triangles"):
        arrays |= {key: np.empty((0, 3)), f"{key}_sizes": np.array([8], dtype=int)}
    written = io.BytesIO()
    np.savez_compressed(written, **arrays)
    return written.getvalue()


@pytest.fixture
def read(tmp_path, monkeypatch):
    """Reads a STEP file of which the process made these bytes."""
    path = tmp_path / "hull.step"
    path.write_text("ISO-10303-21;")

    def read_made(data):
        monkeypatch.setattr(cad_files, "_run", lambda path, out, *rest: out.write_bytes(data))
        return read_geometry(path)

    return read_made


def test_what_is_refused_is_told_once(read, monkeypatch):
    monkeypatch.setattr(cad_files, "MAX_GEOMETRY_POINTS", 15)
    with pytest.raises(hull_io.HullFileError) as refused:
        read(archive())
    words = "hull.step: it has 16 points and 0 curves, more than is read; export the hull alone."
    assert str(refused.value) == words


def test_what_is_damaged_is_refused(read):
    whole = archive()
    spoilt = bytearray(whole)
    spoilt[60:70] = bytes(10)
    for data in (b"", b"no archive", whole[: len(whole) // 2], bytes(spoilt)):
        with pytest.raises(hull_io.HullFileError, match="what was read of it can't be used"):
            read(data)
