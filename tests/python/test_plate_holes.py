# SPDX-License-Identifier: GPL-3.0-or-later
"""Plates with holes, as around a bow thruster's tunnel, laid out and drawn."""

import hull_native as hn
import numpy as np
import pytest
import vessels
from plate_hulls import cylinder, grid_surface, one, sphere


def tube(around=16, rows=4):
    """A cylinder that is closed around x, open at its ends."""
    angles = np.arange(around) * 2.0 * np.pi / around
    ring = np.stack([0.0 * angles, 2.0 * np.cos(angles), 2.0 * np.sin(angles)], axis=1)
    points = np.concatenate([ring + [x, 0.0, 0.0] for x in range(rows + 1)])
    faces = [
        (k + i, k + around + i, k + around + (i + 1) % around, k + (i + 1) % around)
        for k in range(0, around * rows, around)
        for i in range(around)
    ]
    return hn.LimitSurface(hn.ControlMesh(points, [4] * len(faces), np.ravel(faces)))


def around(plates):
    """The plate with a hole."""
    return one([plate for plate in plates if len(plate.loops) == 2])


def length(sides):
    return sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for _, line in sides)


def enclosed(sides):
    """Area within a loop of sides, above 0 where it runs counter-clockwise."""
    x, y = np.concatenate([line[:-1] for _, line in sides]).T
    return 0.5 * (x @ np.roll(y, -1) - y @ np.roll(x, -1))


def test_on_a_cylinder_it_is_developed():
    surface = cylinder()
    curves = hn.HullCurves(surface, 1e-5)
    axis = np.array([3.0, 2.5, 0.0]), np.array([0.0, 0.0, 1.0])
    plates = hn.plates(surface, curves.on_cylinder(axis[0], direction=axis[1], radius=0.6))
    plate = around(plates)
    flat, hole = plate.flat(), one(plate.flat().holes)
    assert flat.developed and flat.area == pytest.approx(plate.area, rel=1e-9)
    assert enclosed(flat.sides) + enclosed(hole) == pytest.approx(plate.area, rel=1e-4)
    assert -enclosed(hole) == pytest.approx(
        one([p for p in plates if p is not plate]).area, rel=1e-4
    )
    # Chords of the hull's curve and of the flat one.
    assert length(hole) == pytest.approx(length(plate.loops[1]), rel=1e-5)


@pytest.mark.parametrize("z", [9.8, 9.9])
def test_of_a_cap_it_is_stretched_at_its_edge(z):
    """Twice as much as a whole plate is there, at most (Timoshenko and Goodier 1951, 35)."""
    surface = sphere()
    curves = hn.HullCurves(surface, 1e-4)
    plate = around(hn.plates(surface, curves.in_plane(hn.plane_across("z", z)), size=0.5))
    flat, whole = plate.flat(), one(hn.plates(surface, [], size=0.5)).flat()
    assert flat.converged and not flat.developed
    ratio, of_whole = flat.stretch[1] / flat.stretch[0], whole.stretch[1] / whole.stretch[0]
    assert of_whole < ratio < 1.0 + 2.0 * (of_whole - 1.0)
    assert enclosed(flat.sides) + enclosed(one(flat.holes)) == pytest.approx(flat.area, rel=1e-5)
    assert enclosed(one(flat.holes)) < 0.0


def test_a_tunnel_through_the_coaster(tmp_path):
    surface = vessels.vessel("coaster").surface
    curves, seams = hn.shell_seams(surface, strake=3.0, plate_length=20.0)
    tunnel = curves.on_cylinder(
        np.array([40.0, 0.0, 3.0]), direction=np.array([0.0, 1.0, 0.0]), radius=0.7, name="Tunnel"
    )
    plate = around(hn.plates(surface, [*seams, *tunnel], left_out=[]))
    (listed,) = hn.plate_list([plate], thickness=0.012)
    assert listed.flat.converged and {name for name, _ in one(listed.flat.holes)} == {"Tunnel"}
    drawing = hn.plate_drawing(listed)
    path = tmp_path / "plate.dxf"
    drawing.write(path)
    assert "Tunnel" in path.read_text()
    assert len(listed.outline) == len(listed.flat.sides) + 1


def test_plates_are_let_in_around_openings():
    """Where seams and butts cross, which end around it: the plate let in is whole. The hull's area
    stays, and other plates are as they were."""
    surface = vessels.vessel("coaster").surface
    rules = [hn.SeamRule("waterline", 3.0), hn.SeamRule("station", 40.0)]
    thruster = hn.cylinder((40.0, -20.0, 3.0), (40.0, 20.0, 3.0), 0.7, name="Thruster", cut=True)
    far = hn.cylinder((40.0, -90.0, 3.0), (40.0, -80.0, 3.0), 0.7, name="Beside", cut=True)
    before = hn.plates(surface, hn.seams_by_rules(surface, rules)[1], left_out=[])
    for order in (1, -1):
        around_it = [hn.SeamRule("openings", d) for d in (0.0, 0.4)][::order]
        _, seams = hn.seams_by_rules(surface, rules + around_it, appendages=[thruster, far])
        plates = hn.plates(surface, seams)
        assert len(plates) == len(before) + 2
        assert sum(p.area for p in plates) == pytest.approx(sum(p.area for p in before), rel=1e-9)
        let_in = around(plates)
        assert let_in.area == pytest.approx(np.pi * (1.1**2 - 0.7**2), rel=1e-3)
        flat = let_in.flat()
        assert flat.converged and {name for name, _ in one(flat.holes)} == {"Thruster"}
    rule = hn.SeamRule("openings", 0.4)
    with pytest.raises(ValueError, match="no tunnel or tube opens the shell"):
        hn.seams_by_rules(surface, [rule], appendages=[far])
    with pytest.raises(ValueError, match="must be 0 m or more"):
        hn.SeamRule("openings", -0.1)


@pytest.mark.parametrize("order", [1, -1])
@pytest.mark.parametrize("turned", [1, -1])
@pytest.mark.parametrize(
    "corners", [[(1, 1), (2, 2)], [(2, 2), (1, 1)], [(2, 1), (1, 2)], [(3, 1), (2, 2), (1, 3)]]
)
def test_holes_that_touch(corners, order, turned):
    """Squares that have corners in common: the plate around them has a loop for each."""
    x, y = np.meshgrid(np.arange(7.0), np.arange(7.0), indexing="ij")
    surface = grid_surface(np.stack([x, y, 0.0 * x], axis=-1))
    curves = hn.HullCurves(surface, 1e-4)
    square = np.array([(0, 0, 5), (1, 0, 5), (1, 1, 5), (0, 1, 5), (0, 0, 5)], dtype=float)
    seams = [
        one(curves.projected(square[::turned] + [*corner, 0.0], direction=(0, 0, -1), name=str(k)))
        for k, corner in enumerate(corners)
    ]
    plates = hn.plates(surface, seams[::order])
    whole = max(plates, key=lambda p: p.area)
    assert [len(p.loops) for p in plates if p is not whole] == [1] * len(corners)
    assert len(whole.loops) == 1 + len(corners)
    flat = whole.flat()
    assert flat.area == pytest.approx(36.0 - len(corners), rel=1e-9)
    for hole in flat.holes:
        assert enclosed(hole) == pytest.approx(-1.0, rel=1e-9)


def test_closed_around_the_hull_is_refused():
    surface = tube()
    with pytest.raises(ValueError, match="closed around the hull"):
        one(hn.plates(surface, [])).flat()
    curves = hn.HullCurves(surface, 1e-4)
    ring = max(hn.plates(surface, curves.in_plane(hn.plane_across("x", 1.5))), key=lambda p: p.area)
    with pytest.raises(ValueError, match="closed around the hull"):
        ring.flat()


def test_a_closed_surface_is_refused():
    ball = hn.LimitSurface(
        hn.ControlMesh(
            np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float),
            [4] * 6,
            [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3],
        )
    )
    with pytest.raises(ValueError, match="closed around the hull"):
        one(hn.plates(ball, [])).flat()
