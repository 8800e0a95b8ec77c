# SPDX-License-Identifier: GPL-3.0-or-later
"""Which reader takes a file, and what becomes of files that none can take."""

import os

import hull_io
import pytest
from freeship_writer import binary_file, box_model, text_file


@pytest.fixture
def hull_json(tmp_path):
    source = tmp_path / "box.fbm"
    source.write_bytes(binary_file(box_model(), 335))
    hull_io.write_hull_file(hull_io.read_hull(source), tmp_path / "box.hull.json")
    return (tmp_path / "box.hull.json").read_bytes()


@pytest.mark.parametrize("name", ["hull.fbm", "hull.FTM", "hull.hull.json", "hull", "hull.txt"])
def test_the_content_decides_whatever_the_name(tmp_path, hull_json, name):
    path = tmp_path / name
    for content in (binary_file(box_model(), 335), text_file(box_model(), 335), hull_json):
        path.write_bytes(content)
        for argument in (path, str(path)):
            assert len(hull_io.read_hull(argument).faces) == 5


@pytest.mark.parametrize(
    "name, content, problem",
    [
        ("a.fbm", b"", "does not begin with 'FREE!ship'"),
        ("a.ftm", b"FREE!", "does not begin with 'FREE!ship'"),
        ("a.hull.json", b"", "it is not JSON"),
        ("a.json", b"[]", "is no object"),
        ("a.doc", b"solid", "neither a FREE!ship file nor a hull file"),
        ("a", bytes(100), "neither a FREE!ship file nor a hull file"),
    ],
)
def test_an_unknown_file_is_refused(tmp_path, name, content, problem):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(hull_io.HullFileError) as caught:
        hull_io.read_hull(tmp_path / name)
    assert str(caught.value).startswith(f"{name}: ")
    assert problem in str(caught.value)


OFFSETS = "station,0,1,2\nwaterline,,,\n0,1,2,3\n1,1,2,3\n"


@pytest.mark.parametrize(
    "name, content",
    [
        ("ship.geo", b"[TShipLines]\nOrderU=4\n"),
        ("ship", b"Title\n[TBSplineSurface]\nOrderU=4\n"),
        ("ship.STL", b"solid"),
        ("ship.stl.gz", b"\x1f\x8b\x08"),
        ("ship.obj", b"v 0 0 0\n"),
        ("ship.dxf", b"0\nSECTION\n"),
        ("ship.step", b"ISO-10303-21;"),
        ("ship.bin", b"ISO-10303-21;"),
        ("ship.igs", b"anything"),
        ("ship.csv", OFFSETS.encode()),
        ("ship.txt", OFFSETS.encode()),
        ("ship.dat", OFFSETS.encode()),
    ],
)
def test_files_of_geometry_are_sent_to_hull_from_file(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(hull_io.HullFileError, match="Hull from File, which lays a hull") as caught:
        hull_io.read_hull(tmp_path / name)
    assert str(caught.value).startswith(f"{name}: it is a file of a surface, lines or points")


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    with pytest.raises(hull_io.HullFileError, match="no.fbm: it can't be opened"):
        hull_io.read_hull(tmp_path / "no.fbm")
    with pytest.raises(hull_io.HullFileError, match="it is not a file"):
        hull_io.read_hull(tmp_path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_refused_without_waiting(tmp_path):
    os.mkfifo(tmp_path / "pipe.fbm")
    with pytest.raises(hull_io.HullFileError, match="it is not a file"):
        hull_io.read_hull(tmp_path / "pipe.fbm")


@pytest.mark.parametrize("name, limit", [("a.fbm", 64), ("a.hull.json", 8)])
def test_a_huge_file_is_refused(tmp_path, name, limit):
    path = tmp_path / name
    path.write_bytes(b"{" if name.endswith("json") else binary_file(box_model(), 335))
    os.truncate(path, limit * 2**20 + 2**19)
    with pytest.raises(hull_io.HullFileError, match=f"no hull file has more than {limit} MB"):
        hull_io.read_hull(path)
