# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves in plain Python: their parts, their problems by name, and the surface of
samples sampled to lines and back."""

from collections import Counter
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]


def sample_surface(name):
    data = hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json")
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.LimitSurface(mesh, data.scheme)


def lines_of(surface, stations=19, waterlines=9, curves=1e-5, has_flats=False, joined=3e-5):
    """(CurveNetwork, length) of evenly spread sections of a surface, so many inside its ends each;
    curves: their tolerance, of the length; joined: within how much of it they are. has_flats: with
    buttocks of flats and the ends of knuckles that fade out."""
    points = np.asarray(surface.mesh.points)
    low, high = points.min(axis=0), points.max(axis=0)
    length = high[0] - low[0]
    buttocks = np.linspace(0.0, high[1], waterlines + 2)[1:-1]
    lines = hn.network_curves(
        surface,
        stations=np.linspace(low[0], high[0], stations + 2)[1:-1],
        waterlines=np.linspace(low[2], high[2], waterlines + 2)[1:-1],
        tolerance=curves * length,
        **({"flat_buttocks": buttocks, "fading": True} if has_flats else {}),
    )
    return hn.CurveNetwork(lines, joined * length), length


def square_net(height=lambda x, y: 0.0 * x):
    """Lines of a surface over 0 … 10 m each way, three in each direction."""
    at = np.linspace(0.0, 10.0, 9)
    curves = []
    for name, x in zip("ABC", (0.0, 5.0, 10.0)):
        points = np.stack([np.full(9, x), at, height(np.full(9, x), at)], axis=1)
        curves.append(hn.NetworkCurve(name, points, kind="station", plane=(1, 0, 0, x)))
    for name, y in zip("UVW", (0.0, 5.0, 10.0)):
        points = np.stack([at, np.full(9, y), height(at, np.full(9, y))], axis=1)
        curves.append(hn.NetworkCurve(name, points, kind="buttock", plane=(0, 1, 0, y)))
    return curves


def test_parts_agree_with_one_another():
    network = hn.CurveNetwork(square_net(lambda x, y: 0.02 * x * y), 1e-3)
    assert network.problems == []
    assert (len(network.nodes), len(network.edges), network.region_count) == (9, 12, 4)
    uses = Counter()
    for region in range(network.region_count):
        ring = []
        for side in network.sides(region):
            for edge, is_along in side:
                uses[edge] += 1
                ring.append(tuple(network.edges[edge][:: 1 if is_along else -1]))
        # Each edge begins where the one before ends.
        assert all(a[1] == b[0] for a, b in zip(ring, ring[1:] + ring[:1]))
    assert sorted(uses.values()) == 8 * [1] + 4 * [2]
    for edge, (start, end) in enumerate(network.edges):
        points = network.edge_points(edge, 4)
        assert np.array_equal(points[[0, -1]], network.nodes[[start, end]])
    assert network.roles == [(2, 0, 0), (0, 0, 2), (2, 0, 0)] * 2


def test_patches_meet_their_edges_and_the_surface():
    height = lambda x, y: 0.02 * x * y + 1e-3 * x**2 * y  # noqa: E731
    network = hn.CurveNetwork(square_net(height), 1e-3)
    for region in range(network.region_count):
        patch = network.patch(region)
        places, triangles = patch.grid(6)
        points, normals = patch.evaluate(places)
        # Cubics at most in each direction, with straight ways across in the plane.
        assert np.abs(points[:, 2] - height(points[:, 0], points[:, 1])).max() < 2e-3
        assert np.allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-14)
        a, b, c = (points[triangles[:, k]] for k in range(3))
        assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), normals[triangles[:, 0]]) > 0).all()
        for number, side in enumerate(network.sides(region)):
            corners = patch.domain[[number, (number + 1) % 4]]
            ((edge, is_along),) = side
            on = network.edge_points(edge, 10)[:: 1 if is_along else -1]
            shares = np.linspace(0, 1, 11)[:, None]
            border, _ = patch.evaluate((1 - shares) * corners[0] + shares * corners[1])
            assert np.abs(border - on).max() < 1e-12


def test_a_moved_curve_moves_its_slaves():
    curves = square_net()
    ends = hn.CurveEnd("slave_tangent", master=4)
    curves[0] = hn.NetworkCurve("A", [(5, 5, 0), (7, 6, 0), (10, 10, 0)], start=ends)
    network = hn.CurveNetwork(curves, 1e-3)
    points = curves[4].points
    points[3] += (0, 0.5, 0.4)
    moved = network.with_curve(hn.NetworkCurve("V", points), 4)
    assert not np.allclose(moved.pieces(0)[0][2], network.pieces(0)[0][2])
    anew = hn.CurveNetwork([*curves[:4], hn.NetworkCurve("V", points), curves[5]], 1e-3)
    assert np.array_equal(moved.nodes, anew.nodes)
    assert [p.what for p in moved.problems] == [p.what for p in anew.problems]
    with pytest.raises(ValueError, match="There is no curve 6"):
        network.with_curve(curves[0], 6)
    both = network.with_curves([*curves[:4], hn.NetworkCurve("V", points), curves[5]])
    assert np.array_equal(both.nodes, anew.nodes)
    with pytest.raises(ValueError, match="give as many, not 5"):
        network.with_curves(curves[:5])


def test_meetings_are_found_whether_they_join_anything_or_not():
    curves = [
        hn.NetworkCurve("A", [(0, 0, 0), (10, 0, 0)]),
        hn.NetworkCurve("B", [(4, -5, 0.02), (4, 5, 0.02)]),
    ]
    assert hn.CurveNetwork(curves, 0.05).nodes.shape == (0, 3)
    ((first, second, places),) = hn.network_meetings(curves, 0.05)
    assert (first, second) == (0, 1)
    assert np.abs(places - [(4, 0, 0), (4, 0, 0.02)]).max() < 1e-12
    assert hn.network_meetings(curves, 0.01) == []
    with pytest.raises(ValueError, match="Curve A"):
        hn.network_meetings([hn.NetworkCurve("A", [(0, 0, 0), (0, 0, 0)])], 0.01)


def problem_of(curves, kind, **options):
    found = [p for p in hn.network_check(curves, 1e-3, **options) if p.kind == kind]
    assert found, [p.what for p in hn.network_check(curves, 1e-3, **options)]
    return found[0]


def test_near_misses_are_joined_or_named():
    for gap in (0.5e-3, 2e-3):
        curves = square_net()
        points = curves[1].points
        points[:, 2] += gap
        curves[1] = hn.NetworkCurve("B", points)
        problems = hn.network_check(curves, 1e-3)
        if gap < 1e-3:
            assert problems == []
            continue
        gaps = [p for p in problems if p.kind == "gap"]
        assert len(gaps) == 3
        for problem in gaps:
            assert problem.what.startswith("Curves B at (5.000, ")
            assert "2 mm, more than the tolerance of 1 mm" in problem.what
            assert np.linalg.norm(np.diff(problem.places, axis=0)) == pytest.approx(gap)
        # Not looked for any further than is asked.
        wide = hn.network_check(curves, 1e-3, near_misses=1.5)
        assert [p.kind for p in wide] == ["apart"]


def test_problems_have_names():
    dangling = square_net() + [hn.NetworkCurve("D", [(2, -1, 0), (2, 5, 0)], shape="line")]
    problem = problem_of(dangling, "dangling_end")
    assert problem.what.startswith("Curve D ends at (2.000, -1.000, 0.000) m, 1.000 m beyond")
    assert not problem.is_note and list(problem.curves) == [6]
    tee = square_net() + [hn.NetworkCurve("D", [(2, 0, 0), (2, 5, 0)], shape="line")]
    assert problem_of(tee, "tee").is_note
    twice = square_net() + square_net()[:1]
    assert list(problem_of(twice, "duplicate").curves) == [0, 6]
    off = square_net()
    off[0] = hn.NetworkCurve("A", off[0].points + [0.01, 0, 0], plane=(1, 0, 0, 0))
    assert problem_of(off, "off_plane").what.startswith("Point 0 of curve A")


def test_what_is_none_is_refused():
    with pytest.raises(ValueError, match="kind is one of 'station', .* not 'frame'"):
        hn.NetworkCurve("A", [(0, 0, 0), (1, 0, 0)], kind="frame")
    with pytest.raises(ValueError, match="shape is one of"):
        hn.NetworkCurve("A", [(0, 0, 0), (1, 0, 0)], shape="round")
    with pytest.raises(ValueError, match="kind is one of 'free', 'tangent'"):
        hn.CurveEnd("loose")
    with pytest.raises(TypeError, match="start has to be a CurveEnd"):
        hn.NetworkCurve("A", [(0, 0, 0), (1, 0, 0)], start="free")
    with pytest.raises(ValueError, match=r"plane has to be of shape \(4,\)"):
        hn.NetworkCurve("A", [(0, 0, 0), (1, 0, 0)], plane=(1, 0, 0))
    with pytest.raises(ValueError, match="tolerance must be above zero"):
        hn.CurveNetwork(square_net(), 0.0)
    with pytest.raises(ValueError, match="plane_angle"):
        hn.CurveNetwork(square_net(), 1e-3, plane_angle=-1.0)
    network = hn.CurveNetwork(square_net(), 1e-3)
    for call in (network.patch, network.sides):
        with pytest.raises(ValueError, match="There is no region 4"):
            call(4)
    with pytest.raises(ValueError, match="no edge 12"):
        network.edge_points(12, 3)
    with pytest.raises(ValueError, match=r"places\[1\] is not within"):
        network.patch(0).evaluate([(0.5, 0.5), (1.5, 0.5)])
    with pytest.raises(ValueError, match="one part or more"):
        network.patch(0).grid(0)


def test_slaves_follow_and_circles_are_named():
    master = hn.NetworkCurve("M", [(0, 0, 0), (4, 1, 0), (8, 0, 0)])
    slave = hn.NetworkCurve(
        "S", [(4, 1, 0), (6, 1, 3), (9, 1, 4)], start=hn.CurveEnd("slave_tangent", master=0)
    )
    network = hn.CurveNetwork([master, slave], 1e-3)
    ((degree, knots, points, weights),) = network.pieces(1)
    way = points[1] - points[0]
    assert np.allclose(way / np.linalg.norm(way), (1, 0, 0), atol=1e-12)
    assert len(knots) == len(points) + degree + 1 and (weights == 1).all()
    circle = [
        hn.NetworkCurve(n, m.points, start=hn.CurveEnd("slave_tangent", master=k))
        for n, m, k in (("M", master, 1), ("S", slave, 0))
    ]
    problem = problem_of(circle, "shape")
    assert "in a circle: M, slave of S, slave of M" in problem.what


@pytest.mark.parametrize("counts, most", [((9, 4), 1e-3), ((19, 9), 5e-4)])
def test_lines_of_the_coaster_give_her_back(counts, most):
    surface = sample_surface("coaster")
    points = np.asarray(surface.mesh.points)
    low, high = points.min(axis=0), points.max(axis=0)
    length = high[0] - low[0]
    stations, waterlines = (
        np.linspace(low[k], high[k], n + 2)[1:-1] for k, n in zip((0, 2), counts)
    )
    curves = hn.network_curves(
        surface, stations=stations, waterlines=waterlines, tolerance=1e-5 * length
    )
    network = hn.CurveNetwork(curves, 3e-5 * length)
    assert network.problems == []
    # A disc: one region more than edges beyond a tree.
    assert len(network.nodes) - len(network.edges) + network.region_count == 1
    found, normals = (
        np.concatenate(part)
        for part in zip(
            *(
                patch.evaluate(patch.grid(6)[0])
                for patch in map(network.patch, range(network.region_count))
            )
        )
    )
    closest = hn.SurfaceTree(surface).closest_points(found)
    assert np.sqrt(np.mean(closest.distances**2)) < most * length
    # Outwards, as the surface's: but where that is folded sharply.
    there = surface.normals(closest.cells, closest.uv)
    agree = np.einsum("ij,ij->i", normals, there)
    assert np.mean(agree > 0.9) > 0.97


@pytest.mark.parametrize(
    "name, curves",
    [("coaster", 1e-5), ("coaster", 1e-7), ("container_ship", 1e-5), ("bulk_carrier", 1e-5)],
)
def test_lines_are_within_their_tolerance_of_the_hull(name, curves):
    surface = sample_surface(name)
    network, length = lines_of(surface, curves=curves)
    edges = [network.edge_points(edge, 17) for edge in range(len(network.edges))]
    closest = hn.SurfaceTree(surface).closest_points(np.concatenate(edges))
    # Where curves miss one another a node is half-way.
    assert np.asarray(closest.distances).max() < 1.5 * curves * length


def test_a_tolerance_of_lines_is_above_zero():
    with pytest.raises(ValueError, match="tolerance has to be above zero"):
        hn.network_curves(sample_surface("barge"), tolerance=0.0)
