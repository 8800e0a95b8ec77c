# SPDX-License-Identifier: GPL-3.0-or-later
"""A half hull on the wrong side is refused with a sentence, in place of numbers that are none."""

import hull_io.sides
import hull_native
import numpy as np
import pytest

SENTENCE = "lies to starboard .* mirror it to port"


ACROSS = [0.0, 0.002, 0.02, 0.3]


def box(side, across=0.0):
    """The half of a box 10 x 4 x 3 m on one side, open on top and in the centre plane, over which
    its centre line lies by that part of its half-breadth."""
    points = np.array(
        [(x, side * y, z) for x in (0.0, 10.0) for y in (-2.0 * across, 2.0) for z in (0.0, 3.0)]
    )
    faces = np.array([[2, 3, 7, 6], [0, 2, 6, 4], [0, 1, 3, 2], [4, 6, 7, 5]])
    if side < 0:
        faces = faces[:, ::-1]
    creases = {tuple(sorted(pair)) for f in faces.tolist() for pair in zip(f, f[1:] + f[:1])}
    mesh = hull_native.ControlMesh(
        points, np.full(4, 4, dtype=np.int32), faces.reshape(-1).astype(np.int32),
        np.array(sorted(creases), dtype=np.int32), np.empty(0, dtype=np.int32),
    )  # fmt: skip
    return hull_native.LimitSurface(mesh)


def test_the_port_half_is_measured():
    body = hull_native.HullBody(box(1.0), mirrored=True)
    assert hull_native.hydrostatics(body, draft=1.5).displaced_volume == pytest.approx(60.0)


@pytest.mark.parametrize("across", ACROSS)
def test_hydrostatics_are_refused(across):
    body = hull_native.HullBody(box(-1.0, across), mirrored=True)
    with pytest.raises(ValueError, match=SENTENCE):
        hull_native.hydrostatics(body, draft=1.5)
    whole = hull_native.HullBody(box(-1.0, across), mirrored=False)
    assert hull_native.hydrostatics(whole, draft=1.5).displaced_volume > 0.0


def test_a_body_that_is_moved_over_is_refused_and_back_again():
    surface = box(1.0)
    points = np.array(surface.mesh.points)
    body = hull_native.HullBody(surface, mirrored=True)
    surface.set_points(points - [0.0, 3.0, 0.0])
    body.update()
    with pytest.raises(ValueError, match=SENTENCE):
        hull_native.hydrostatics(body, draft=1.5)
    surface.set_points(points)
    body.update()
    assert hull_native.hydrostatics(body, draft=1.5).displaced_volume == pytest.approx(60.0)


@pytest.mark.parametrize("across", [0.02, 0.3, 0.95])
def test_a_port_half_across_the_centre_plane_is_measured(across):
    body = hull_native.HullBody(box(1.0, across), mirrored=True)
    found = hull_native.hydrostatics(body, draft=1.5)
    assert found.immersed_beam == pytest.approx(4.0)


@pytest.mark.parametrize("across", [0.0, 0.3, 0.499, 0.501, 0.9])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_files_are_mended_by_the_same_rule(side, across):
    surface = box(side, across)
    body = hull_native.HullBody(surface, mirrored=True)
    if hull_io.sides.lies_to_starboard(surface.mesh.points[:, 1]):
        with pytest.raises(ValueError, match=SENTENCE):
            hull_native.hydrostatics(body, draft=1.5)
    else:
        assert hull_native.hydrostatics(body, draft=1.5).displaced_volume > 0.0


def test_a_whole_hull_may_reach_further_to_starboard():
    """As a proa with her outrigger does."""
    lines = {"stations": [5.0], "waterlines": [], "buttocks": [0.3]}
    with pytest.raises(ValueError, match=SENTENCE):
        hull_native.offset_table(box(-1.0, 0.3), **lines)
    table = hull_native.offset_table(box(-1.0, 0.3), **lines, mirrored=False)
    assert table.heights == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(ValueError, match="Nothing of the hull lies to port"):
        hull_native.offset_table(box(-1.0), **lines, mirrored=False)


@pytest.mark.parametrize("across", ACROSS)
def test_offsets_and_lines_plan_are_refused(tmp_path, across):
    half = box(-1.0, across)
    with pytest.raises(ValueError, match=SENTENCE):
        hull_native.offset_table(half, stations=[5.0], waterlines=[1.0], buttocks=[1.0])
    path = tmp_path / "lines.svg"
    with pytest.raises(ValueError, match=SENTENCE):
        hull_native.write_lines_drawing(half, path, mirrored=True, stations=[5.0], offsets=False)
    assert not path.exists()
