# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample hulls: valid, flat where they are meant to be, fair, and of known particulars."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]

# At the design draft: displaced volume (m³), LCB, KB (m), wetted surface, waterplane area (m²),
# LCF and KMt (m).
# Computed by this program; the volume agrees with that from breadths, an independent integral.
EXPECTED = {
    "barge": [
        2511.0149620426982,
        37.42953706754878,
        1.6971922942402278,
        1276.1515746895475,
        860.3390506127002,
        37.78211475648839,
        5.323327420264424,
    ],
    "coaster": [
        4386.526529295441,
        42.263644265081304,
        2.8512024055131153,
        1654.36025930076,
        1040.188904055836,
        38.13168267370533,
        6.0969960143018795,
    ],
}
BLOCK_COEFFICIENT = {"barge": (0.88, 0.92), "coaster": (0.70, 0.75)}
# Where the flat bottom reaches: x from, x to, y to, in m.
FLAT_BOTTOM = {"barge": (9.5, 51.5, 3.79), "coaster": (34.9, 66.0, 2.8)}
# Where the flat side reaches: x from, x to, z from, in m.
FLAT_SIDE = {"barge": (9.5, 51.5, 1.63), "coaster": (34.9, 48.0, 2.22)}
# Radius of the bilge amidships, and how far the section may leave the circle, in m.
BILGE = {"barge": (0.99, 0.015), "coaster": (1.6, 0.012)}


@pytest.fixture(params=sorted(EXPECTED))
def sample(request):
    data = hull_io.read_hull(ROOT / "samples" / f"{request.param}.hull.json")
    shell = hull_io.shell_arrays(data)
    arrays = shell.arguments()
    return request.param, data, arrays, hn.LimitSurface(hn.ControlMesh(*arrays))


def test_every_sample_is_tested():
    """Here, or as the vessels with sources are."""
    found = {path.name for path in (ROOT / "samples").glob("*.hull.json")}
    others = {path.stem for path in (ROOT / "samples" / "expected").glob("*.json")}
    assert found == {f"{name}.hull.json" for name in {*EXPECTED, *others}}


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


def test_a_designer_would_believe_the_coefficients(sample):
    name, data, _, surface = sample
    particulars = data.particulars
    h = hn.upright_hydrostatics(surface, draft=particulars.draft, mirrored=True)
    block = particulars.length_pp * particulars.beam * particulars.draft
    least, most = BLOCK_COEFFICIENT[name]
    assert least < h.displaced_volume / block < most
    assert abs(h.lcb / particulars.length_pp - 0.5) < 0.02
    assert h.km_transverse > h.kb > 0.5 * particulars.draft


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
    x, y, z = surface.tessellate(8).points.T
    # The shell has nothing else so deep.
    inside = (x > start) & (x < end) & (y < width) & (z < 1.0)
    assert inside.sum() > 20
    assert np.abs(z[inside]).max() <= 1e-12


def test_side_is_flat_and_vertical(sample):
    name, data, _, surface = sample
    start, end, bottom = FLAT_SIDE[name]
    x, y, z = surface.tessellate(8).points.T
    inside = (x > start) & (x < end) & (z > bottom)
    assert inside.sum() > 20
    assert np.abs(y[inside] - 0.5 * data.particulars.beam).max() <= 1e-12


def test_bilge_is_nearly_a_circle(sample):
    name, data, _, surface = sample
    radius, most = BILGE[name]
    points = hn.section(surface, "x", 40.0, 1e-5)[0].points
    centre = np.array([0.5 * data.particulars.beam - radius, radius])
    arm = points[:, 1:] - centre
    bilge = (arm[:, 0] > 0.0) & (arm[:, 1] < 0.0)
    assert bilge.sum() > 20
    assert np.abs(np.linalg.norm(arm[bilge], axis=1) - radius).max() <= most


def test_transoms_are_plane(sample):
    _, data, _, surface = sample
    tessellation = surface.tessellate(4)
    cells_of_face = np.repeat(np.arange(len(data.faces)), [len(face) for face in data.faces])
    transom = data.points[[face[0] for face in data.faces], 0]
    for face, layer in enumerate(data.face_layers):
        if data.layers[layer].name.startswith("Transom"):
            x = tessellation.points[cells_of_face[tessellation.cells] == face, 0]
            assert np.abs(x - transom[face]).max() <= 1e-12
    assert any(data.face_layers)


def inflections(points, straight=0.0):
    """How often a plane polyline's curvature changes sign; below `straight` (1/m) it has none."""
    steps = np.diff(points, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    steps, lengths = steps[lengths > 1e-4], lengths[lengths > 1e-4]
    angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    curvature = np.diff(angles) / (0.5 * (lengths[1:] + lengths[:-1]))
    signs = np.sign(curvature[np.abs(curvature) > straight])
    return int((np.diff(signs) != 0).sum())


# At the knuckle of the barge's rake the lines turn, but always the same way. The coaster's stations
# and buttocks turn once, from the bilge to the flare of the bow; no waterline is hollow. Flatter
# than a circle of 150 m a line is straight to the eye: 0.6 m of it, a frame space, stand 0.3 mm off
# their chord. Of 50 m at the deck edge, that buttocks cross at a slant.
@pytest.mark.parametrize(
    "axis, kept, most, radius",
    [("x", (1, 2), 1, 150.0), ("y", (0, 2), 1, 50.0), ("z", (0, 1), 0, 150.0)],
)
def test_lines_are_fair(sample, axis, kept, most, radius):
    name, data, _, surface = sample
    particulars = data.particulars
    reach = {"x": particulars.length_pp, "y": 0.5 * particulars.beam, "z": particulars.draft}[axis]
    cut = 0
    for position in np.linspace(0.03, 0.97, 25) * reach:
        for curve in hn.section(surface, axis, position, 1e-5):
            found = inflections(curve.points[:, kept], 1.0 / radius)
            assert found <= (0 if name == "barge" else most), f"{axis} = {position:.2f} m"
            cut += 1
    assert cut >= 25


def test_the_count_of_inflections_counts():
    x = np.linspace(0.0, 60.0, 400)
    assert inflections(np.column_stack([x, np.cos(0.3 * x)])) == 6
    assert inflections(np.column_stack([x, 0.02 * x**2])) == 0
