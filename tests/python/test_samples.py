# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample hulls: valid, flat where they are meant to be, fair, and of known particulars."""

import sys
from pathlib import Path

import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "blender" / "io"))
from hull_io_loader import load_hull_io  # noqa: E402

hull_io = load_hull_io()

# At the design draft: displaced volume (m³), LCB, KB (m), wetted surface, waterplane area (m²),
# LCF and KMt (m).
# Computed by this program; the volume agrees with that from breadths, an independent integral.
EXPECTED = {
    "barge": [
        2533.8335739112667,
        36.27988869080322,
        1.679898653157283,
        1295.5174356198515,
        855.141639167869,
        37.579892983116814,
        5.2208178234967,
    ],
    "coaster": [
        4656.274512273051,
        42.739391172333946,
        2.813945177552342,
        1726.6162640036212,
        1083.7291572708425,
        38.52400215629364,
        6.122115018463578,
    ],
}
# Where the flat bottom reaches: x from, x to, y to, in m.
FLAT_BOTTOM = {"barge": (7.6, 50.2, 3.6), "coaster": (35.5, 66.0, 3.0)}


@pytest.fixture(params=sorted(EXPECTED))
def sample(request):
    data = hull_io.read_hull(ROOT / "samples" / f"{request.param}.hull.json")
    shell = hull_io.shell_arrays(data)
    arrays = (shell.points, shell.face_sizes, shell.face_vertices, shell.creases, shell.corners)
    return request.param, data, arrays, hn.LimitSurface(hn.ControlMesh(*arrays))


def test_every_sample_is_tested():
    assert {path.name for path in (ROOT / "samples").glob("*.hull.json")} == {
        f"{name}.hull.json" for name in EXPECTED
    }


def test_meshes_are_sound_and_small(sample):
    name, data, arrays, _ = sample
    assert hn.check_mesh(*arrays) == []
    assert data.half
    assert len(data.points) <= (32 if name == "barge" else 120)


def test_particulars(sample):
    name, data, _, surface = sample
    h = hn.upright_hydrostatics(surface, draft=data.particulars.draft, mirrored=True)
    found = [h.displaced_volume, h.lcb, h.kb, h.wetted_surface, h.waterplane_area]
    found += [h.lcf, h.km_transverse]
    assert found == pytest.approx(EXPECTED[name], rel=1e-9)
    # Closed below the water but for vertical openings, and turned outwards.
    assert h.volume_from_breadths == pytest.approx(h.displaced_volume, rel=1e-12)


def test_breadth_and_length(sample):
    _, data, _, surface = sample
    points = surface.tessellate(8).points
    assert 2.0 * points[:, 1].max() == pytest.approx(data.particulars.beam, rel=1e-3)
    waterline = np.concatenate([c.points for c in hn.section(surface, "z", data.particulars.draft)])
    # From the after perpendicular, or a stern that overhangs it, to the fore perpendicular.
    assert waterline[:, 0].min() <= 1e-9
    assert waterline[:, 0].max() == pytest.approx(data.particulars.length_pp, rel=5e-3)


def test_bottom_is_flat(sample):
    name, _, _, surface = sample
    start, end, width = FLAT_BOTTOM[name]
    tessellation = surface.tessellate(8)
    x, y, z = tessellation.points.T
    # The shell has nothing else so deep.
    inside = (x > start) & (x < end) & (y < width) & (z < 1.0)
    assert inside.sum() > 20
    assert np.abs(z[inside]).max() <= 1e-12


def inflections(points):
    """How often a plane polyline's curvature changes sign, slight ripples below 1/5 km left out."""
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    steps, lengths = steps[lengths > 1e-4], lengths[lengths > 1e-4]
    angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    curvature = np.diff(angles) / (0.5 * (lengths[1:] + lengths[:-1]))
    signs = np.sign(curvature[np.abs(curvature) > 2e-4])
    return int((np.diff(signs) != 0).sum())


def test_lines_are_fair(sample):
    """Stations turn at most from bilge to flare and back, waterlines at most once."""
    name, data, _, surface = sample
    particulars = data.particulars
    most = 0 if name == "barge" else 2
    for x in np.linspace(0.02, 0.98, 21) * particulars.length_pp:
        for curve in hn.section(surface, "x", x, 1e-5):
            assert inflections(curve.points[:, 1:]) <= most, f"station at {x:.2f} m"
    most = 0 if name == "barge" else 1
    for z in np.linspace(0.1, 1.0, 9) * particulars.draft:
        for curve in hn.section(surface, "z", z, 1e-5):
            assert inflections(curve.points[:, :2]) <= most, f"waterline at {z:.2f} m"
