# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of hulls between parents of one topology: members are sums of their parents' points and
surfaces, volumes the polynomials they must be, weights are found for wanted numbers."""

import hull_native as hn
import numpy as np
import pytest
from test_form_numbers import Sample

SEED = 20261124
# Parts of volume, of the hull's size: rounding of integrals over some thousand pieces.
EXACT = 1e-12


def remade(surface, **changed):
    """The surface with other arrays of its control mesh."""
    mesh = surface.mesh
    arrays = {
        "points": mesh.points,
        "face_sizes": mesh.face_sizes,
        "face_vertices": mesh.face_vertices,
        "creases": mesh.creases,
        "corners": np.flatnonzero(mesh.vertex_kinds >= 3),
    }
    return hn.LimitSurface(hn.ControlMesh(**{**arrays, **changed}), surface.scheme)


def without_a_crease(surface):
    mesh = surface.mesh
    border = {tuple(sorted(edge)) for edge in mesh.border_edges.tolist()}
    inner = [k for k, edge in enumerate(mesh.creases.tolist()) if tuple(sorted(edge)) not in border]
    return remade(surface, creases=np.delete(mesh.creases, inner[0], axis=0))


def fuller(sample, factor=0.15):
    """The sample with fuller ends, longer and deeper: a parent that is no affine image."""
    points = sample.surface.mesh.points.copy()
    middle = (points[:, 0] - points[:, 0].mean()) / np.ptp(points[:, 0])
    points[:, 1] *= 1 + factor * np.sin(np.pi * middle) ** 2
    points[:, 0] *= 1.05
    points[:, 2] *= 1 + 0.1 * middle
    return remade(sample.surface, points=points)


@pytest.fixture(scope="module")
def coaster():
    return Sample("coaster")


@pytest.fixture(scope="module")
def pair(coaster):
    return hn.HullFamily([coaster.surface, fuller(coaster)])


def whole_volume_of(surface, sample):
    """By hydrostatics in water above all of it."""
    body = hn.HullBody(surface, mirrored=sample.half)
    top = surface.mesh.points[:, 2].max() + 1.0
    return hn.hydrostatics(body, draft=top)


def displaced(sample, points, draft):
    surface = remade(sample.surface, points=points)
    return hn.hydrostatics(
        hn.HullBody(surface, mirrored=sample.half), draft=draft, **sample.dimensions
    )


def test_members_have_the_parents_exactly_and_the_sum_between(coaster, pair):
    other = fuller(coaster)
    assert np.array_equal(pair.points([1, 0]), coaster.surface.mesh.points)
    assert np.array_equal(pair.points([0, 1]), other.mesh.points)
    member = remade(coaster.surface, points=pair.points([0.7, 0.3]))
    random = np.random.default_rng(SEED)
    cells, uv = random.integers(0, member.cell_count, 200), random.random((200, 2))
    (of_member,) = member.evaluate(cells, uv)
    (of_first,), (of_other,) = coaster.surface.evaluate(cells, uv), other.evaluate(cells, uv)
    assert np.abs(of_member - 0.7 * of_first - 0.3 * of_other).max() <= 1e-14 * coaster.size


def test_what_parents_share_stays_bit_by_bit(coaster):
    other = coaster.surface.mesh.points * [1.1, 1.2, 1.0]
    family = hn.HullFamily(
        [coaster.surface, remade(coaster.surface, points=other), fuller(coaster)]
    )
    for weights in ([0.1, 0.3, 0.6], [1.7, -0.6, -0.1]):
        member = family.points(weights)
        plane = coaster.surface.mesh.points[:, 1] == 0
        assert plane.any() and not member[plane, 1].any()
    two = hn.HullFamily([coaster.surface, remade(coaster.surface, points=other)])
    assert np.array_equal(two.points([0.9, 0.1])[:, 2], other[:, 2])


def test_whole_volume_is_a_cubic_and_its_moments_are_quartics(coaster, pair):
    whole = pair.whole_volume([1, 0], [0, 1], mirrored=True)
    assert whole.departure <= EXACT
    for t in (-0.3, 0.1, 0.5, 0.9, 1.2):
        member = remade(coaster.surface, points=pair.points([1 - t, t]))
        found = whole_volume_of(member, coaster)
        assert whole.volume_at(t) == pytest.approx(found.displaced_volume, rel=10 * EXACT)
        centre = [found.lcb, found.tcb, found.kb]
        assert np.abs(whole.centre_at(t) - centre).max() <= 10 * EXACT * coaster.size
    # No lower power would do: the members differ by more than a scaling along one axis.
    assert abs(whole.volume[3]) > 1e-6 * whole.volume[0]


def test_t_for_a_wanted_volume(coaster, pair):
    whole = pair.whole_volume([1, 0], [0, 1], mirrored=True)
    wanted = whole.volume_at(0.0) + 0.37 * (whole.volume_at(1.0) - whole.volume_at(0.0))
    (t,) = whole.at_volume(wanted)
    member = remade(coaster.surface, points=pair.points([1 - t, t]))
    found = whole_volume_of(member, coaster).displaced_volume
    assert found == pytest.approx(wanted, rel=1e-9)
    assert whole.at_volume(10 * wanted) == []
    assert whole.at_volume(whole.volume[0]) == pytest.approx([0.0], abs=1e-11)
    # A root there by rounding is one, on whichever side of the beginning it is found.
    for off in (-9e-13, -5e-13, 5e-13, 9e-13):
        assert whole.at_volume((1 + off) * whole.volume[0]) == pytest.approx([0.0], abs=1e-10)


def test_departure_of_what_has_no_volume_is_no_number(coaster):
    points = coaster.surface.mesh.points
    flat = remade(coaster.surface, points=points * [1, 0, 1])
    family = hn.HullFamily([coaster.surface, flat])
    assert np.isnan(family.whole_volume([0, 1], [0, 1], mirrored=True).departure)
    assert family.whole_volume([1, 0], [0, 1], mirrored=True).departure <= EXACT


def test_t_for_a_wanted_displacement(coaster, pair):
    ends = [
        displaced(coaster, pair.points(w), coaster.draft).displaced_volume for w in ([1, 0], [0, 1])
    ]
    wanted = 0.5 * sum(ends)
    drafts = [coaster.draft, coaster.draft]
    t = pair.t_of_displacement([1, 0], [0, 1], wanted, mirrored=True, drafts=drafts)
    found = displaced(coaster, pair.points([1 - t, t]), coaster.draft).displaced_volume
    assert found == pytest.approx(wanted, rel=1e-9)
    out = pair.t_of_displacement([1, 0], [0, 1], 3 * wanted, mirrored=True, drafts=drafts)
    assert out is None


def test_weights_for_wanted_numbers(coaster):
    def sheared(points):
        return points + np.outer(np.sin(np.pi * points[:, 0] / 84.0), [1.0, 0.0, 0.0])

    points = coaster.surface.mesh.points
    parents = [coaster.surface, fuller(coaster), remade(coaster.surface, points=sheared(points))]
    family = hn.HullFamily(parents)
    there = displaced(coaster, family.points([0.2, 0.5, 0.3]), coaster.draft)
    targets = [
        hn.FormTarget("displaced_volume", there.displaced_volume),
        hn.FormTarget("lcb", there.lcb),
    ]
    weights, reached = family.wanted_weights(
        [1, 0, 0], targets, mirrored=True, draft=coaster.draft, **coaster.dimensions
    )
    assert reached.status == "met"
    assert weights.sum() == pytest.approx(1, abs=1e-12)
    # Two numbers, two weights that are free: there is one answer nearby.
    assert weights == pytest.approx([0.2, 0.5, 0.3], abs=1e-6)
    moved = points + reached.moves
    assert np.abs(moved - family.points(weights)).max() <= 1e-10 * coaster.size


def test_weights_with_free_dimensions(coaster, pair):
    before = displaced(coaster, coaster.surface.mesh.points, coaster.draft)
    targets = [
        hn.FormTarget("displaced_volume", 1.1 * before.displaced_volume),
        hn.FormTarget("project.block", before.project.block + 0.01),
        hn.FormTarget("km_transverse", before.km_transverse),
    ]
    weights, reached = pair.wanted_weights(
        [1, 0],
        targets,
        mirrored=True,
        draft=coaster.draft,
        length_scale=(0.8, 1.25),
        beam_scale=(0.8, 1.25),
        draft_scale=(0.8, 1.25),
        **coaster.dimensions,
    )
    assert reached.status == "met"
    scaled = pair.points(weights) * reached.scale
    found = hn.hydrostatics(
        hn.HullBody(remade(coaster.surface, points=scaled), mirrored=True),
        draft=coaster.draft * reached.scale[2],
        length_pp=coaster.dimensions["length_pp"] * reached.scale[0],
        beam=coaster.dimensions["beam"] * reached.scale[1],
    )
    assert found.displaced_volume == pytest.approx(1.1 * before.displaced_volume, rel=1e-8)
    assert found.project.block == pytest.approx(before.project.block + 0.01, rel=1e-8)
    assert found.km_transverse == pytest.approx(before.km_transverse, rel=1e-8)


def test_the_bow_of_one_and_the_stern_of_another(coaster, pair):
    (middles,) = coaster.surface.evaluate(
        np.arange(coaster.surface.cell_count), np.full((coaster.surface.cell_count, 2), 0.5)
    )
    bow = np.flatnonzero(middles[:, 0] > 50)
    field = hn.ShapeField.of_region(coaster.surface, bow, extent=30.0)
    points = pair.points([1, 0], local=[(field, [0, 1])], mirrored=True)
    x = coaster.surface.mesh.points[:, 0]
    first, other = pair.points([1, 0]), pair.points([0, 1])
    assert np.array_equal(points[x < 15], first[x < 15])
    assert np.array_equal(points[x > 65], other[x > 65])
    between = (x > 25) & (x < 45)
    assert np.abs(points - first)[between].max() > 1e-3
    assert np.abs(points - other)[between].max() > 1e-3
    assert pair.first_fold(points) is None
    held = [
        (field, [0, 1]),
        (hn.ShapeField.of_region(coaster.surface, bow, extent=30.0, protects=True), None),
    ]
    assert np.array_equal(pair.points([1, 0], local=held, mirrored=True)[x > 65], first[x > 65])


def test_folds_of_members_are_found(pair):
    assert pair.first_fold(pair.points([0.5, 0.5])) is None
    assert pair.first_fold(pair.points([21, -20])) is not None


def test_weights_must_sum_to_one(pair):
    with pytest.raises(ValueError, match="sum to 1"):
        pair.points([0.5, 0.4])
    with pytest.raises(ValueError, match="for each of 2 parents"):
        pair.points([1.0])
    with pytest.raises(ValueError, match="sum to 1"):
        pair.points([float("nan"), 1.0])


def test_what_differs_is_named(coaster):
    smoothed = without_a_crease(coaster.surface)
    with pytest.raises(ValueError, match="Parent 2 has no creases where the first has them"):
        hn.HullFamily([coaster.surface, smoothed])
    barge = Sample("barge").surface
    (said, *_) = hn.family_differences([coaster.surface, coaster.surface, barge])
    assert said.startswith("Parent 3 has 32 points, the first has 113")
    smooth = int(np.flatnonzero(coaster.surface.mesh.vertex_kinds == 0)[0])
    cornered = remade(coaster.surface, corners=[smooth])
    (said,) = hn.family_differences([coaster.surface, cornered])
    assert f"corners at different points: {smooth}" in said


def test_flats_that_differ_are_named(coaster):
    points = coaster.surface.mesh.points
    deck = np.flatnonzero(np.abs(points[:, 0] - points[:, 0].min()) < 1e-6)
    assert len(deck) > 3
    turned = points.copy()
    turned[deck, 0] += 0.01 * turned[deck, 2]
    bent = points.copy()
    bent[deck[0], 0] += 0.1
    flats = [("transom", deck)]

    def said(changed):
        parents = [coaster.surface, remade(coaster.surface, points=changed)]
        return hn.family_differences(parents, flats=flats)

    assert said(points * [2.0, 1.0, 1.0]) == []
    assert "turned in parent 2" in said(turned)[0]
    assert "not flat in parent 2" in said(bent)[0]
