# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies of one mesh that overlap are found and told; panels are compared with what has panels;
what is to be cut out and lies beside the hull is named."""

import warnings

import hull_native as hn
import numpy as np
import pytest
from production_hulls import SAMPLES, body_of
from test_appendages import TUNNEL, UP, box_body, box_hull, whole_volume

HULL = ((0, -2, 0), (10, 2, 3))


def test_boxes_that_overlap():
    """By a closed form, and by what join([]) takes off."""
    _, body = box_body(HULL, ((8, -1, 1), (12, 1, 2)))
    assert body.may_overlap
    ((first, second, volume, countable),) = body.own_overlaps
    assert (first, second, countable) == (0, 6, True)
    assert volume == pytest.approx(2 * 2 * 1, abs=1e-9)
    body.join([])
    assert body.joined_volume == pytest.approx(-volume, abs=1e-9)


def test_one_within_another_and_three_at_once():
    _, body = box_body(HULL, ((2, -1, 1), (4, 1, 2)), ((3, -1.5, 0.5), (5, 0.5, 1.5)))
    pairs = {(a, b): volume for a, b, volume, _ in body.own_overlaps}
    assert pairs == {
        (0, 6): pytest.approx(4.0), (0, 12): pytest.approx(4.0), (6, 12): pytest.approx(0.75),
    }  # fmt: skip
    body.join([])
    assert whole_volume(body) == pytest.approx(120.0, abs=1e-9)


@pytest.mark.parametrize(
    "other",
    [
        ((11, -1, 1), (12, 1, 2)),  # apart
        ((10, -1, 1), (12, 1, 2)),  # side to side
        ((2, -1, 3), (4, 1, 4)),  # a house on the deck
    ],
)
def test_bodies_that_do_not(other):
    _, body = box_body(HULL, other)
    assert body.own_overlaps == []


def test_what_is_far_apart_is_not_looked_at():
    assert not box_hull()[1].may_overlap
    assert not box_body(HULL, ((20, -1, 1), (22, 1, 2)))[1].may_overlap


def test_boxes_around_bodies_are_not_bodies():
    """Two wedges that lie in one box, a way apart."""
    mesh = box_body(HULL, HULL)[0].mesh
    points = np.array(mesh.points)
    # The first is below the diagonal of the box, the second above it.
    points[[4, 6], 2], points[[5, 7], 2] = 0.2, 2.4
    points[[8, 10], 2], points[[9, 11], 2] = 0.6, 2.8
    surface = hn.LimitSurface(mesh.with_points(points))
    body = hn.HullBody(surface, mirrored=False)
    assert body.may_overlap and body.own_overlaps == []


def test_surfaces_in_one_another():
    """Decks at one height: the volume in common is estimated, join([]) says why it can't."""
    _, body = box_body(HULL, ((8, -1, 1), (12, 1, 3)))
    ((_, _, volume, countable),) = body.own_overlaps
    assert not countable and volume == pytest.approx(2 * 2 * 2, rel=0.05)
    with pytest.raises(ValueError, match="surfaces of the hull's own bodies lie in one another"):
        body.join([])
    assert body.joined_volume is None


@pytest.mark.parametrize("name", SAMPLES)
def test_of_samples_the_yacht_s_rudder_alone(name):
    """A second way: what join([]) takes off, which is none of all others."""
    _, body = body_of(name)
    shared = sum(volume for _, _, volume, _ in body.own_overlaps)
    joined = hn.HullBody(body.surface, mirrored=body.mirrored)
    joined.join([])
    assert shared == pytest.approx(-joined.joined_volume, rel=1e-6, abs=1e-9)
    assert (shared > 0.0) == (name == "sailing_yacht")


def test_panels_are_compared_with_what_has_panels():
    """A keel that is joined changes neither panels nor the volume beside them."""
    sample, body = body_of("sailing_yacht")
    draft, length = sample.ship.draft, sample.ship.length_pp
    keel = hn.foil("63-012", (7.0, 0, 1.2), (6.7, 0, -0.6), 2.0, tip_chord=1.5)
    joined = hn.HullBody(body.surface, mirrored=body.mirrored)
    joined.join([keel])
    bare, other = (hn.wetted_panels(one, length / 60, draft=draft) for one in (body, joined))
    assert other.displaced_volume == bare.displaced_volume
    assert other.displaced_volume == pytest.approx(body.immersion(UP, draft).volume, rel=1e-12)
    assert joined.immersion(UP, draft).volume > bare.displaced_volume * 1.001
    assert np.array_equal(other.volumes, bare.volumes)
    assert other.volumes.mean() == pytest.approx(other.displaced_volume, rel=5e-3)


def test_what_cuts_nothing_is_named():
    _, body = box_hull()
    off = TUNNEL | {"start": (17.0, -3.0, 1.2), "end": (17.0, 3.0, 1.2)}
    above = TUNNEL | {"start": (7.0, -3.0, 4.2), "end": (7.0, 3.0, 4.2)}
    for beside in (off, above):
        with pytest.warns(UserWarning, match="thruster cuts nothing out of the hull, beside which"):
            body.join([hn.cylinder(**beside, name="thruster"), hn.cylinder(**TUNNEL, name="own")])
        assert body.idle_cuts == ["thruster"] and body.joined_volume < -1.0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        body.join([hn.cylinder(**TUNNEL)])
    assert body.idle_cuts == []


def test_bodies_all_but_in_one_another_are_refused():
    """Two coasters a tenth of a millimetre apart here and there: there is no end to how often
    their surfaces cross, which is told and not waited for."""
    sample, _ = body_of("coaster")
    mesh = sample.surface.mesh
    count, random = len(mesh.points), np.random.default_rng(23)
    points = np.concatenate([mesh.points, mesh.points + random.uniform(-1e-4, 1e-4, (count, 3))])
    pairs = np.asarray(sample.data.creases).reshape(-1, 2)
    both = hn.ControlMesh(
        points,
        np.concatenate([mesh.face_sizes, mesh.face_sizes]),
        np.concatenate([mesh.face_vertices, mesh.face_vertices + count]),
        np.concatenate([pairs, pairs + count]),
    )
    body = hn.HullBody(hn.LimitSurface(both), mirrored=False)
    with pytest.raises(ValueError, match="own bodies lie in one another"):
        body.join([])
    ((_, _, volume, countable),) = body.own_overlaps
    assert not countable
    # An estimate, of 4,096 points.
    alone = whole_volume(hn.HullBody(sample.surface, mirrored=False))
    assert volume == pytest.approx(alone, rel=0.05)
