# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to main dimensions while bilge, bulb or knuckles keep their shape."""

import re
import sys
from copy import deepcopy
from dataclasses import replace
from math import inf
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io import stretching
from hull_io.mirror import mirror_faces

SAMPLES = Path(__file__).resolve().parents[3] / "samples"


def sample(name):
    return hull_io.read_hull(SAMPLES / f"{name}.hull.json")


def surface_of(data):
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.LimitSurface(mesh, data.scheme)


def body_of(data):
    return hn.HullBody(surface_of(data), mirrored=data.half)


def stretched_axis(kept, factor, extent=(-2.0, 100.0), anchors=(0.0, 90.0), **more):
    return stretching.axis_stretch(
        "length", kept, extent=extent, anchors=anchors, present=90.0, wanted=factor * 90.0, **more
    )


@pytest.mark.parametrize("kept", ([(90.0, inf)], [(-inf, 20.0)], [(20.0, 35.0), (60.0, 70.0)]))
@pytest.mark.parametrize("factor", (0.8, 1.25))
def test_the_map_keeps_ranges_and_meets_the_dimension(kept, factor):
    own = stretched_axis(kept, factor)
    assert own(90.0) - own(0.0) == pytest.approx(factor * 90.0, rel=1e-14)
    assert own(0.0) == 0.0
    x = np.linspace(-5.0, 105.0, 20001)
    # The integral and the weight are written separately: each is the other's derivative, to the
    # second order of the differences.
    slopes = np.diff(own(x)) / np.diff(x)
    assert np.abs(slopes - own.slope(0.5 * (x[1:] + x[:-1]))).max() < 1e-6
    assert slopes.min() > 0.1
    # Twice continuously differentiable: second differences have no jump.
    assert np.abs(np.diff(own.slope(x), 2)).max() < 1e-4
    for begin, end in kept:
        inside = x[(x >= begin) & (x <= end)]
        assert np.ptp(own(inside) - inside) < 1e-12
    assert np.abs(own.inverse(own(x)) - x).max() < 1e-11


def test_a_beam_is_stretched_to_both_sides():
    own = stretched_axis([(30.0, inf)], 1.1, extent=(0.0, 45.0), anchors=(0.0, 45.0), mirrored=True)
    y = np.linspace(-50.0, 50.0, 101)
    assert np.array_equal(own(y), -own(-y))
    assert own(45.0) == pytest.approx(49.5, rel=1e-14)
    assert np.abs(own.inverse(own(y)) - y).max() < 1e-11


def test_what_cannot_be_is_refused_with_what_can_be_reached():
    for factor in (10.0, 0.05):
        with pytest.raises(ValueError, match=r"the length can become .* to .* m, not") as told:
            stretched_axis([(90.0, inf)], factor)
        reach = re.search(r"become (\S+) to (\S+) m", str(told.value)).groups()
        for value, outwards in zip(reach, (0.999, 1.001)):
            factor = float(value) / 90.0
            stretched_axis([(90.0, inf)], factor / outwards)
            with pytest.raises(ValueError):
                stretched_axis([(90.0, inf)], factor * outwards)
    with pytest.raises(ValueError, match="Nothing is left"):
        stretched_axis([(-inf, inf)], 1.1)


# Where control points leave it the bilge is kept to rounding: coarser meshes shape it from the
# centre plane on, and it changes by the part of the smooth map that reaches it.
@pytest.mark.parametrize("name, bound", [("bulk_carrier", 1e-9), ("coaster", 1e-3), ("roro", 2e-3)])
def test_the_bilge_radius_is_kept(name, bound):
    data = sample(name)
    now = data.particulars
    made, mapped = hull_io.to_dimensions_keeping(
        data, hn, ("bilge",), beam=1.1 * now.beam, draft=1.06 * now.draft
    )
    assert (made.particulars.beam, made.particulars.draft) == (1.1 * now.beam, 1.06 * now.draft)
    assert made.particulars.length_pp == now.length_pp
    before = hn.bilge_of(body_of(data), now.draft)
    after = hn.bilge_of(body_of(made), now.draft, before.x)
    assert after.radius == pytest.approx(before.radius, rel=bound)
    plain = hn.bilge_of(
        body_of(hull_io.to_dimensions(data, beam=1.1 * now.beam, draft=1.06 * now.draft)),
        now.draft, before.x,
    )  # fmt: skip
    assert plain.radius > 1.04 * before.radius
    low, high = hn.surface_ends(surface_of(made))
    old_low, old_high = hn.surface_ends(surface_of(data))
    assert high[1] == pytest.approx(1.1 * old_high[1], rel=1e-9)
    assert (low[0], high[0]) == pytest.approx((old_low[0], old_high[0]), abs=1e-9)
    assert mapped.ends_missed < 1e-9
    assert mapped.rms < 1e-3 * now.beam
    for flat in made.flats:
        own = made.points[sorted({point for face in flat.faces for point in made.faces[face]})]
        assert np.abs(own @ flat.normal - flat.offset).max() < 1e-12 * np.abs(made.points).max()


def test_the_bulb_moves_as_one_and_lpp_is_met():
    data = sample("bulk_carrier")
    now = data.particulars
    made, mapped = hull_io.to_dimensions_keeping(data, hn, ("bulb",), length_pp=1.1 * now.length_pp)
    longer = 0.1 * now.length_pp
    before = surface_of(data).evaluate_grid(8)[0].reshape(-1, 3)
    after = surface_of(made).evaluate_grid(8)[0].reshape(-1, 3)
    bulb = (before[:, 0] > now.length_pp) & (before[:, 2] < now.draft)
    assert bulb.sum() > 100
    assert np.abs(after[bulb] - before[bulb] - (longer, 0.0, 0.0)).max() < 1e-9
    ends = [hn.surface_ends(surface_of(one))[1][0] for one in (data, made)]
    assert ends[1] - ends[0] == pytest.approx(longer, abs=1e-9)
    assert made.particulars.length_pp == 1.1 * now.length_pp and mapped.ends_missed < 1e-9


def test_knuckles_keep_their_heights_and_the_depth_is_met():
    data = sample("container_ship")
    now = data.particulars
    kept_of = {"draft": now.draft, "depth": now.depth, "knuckles": True}
    height = hn.kept_ranges(body_of(data), **kept_of)[2][0][1]
    assert now.draft < height < now.depth
    made, _ = hull_io.to_dimensions_keeping(data, hn, ("knuckles",), depth=1.1 * now.depth)
    kept = 0
    curves = [hn.crease_curves(surface_of(one)) for one in (data, made)]
    for old, new in zip(*curves):
        # A crease that ends within the surface is shaped there by what is around it: left out.
        t = np.linspace(4.0, old.edge_count, 10 * old.edge_count) if old.edge_count > 4 else [0.0]
        before, after = old.evaluate(t)[0][:, 2], new.evaluate(t)[0][:, 2]
        if old.kind == "crease" and before.max() < now.depth:
            kept += 1
            assert np.abs(after - before).max() < 1e-9
    assert kept and made.particulars.depth == 1.1 * now.depth
    assert made.particulars.draft == now.draft  # below the knuckles


def test_fine_meshes_are_brought_nearer_too(monkeypatch):
    data = sample("coaster")
    surface = surface_of(data)
    for _ in range(2):
        surface = hn.LimitSurface(surface.refined_mesh(), data.scheme)
    now, body = data.particulars, hn.HullBody(surface, mirrored=data.half)
    assert 1500 < len(surface.mesh.points) < 2000
    kept = hn.kept_ranges(body, draft=now.draft, depth=now.depth, bilge=True)
    wanted = {"beam": 1.1 * now.beam, "draft": 1.05 * now.draft}
    stretch = stretching.stretch_to(now, kept, *hn.surface_ends(surface), **wanted)
    mapped = hn.map_surface(surface, stretch)
    monkeypatch.setattr(sys.modules[hn.map_surface.__module__], "_MOST_POINTS", 1)
    plain = hn.map_surface(surface, stretch)
    assert mapped.rms < 0.7 * plain.rms and mapped.largest < 0.7 * plain.largest
    assert mapped.ends_missed < 1e-9


def test_a_knuckle_that_leaves_no_side_to_grow_says_so():
    data = sample("roro")
    with pytest.raises(ValueError, match="leaves 0.75 m of the depth of 15.5 m .* or keep less"):
        hull_io.to_dimensions_keeping(data, hn, ("knuckles",), depth=1.05 * data.particulars.depth)


@pytest.mark.parametrize(
    "name, keep, said",
    [
        ("planing_boat", "bilge", "no bilge arc"),
        ("sailing_yacht", "bilge", "no bottom"),
        ("coaster", "bulb", "no bulb"),
        ("coaster", "knuckles", "no knuckle"),
        ("coaster", "deck", "bilge, bulb, knuckles can be kept, not deck"),
    ],
)
def test_what_a_hull_does_not_have_cannot_be_kept(name, keep, said):
    with pytest.raises(ValueError, match=said):
        hull_io.to_dimensions_keeping(sample(name), hn, (keep,), beam=5.0)


def test_a_bilge_beyond_the_hull_or_above_the_water_is_refused():
    body = body_of(sample("coaster"))
    with pytest.raises(ValueError, match="no section at x 1000.00 m: choose a place within it"):
        hn.bilge_of(body, 5.0, 1000.0)
    with pytest.raises(ValueError, match="Nothing is under water at a draft of -3.000 m"):
        hn.bilge_of(body, -3.0)


def test_nonsense_is_refused_and_factors_stay_what_they_are():
    data = sample("coaster")
    points = data.points.copy()
    for beam in (float("nan"), 0.0, -1.0, 10.0 * data.particulars.beam, 1e9):
        with pytest.raises(ValueError):
            hull_io.to_dimensions_keeping(data, hn, ("bilge",), beam=beam)
    assert np.array_equal(data.points, points)
    without_draft = deepcopy(data)
    without_draft.particulars.draft = 0.0
    with pytest.raises(ValueError, match="a draft first"):
        hull_io.to_dimensions_keeping(without_draft, hn, ("bilge",), beam=15.0)
    # Lengthwise nothing of the bilge is kept: the exact factor does it.
    made, mapped = hull_io.to_dimensions_keeping(data, hn, ("bilge",), length_pp=90.0)
    assert mapped is None
    assert np.array_equal(made.points, hull_io.to_dimensions(data, length_pp=90.0).points)


def test_places_on_the_hull_follow_the_map():
    data = sample("bulk_carrier")
    now = data.particulars
    data.downflooding_points = [hull_io.DownfloodingPoint("fore", (now.length_pp + 2.0, 1.0, 30.0))]
    data.lines = hull_io.LineChoice(frame_spacing=0.8)
    made, _ = hull_io.to_dimensions_keeping(data, hn, ("bulb",), length_pp=1.05 * now.length_pp)
    assert made.downflooding_points[0].position[0] == pytest.approx(1.05 * now.length_pp + 2.0)
    assert made.lines.frame_spacing == pytest.approx(0.84)


def test_whole_hulls_are_stretched_as_halves_are():
    half = sample("coaster")
    whole = replace(deepcopy(half), half=False)
    mirror_faces(whole, range(len(half.faces)))
    made = [
        hull_io.to_dimensions_keeping(one, hn, ("bilge",), beam=1.1 * half.particulars.beam)
        for one in (half, whole)
    ]
    assert made[0][1].rms == pytest.approx(made[1][1].rms, rel=0.1)
    y = hn.surface_ends(surface_of(made[1][0]))
    assert (y[0][1], y[1][1]) == pytest.approx((-1.1 * 6.8, 1.1 * 6.8), abs=1e-9)
