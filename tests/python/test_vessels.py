# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample vessels: sound, small, fair, of known particulars, and fit for all uses."""

import json

import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness.lines import judged

EXPECTED = {
    path.stem: json.loads(path.read_text())
    for path in sorted((vessels.SAMPLES / "expected").glob("*.json"))
}
# The most control points that a vessel of its kind takes, of the half hull.
MOST_POINTS = {
    "barge": 32,
    "bulk_carrier": 125,
    "container_ship": 136,
    "naval_vessel": 153,
    "research_vessel": 119,
    "roro": 117,
}


@pytest.fixture(scope="module", params=sorted(EXPECTED))
def vessel(request):
    return vessels.vessel(request.param)


@pytest.fixture(scope="module")
def patches(vessel):
    return hn.exact_patches(vessel.surface)


def upright(vessel):
    draft = vessel.data.particulars.draft
    return hn.upright_hydrostatics(vessel.surface, draft=draft, mirrored=vessel.data.half)


def size_of(vessel):
    return float(np.ptp(vessel.data.points, axis=0).max())


def test_every_source_has_numbers():
    assert set(vessels.sources.names()) <= set(EXPECTED)
    assert set(EXPECTED) <= set(vessels.names())


def agree(made, stored):
    """Whether what JSON tells is the same, numbers to their last place but one: the last one of
    NumPy's powers differs from processor to processor."""
    if isinstance(stored, dict):
        return made.keys() == stored.keys() and all(agree(made[key], stored[key]) for key in stored)
    if isinstance(stored, list):
        return len(made) == len(stored) and all(map(agree, made, stored))
    if isinstance(stored, float):
        return abs(made - stored) <= 1e-15 * max(1.0, abs(stored))
    return made == stored


def test_file_and_source_agree(vessel, tmp_path):
    path = tmp_path / "made.hull.json"
    vessels.hull_io.write_hull_file(vessel.source.make(vessels.hull_io), path)
    stored = vessels.SAMPLES / f"{vessel.name}.hull.json"
    assert agree(json.loads(path.read_text()), json.loads(stored.read_text()))


def test_mesh_is_sound_and_small(vessel):
    shell = vessels.hull_io.shell_arrays(vessel.data)
    arrays = shell.arguments()
    assert hn.check_mesh(*arrays) == []
    most = MOST_POINTS.get(vessel.name, vessel.source.MOST_POINTS)
    assert len(vessel.data.points) <= min(most, vessel.source.MOST_POINTS)
    assert vessel.source.FEATURES


def test_particulars(vessel):
    found = upright(vessel)
    for name, value in EXPECTED[vessel.name].items():
        assert getattr(found, name) == pytest.approx(value, rel=1e-9), name
    # Closed below the water but for vertical openings, and turned outwards.
    assert found.volume_from_breadths == pytest.approx(found.displaced_volume, rel=1e-9)


def test_beam_is_as_given(vessel):
    points = vessel.surface.tessellate(8).points
    assert 2.0 * points[:, 1].max() == pytest.approx(vessel.data.particulars.beam, rel=5e-3)


def area_of(points):
    return 0.5 * np.linalg.norm(np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0))


def test_flats_are_plane(vessel):
    """The surface of a part that is kept flat, but for its rim where that has no crease."""
    data = vessel.data
    for flat in data.flats:
        meant = sum(area_of(data.points[data.faces[face]]) for face in flat.faces)
        plane = np.array([*flat.normal, flat.offset])
        regions = hn.flat_regions(vessel.surface, plane=plane, tolerance=1e-12 * size_of(vessel))
        assert sum(region.area for region in regions) > 0.2 * meant, flat.normal


def test_lines_are_fair(vessel):
    beam = vessel.data.particulars.beam
    unwanted = [
        f"{line.name}: {found.mark} at {np.round(found.point, 2)}, {found.size}"
        for line in judged(vessel.surface, beam, vessel.wanted)
        for found in line.unwanted
    ]
    assert unwanted == []


def test_conversion_holds_its_tolerance(vessel, patches):
    report = hn.measure_quality(vessel.surface, patches)
    assert report.largest_distance <= 1e-6 * size_of(vessel)


def test_solid_goes_to_step(vessel, patches, tmp_path):
    report = hn.write_step(patches, tmp_path / "hull.step", mirrored=vessel.data.half, solid=True)
    assert report["valid"] and report["closed"]
    assert report["solids"] >= 1
    assert report["volume"] > upright(vessel).displaced_volume


def test_table_rises_with_the_draft(vessel):
    given = vessel.data.particulars
    body = hn.HullBody(vessel.surface, mirrored=vessel.data.half)
    drafts = list(given.draft * np.array([0.5, 0.8, 0.99, 1.0, 1.01, 1.1]))
    table = hn.hydrostatic_table(
        body, drafts=drafts, length_pp=given.length_pp, beam=given.beam, design_draft=given.draft
    )
    volumes = [row.displaced_volume for row in table]
    assert (np.diff(volumes) > 0.0).all()
    # What is between two drafts, by Simpson's rule.
    areas = [row.waterplane_area for row in table[2:5]]
    between = (drafts[4] - drafts[2]) * np.dot(areas, (1, 4, 1)) / 6.0
    assert volumes[4] - volumes[2] == pytest.approx(between, rel=1e-3)


def test_levers_rise_from_upright_as_gm_tells(vessel):
    found = upright(vessel)
    given = vessel.data.particulars
    gm = 0.05 * given.beam
    body = hn.HullBody(vessel.surface, mirrored=vessel.data.half)
    heels = np.radians([0.0, 1.0, 2.0, 10.0, 20.0, 30.0])
    levers = hn.righting_levers(
        body,
        mass_t=found.displaced_volume * given.water_density,
        centre_of_gravity=[found.lcb, 0.0, found.km_transverse - gm],
        heels=heels,
        water_density=given.water_density,
    )
    assert levers.levers[0] == pytest.approx(0.0, abs=1e-9 * given.beam)
    assert levers.levers[1] == pytest.approx(gm * np.sin(heels[1]), rel=0.05)
    assert np.isfinite(levers.levers).all()
