# SPDX-License-Identifier: GPL-3.0-or-later
"""Fair Region takes planted dents and waves out of sample hulls.

HULL_LONG_FAIRING: of these hulls all marks are counted besides; none is left anywhere.
"""

import os

import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness.lines import judged
from test_fairing import shifts

IS_LONG = bool(os.environ.get("HULL_LONG_FAIRING"))

# (hull, control points nearest to these places, energy, share of the plant's own shift): of one
# point on the sample's own control mesh, of more on the once subdivided one, on which the design is
# smoother than what was planted. The wave needs less than all of it.
BILGE = [(x, y, 0.8) for x, y in ((41.9, 6.6), (45.2, 6.6), (48.5, 6.6), (51.8, 6.6))]
BILGE += [(x, y, 0.8) for x, y in ((55.0, 6.5), (58.1, 6.4), (61.2, 6.1), (64.4, 5.6))]
CONTAINER_BILGE = [(99.9, 23.9, 5.6), (116.7, 24.4, 4.2), (133.5, 24.8, 3.0), (148.3, 24.9, 2.5)]
CONTAINER_BILGE += [(164.1, 25.1, 2.5), (184.1, 25.3, 2.9), (207.1, 25.2, 4.0), (232.3, 24.4, 6.0)]
RORO_BILGE = [(13.0, 13.6, 7.3), (19.5, 13.8, 6.8), (27.0, 13.9, 6.3), (35.4, 14.1, 5.7)]
RORO_BILGE += [(44.5, 14.2, 5.1), (54.4, 14.4, 4.5), (65.0, 14.4, 4.1), (76.1, 14.5, 3.8)]
PLANTED = [
    ("coaster", [(67.9, 6.1, 4.9)], "lengthwise", 1.0),
    ("container_ship", [(162.1, 25.5, 3.5)], "lengthwise", 1.0),
    ("roro", [(158.0, 8.4, 9.1)], "lengthwise", 1.0),
    ("coaster", [(64.6, 6.4, 4.8), (67.9, 6.0, 4.9), (71.2, 5.5, 5.0)], "lengthwise", 1.0),
    (
        "container_ship",
        [(60.0, 21.4, 9.0), (72.2, 22.7, 8.0), (85.3, 23.4, 6.9)],
        "lengthwise",
        1.0,
    ),
    ("roro", [(131.5, 10.8, 3.9), (141.4, 9.2, 4.6), (150.0, 7.7, 5.3)], "lengthwise", 1.0),
    ("coaster", BILGE, "thin_plate", 0.9),
    ("coaster", BILGE, "blend", 1.0),
    ("container_ship", CONTAINER_BILGE, "blend", 1.0),
    ("roro", RORO_BILGE, "blend", 1.0),
]


def planted(name, places, is_finer=None):
    """(a sample's surface, the same with a dent of 4 per mille of the beam, or along many points a
    wave of 2, and the control points that were moved). is_finer: on the once subdivided mesh; None:
    where there are several places."""
    vessel = vessels.vessel(name)
    surface, beam = vessel.surface, vessel.data.particulars.beam
    if len(places) > 1 if is_finer is None else is_finer:
        surface = hn.LimitSurface(surface.refined_mesh(), surface.scheme)
    points = surface.mesh.points.copy()
    chosen = [int(np.linalg.norm(points - place, axis=1).argmin()) for place in places]
    corners = surface.mesh.face_vertices.tolist()
    cells = [corners.index(point) for point in chosen]
    normals = surface.normals(cells, np.zeros((len(cells), 2)))
    normals[:, 0] = 0.0
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    wave = 2e-3 * np.sin(0.5 * np.pi * (np.arange(len(chosen)) + 0.5))
    depths = wave if len(chosen) > 3 else np.full(len(chosen), 4e-3)
    points[chosen] -= beam * depths[:, None] * normals
    return surface, hn.LimitSurface(surface.mesh.with_points(points), surface.scheme), chosen


def distance(one, other):
    """The root mean square distance of a surface from another one."""
    places = one.tessellate(3).points
    return np.sqrt((hn.SurfaceTree(other).closest_points(places).distances ** 2).mean())


@pytest.mark.parametrize("name, places, energy, share", PLANTED)
def test_planted_dents_are_faired_out(name, places, energy, share):
    surface, dented, chosen = planted(name, places)
    start = dented.mesh.points
    deviation = share * shifts(dented, surface.mesh.points - start)[0]
    faired = hn.FairRegion(dented, chosen, energy=energy).solve(deviation)
    assert faired.bound == "deviation" and faired.rms == pytest.approx(deviation, rel=1e-6)
    after = start + faired.moves
    np.testing.assert_array_equal(after[:, 0], start[:, 0])
    result = hn.LimitSurface(surface.mesh.with_points(after), surface.scheme)
    assert distance(dented, surface) > 3.0 * distance(result, surface)
    if IS_LONG:
        vessel = vessels.vessel(name)
        lines = judged(result, vessel.data.particulars.beam, vessel.wanted)
        assert not [mark for line in lines for mark in line.unwanted]


@pytest.mark.parametrize("name, place", [(name, places[0]) for name, places, *_ in PLANTED[:3]])
def test_a_dent_goes_beside_the_blend_with_all_points_around_chosen(name, place):
    """On the once subdivided mesh; they are right, and stay nearly where they are."""
    surface, dented, [point] = planted(name, [place], is_finer=True)
    faces = np.asarray(surface.mesh.face_vertices).reshape(-1, 4)
    chosen = np.unique(faces[(faces == point).any(axis=1)])
    start = dented.mesh.points
    deviation = shifts(dented, surface.mesh.points - start)[0]
    ratios = {}
    for energy in ("lengthwise", "blend"):
        # The same shift is less in the mean over the region of more points.
        found = hn.FairRegion(dented, chosen, energy=energy)
        alone = hn.FairRegion(dented, [point], energy=energy)
        faired = found.solve(deviation * np.sqrt(alone.area / found.area))
        result = hn.LimitSurface(surface.mesh.with_points(start + faired.moves), surface.scheme)
        ratios[energy] = distance(dented, surface) / distance(result, surface)
    assert ratios["blend"] > 3.0 > ratios["lengthwise"]
