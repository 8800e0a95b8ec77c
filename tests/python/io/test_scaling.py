# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls scaled to main dimensions: the surface exactly, and all that belongs to the hull."""

import dataclasses
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io import moving, scaling

SAMPLES = Path(__file__).resolve().parents[3] / "samples"
NAMES = sorted(path.name.split(".")[0] for path in SAMPLES.glob("*.hull.json"))
FACTORS = (1.1, 0.9, 1.05)


def sample(name):
    return hull_io.read_hull(SAMPLES / f"{name}.hull.json")


def surface_of(data):
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.LimitSurface(mesh, data.scheme)


def afloat(data):
    body = hn.HullBody(surface_of(data), mirrored=data.half)
    return hn.hydrostatics(body, draft=data.particulars.draft)


def paths(cls, before=""):
    """All fields of a dataclass and of those in it, by their places."""
    parts = {
        "layers": hull_io.Layer, "particulars": hull_io.Particulars, "flats": hull_io.Flat,
        "kept": hull_io.Kept, "afloat": hull_io.Afloat, "load": hull_io.Load,
        "load_cases": hull_io.LoadCase, "wind": hull_io.Wind,
        "downflooding_points": hull_io.DownfloodingPoint,
        "areas": hull_io.WindArea, "lines": hull_io.LineChoice, "planes": hull_io.CutPlane,
        "targets": hull_io.Targets, "rows": hull_io.Target, "area_target": hull_io.AreaTarget,
        "weights": hull_io.Weights, "items": hull_io.Weight,
        "resistance": hull_io.Resistance,
        "holtrop": hull_io.HoltropInputs, "delft": hull_io.DelftInputs,
        "michell": hull_io.MichellInputs,
        "developables": hull_io.Developable,
        "curves": hull_io.ControlCurve,
        "ties": hull_io.Tie, "groups": hull_io.PointGroup,
        "appendages": hull_io.Appendage,
        "plating": hull_io.Plating, "rules": hull_io.SeamRule, "ranges": hull_io.FrameRange,
        "fields": hull_io.ShapeField, "end": hull_io.FieldEnd,
    }  # fmt: skip
    for field in dataclasses.fields(cls):
        kind = parts.get(field.name)
        if before == "area_target." and field.name in ("base", "points"):
            kind = hull_io.AreaPoint
        if kind and before != "appendages.":
            yield from paths(kind, f"{before}{field.name}.")
        else:
            yield before + field.name


def test_of_everything_in_a_hull_it_is_said_how_it_follows():
    everything = list(paths(hull_io.HullData))
    assert len(everything) == len(set(everything)) > 60
    assert set(everything) == set(scaling.FOLLOWING) | scaling.STAYING
    assert not set(scaling.FOLLOWING) & scaling.STAYING
    assert set(scaling.FOLLOWING.values()) == {*scaling.CHANGES, "plane"}


@pytest.mark.parametrize("name", NAMES)
def test_the_surface_and_its_numbers_are_scaled_exactly(name):
    data = sample(name)
    made = hull_io.scaled(data, FACTORS)
    before, after = surface_of(data).tessellate(3).points, surface_of(made).tessellate(3).points
    size = np.abs(before).max()
    # Sums of some twenty products are rounded.
    assert np.abs(after - before * FACTORS).max() < 1e-14 * 20 * size
    x, y, z = FACTORS
    old, new = afloat(data), afloat(made)
    volume = x * y * z
    assert new.displaced_volume == pytest.approx(volume * old.displaced_volume, rel=1e-12)
    assert new.lcb == pytest.approx(x * old.lcb, abs=1e-12 * size)
    assert new.kb == pytest.approx(z * old.kb, abs=1e-12 * size)
    assert new.lcf == pytest.approx(x * old.lcf, abs=1e-12 * size)
    assert new.waterplane_area == pytest.approx(x * y * old.waterplane_area, rel=1e-12)
    assert new.bm_transverse == pytest.approx(y * y / z * old.bm_transverse, rel=1e-11)
    assert new.bm_longitudinal == pytest.approx(x * x / z * old.bm_longitudinal, rel=1e-11)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("change", (0.9, 1.1))
def test_all_samples_reach_their_dimensions(name, change):
    data = sample(name)
    wanted = {
        key: change * getattr(data.particulars, key) for key in ("length_pp", "beam", "draft")
    }
    made = hull_io.to_dimensions(data, **wanted)
    for key, value in wanted.items():
        assert getattr(made.particulars, key) == value
    old, new = (np.ptp(surface_of(one).tessellate(3).points, axis=0) for one in (data, made))
    np.testing.assert_allclose(new, change * old, rtol=1e-9)
    hydrostatics = afloat(made)
    np.testing.assert_allclose(
        hydrostatics.displaced_volume, change**3 * afloat(data).displaced_volume, rtol=1e-12
    )
    size = np.abs(made.points).max()
    for flat in made.flats:
        own = made.points[sorted({point for face in flat.faces for point in made.faces[face]})]
        assert np.linalg.norm(flat.normal) == pytest.approx(1.0, abs=1e-15)
        off = data_off(data, made, flat)
        assert np.abs(own @ flat.normal - flat.offset).max() <= off + 1e-12 * size
    assert made.creases == data.creases and made.corners == data.corners


def data_off(data, made, flat):
    """How far the points of the flat were from its plane before, and may be, as stretched."""
    before = data.flats[made.flats.index(flat)]
    own = data.points[sorted({point for face in before.faces for point in data.faces[face]})]
    return 1.2 * np.abs(own @ before.normal - before.offset).max()


def test_appendages_follow():
    """Their ends as points do, chords as the hull's length, cylinders as large as their volume."""
    data = sample("coaster")
    data.appendages = [
        hull_io.Appendage("tunnel", "cylinder", (80.0, -7.0, 2.0), (80.0, 7.0, 2.0), (0.7, 0.6)),
        hull_io.Appendage("keel", "foil", (40.0, 0.0, 1.0), (39.0, 0.0, -2.0), (6.0, 4.0), "0012"),
        hull_io.Appendage("bulb", "bulb", (42.0, 0.0, -2.0), (36.0, 0.0, -2.0), (1.0, 0.5), "0018"),
    ]
    made = hull_io.scaled(data, FACTORS).appendages
    for own, before in zip(made, data.appendages):
        assert own.start == pytest.approx(np.multiply(FACTORS, before.start), rel=1e-15)
        assert own.end == pytest.approx(np.multiply(FACTORS, before.end), rel=1e-15)
        assert (own.name, own.section, own.thicknesses) == (
            before.name, before.section, before.thicknesses,
        )  # fmt: skip
    assert made[1].sizes == pytest.approx((1.1 * 6.0, 1.1 * 4.0), rel=1e-15)
    volumes = [
        [hn.cylinder(one.start, one.end, one.sizes[0], end_radius=one.sizes[1]).volume,
         hn.bulb(two.section, two.start, two.end, two.sizes[0]).volume]
        for one, _, two in (data.appendages, made)
    ]  # fmt: skip
    assert volumes[1] == pytest.approx(np.prod(FACTORS) * np.array(volumes[0]), rel=1e-9)


def test_what_is_wanted_follows_and_variants_stay():
    data = sample("coaster")
    data.targets.rows = [hull_io.Target("section_area", 50.0, station=20.0)]
    data.area_target = hull_io.AreaTarget(
        [hull_io.AreaPoint(10.0, 40.0)], [hull_io.AreaPoint(30.0, 60.0)], "a table"
    )
    data.fields = [
        hull_io.ShapeField("Deck", 10.0, base="line", line=[(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)]),
        hull_io.ShapeField("Bow", 5.0, place=(80.0, 0.0, 5.0), shift=(1.0, 1.0, 1.0)),
    ]
    data.variants = [hull_io.Variant(sample("coaster"), "as built")]
    made = hull_io.scaled(data, (1.1, 0.9, 1.05))
    assert made.fields[0].extent == 1.1 * 10.0 and made.fields[0].falloff == 0.6
    np.testing.assert_allclose(made.fields[0].line[1], (4.4, 4.5, 6.3))
    np.testing.assert_allclose(made.fields[1].place, (88.0, 0.0, 5.25))
    np.testing.assert_allclose(made.fields[1].shift, (1.1, 0.9, 1.05))
    assert made.targets.rows == [hull_io.Target("section_area", 50.0, station=1.1 * 20.0)]
    assert made.area_target.base == [hull_io.AreaPoint(1.1 * 10.0, 40.0 * 0.9 * 1.05)]
    assert made.area_target.points == [hull_io.AreaPoint(1.1 * 30.0, 60.0 * 0.9 * 1.05)]
    assert np.array_equal(made.variants[0].hull.points, data.variants[0].hull.points)


def test_particulars_are_told_and_missing_ones_refused():
    data = sample("coaster")
    depth = data.particulars.depth
    made = hull_io.to_dimensions(data, draft=6.0)
    assert made.particulars.draft == 6.0
    assert made.particulars.depth == pytest.approx(depth * 6.0 / data.particulars.draft, rel=1e-15)
    assert made.particulars.length_pp == data.particulars.length_pp
    both = hull_io.to_dimensions(data, draft=5.0, depth=1.25 * depth)
    assert (both.particulars.draft, both.particulars.depth) == (5.0, 1.25 * depth)
    np.testing.assert_allclose(both.points[:, 2], 1.25 * data.points[:, 2], rtol=1e-15)
    for wrong in (0.0, -1.0, float("nan"), float("inf")):
        for name in ("length_pp", "beam", "draft", "depth"):
            with pytest.raises(ValueError, match="above zero"):
                hull_io.to_dimensions(data, **{name: wrong})
    with pytest.raises(ValueError, match="draft of nan"):
        hull_io.to_dimensions(data, draft=float("nan"), depth=8.0)
    with pytest.raises(ValueError, match="nearer"):
        hull_io.to_dimensions(data, length_pp=1e7)
    data.particulars.beam = 0.0
    with pytest.raises(ValueError, match="no beam"):
        hull_io.to_dimensions(data, beam=12.0)


def test_what_belongs_to_the_hull_follows():
    data = sample("coaster")
    data.afloat = hull_io.Afloat(0.5, 5.0)
    data.load = hull_io.Load(1000.0, 4.0, 40.0)
    data.load_cases = [hull_io.LoadCase("one", 500.0, 30.0, -0.5, 2.0)]
    data.downflooding_points = [hull_io.DownfloodingPoint("hatch", (10.0, 2.0, 8.0))]
    data.wind = hull_io.Wind(areas=[hull_io.WindArea("house", 50.0, 9.0)], keel_area=8.0)
    data.lines = hull_io.LineChoice(
        waterline_spacing=1.0, buttock_spacing=2.0, frame_spacing=0.6, stations="1 3:9:2",
        waterlines="0,5; 2", buttocks="nonsense", diagonals="4/45 5/90",
        planes=[hull_io.CutPlane("cant", (1.0, 1.0, 0.0), (60.0, 0.0, 0.0))],
    )  # fmt: skip
    made = hull_io.scaled(data, (2.0, 3.0, 4.0))
    assert made.afloat == hull_io.Afloat(2.0, 5.0)
    assert made.load == hull_io.Load(24000.0, 16.0, 80.0)
    assert made.load_cases == [hull_io.LoadCase("one", 12000.0, 60.0, -1.5, 8.0)]
    assert made.downflooding_points[0].position == (20.0, 6.0, 32.0)
    assert made.wind.areas == [hull_io.WindArea("house", 400.0, 36.0)]
    assert (made.wind.keel_area, made.wind.lever, made.wind.pressure) == (64.0, None, 504.0)
    lines = made.lines
    spacings = (lines.waterline_spacing, lines.buttock_spacing, lines.frame_spacing)
    assert spacings == (4.0, 6.0, 1.2)
    assert (lines.stations, lines.waterlines, lines.buttocks) == ("2 6:18:4", "2 8", "nonsense")
    assert lines.diagonals == "16/53.1301024 20/90"
    plane = lines.planes[0]
    assert plane.point == (120.0, 0.0, 0.0)
    assert np.linalg.norm(plane.normal) == pytest.approx(np.sqrt(2.0))
    assert plane.normal[0] / plane.normal[1] == pytest.approx(1.5)
    for point in ((60, 0, 5), (50, 10, 0), (55, 5, 1)):  # of the plane before
        there = np.multiply(point, (2.0, 3.0, 4.0)) - plane.point
        assert np.dot(plane.normal, there) == pytest.approx(0.0, abs=1e-12)
    data.lines.stations_in = "frames"
    assert hull_io.scaled(data, (2.0, 3.0, 4.0)).lines.stations == "1 3:9:2"
    assert data.load.mass_t == 1000.0  # the hull given stays


def test_inputs_of_the_resistance_follow_where_they_are_dimensional():
    """Those that are not given stay so, also where heights are shifted."""
    data = sample("coaster")
    own = data.resistance
    own.thruster_diameter, own.planing_mass_t, own.planing_lcg = 1.0, 5.0, 3.0
    own.holtrop = hull_io.HoltropInputs(
        length=80.0, beam=12.0, draft_aft=5.0, displaced_volume=10.0, midship=0.9,
        wetted_surface=100.0, bulb_area=2.0, entrance_angle_deg=20.0,
    )  # fmt: skip
    own.delft = hull_io.DelftInputs(
        waterplane_area=50.0, lcb=4.0, prismatic=0.5, keel_wetted_surface=4.0, keel_volume=0.5,
        keel_centre=-0.25, keel_thickness=0.1, rudder_chord=0.5,
    )  # fmt: skip
    own.michell = hull_io.MichellInputs(80.0, 100.0)
    own.pitch_ratio, own.blade_area_ratio, own.thruster_coefficient = 1.1, 0.7, 0.004
    made = scaling.follow(data, scaling.Scale((2.0, 3.0, 4.0), (0.0, 0.0, 1.0))).resistance
    assert (made.thruster_diameter, made.planing_mass_t, made.planing_lcg) == (4.0, 120.0, 6.0)
    surface = made.holtrop.wetted_surface
    assert surface == pytest.approx(100.0 * 24.0 ** (2.0 / 3.0), rel=1e-14)
    assert made.holtrop == hull_io.HoltropInputs(
        length=160.0, beam=36.0, draft_aft=21.0, displaced_volume=240.0, midship=0.9,
        wetted_surface=surface, bulb_area=24.0, entrance_angle_deg=20.0,
    )  # fmt: skip
    assert made.delft == hull_io.DelftInputs(
        waterplane_area=300.0, lcb=8.0, prismatic=0.5, keel_wetted_surface=32.0, keel_volume=12.0,
        keel_centre=-1.0, keel_thickness=0.1, rudder_chord=1.0,
    )  # fmt: skip
    assert made.michell == hull_io.MichellInputs(160.0, surface)
    coefficients = made.pitch_ratio, made.blade_area_ratio, made.thruster_coefficient
    assert coefficients == (1.1, 0.7, 0.004)
    # Of a hull that keeps its proportions a wetted surface grows as any area does.
    assert scaling.Scale((2.0, 2.0, 2.0)).surface(3.0) == pytest.approx(12.0)


def test_a_shift_moves_places_and_leaves_lengths():
    scale = scaling.Scale((2.0, 1.0, 1.0), (3.0, 0.0, 0.0))
    assert scale.listed(0, "1 2:6:2") == "5 7:15:4"
    normal, offset = scale.plane((0.6, 0.0, 0.8), 5.0)
    for point in ((3.0, 1.0, 4.0), (7.0, 2.0, 1.0)):
        assert np.dot(normal, scale.points(point)) == pytest.approx(offset)
    assert scale.plane((1.0, 0.0, 0.0), 5.0)[1] == 13.0


def test_scaled_hulls_are_written_and_read(tmp_path):
    made = hull_io.to_dimensions(sample("roro"), length_pp=180.0, beam=26.0, draft=7.0)
    hull_io.write_hull_file(made, tmp_path / "made.hull.json")
    again = hull_io.read_hull(tmp_path / "made.hull.json")
    assert np.array_equal(again.points, made.points)
    assert again.particulars == made.particulars and again.lines == made.lines


@pytest.mark.parametrize("given", [0.0, 1.5])
def test_what_is_not_given_stays_so_where_a_hull_is_moved_up(given):
    """0 of a draft, depth or KG stands for none; that of a point is a height."""
    data = sample("coaster")
    holtrop = data.resistance.holtrop
    data.particulars.draft = data.particulars.depth = data.load.kg = given
    holtrop.draft_forward = holtrop.draft_aft = holtrop.bulb_height = given
    data.load_cases = [hull_io.LoadCase("ballast", 8.0, 5.0, 0.0, 0.0)]
    made = scaling.follow(data, moving.upwards(0.5, heights_stay=False))
    wanted = given + 0.5 if given else 0.0
    ship, holtrop = made.particulars, made.resistance.holtrop
    assert [ship.draft, ship.depth, made.load.kg] == [wanted] * 3
    assert [holtrop.draft_forward, holtrop.draft_aft, holtrop.bulb_height] == [wanted] * 3
    assert made.load_cases[0].vcg == 0.5 and (made.points == data.points + (0, 0, 0.5)).all()
