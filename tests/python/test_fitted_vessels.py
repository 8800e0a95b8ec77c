# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples that were fitted to published surfaces: how near they come."""


import hull_native as hn
import numpy as np
import pytest
import target_hulls
import vessels

# Of the published volume and wetted surface.
SHARE = {"container_ship": 0.003, "bulk_carrier": 0.005}


@pytest.fixture(scope="module", params=sorted(SHARE))
def vessel(request):
    return vessels.vessel(request.param)


def upright(vessel):
    draft = vessel.data.particulars.draft
    return hn.upright_hydrostatics(vessel.surface, draft=draft, mirrored=True)


def target(name):
    path = target_hulls.FOLDER / target_hulls.FILES[name][0]
    if not path.exists():
        pytest.skip(f"{path} is missing: it comes with the shared data, not with the project")
    return target_hulls.triangles(name)


def test_published_numbers_are_met(vessel):
    found = upright(vessel)
    for name, value in vessel.source.PUBLISHED.items():
        assert getattr(found, name) == pytest.approx(value, rel=SHARE[vessel.name]), name


def displaced(corners, draft):
    """Volume of a closed surface of triangles below the draft, and its moment about AP: integrals
    of depth over projected areas, by midpoints; what the water cuts is first cut small."""
    for _ in range(4):
        above = corners[:, :, 2] > draft
        cut = above.any(axis=1) & ~above.all(axis=1)
        a, b, c = corners[cut].transpose(1, 0, 2)
        d, e, f = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
        parts = [np.stack(p, axis=1) for p in ((a, d, f), (d, b, e), (f, e, c), (d, e, f))]
        corners = np.concatenate([corners[~cut], *parts])
    area = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]
    centre = corners.mean(axis=1)
    parts = area * np.minimum(centre[:, 2] - draft, 0.0)
    return abs(parts.sum()), abs((parts * centre[:, 0]).sum())


def test_a_box_displaces_its_volume():
    corners = np.array([[x, y, z] for x in (0, 10) for y in (-2, 2) for z in (0, 5)], float)
    quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    faces = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    volume, moment = displaced(corners[np.array(faces)], 3.0)
    assert volume == pytest.approx(120.0, rel=1e-12)
    assert moment == pytest.approx(600.0, rel=1e-12)


def test_container_ship_floats_as_its_target():
    vessel = vessels.vessel("container_ship")
    found = upright(vessel)
    volume, moment = displaced(target("container_ship"), vessel.data.particulars.draft)
    assert volume == pytest.approx(found.displaced_volume, rel=0.003)
    assert abs(moment / volume - found.lcb) <= 0.001 * vessel.data.particulars.length_pp


def test_container_ship_is_the_surface_below_the_water():
    vessel = vessels.vessel("container_ship")
    points, _ = target_hulls.samples(target("container_ship"), 60000)
    below = (points[:, 1] >= 0.0) & (points[:, 2] < vessel.data.particulars.draft)
    apart = hn.SurfaceTree(vessel.surface).closest_points(points[below]).distances
    assert below.sum() > 10000
    assert np.sqrt(np.mean(apart**2)) <= 0.060
    assert np.max(np.abs(apart)) <= 0.4


def test_bulk_carrier_goes_by_the_corners_of_its_target():
    vessel = vessels.vessel("bulk_carrier")
    # Its triangles are up to 100 m long and cut off what bulges between their corners.
    corners = np.unique(target("bulk_carrier").reshape(-1, 3).round(3), axis=0)
    below = (corners[:, 1] >= 0.0) & (corners[:, 2] < vessel.data.particulars.draft)
    apart = hn.SurfaceTree(vessel.surface).closest_points(corners[below]).distances
    assert below.sum() > 3000
    assert np.sqrt(np.mean(apart**2)) <= 0.12
    assert np.max(np.abs(apart)) <= 0.55
