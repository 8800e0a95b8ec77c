# SPDX-License-Identifier: GPL-3.0-or-later
"""The published examples of shape fields (Veelo 2004, 6.1 and 6.2) on hulls of ours."""

from functools import cache

import hull_native as hn
import numpy as np
import pytest
import vessels
from field_replays import bulb, follow
from field_replays import frigate as replay
from field_replays import profile_number, refined, waterline
from hull_fairness import kinks, lines

pytestmark = pytest.mark.one_in(2)

# Where marks of the frigate's fore ship are counted.
FORE_SHIP = np.array([60.0, -1.0, -5.0]), np.array([200.0, 20.0, 20.0])
# Where marks of the bulb are looked for: abaft nothing moves.
BOW = np.array([60.0, -1.0, -5.0]), np.array([200.0, 20.0, 20.0])
# Less of a shift is none, m.
NO_SHIFT = 1e-5


@cache
def frigate(subdivided=0):
    return refined(vessels.vessel(replay.NAME).surface, subdivided)


def beam():
    return vessels.vessel(replay.NAME).data.particulars.beam


def inflections(surface):
    """How many the waterlines of the frigate's fore ship have together."""
    judged = lines.judged(surface, beam(), within=FORE_SHIP)
    return sum(
        found.mark == "inflection"
        for line in judged
        if line.kind == "waterline"
        for found in line.found
    )


def narrowed(surface, protected):
    """The surface and hull_native.Reshaped; followed to within a few centimetres, unfolded."""
    moved, result = follow(surface, replay.narrowing(surface, protected))
    assert result.folded_place is None
    assert result.rms < 3e-3 and result.largest < 0.02
    point = replay.point_of_narrowing(surface)
    wanted = point - [0.0, replay.NARROWER, 0.0]
    assert hn.SurfaceTree(moved).closest_points(wanted[None]).distances[0] < 0.01
    return moved, result


@pytest.mark.parametrize("subdivided", [0, 1])
def test_narrowed_waterlines_inflect_by_what_the_stem_is_protected_with(subdivided):
    surface = frigate(subdivided)
    before = inflections(surface)
    counts = {"plane, falloff 1": inflections(narrowed(surface, replay.plane_protected(1.0))[0])}
    for falloff in (1.0, replay.STEM_FALLOFF):
        protected = replay.stem_protected(surface, falloff)
        counts[f"stem, falloff {falloff}"] = inflections(narrowed(surface, protected)[0])
    print("before", before, counts)
    recommended = counts.pop(f"stem, falloff {replay.STEM_FALLOFF}")
    assert recommended == before == 4
    assert min(counts.values()) >= 18


def test_the_knuckle_stays_a_crease_where_it_moves():
    surface = frigate()
    protected = replay.stem_protected(surface, replay.STEM_FALLOFF)
    fields = replay.narrowing(surface, protected)
    moved, _ = narrowed(surface, protected)
    number = replay.knuckle(surface)
    before, after = (hn.crease_curves(s)[number] for s in (surface, moved))
    assert np.array_equal(moved.mesh.creases, surface.mesh.creases)
    assert np.array_equal(after.vertices, before.vertices)
    t = np.linspace(0.0, before.edge_count, 200)
    (points,), (there,) = before.evaluate(t), after.evaluate(t)
    assert np.abs(there - points).max() > 0.4
    wanted = hn.FieldCurve(points + fields.at(points)[0])
    assert wanted.distances(there).max() < 0.02
    # No less of a knuckle anywhere: by less than a degree.
    angles = [hn.knuckle_angles(s, number).angles for s in (surface, moved)]
    np.testing.assert_allclose(angles[1], angles[0], atol=np.radians(1.0))
    # One curve, seen from both sides.
    tree = hn.SurfaceTree(moved)
    assert tree.closest_points(there).distances.max() < 1e-12 * surface.mesh.size


@pytest.mark.parametrize("subdivided", [0, 1])
def test_a_protected_knuckle_stays_where_it_is(subdivided):
    surface = frigate(subdivided)
    number = replay.knuckle(surface)
    crease = hn.crease_curves(surface)[number]
    curve = hn.FieldCurve.of_crease(crease)
    protected = replay.stem_protected(surface, replay.STEM_FALLOFF)
    protected.append(hn.ShapeField.along(curve, extent=8.0, falloff=0.5, protects=True))
    fields = replay.narrowing(surface, protected)
    moved, result = follow(surface, fields, kept=crease.vertices)
    assert result.folded_place is None and np.abs(result.moves[:, 1]).max() > 0.4
    assert not result.moves[crease.vertices].any()
    t = np.linspace(0.0, crease.edge_count, 200)
    apart = hn.crease_curves(moved)[number].evaluate(t)[0] - crease.evaluate(t)[0]
    assert np.abs(apart).max() < 1e-12 * surface.mesh.size
    # The field is level at its base, the surface has no second derivative across a crease: its
    # sides turn in proportion to the distance of control points.
    angles = [hn.knuckle_angles(s, number).angles for s in (surface, moved)]
    np.testing.assert_allclose(angles[1], angles[0], atol=np.radians(9.0 / 2**subdivided))


@cache
def plain_bow(subdivided=bulb.SUBDIVIDED):
    return refined(vessels.surface_of(bulb.plain_bow()), subdivided)


@cache
def bulb_steps():
    return list(bulb.steps(plain_bow()))


def test_fields_around_a_sharply_bent_stem_fold_the_bow():
    """Which is told; so the bulb begins with a base beside the stem."""
    surface = plain_bow(1)
    wanted, _ = bulb.wanted_profile(surface)
    fields = bulb.onto_profile(surface, wanted, extent=bulb.EXTENT)
    x, _, z = follow(surface, fields)[1].folded_place
    assert 97.0 < x < 100.0 and 2.0 < z < 6.0


def test_the_bulb_is_on_the_wanted_profile():
    wanted, wanted_bulb = bulb.wanted_profile(plain_bow())
    assert hn.FieldCurve(bulb.fore_profile(plain_bow())).distances(wanted_bulb).max() > 4.0
    apart = []
    for step in bulb_steps():
        assert step.result.folded_place is None
        curve = hn.crease_curves(step.surface)[profile_number(step.surface)]
        (line,) = curve.evaluate(np.linspace(0.0, curve.edge_count, 32 * curve.edge_count + 1))
        fore = line[:, 0] > bulb.AFT_END + 1.0
        apart.append(wanted.distances(line[fore]).max())
        rms, largest = step.result.rms, step.result.largest
        print(step.name, "rms", rms, "largest", largest, "from the profile", apart[-1])
        assert np.abs(line[:, 1]).max() < 1e-12 * step.surface.mesh.size
    assert apart[0] < 0.3 and max(apart[1:]) < 1e-3
    # And no part of it is missing.
    assert hn.FieldCurve(line[fore]).distances(wanted_bulb).max() < 1e-3


def test_the_bulb_is_fuller_than_a_drawn_out_stem():
    breadths = []
    for step in (bulb_steps()[1], bulb_steps()[-1]):
        points = waterline(step.surface, bulb.TIP_Z)[::-1]
        breadths.append(np.interp([99.0, 100.0, 101.0, 102.0], points[:, 0], points[:, 1]))
    print("half-breadths", *breadths)
    assert (breadths[1] > 1.25 * breadths[0]).all()


@cache
def plain_marks():
    return marks(plain_bow())


def marks(surface):
    """(name of the line, kind, place (3,)) of all marks on the bow."""
    return [
        (line.name, found.mark, np.array(found.point))
        for line in lines.judged(surface, bulb.BEAM, within=BOW)
        for found in line.found
    ]


def new_where_nothing_shifts(surface, fields):
    """(new marks where none of several hull_native.ShapeFields shifts, how many are there)."""
    found = marks(surface)
    places = np.array([place for *_, place in found])
    shifts = [np.abs(one.at(places)[0]).max(axis=1) for one in fields]
    there = [found[i] for i in np.flatnonzero(np.max(shifts, axis=0) < NO_SHIFT)]
    return [mark for mark in there if not was_there(*mark)], len(there)


def was_there(name, kind, place):
    near = kinks.REACH * bulb.BEAM
    return any(
        (name, kind) == before[:2] and np.linalg.norm(place - before[2]) < near
        for before in plain_marks()
    )


def test_no_mark_comes_where_no_field_shifts():
    after = bulb_steps()[-1].surface
    new, count = new_where_nothing_shifts(after, [step.fields for step in bulb_steps()])
    print(count, "marks where no field shifts, new:", new)
    assert count > 0 and not new
    before = plain_bow().mesh.points
    moved = (after.mesh.points != before).any(axis=1)
    assert before[moved, 0].min() > 78.0


def test_a_base_that_reaches_as_far_at_its_top_has_light_wave_above():
    """Where nothing moves: a mark is reckoned by a tenth of the beam along the line, down to
    where the surface does."""
    fields = bulb.drawn_out(plain_bow(), top_extent=bulb.EXTENT)
    surface, _ = follow(plain_bow(), fields, with_profile=True)
    new, _ = new_where_nothing_shifts(surface, [fields])
    print(new)
    assert {kind for _, kind, _ in new} <= {"kink", "wave"} and len(new) >= 2
    assert all(place[2] > bulb.BASE_TOP for *_, place in new)
