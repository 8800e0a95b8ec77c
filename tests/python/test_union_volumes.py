# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls with a keel, a skeg and a rudder: volume and wetted surface of the union by inclusion and
exclusion, what hull and foil share by rays along the foil's straight lines."""

import hull_native as hn
import numpy as np
import pytest
from foil_shares import SymmetricFoil
from transformation_hulls import SAMPLES, Sample

# Section, leading edge, chords (of Lpp), how far the tip is swept, the root above the bottom where
# that is highest along the chord, and the tip below it (of the draft).
FINS = {
    "keel": ("63-012", 0.55, 0.10, 0.08, 0.02, 0.15, 0.6),
    "skeg": ("0010", 0.30, 0.08, 0.06, 0.01, 0.10, 0.3),
    "rudder": ("0018", 0.16, 0.03, 0.025, 0.003, 0.10, 0.5),
}
BODIES = {"catamaran": 0.35}  # of the beam: where the demihull's middle is
# The yacht has a keel and a rudder of her own: what is added lies before, between and beside them.
PLACES = {("sailing_yacht", "keel"): 0.80}


def bottoms(sample, x, y):
    """z of the hull's lowest points over places x on y."""
    tree, points = hn.SurfaceTree(sample.surface), sample.mesh.points
    beside = y or 1e-7 * np.ptp(points[:, 0])
    begin = np.stack([x, np.full_like(x, beside), np.full_like(x, points[:, 2].min() - 1.0)], -1)
    return tree.ray_hits(begin, np.tile([0.0, 0.0, 1.0], (len(x), 1))).points[:, 2]


def fin_of(sample, name):
    section, lead, chord, tip_chord, sweep, within, below = FINS[name]
    lead = PLACES.get((sample.name, name), lead)
    length, draft = sample.ship.length_pp, sample.ship.draft
    y = BODIES.get(sample.name, 0.0) * sample.ship.beam
    heights = bottoms(sample, np.linspace(lead - chord, lead, 9) * length, y)
    top, low = heights.max() + within * draft, heights.min() - below * draft
    return SymmetricFoil(
        section,
        (lead * length, y, top),
        ((lead - sweep) * length, y, low),
        chord * length,
        tip_chord * length,
    )


@pytest.fixture(scope="module", params=SAMPLES)
def sample(request):
    found = Sample(request.param)
    found.name = request.param
    body = hn.HullBody(found.surface, mirrored=found.half)
    body.join([])
    found.overlap = -body.joined_volume  # of her own bodies
    return found


@pytest.mark.parametrize("name", FINS)
def test_union(sample, name):
    """Hull and foil less what they share: to 1e-9 of the foil's volume."""
    foil = fin_of(sample, name)
    is_beside = foil.root[1] != 0.0
    bodies = 2 if is_beside and sample.half else 1
    shared = foil.share_within(sample.surface, sample.half and not is_beside, 3, 16)
    body = hn.HullBody(sample.surface, mirrored=sample.half)
    body.join([foil.body(mirrored=bodies == 2)])
    added = (body.joined_volume + sample.overlap) / bodies
    assert 0.0 < shared < foil.volume
    assert foil.body().volume == pytest.approx(foil.volume, rel=1e-12)
    assert added + shared == pytest.approx(foil.volume, rel=1e-9)


def wetted_by(sample, bodies):
    """m² of all of the hull and what is joined to it."""
    body = hn.HullBody(sample.surface, mirrored=sample.half)
    body.join(bodies)
    points = sample.mesh.points
    level = points[:, 2].max() + np.ptp(points[:, 0])
    return body.immersion((0.0, 0.0, 1.0), level).wetted_surface


def test_wetted_surface_of_the_union(sample):
    """On round bottoms, a keel's sides and tip outside the hull less what it covers of that: to
    1e-9 of what it adds."""
    keel = fin_of(sample, "keel")
    is_beside = keel.root[1] != 0.0
    bodies = 2 if is_beside and sample.half else 1
    is_half = sample.half and not is_beside
    covered = keel.covered_area(sample.surface, is_half)
    outside = keel.outside_area(sample.surface, is_half)
    added = wetted_by(sample, [keel.body(mirrored=bodies == 2)]) - wetted_by(sample, [])
    assert 0.0 < covered < 0.2 * outside
    assert added / bodies == pytest.approx(outside - covered, rel=1e-9)
