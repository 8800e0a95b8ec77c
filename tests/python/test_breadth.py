# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to wanted numbers that nowhere become wider than they are at their widest."""

import hull_native as hn
import numpy as np
import pytest
from test_form_numbers import Sample
from test_targets import arguments, centre_limits, moved

# Of the half breadth; single precision leaves as much.
WIDER = 1.1e-7


def outline_limits(sample):
    """Profile and borders stay."""
    points = sample.surface.mesh.points
    stays = np.abs(points[:, 1]) <= 1e-6 * sample.size
    stays[np.unique(sample.surface.mesh.border_edges)] = True
    held = np.flatnonzero(stays)
    limits = centre_limits(sample)
    limits["held_points"] = np.concatenate([limits["held_points"], np.tile(held, 3)]).astype(int)
    axes = np.repeat(np.eye(3), len(held), axis=0)
    limits["held_normals"] = np.concatenate([limits["held_normals"], axes])
    return limits


def stiffer(sample, by):
    """Targets of the same displacement and LCB with a KMt that is so much greater."""
    now = sample.hydrostatics()
    return [
        hn.FormTarget("displaced_volume", now.displaced_volume),
        hn.FormTarget("lcb_percent", now.lcb_percent),
        hn.FormTarget("km_transverse", now.km_transverse + by, sense="at least"),
    ]


def seen_half_breadth(sample, moves):
    mesh = sample.surface.mesh.with_points(sample.surface.mesh.points + moves)
    points = hn.LimitSurface(mesh, sample.surface.scheme).evaluate_grid(40)[0]
    return float(np.abs(points[..., 1]).max())


@pytest.mark.parametrize("name", ["coaster", "bulk_carrier", "naval_vessel"])
def test_a_stiffer_hull_is_no_wider(name):
    sample = Sample(name)
    targets, limits = stiffer(sample, 0.15), outline_limits(sample)
    before = hn.half_breadth(sample.surface)
    free = hn.reach_targets(sample.surface, targets, **arguments(sample), **limits)
    assert seen_half_breadth(sample, free.moves) > (1.0 + 1e-4) * before
    reached, binds = hn.reach_within_breadth(sample.surface, targets, **arguments(sample), **limits)
    assert binds and reached.status == "met" and reached.cost > free.cost
    assert seen_half_breadth(sample, reached.moves) <= (1.0 + WIDER) * before
    after = moved(sample, reached.moves)
    for target, value in zip(targets, ("displaced_volume", "lcb_percent", "km_transverse")):
        found = getattr(after, value)
        assert target.low - 1e-7 * abs(target.low) <= found
        assert found <= target.high + 1e-7 * abs(target.high)


def test_what_does_not_become_wider_costs_nothing():
    sample = Sample("sailing_yacht")
    targets, limits = stiffer(sample, 0.05), outline_limits(sample)
    reached, binds = hn.reach_within_breadth(sample.surface, targets, **arguments(sample), **limits)
    free = hn.reach_targets(sample.surface, targets, **arguments(sample), **limits)
    assert not binds and np.array_equal(reached.moves, free.moves)


def test_a_free_beam_scales_what_is_no_wider():
    sample = Sample("coaster")
    before, told = hn.half_breadth(sample.surface), []
    reached, _ = hn.reach_within_breadth(
        sample.surface, stiffer(sample, 0.3), beam_scale=(1.0, 1.01), progress=told.append,
        **arguments(sample), **outline_limits(sample),
    )  # fmt: skip
    assert reached.status == "met" and reached.scale[1] > 1.0
    assert seen_half_breadth(sample, reached.moves) <= (1.0 + WIDER) * before * reached.scale[1]
    assert told == sorted(told) and 0.0 <= told[0] <= told[-1] <= 1.0


def test_the_greatest_half_breadth_is_found():
    sample = Sample("naval_vessel")
    fine = float(np.abs(sample.surface.evaluate_grid(200)[0][..., 1]).max())
    found = hn.half_breadth(sample.surface)
    assert fine <= found <= (1.0 + 1e-6) * fine


@pytest.mark.parametrize("place", [(-1, 0.5, 0.5), (10**6, 0, 0), (0, 1.5, 0.5), (0, np.nan, 0)])
def test_places_that_are_none_are_refused(place):
    sample = Sample("coaster")
    target = hn.FormTarget("coordinate", 1.0, sense="at most", place=place)
    with pytest.raises(ValueError, match="place"):
        hn.reach_targets(sample.surface, [target], **arguments(sample))


def test_a_place_is_given_with_a_coordinate_only():
    with pytest.raises(ValueError, match="place"):
        hn.FormTarget("lcb", 1.0, place=(0, 0.5, 0.5))
    with pytest.raises(ValueError, match="place"):
        hn.FormTarget("coordinate", 1.0)
