# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of panels, read as the descriptions of their formats have them: WAMIT's of .gdf files (user
manual, 6.1) and Nemoh's of mesh files; half hulls with their plane of symmetry."""

import hull_io
import numpy as np
import pytest
from production_hulls import SAMPLES
from test_wetted_panels import panels_at


def read_gdf(path):
    """((ULEN, GRAV), (ISX, ISY), corners (n, 4, 3) times ULEN as they are): a header, two numbers,
    two numbers, one number, each on a line with what may follow, and 12 numbers a panel in any
    lines."""
    header, sizes, symmetry, count, *rest = path.read_text(encoding="ascii").splitlines()
    assert 0 < len(header) <= 72
    numbers = np.array(" ".join(rest).split(), dtype=float)
    count = int(count.split()[0])
    assert len(numbers) == 12 * count
    return (
        tuple(map(float, sizes.split()[:2])),
        tuple(map(int, symmetry.split()[:2])),
        numbers.reshape(count, 4, 3),
    )


def read_nemoh(path):
    """(symmetry about y = 0, corners (n, 4, 3)): "2" and the symmetry, numbered points up to number
    0, panels of four points' numbers up to 0."""
    rows = [row.split() for row in path.read_text(encoding="ascii").splitlines()]
    assert rows[0][0] == "2" and len(rows[0]) == 2
    end = next(k for k, row in enumerate(rows) if k and int(row[0]) == 0)
    points = {int(row[0]): [float(word) for word in row[1:]] for row in rows[1:end]}
    panels = []
    for row in rows[end + 1 :]:
        if set(row) == {"0"}:
            break
        panels.append([points[int(word)] for word in row])
    assert row == ["0"] * 4 and sorted(points) == list(range(1, len(points) + 1))
    return int(rows[0][1]), np.array(panels)


def fluxes(corners):
    """(3,) ∫ x n_x, ∫ y n_y, ∫ z n_z dA over panels (n, 4, 3): the mean of both ways to cut each in
    triangles, normals by the order of corners."""
    sums = np.zeros(3)
    for one in ((0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)):
        a, b, c = corners[:, one].transpose(1, 0, 2)
        sums += 0.5 * np.sum((a + b + c) / 3.0 * np.cross(b - a, c - a) / 2.0, axis=0)
    return sums


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("heel_deg", [0.0, 11.0])
def test_wamit_takes_all_panels(name, heel_deg, tmp_path):
    """All there as they are, none without area or with more than two corners in the water's
    surface, to which WAMIT objects. Upright the half y >= 0 has ISY = 1 and half of the volume by
    each flux. Heeled, the barge's deck is in the water: closing lines run along the transom's
    edge."""
    _, _, mesh = panels_at(name, 0.5, heel_deg, 20)
    hull_io.write_gdf(tmp_path / "hull.gdf", mesh.points, mesh.panels, half=mesh.half)
    (ulen, gravity), symmetry, corners = read_gdf(tmp_path / "hull.gdf")
    assert (ulen, gravity) == (1.0, 9.80665)
    is_half = heel_deg == 0.0
    assert symmetry == ((0, 1) if is_half else (0, 0))
    assert len(corners) == len(mesh.panels)
    # Corners within a millionth of one another are one, that of a triangle.
    wanted = mesh.points[mesh.panels]
    gaps = np.linalg.norm(corners[:, :, None] - wanted[:, None], axis=-1)
    assert max(gaps.min(axis=1).max(), gaps.min(axis=2).max()) < 1.1e-6
    assert corners[..., 2].max() == 0.0
    in_water = corners[..., 2] == 0.0
    same = (corners == np.roll(corners, 1, axis=1)).all(axis=2)
    assert ((in_water & ~same).sum(axis=1) <= 2).all() and (same.sum(axis=1) <= 1).all()
    areas = np.linalg.norm(
        np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]), axis=1
    )
    assert (0.5 * areas >= 1e-10).all()
    volumes = fluxes(corners) * (2.0 if is_half else 1.0)
    assert volumes == pytest.approx(np.full(3, volumes.mean()), rel=1e-8)
    assert volumes == pytest.approx(mesh.volumes, rel=1e-8)
    # Panels of a twentieth of the length.
    assert volumes.mean() == pytest.approx(mesh.displaced_volume, rel=2e-2)
    if is_half:
        assert (corners[..., 1] >= 0.0).all()


@pytest.mark.one_in(3)
@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("heel_deg", [0.0, 11.0])
def test_nemoh_takes_all_panels(name, heel_deg, tmp_path):
    """The half upright, with its symmetry told, all of the hull heeled."""
    _, _, mesh = panels_at(name, 0.5, heel_deg, 20)
    hull_io.write_nemoh(tmp_path / "hull.dat", mesh.points, mesh.panels, half=mesh.half)
    symmetry, corners = read_nemoh(tmp_path / "hull.dat")
    is_half = heel_deg == 0.0
    assert symmetry == int(is_half)
    assert corners == pytest.approx(mesh.points[mesh.panels], abs=1e-7)
    assert corners[..., 2].max() == 0.0
    if is_half:
        assert (corners[..., 1] >= 0.0).all()
    volumes = fluxes(corners) * (2.0 if is_half else 1.0)
    assert volumes == pytest.approx(mesh.volumes, rel=1e-8)
