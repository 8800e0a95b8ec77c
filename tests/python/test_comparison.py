# SPDX-License-Identifier: GPL-3.0-or-later
"""One hull beside another in plain Python: differences against direct evaluation and closed forms,
distances where they are known."""

import itertools
import os
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
FREESHIP = SAMPLES.parents[1] / "shared" / "hulls" / "freeship"
NAMES = sorted(path.name.split(".")[0] for path in SAMPLES.glob("*.hull.json"))
SEED = 20261123
# Long runs are for a developer: all pairs of samples, and the FREE!ship files.
LONG = os.environ.get("HULL_COMPARE_ALL") == "1"


def read(path, factors=(1.0, 1.0, 1.0)):
    """(LimitSurface, whether it is a half, ComparedHull at the draft of the file)."""
    data = hull_io.read_hull(path)
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(
        shell.points * factors,
        shell.face_sizes,
        shell.face_vertices,
        creases=shell.creases,
        corners=shell.corners,
    )
    surface = hn.LimitSurface(mesh, data.scheme)
    body = hn.HullBody(surface, mirrored=data.half, openings="closed")
    given = data.particulars
    compared = hn.ComparedHull(
        body,
        given.draft * factors[2],
        length_pp=given.length_pp * factors[0] or None,
        beam=given.beam * factors[1] or None,
    )
    return surface, data.half, compared


def sample(name, factors=(1.0, 1.0, 1.0)):
    return read(SAMPLES / f"{name}.hull.json", factors)


def box(length=10.0, half_breadth=2.0, depth=3.0, whole=False):
    """A box open at the top, its port half or the whole: the surface is the box itself."""
    low = -half_breadth if whole else 0.0
    points = np.array(
        [[x, y, z] for x in (0.0, length) for y in (low, half_breadth) for z in (0.0, depth)]
    )
    faces = [(2, 3, 7, 6), (0, 2, 6, 4), (0, 1, 3, 2), (4, 6, 7, 5)]
    faces += [(0, 4, 5, 1)] if whole else []
    edges = {tuple(sorted(pair)) for face in faces for pair in zip(face, face[1:] + face[:1])}
    mesh = hn.ControlMesh(points, [4] * len(faces), np.ravel(faces), creases=np.array(list(edges)))
    return hn.LimitSurface(mesh)


def lying(surface, draft, mirrored=True, **more):
    body = hn.HullBody(surface, mirrored=mirrored, openings="closed")
    return hn.ComparedHull(body, draft, **more)


def by_name(comparison):
    return {row.quantity: row for row in comparison.rows}


def test_every_number_is_that_of_hydrostatics():
    _, _, hull = sample("coaster", (1.02, 1.05, 1.1))
    _, _, other = sample("coaster")
    rows = by_name(hn.compare_hulls(hull, other))
    found, others = hull.hydrostatics(), other.hydrostatics()
    assert len(rows) > 40 and "draft" not in rows and "volume_error" not in rows
    for name, row in rows.items():
        value = wanted = found
        beside = others
        for part in name.split("."):
            wanted, beside = getattr(wanted, part), getattr(beside, part)
        value = row.value
        assert value == (wanted or value), name
        if row.difference is not None:
            assert row.difference == wanted - beside, name
        if row.percent is not None and name.startswith(("displace", "k", "wetted", "project")):
            assert row.percent == pytest.approx(100.0 * (wanted / beside - 1.0), rel=1e-9), name


def test_percentages_mean_something():
    """Along the ship they are of Lpp; of what is zero but for rounding there are none."""
    rows = by_name(hn.compare_hulls(sample("roro")[2], sample("coaster")[2]))
    lpp = sample("coaster")[2].length_pp
    for name in ("lcb", "lcf", "lateral_x", "largest_section.position"):
        assert rows[name].percent == pytest.approx(100.0 * rows[name].difference / lpp)
    assert rows["lcb_percent"].percent is None and rows["lcb_percent"].difference is not None
    assert rows["tcb"].percent is None
    without = hn.compare_hulls(lying(box(), 1.0), lying(box(), 1.0))
    assert by_name(without)["lcb"].percent is None
    assert by_name(without)["project.block"].value is None
    assert by_name(without)["project.block"].difference is None


@pytest.mark.parametrize("name", ["barge", "container_ship", "catamaran"])
def test_an_affine_image_differs_as_its_factors_say(name):
    """Integrals are to 1e-9 of the whole; what follows from them is as close."""
    a, b, c = factors = 1.03, 0.97, 1.05
    rows = by_name(hn.compare_hulls(sample(name, factors)[2], sample(name)[2]))
    for quantity, factor in (
        ("displaced_volume", a * b * c),
        ("waterplane_area", a * b),
        ("waterline_length", a),
        ("immersed_beam", b),
        ("kb", c),
        ("project.block", 1.0),
        ("bm_transverse", b * b / c),
        ("bm_longitudinal", a * a / c),
        ("midship_section.area", b * c),
    ):
        assert rows[quantity].percent == pytest.approx(100.0 * (factor - 1.0), abs=1e-6), quantity


def test_areas_of_boxes():
    hull, other = lying(box(), 1.0), lying(box(half_breadth=1.5), 2.0)
    found = hn.compare_areas(hull, other, stations=[-1.0, 2.5, 5.0, 11.0])
    assert found.areas == pytest.approx([0.0, 4.0, 4.0, 0.0])
    assert found.other_areas == pytest.approx([0.0, 6.0, 6.0, 0.0])
    assert found.differences == pytest.approx([0.0, -2.0, -2.0, 0.0])
    assert found.largest == pytest.approx(-2.0) and 0.0 < found.largest_at < 10.0
    # Where one of them ends the whole area is missing.
    longer = hn.compare_areas(lying(box(length=12.0), 1.0), hull)
    assert longer.largest == pytest.approx(4.0) and 10.0 < longer.largest_at < 12.0


def test_the_largest_difference_of_areas_is_found_between_the_stations():
    hull, other = sample("coaster", (1.0, 1.1, 1.0))[2], sample("coaster", (1.05, 1.0, 1.0))[2]
    found = hn.compare_areas(hull, other, stations=[20.0, 60.0])
    x = np.linspace(-5.0, 95.0, 4001)
    brute = np.abs(hull.areas(x) - other.areas(x)).max()
    # The parts between stations are a 161st of a 32nd of the length: a parabola's top is met to
    # 1e-6 of what it falls there.
    assert abs(found.largest) == pytest.approx(brute, rel=1e-5)


def test_nothing_under_water_is_told():
    with pytest.raises(ValueError, match="Nothing is under water at a draft of -1.000 m"):
        hn.compare_hulls(lying(box(), 1.0), lying(box(), -1.0))


def test_distances_of_boxes():
    """Wider by 0.5: outside at the side, nothing at the bottom but where it sticks out."""
    wider, field = box(half_breadth=2.5), hn.DistanceField(box(), mirrored=True)
    places = [
        ([5.0, 2.5, 1.5], 0.5),  # side
        ([5.0, -2.5, 1.5], 0.5),  # the other one
        ([5.0, 1.0, 0.0], 0.0),
        ([5.0, 0.5, 0.25], -0.25),  # inside, over the bottom
        ([0.5, 0.25, 1.5], -0.5),  # at the end
        ([5.0, 2.5, -0.5], np.hypot(0.5, 0.5)),  # off the bilge knuckle
        ([5.0, 2.5, 3.0], 0.5),  # at the sheer, across
        ([5.0, 2.0, 3.5], np.nan),  # above the sheer
        ([5.0, 2.1, 3.5], np.nan),
        ([5.0, 2.5, 3.1], np.hypot(0.5, 0.1)),
        ([5.0, 0.0, -0.25], 0.25),  # below the keel, whose border is none: it is mirrored
    ]
    found = field.distances([point for point, _ in places])
    np.testing.assert_allclose(found, [wanted for _, wanted in places], atol=1e-12)
    result = hn.surface_distances(wider, wider.tessellate(8), field)
    assert result.outwards == pytest.approx(0.5, abs=1e-12) and result.inwards is None
    assert result.outwards_at[1] == pytest.approx(2.5)
    # But for the two upper corners, where the point is in the plane of the end, off its border.
    assert result.share == pytest.approx(1.0, abs=2e-3)
    # Of 30 + 2 * 7.5 + 25 m² the side is 0.5 off; of bottom and ends what sticks out, at an
    # average 0.25 over a width of 0.5.
    side, others = 30.0 * 0.5, 0.5 * 0.25 * (10.0 + 2.0 * 3.0)
    assert result.mean_size == pytest.approx((side + others) / 70.0, rel=1e-2)


def test_what_lies_beyond_the_borders_has_no_distance():
    higher, field = box(depth=4.0), hn.DistanceField(box(), mirrored=True)
    result = hn.surface_distances(higher, higher.tessellate(16), field)
    assert result.outwards is None and result.inwards is None and result.rms == 0.0
    area = 2.0 * 10.0 + (10.0 + 2.0 * 2.0) * 4.0
    assert result.share == pytest.approx(1.0 - 14.0 / area, abs=0.02)
    nothing = hn.surface_distances(higher, higher.tessellate(2), _far_field())
    assert nothing.share == 0.0 and nothing.rms is None and nothing.outwards is None


def _far_field():
    """Of a patch that no point of the box is across from."""
    mesh = hn.ControlMesh(
        [[50.0, 9.0, 0.0], [51.0, 9.0, 0.0], [51.0, 9.0, 1.0], [50.0, 9.0, 1.0]],
        [4], [0, 1, 2, 3], corners=[0, 1, 2, 3],
    )  # fmt: skip
    return hn.DistanceField(hn.LimitSurface(mesh), mirrored=False)


def test_halves_and_wholes():
    """The same distances whichever of both is modelled as a half."""
    for mirrored in (True, False):
        field = hn.DistanceField(box(whole=not mirrored), mirrored=mirrored)
        for whole in (True, False):
            hull = box(half_breadth=2.5, depth=2.5, whole=whole)
            found = hn.surface_distances(hull, hull.tessellate(8), field)
            assert found.outwards == pytest.approx(0.5, abs=1e-12)
            assert found.inwards is None and found.share == pytest.approx(1.0)


def test_an_offset_of_known_distance():
    """Points shifted along the normals of a smooth hull, by less than its radii, are that far."""
    surface, half, _ = sample("naval_vessel")
    random = np.random.default_rng(SEED)
    cells = random.integers(surface.cell_count, size=400)
    uv = random.uniform(0.02, 0.98, (400, 2))
    points, normals = surface.positions(cells, uv), surface.normals(cells, uv)
    field = hn.DistanceField(surface, mirrored=half)
    shifts = random.choice([-1e-4, 1e-4, 1e-3], 400)
    found = field.distances(points + shifts[:, None] * normals)
    # Near knuckles and the centre plane another part of the hull may be nearer, never farther.
    known = np.isfinite(found)
    assert known.mean() > 0.98
    assert np.all(np.abs(found[known]) <= np.abs(shifts[known]) + 1e-12)
    as_told = np.abs(found - shifts)[known] < 1e-9
    assert as_told.mean() > 0.97


def test_a_surface_is_on_itself():
    surface, half, _ = sample("research_vessel")
    found = hn.surface_distances(
        surface, surface.tessellate(5), hn.DistanceField(surface, mirrored=half)
    )
    assert found.share == 1.0 and found.rms < 1e-12
    assert found.outwards in (None, pytest.approx(0.0, abs=1e-11))


def test_distances_can_be_coloured():
    scale = hn.colour_scale([-0.5, 0.0, 2.0], kind="distance", percentile=1.0)
    assert scale.signed and scale.unit == "mm" and (scale.low, scale.high) == (-2.0, 2.0)
    assert scale.tick_values.max() == 2000.0 and scale.tick_positions[-1] == 1.0
    with pytest.raises(ValueError, match="surface_distances"):
        surface = box()
        hn.surface_field(surface, surface.tessellate(2), kind="distance")


def test_pairs_of_samples():
    """Any hull beside any other: what one is more the other is less, and nothing fails."""
    pairs = list(itertools.combinations(NAMES, 2))
    random = np.random.default_rng(SEED)
    chosen = pairs if LONG else [pairs[i] for i in random.choice(len(pairs), 4, replace=False)]
    hulls = {name: sample(name) for pair in chosen for name in pair}
    for one, other in chosen:
        check_pair(hulls[one], hulls[other])


def check_pair(one, other):
    there = by_name(hn.compare_hulls(one[2], other[2]))
    back = by_name(hn.compare_hulls(other[2], one[2]))
    for name, row in there.items():
        if row.difference is not None:
            assert np.isfinite(row.difference) and row.difference == -back[name].difference, name
    field = hn.DistanceField(other[0], mirrored=other[1])
    found = hn.surface_distances(one[0], one[0].tessellate(3), field)
    assert 0.0 <= found.share <= 1.0
    if found.rms is not None:
        known = found.values[np.isfinite(found.values)]
        assert found.mean_size <= found.rms * (1.0 + 1e-12)
        assert (found.outwards or 0.0) >= known.max() - 1e-12
        assert (found.inwards or 0.0) <= known.min() + 1e-12


@pytest.mark.skipif(not LONG, reason="a long run: HULL_COMPARE_ALL=1")
def test_pairs_of_foreign_hulls():
    if not FREESHIP.is_dir():
        pytest.skip(f"reference data missing: {FREESHIP}")
    hulls = []
    for path in sorted(FREESHIP.glob("*.f?m")):
        try:
            hulls.append((path.name, read(path)))
        except ValueError as error:
            print(f"{path.name}: {error}")
    for (name, one), (other_name, other) in itertools.permutations(hulls, 2):
        try:
            check_pair(one, other)
        except ValueError as error:
            print(f"{name} beside {other_name}: {error}")
