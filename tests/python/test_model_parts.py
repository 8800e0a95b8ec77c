# SPDX-License-Identifier: GPL-3.0-or-later
"""Models cut in planes, hollowed to a wall, and in segments for a machine."""

import itertools
import math

import hull_io
import hull_native as hn
import numpy as np
import pytest
from production_hulls import SAMPLES, body_of
from test_closed_models import CUBE, CUBE_TRIANGLES

BIG_MACHINE = (1e4, 1e4, 1e4)


def cube(size=2.0, centre=(0.0, 0.0, 0.0)):
    return hn.ClosedModel(0.5 * size * CUBE + centre, CUBE_TRIANGLES)


def ball(radius, around=48):
    """Corners on the sphere, in rings from pole to pole."""
    rings = around // 2
    polar = np.pi * np.arange(1, rings) / rings
    turn = 2 * np.pi * np.arange(around) / around
    x = np.sin(polar)[:, None] * np.cos(turn)
    y = np.sin(polar)[:, None] * np.sin(turn)
    z = np.repeat(-np.cos(polar)[:, None], around, axis=1)
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    points = radius * np.vstack([points, [[0, 0, -1], [0, 0, 1]]])
    south, north = len(points) - 2, len(points) - 1
    faces = []
    for i in range(rings - 2):
        for j in range(around):
            a, b = i * around + j, i * around + (j + 1) % around
            c, d = a + around, b + around
            faces += [(a, b, d), (a, d, c)]
    top = (rings - 2) * around
    for j in range(around):
        faces.append((south, (j + 1) % around, j))
        faces.append((north, top + j, top + (j + 1) % around))
    return hn.ClosedModel(points, faces)


def sample_model(name, tolerance=4e-4, scale=100.0):
    """In mm at 1 : scale."""
    sample, body = body_of(name)
    return hn.closed_model(body, tolerance * sample.ship.length_pp).scaled(1000.0 / scale)


# --- cut ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("axis", "xyz")
@pytest.mark.parametrize("at", [-0.4, 0.0, 0.7])
def test_cut_cube(axis, at):
    below, above = hn.cut_model(cube(), axis, at)
    assert below.open_sides == above.open_sides == 0
    assert below.volume == pytest.approx(4.0 * (1.0 + at), rel=1e-14)
    assert above.volume == pytest.approx(4.0 * (1.0 - at), rel=1e-14)
    k = "xyz".index(axis)
    assert below.points[:, k].max() == above.points[:, k].min() == at


def test_cut_beside_a_model():
    below, above = hn.cut_model(cube(), "x", -1.0)
    assert not len(below.triangles) and above.volume == pytest.approx(8.0)
    below, above = hn.cut_model(cube(), "x", 3.0)
    assert not len(above.triangles) and below.volume == pytest.approx(8.0)


def test_cut_through_a_hollow():
    """The ring of the cut is filled around the hollow, and both parts open it."""
    with pytest.raises(ValueError, match="cell must be a length"):
        hn.hollowed(cube(), 0.5, "0.25")
    hollow = hn.hollowed(cube(), 0.5, 0.25)
    for axis, at in itertools.product("xyz", (0.03, -0.2)):
        below, above = hn.cut_model(hollow.model, axis, at)
        assert below.open_sides == above.open_sides == 0
        assert below.volume + above.volume == pytest.approx(hollow.model.volume, rel=1e-13)
        (ring,) = [one for one in hollow.model.slices([at])] if axis == "z" else [None]
        if ring is not None:
            caps = below.points[below.triangles]
            flat = (caps[:, :, 2] == at).all(axis=1)
            a, b, c = caps[flat].transpose(1, 0, 2)
            area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
            assert area == pytest.approx(ring.area, rel=1e-12)


@pytest.mark.parametrize("name", SAMPLES)
def test_cut_samples(name):
    """In the centre plane too, where many corners lie; the caps have the area of the slice."""
    model = sample_model(name, 8e-4)
    low, high = model.points.min(axis=0), model.points.max(axis=0)
    for axis, share in (("x", 0.37), ("y", 0.5), ("z", 0.31), ("x", 0.9), ("y", 0.2)):
        k = "xyz".index(axis)
        at = 0.0 if (axis, share) == ("y", 0.5) else float(low[k] + share * (high[k] - low[k]))
        below, above = hn.cut_model(model, axis, at)
        assert below.open_sides == above.open_sides == 0
        assert below.volume + above.volume == pytest.approx(model.volume, rel=1e-12)
        assert (below.points[:, k] <= at).all() and (above.points[:, k] >= at).all()
        if axis == "y" and at == 0.0:
            assert below.volume == pytest.approx(above.volume, rel=1e-6)
        for part, sign in ((below, 1.0), (above, -1.0)):
            corners = part.points[part.triangles]
            flat = (corners[:, :, k] == at).all(axis=1)
            a, b, c = corners[flat].transpose(1, 0, 2)
            turned = sign * np.cross(b - a, c - a)[:, k]
            if not len(turned):  # nothing of the model is there, as between two hulls
                continue
            # No triangle of a cap is turned over: they do not overlap.
            assert turned.min() >= -1e-6 * turned.sum()


def test_cut_refused():
    for axis, at, words in (("w", 0.0, "axis"), ("x", math.nan, "finite")):
        with pytest.raises(ValueError, match=words):
            hn.cut_model(cube(), axis, at)


# --- walls ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("wall", [0.1, 0.25, 0.6])
def test_wall_of_a_cube(wall):
    """8 - (2 - 2 t)^3, flat sides exact; chamfers at edges are off by cell² along each."""
    cell = 0.05
    hollow = hn.hollowed(cube(), wall, cell)
    inner = 2.0 - 2.0 * wall
    assert hollow.hollows == 1 and hollow.model.open_sides == 0
    assert hollow.model.volume == pytest.approx(8.0 - hollow.hollow_volume, rel=1e-12)
    short = inner**3 - hollow.hollow_volume
    assert -1e-9 <= short <= 12 * inner * cell**2
    points = hollow.model.points[8:]
    assert np.abs(np.abs(points).max(axis=1) - (1.0 - wall)).max() < 1e-12


def test_steiner_of_a_cube():
    # 6 faces of 4 t, 12 edges of 2 t²: 24 t - 24 t²; the corners' 8 t³ are what it leaves out.
    for wall in (0.1, 0.3):
        assert hn.wall_volume(cube(), wall) == pytest.approx(24 * wall - 24 * wall**2, rel=1e-12)


def test_wall_of_a_ball():
    """Second order in the cubes, to the ball of radius r - t."""
    model, chord = ball(1.0, 128), 1.0 - math.cos(math.pi / 128) ** 2
    volumes = []
    for cell in (0.12, 0.06, 0.03):
        hollow = hn.hollowed(model, 0.2, cell)
        distance = np.linalg.norm(hollow.model.points[len(model.points) :], axis=1)
        assert np.abs(distance - 0.8).max() < chord
        volumes.append(hollow.hollow_volume)
    steps = np.diff(volumes)
    assert 3.2 < steps[0] / steps[1] < 5.0
    limit = volumes[2] + steps[1] / 3.0
    assert abs(limit - 4 / 3 * math.pi * 0.8**3) < 4 * math.pi * 0.8**2 * chord
    # Area t - H t² + …: 4 pi (t - t²), and a third of t³ that it leaves out.
    area = hn.wall_volume(model, 0.2)
    assert area == pytest.approx(4 * math.pi * (0.2 - 0.04), rel=2e-3)


def test_thin_parts_stay_solid():
    """Two cubes are hollow each; a cone is not where it is thin."""
    parts = [cube(2.0, (-2.0, 0, 0)), cube(2.0, (2.0, 0, 0))]
    points = np.vstack([p.points for p in parts])
    triangles = np.vstack([parts[0].triangles, parts[1].triangles + 8])
    apart = hn.ClosedModel(points, triangles)
    assert hn.hollowed(apart, 0.2, 0.1).hollows == 2
    # A cone's tip: the wall is nowhere thinner than asked for.
    turn = 2 * np.pi * np.arange(64) / 64
    rim = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    cone = np.vstack([rim, [[0, 0, 0], [0, 0, 3.0]]])
    faces = [(64, (j + 1) % 64, j) for j in range(64)]
    faces += [(65, j, (j + 1) % 64) for j in range(64)]
    hollow = hn.hollowed(hn.ClosedModel(cone, faces), 0.2, 0.1)
    inner = hollow.model.points[66:]
    slant = 3.0 / math.hypot(1.0, 3.0)  # distance from the cone: (1 - z / 3 - r) slant
    radius = np.hypot(inner[:, 0], inner[:, 1])
    away = np.minimum((1.0 - inner[:, 2] / 3.0 - radius) * slant, inner[:, 2])
    assert away.min() > 0.2 * (1.0 - 2e-3)
    assert inner[:, 2].max() < 3.0 - 0.2 / slant * 3.0 + 1e-9


@pytest.mark.parametrize("name", ["coaster", "planing_boat"])
def test_walls_of_samples(name):
    """Closed, the inner surface a wall away from the triangles, by another way to find that."""
    model = sample_model(name)
    wall = 0.05 * np.ptp(model.points[:, 2])
    hollow = hn.hollowed(model, wall, wall)
    assert hollow.model.open_sides == 0
    # Whose cells are not known: there were those of the outer triangles alone once, and scaled()
    # read beyond them.
    assert len(model.cells) == len(model.triangles) and len(hollow.model.cells) == 0
    assert hollow.model.scaled(1.0).open_sides == 0
    inner = hollow.model.points[len(model.points) :]
    away = nearest(model, inner[:: max(1, len(inner) // 40)])
    assert away.min() > 0.99 * wall and np.median(np.abs(away / wall - 1.0)) < 1e-6


def test_wall_of_the_coaster_by_steiner():
    """Without the corners' t³ and the stem's, where the mitre is wider than a triangle."""
    model = sample_model("coaster")
    hollow = hn.hollowed(model, 2.0)
    thick = model.volume - hollow.hollow_volume
    assert thick == pytest.approx(hn.wall_volume(model, 2.0), rel=3e-3)


def nearest(model, points):
    """Distances (n,) of points from a model's triangles, one by one."""
    a, b, c = model.points[model.triangles].transpose(1, 0, 2)
    result = []
    for p in points:
        best = np.full(len(a), np.inf)
        normal = np.cross(b - a, c - a)
        size = np.einsum("ij,ij->i", normal, normal)
        with np.errstate(divide="ignore", invalid="ignore"):
            height = np.einsum("ij,ij->i", p - a, normal) / size
            foot = p - height[:, None] * normal
            inside = np.ones(len(a), dtype=bool)
            for s, e in ((a, b), (b, c), (c, a)):
                inside &= np.einsum("ij,ij->i", np.cross(e - s, foot - s), normal) >= 0.0
            best[inside] = np.abs(height[inside]) * np.sqrt(size[inside])
        for s, e in ((a, b), (b, c), (c, a)):
            way = e - s
            length = np.maximum(np.einsum("ij,ij->i", way, way), 1e-300)
            t = np.clip(np.einsum("ij,ij->i", p - s, way) / length, 0.0, 1.0)
            best = np.minimum(best, np.linalg.norm(s + t[:, None] * way - p, axis=1))
        result.append(np.nanmin(best))
    return np.array(result)


def test_walls_refused():
    for wall, cell, words in (
        (0.0, 0.1, "positive"),
        (0.1, 0.0, "positive"),
        (1.0, 0.1, "nothing hollow"),
        (0.1, 1e-4, "would do"),
        # The side that would do is larger than the wall: other cubes do not help.
        (1e-3, 1e-4, "take a wall of 0.00[0-9]* or more, and cubes as large, or a smaller model"),
        (0.3, 0.31, "take them no larger than the wall"),
    ):
        with pytest.raises(ValueError, match=words):
            hn.hollowed(cube(), wall, cell)


def test_the_largest_cubes_find_a_wall_however_it_lies():
    """Larger ones, of 1.3 walls and more, had the hollow joined to what is outside in some."""
    random = np.random.default_rng(1)
    for _ in range(60):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        turn *= np.linalg.det(turn)
        model = hn.ClosedModel(CUBE @ turn.T, CUBE_TRIANGLES)
        hollow = hn.hollowed(model, 0.3, 0.3)
        assert hollow.hollows == 1 and 2.0 < hollow.hollow_volume < 1.4**3
        assert np.abs(hollow.model.points[8:] @ turn).max() < 0.7 + 1e-9


def test_wall_ends_when_asked():
    class Enough(Exception):
        pass

    def stop(share):
        if share > 0.3:
            raise Enough

    with pytest.raises(Enough):
        hn.hollowed(ball(1.0), 0.1, 0.02, progress=stop)


# --- segments -------------------------------------------------------------------------------------


def test_a_box_is_one_segment():
    found = hn.segmented(cube(), machine=BIG_MACHINE)
    (one,) = found.segments
    assert one.can_be_made and one.has_back and one.fits and one.inaccessible == 0.0
    assert one.model.volume == pytest.approx(8.0)


def test_a_ball_is_halved():
    """No plane to lie on, half of it turned away: two halves, from both sides, and no more."""
    model = ball(1.0)
    found = hn.segmented(model, machine=BIG_MACHINE)
    assert len(found.segments) == 2 and all(one.can_be_made for one in found.segments)
    first, second = (one.direction for one in found.segments)
    assert first[1] == second[1] and first[0] != second[0]
    for one in found.segments:
        assert one.model.volume == pytest.approx(0.5 * model.volume, rel=1e-9)


def test_small_machine():
    """A bar of 2 x 2 x 12 for a machine of 3 x 3 x 3: four parts at least, of whole layers."""
    bar = hn.ClosedModel(CUBE * [1, 1, 6], CUBE_TRIANGLES)
    found = hn.segmented(bar, machine=(3.0, 3.0, 3.0))
    assert len(found.segments) == 4 and all(one.can_be_made for one in found.segments)
    assert sum(one.model.volume for one in found.segments) == pytest.approx(48.0, rel=1e-14)


def mushroom():
    """A square cap on a square stalk: from above all of it is hidden but the cap."""
    rings = [(0.5, 0.0), (0.5, 1.0), (1.0, 1.0), (1.0, 2.0)]
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float)
    points = np.vstack([np.hstack([r * corners, np.full((4, 1), z)]) for r, z in rings])
    faces = [(0, 2, 1), (0, 3, 2), (12, 13, 14), (12, 14, 15)]
    for i in range(3):
        for j in range(4):
            a, b = 4 * i + j, 4 * i + (j + 1) % 4
            faces += [(a, b, b + 4), (a, b + 4, a + 4)]
    return hn.ClosedModel(points, faces)


def test_accessibility_is_of_the_segment():
    """From below the stalk is in no one's way: one segment lying on the cap's top."""
    found = hn.segmented(mushroom(), machine=BIG_MACHINE)
    (one,) = found.segments
    assert one.direction == "-z" and one.can_be_made
    # Too high for the tool: halves, lying on the cut, as equal as they can be.
    found = hn.segmented(mushroom(), machine=(4.0, 4.0, 1.2), planes=8)
    assert len(found.segments) == 2 and all(one.can_be_made for one in found.segments)
    assert [one.model.volume for one in found.segments] == pytest.approx([2.5, 2.5])


@pytest.mark.parametrize("planes", [4, 5])
def test_own_faces_between_layers_are_reached_or_not(planes):
    """A hollow cube is made in halves, whether the hollow's faces lie in planes of the grid, where
    they once counted as cuts, or not."""
    points = np.vstack([2.0 * CUBE, CUBE])
    faces = np.vstack([CUBE_TRIANGLES, np.add([t[::-1] for t in CUBE_TRIANGLES], 8)])
    found = hn.segmented(hn.ClosedModel(points, faces), machine=BIG_MACHINE, planes=planes)
    assert len(found.segments) == 2 and all(one.can_be_made for one in found.segments)
    assert [one.model.volume for one in found.segments] == pytest.approx([28.0, 28.0])


def best_by_trial(found):
    return len(found.segments), sum(math.sqrt(one.model.volume) for one in found.segments)


def test_search_is_exact():
    """Against all ways to cut a bar across once or twice."""
    bar = hn.ClosedModel(CUBE * [1, 1, 6], CUBE_TRIANGLES)
    found = hn.segmented(bar, machine=(2.0, 2.0, 7.0), planes=12)
    count, roots = best_by_trial(found)
    places = np.linspace(-6, 6, 13)[1:-1]
    fitting = [(2, math.sqrt(4 * (p + 6)) + math.sqrt(4 * (6 - p))) for p in places if abs(p) <= 1]
    assert (count, roots) == pytest.approx(max(fitting, key=lambda one: (-one[0], one[1])))


@pytest.mark.parametrize("name", SAMPLES)
def test_segments_of_samples(name):
    model = sample_model(name, 8e-4)
    size = np.ptp(model.points, axis=0)
    machine = (0.45 * size[0], size[1], max(0.6 * size[1], size[2]))
    found = hn.segmented(model, machine=machine, planes=12)
    volumes = [one.model.volume for one in found.segments]
    assert sum(volumes) == pytest.approx(model.volume, rel=1e-11)
    assert all(one.model.open_sides == 0 for one in found.segments)
    assert len(found.segments) >= 3
    for one in found.segments:
        low, high = one.box
        assert (one.model.points >= np.array(low) - 1e-9).all()
        assert (one.model.points <= np.array(high) + 1e-9).all()
        assert one.fits or not one.can_be_made


@pytest.mark.parametrize("name", ["coaster", "planing_boat"])
def test_what_is_accessible(name):
    """By rays through the segment alone, from points on it, of another program: along the tool."""
    model = sample_model(name, 8e-4)
    size = np.ptp(model.points, axis=0)
    found = hn.segmented(model, machine=(0.5 * size[0], size[1], size[1]), planes=12)
    good = [one for one in found.segments if one.can_be_made]
    assert good
    random = np.random.default_rng(11)
    for one in good[:4]:
        k, sign = "xyz".index(one.direction[1]), 1.0 if one.direction[0] == "+" else -1.0
        # Turned so that the tool is above.
        order = [(k + 1) % 3, (k + 2) % 3, k]
        points = one.model.points[:, order] * [1.0, sign, sign]
        seen = hn.ClosedModel(points, one.model.triangles)
        corners = seen.points[seen.triangles]
        a, b, c = corners.transpose(1, 0, 2)
        across = np.cross(b - a, c - a)
        area = np.linalg.norm(across, axis=1)
        steep = across[:, 2] / np.maximum(area, 1e-300)
        chosen = random.choice(
            len(area), 400, p=np.where(steep > 0.05, area, 0.0) / area[steep > 0.05].sum()
        )
        middles = corners[chosen].mean(axis=1) + [0.0, 0.0, 1e-6]
        covered = seen.covers(middles)
        assert covered.mean() < 0.01


def test_dowels():
    bar = hn.ClosedModel(CUBE * [1, 1, 6], CUBE_TRIANGLES)
    found = hn.segmented(bar, machine=(3.0, 3.0, 3.0), dowel=0.3, dowel_depth=0.5)
    assert len(found.segments) == 4 and found.holes == 12 and found.bare_joints == 0
    disc = 16 * math.sin(2 * math.pi / 32) * 0.15**2
    assert found.holes_volume == pytest.approx(12 * disc * 0.5, rel=1e-12)
    whole = sum(one.model.volume for one in found.segments) + found.holes_volume
    assert whole == pytest.approx(48.0, rel=1e-13)
    assert all(one.model.open_sides == 0 for one in found.segments)
    # Both sides of a joint have their holes at the same places.
    lower, upper = sorted(found.segments, key=lambda one: one.box[0][2])[:2]
    at = lower.box[1][2]
    rims = [
        {
            tuple(np.round(p, 9))
            for p in one.model.points
            if p[2] == at and abs(p[0]) < 0.999 > abs(p[1])
        }
        for one in (lower, upper)
    ]
    assert rims[0] == rims[1] and len(rims[0]) == 64


def test_dowels_beside_corners_at_their_depth():
    """A corner just where a hole and what is left below it ends is in no dowel's way."""
    rings = [-6.0, -0.5, 6.0]
    points = np.concatenate([CUBE[[0, 1, 3, 2]] * [1, 1, 0] + [0, 0, z] for z in rings])
    faces = [(0, 2, 1), (0, 3, 2), (8, 9, 10), (8, 10, 11)]
    for a in (0, 4):
        for j in range(4):
            i, k = a + j, a + (j + 1) % 4
            faces += [(i, k, k + 4), (i, k + 4, i + 4)]
    bar = hn.ClosedModel(points, faces)
    found = hn.segmented(bar, machine=(3.0, 3.0, 3.0), dowel=0.25, dowel_depth=0.375)
    assert any(one.box[1][2] == 0.0 for one in found.segments)
    assert len(found.segments) == 4 and found.holes == 12 and found.bare_joints == 0


def test_dowels_of_a_hull(tmp_path):
    model = sample_model("coaster", 8e-4)
    found = hn.segmented(
        model, machine=(300.0, 150.0, 80.0), planes=12, dowel=6.0, dowel_depth=12.0
    )
    assert found.holes > 0 and all(one.model.open_sides == 0 for one in found.segments)
    whole = sum(one.model.volume for one in found.segments) + found.holes_volume
    assert whole == pytest.approx(model.volume, rel=1e-11)
    hull_io.write_stl(
        tmp_path / "a.stl", found.segments[0].model.points, found.segments[0].model.triangles
    )


def test_thick_layers():
    """A cone of 30° to its axis is made of layers across that, one of 60° of upright ones."""
    turn = 2 * np.pi * np.arange(64) / 64
    for height, steep in ((math.sqrt(3.0), True), (1.0 / math.sqrt(3.0), False)):
        rim = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
        points = np.vstack([rim, [[0, 0, 0], [0, 0, height]]])
        faces = [(64, (j + 1) % 64, j) for j in range(64)]
        faces += [(65, j, (j + 1) % 64) for j in range(64)]
        cone = hn.ClosedModel(points, faces)
        found = hn.segmented(cone, machine=BIG_MACHINE, making="thick_layers", planes=4)
        if steep:
            assert [one.direction for one in found.segments] == ["+z"]
            assert found.segments[0].can_be_made
        else:
            # Layers upright take it: there its faces are 60° from their normals.
            assert [one.direction in ("+x", "+y") for one in found.segments] == [True]


def test_segments_refused():
    for options, words in (
        ({"machine": (0.0, 1.0, 1.0)}, "positive"),
        ({"machine": BIG_MACHINE, "planes": 2}, "4 to 64"),
        ({"machine": BIG_MACHINE, "making": "casting"}, "thick_layers"),
        ({"machine": BIG_MACHINE, "dowel": 0.1}, "depth"),
        ({"machine": (0.02, 0.02, 0.02)}, "too many"),
        ({"machine": (1e-12, 1e-12, 1e-12)}, "too many"),
    ):
        with pytest.raises(ValueError, match=words):
            hn.segmented(cube(), **options)
