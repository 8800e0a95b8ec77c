# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry packed by gzip: of one member or several, and what is wrong with some."""

import gzip

import hull_io
import pytest
from hull_io.geometry import read_geometry, reading

POINTS = "".join(f"{k} {k * k} {k % 7}\n" for k in range(300)).encode()
PACKED = gzip.compress(POINTS)


@pytest.fixture
def read(tmp_path):
    def read_data(data):
        path = tmp_path / "scan.xyz.gz"
        path.write_bytes(data)
        return read_geometry(path).points.tolist()

    return read_data


def test_all_members_are_read(read):
    """As pigz and bgzip write them, and as files packed one by one are put together."""
    whole = [[k, k * k, k % 7] for k in range(300)]
    assert read(PACKED) == whole
    parts = [gzip.compress(POINTS[at : at + 1000]) for at in range(0, len(POINTS), 1000)]
    assert len(parts) > 2
    assert read(b"".join(parts)) == whole
    assert read(PACKED + bytes(512)) == whole


@pytest.mark.parametrize("data", [PACKED[:-9], PACKED + PACKED[:40]], ids=["one", "two"])
def test_what_is_cut_short(read, data):
    with pytest.raises(hull_io.HullFileError, match="cut short"):
        read(data)


@pytest.mark.parametrize(
    "data",
    [
        PACKED[:30] + bytes(20) + PACKED[50:],
        PACKED[:-8] + bytes(8),
        PACKED + PACKED[:30] + bytes(20) + PACKED[50:],
        PACKED + b"and more",
    ],
    ids=["its content", "its sum", "a later member", "what follows"],
)
def test_what_is_damaged(read, data):
    with pytest.raises(hull_io.HullFileError, match="it is damaged"):
        read(data)


def test_members_count_together(read, monkeypatch):
    monkeypatch.setattr(reading, "MAX_GEOMETRY_BYTES", len(POINTS) + 100)
    assert read(PACKED)
    with pytest.raises(hull_io.HullFileError, match="larger than is read"):
        read(PACKED + PACKED)
