# SPDX-License-Identifier: GPL-3.0-or-later
"""The project's own hull file: what is written is read, whatever is damaged."""

import json
import os
import random
import stat

import hull_io
import numpy as np
import pytest
from hull_file_content import assert_same, content
from hull_io import bytes_on_disk


def test_a_file_is_read(read):
    hull = read(content())
    assert hull.name == "Box"
    assert hull.half and hull.units == "m" and hull.source == "a test"
    assert hull.points.dtype == np.float64
    assert hull.points[5].tolist() == [10, 2, 3]
    assert hull.faces == [[0, 3, 2, 1], [3, 4, 5, 2]]
    assert hull.creases == [(2, 3)]
    assert hull.corners == [3]
    assert hull.particulars == hull_io.Particulars(10.0, 4.0, 1.5, 0.0, 1.025)
    assert [layer.in_hydrostatics for layer in hull.layers] == [True, False]
    assert hull_io.shell_face_indices(hull) == [0]
    assert hull.scheme == "catmull_clark" and hull.deck_edge == [(4, 5)]
    assert hull.shown_rows == [(2, 3), (2, 5)]
    assert hull.afloat == hull_io.Afloat(-0.25, 5.0, False)
    assert hull.load == hull_io.Load(12.5, 1.75, 4.5, False, False, "case", "ballast")
    assert hull.load_cases == [hull_io.LoadCase("ballast", 8.0, 5.0, -0.1, 1.0)]
    assert hull.weights == hull_io.Weights(0.01, 2.7, [hull_io.Weight("mast", 0.5, vcg=6.0)])
    assert hull.resistance == hull_io.Resistance(
        "savitsky", (5.0, 30.0, 2.5), stern=-10, deadrise_deg=18.0, thrust_arm=-0.1,
        twin_screw=True, shaft_efficiency=0.98, zeros=("transom_area", "deadrise_deg"),
        holtrop=hull_io.HoltropInputs(bulb_area=2.0),
        open_stern=True, hulls="one", blade_area_ratio=0.7,
        delft=hull_io.DelftInputs(lcb=4.5, keel_centre=-0.5),
        michell=hull_io.MichellInputs(wetted_surface=70.0),
    )  # fmt: skip
    assert hull.downflooding_points == [hull_io.DownfloodingPoint("hatch", (5.0, 1.0, 3.0))]
    areas = [hull_io.WindArea("house", 20.0, 4.5), hull_io.WindArea("Wind area", 5.0)]
    assert hull.wind == hull_io.Wind(False, areas, 3.5, 252.0, 1.5, True, 4.0)
    assert hull.lines == hull_io.LineChoice(
        shown=("stations", "waterlines"),
        station_count=10,
        waterline_spacing=0.5,
        stations="1 3:9:2",
        stations_in="frames",
        frame_spacing=0.6,
        planes=[hull_io.CutPlane("bow", (1.0, 0.0, 0.0), (9.0, 0.0, 0.0), False)],
    )
    first, second, third, faces, section = hull.fields
    assert first == hull_io.ShapeField(
        "Field 1", 5, place=(1, 2, 3), falloff=0.4, shift=(0, 0.3, 0)
    )
    assert (second.name, second.role, second.on) == ("Deck edge", "protect", False)
    assert second.line[2] == (2, 0, 2) and second.closed and second.axes == "xz"
    assert (third.base, third.axis, third.line) == ("plane", "z", [])
    assert (faces.base, faces.faces, faces.end) == ("faces", [0, 1], None)
    assert section.becomes == [(5, 0, 0), (5, 2, 1)]
    assert section.end == hull_io.FieldEnd(2, 0.5, (0, 0, 0.1))
    assert hull.targets == hull_io.Targets(
        rows=[
            hull_io.Target("kmt", 6.3, "at least", 0.1),
            hull_io.Target("section_area", 5.0, station=4.0, on=False),
        ],
        moving="none",
        staying=("deck_edge",),
        beam=hull_io.FreeDimension(True, 2.0),
        fairness=0.1,
    )
    pairs = [(point.x, point.area) for point in hull.area_target.points]
    assert pairs == [(0.0, 0.0), (5.0, 4.0), (10.0, 0.5)]
    assert hull.area_target.base[1] == hull_io.AreaPoint(5.0, 4.5)
    assert hull.area_target.source == "a table"
    first, second = hull.variants
    assert (first.hull.name, first.note, first.hull.half) == ("as built", "the first", True)
    assert first.hull.points[2].tolist() == [9, 2, 0] and first.hull.locked == [2]
    assert first.hull.particulars.draft == 1.25 and first.hull.load.kg == 1.5
    assert (second.hull.name, second.note, second.hull.half) == ("Variant 2", "", False)


def test_what_may_be_left_out(read):
    required = ("format", "version", "units", "half", "points", "faces")
    optional = [key for key in content() if key not in required]
    hull = read(content(**dict.fromkeys(optional)))
    assert hull.name == "box"
    assert hull.particulars == hull_io.Particulars()
    assert hull.creases == [] and hull.corners == []
    assert hull_io.shell_face_indices(hull) == [0, 1]
    assert hull.scheme == "biermann" and hull.deck_edge == []
    assert hull.afloat == hull_io.Afloat() and hull.load == hull_io.Load()
    assert hull.load_cases == [] and hull.downflooding_points == [] and hull.lines is None
    assert hull.wind is None and read(content(wind={})).wind == hull_io.Wind()
    assert not hull.load.kg_is_guess and read(content(load={"kg_is_guess": True})).load.kg_is_guess
    assert read(content(lines={})).lines == hull_io.LineChoice()
    assert hull.targets == hull_io.Targets() and hull.area_target is None and hull.variants == []
    assert hull.fields == []
    assert read(content(targets={})).targets == hull_io.Targets()
    assert read(content(area_target={})).area_target == hull_io.AreaTarget()
    hull = read(content(load={}, load_cases=[{"mass_t": 1}], openings=[{"position": [1, 2, 3]}]))
    assert hull.load == hull_io.Load(None, 0.0, None, True)
    assert hull.load_cases == [hull_io.LoadCase("Load case", 1.0)]
    guessed = read(content(load_cases=[{"mass_t": 1, "vcg_is_guess": True}]))
    assert guessed.load_cases == [hull_io.LoadCase("Load case", 1.0, vcg_is_guess=True)]
    assert hull.downflooding_points == [hull_io.DownfloodingPoint("Opening", (1.0, 2.0, 3.0))]


def test_reference_hulls_come_back_bit_for_bit(freeship_files, tmp_path):
    for source in freeship_files:
        hull = hull_io.read_hull(source)
        path = tmp_path / f"{source.stem}.hull.json"
        hull_io.write_hull_file(hull, path)
        assert_same(hull, hull_io.read_hull(path))


def test_any_name_and_any_number_come_back(read, tmp_path):
    hull = read(content())
    hull.name = 'Ящик "№ 1" \\ \u2028'
    noise = np.random.default_rng(11)
    hull.points = hull.points + noise.normal(size=hull.points.shape) * 1e-7
    hull_io.write_hull_file(hull, tmp_path / "again.hull.json")
    assert_same(hull, hull_io.read_hull(tmp_path / "again.hull.json"))


def test_numpy_indices_are_written_as_numbers(read, tmp_path):
    hull = read(content())
    plain = read(content())
    hull.faces = [np.array(face, dtype=np.int32) for face in hull.faces]
    hull.creases = np.array(hull.creases)
    hull.corners = np.array(hull.corners)
    hull_io.write_hull_file(hull, tmp_path / "again.hull.json")
    assert_same(plain, hull_io.read_hull(tmp_path / "again.hull.json"))


def test_writing_replaces_a_file_whole_or_not_at_all(read, tmp_path, monkeypatch):
    path = tmp_path / "kept.hull.json"
    hull = read(content())
    hull_io.write_hull_file(hull, path)
    before = path.read_bytes()
    os.chmod(path, 0o640)

    hull.points = hull.points + np.nan
    with pytest.raises(hull_io.HullFileError, match="NaN is not a number"):
        hull_io.write_hull_file(hull, path)
    assert path.read_bytes() == before

    hull.points = np.zeros((6, 3))

    def full_disk(_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(bytes_on_disk.os, "fsync", full_disk)
        with pytest.raises(hull_io.HullFileError, match="No space left on device"):
            hull_io.write_hull_file(hull, path)
    assert path.read_bytes() == before

    hull_io.write_hull_file(hull, path)
    assert not hull_io.read_hull(path).points.any()
    assert stat.S_IMODE(os.stat(path).st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["box.hull.json", "kept.hull.json"]


def test_what_would_be_too_large_to_be_read_is_not_written(read, tmp_path):
    hull = read(content())
    large = hull_io.Variant(hull_io.read_hull(tmp_path / "box.hull.json"))
    large.hull.source = "x" * 10_000
    hull.variants = [large] * 1000
    with pytest.raises(hull_io.HullFileError, match="at most 8; remove some of its variants"):
        hull_io.write_hull_file(hull, tmp_path / "large.hull.json")
    assert not (tmp_path / "large.hull.json").exists()


def test_files_without_targets_and_variants_are_as_they_were(read, tmp_path):
    keys = ("targets", "area_target", "variants")
    hull_io.write_hull_file(read(content(**dict.fromkeys(keys))), tmp_path / "a.hull.json")
    assert not set(keys) & set(json.loads((tmp_path / "a.hull.json").read_text()))


def test_writing_into_no_folder_is_refused(read, tmp_path):
    with pytest.raises(hull_io.HullFileError, match="x.hull.json: it can't be written"):
        hull_io.write_hull_file(read(content()), tmp_path / "no" / "x.hull.json")


@pytest.mark.parametrize("begin, said", [("n" * 300, "too long"), ("two\nlines", "line breaks")])
def test_names_that_no_file_can_have(read, tmp_path, begin, said):
    before = os.listdir(tmp_path)
    with pytest.raises(hull_io.HullFileError, match=said):
        hull_io.write_hull_file(read(content()), tmp_path / f"{begin}.hull.json")
    assert set(os.listdir(tmp_path)) <= {*before, "box.hull.json"}


def test_the_longest_name(read, tmp_path):
    path = tmp_path / ("n" * 245 + ".hull.json")
    hull_io.write_hull_file(read(content()), path)
    assert len(hull_io.read_hull(path).points) > 0


def test_damaged_copies_are_refused_or_read(tmp_path):
    """Cut short, bits turned, or a piece replaced by something hostile."""
    seed = 12
    choice = random.Random(seed)
    data = json.dumps(content()).encode()
    hostile = [b"1e999", b"-1", b"null", b"[]", b"{}", b'""', b"true", b"99999999999", b"NaN"]
    path = tmp_path / "box.hull.json"
    read = 0
    for copy in range(1000):
        damaged = bytearray(data)
        start = choice.randrange(len(data))
        if copy % 3 == 0:
            del damaged[start:]
        elif copy % 3 == 1:
            damaged[start] ^= 1 << choice.randrange(8)
        else:
            damaged[start : start + choice.randrange(4)] = choice.choice(hostile)
        path.write_bytes(damaged)
        try:
            hull = hull_io.read_hull(path)
        except hull_io.HullFileError as error:
            assert str(error).startswith("box.hull.json: "), f"seed {seed}, copy {copy}"
            continue
        read += 1
        hull_io.shell_arrays(hull)
    assert 0 < read < 500


@pytest.mark.parametrize("mask", [0o022, 0o077, 0o002])
def test_new_files_have_the_usual_rights_without_a_change_of_these(
    mask, read, tmp_path, monkeypatch
):
    """What is usual holds for all threads, which write files, too."""
    hull = read(content())
    (tmp_path / "box.hull.json").unlink()
    before = os.umask(mask)
    try:
        (tmp_path / "usual").touch()
        with monkeypatch.context() as watched:
            watched.delattr(os, "umask")
            hull_io.write_hull_file(hull, tmp_path / "new.hull.json")
    finally:
        os.umask(before)
    found = {path.name: stat.S_IMODE(path.stat().st_mode) for path in tmp_path.iterdir()}
    assert found == {"usual": 0o666 & ~mask, "new.hull.json": 0o666 & ~mask}
