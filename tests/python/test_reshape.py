# SPDX-License-Identifier: GPL-3.0-or-later
"""Wanted shifts of the exact surface: affine ones are met on all meshes, the optimum is that of a
dense solution with NumPy, and limits hold on all samples."""

from pathlib import Path

import hull_native as hn
import numpy as np
import pytest
from reference_data import MESHES, reference_mesh
from transformation_hulls import grid_mesh
from vessels import surface_of_sample

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))
SEED = 20261123


def size_of(surface):
    return np.ptp(surface.mesh.points, axis=0).max()


def moved(surface, reshaped):
    """A surface of its own with the moves in it."""
    return hn.LimitSurface(
        surface.mesh.with_points(surface.mesh.points + reshaped.moves), surface.scheme
    )


def dense_rows(surface, reshape):
    """(places, points): the weights of all control points at the places, which are found anew on
    the surface by their positions."""
    found = hn.SurfaceTree(surface).closest_points(reshape.positions)
    begin, points, weights = hn.point_weights(surface, found.cells, found.uv)
    rows = np.zeros((len(reshape.positions), len(surface.mesh.points)))
    for i, row in enumerate(rows):
        row[points[begin[i] : begin[i + 1]]] = weights[begin[i] : begin[i + 1]]
    return rows


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
@pytest.mark.parametrize("name", MESHES)
def test_affine_shifts_are_met_exactly(name, scheme):
    surface = hn.LimitSurface(reference_mesh(name), scheme)
    random = np.random.default_rng([SEED, MESHES.index(name)])
    size = size_of(surface)
    reshape = hn.Reshape(surface)
    matrix, shift = random.normal(0, 0.2, (3, 3)), size * random.normal(0, 0.3, 3)
    field = lambda p: p @ matrix.T + shift  # noqa: E731
    result = reshape.solve(field(reshape.positions))
    assert result.largest < 1e-13 * size
    assert result.rms <= result.largest
    cells = random.integers(0, surface.cell_count, 300)
    uv = random.random((300, 2))
    before, after = surface.positions(cells, uv), moved(surface, result).positions(cells, uv)
    assert np.abs(after - before - field(before)).max() < 1e-13 * size


@pytest.mark.parametrize("name", SAMPLES)
def test_optimum_is_that_of_a_dense_solution(name):
    surface = surface_of_sample(name)
    points = surface.mesh.points
    size = size_of(surface)
    random = np.random.default_rng([SEED, SAMPLES.index(name)])
    locked = np.flatnonzero(points[:, 0] > np.quantile(points[:, 0], 0.7))
    in_plane = np.flatnonzero(np.abs(points[:, 1]) < 1e-9 * size)
    reshape = hn.Reshape(
        surface,
        locked=locked,
        held_points=in_plane,
        held_normals=np.tile([0.0, 1.0, 0.0], (len(in_plane), 1)),
    )
    x = reshape.positions / size
    shifts = 0.01 * size * np.stack([np.sin(9 * x[:, 2]), np.cos(7 * x[:, 0]), x[:, 0] ** 2], 1)
    shifts += 1e-3 * size * random.normal(size=shifts.shape)
    result = reshape.solve(shifts)
    rows = dense_rows(surface, reshape)
    root = np.sqrt(reshape.areas / reshape.areas.sum())[:, None]
    for axis in range(3):
        free = np.ones(len(points), bool)
        free[locked] = False
        if axis == 1:
            free[in_plane] = False
        best = np.zeros(len(points))
        best[free] = np.linalg.lstsq(root * rows[:, free], root[:, 0] * shifts[:, axis], None)[0]
        assert np.abs(rows @ (best - result.moves[:, axis])).max() < 1e-9 * size
        assert not result.moves[~free, axis].any()
    left = np.linalg.norm(shifts - rows @ result.moves, axis=1)
    assert result.rms == pytest.approx(np.sqrt((root[:, 0] ** 2 * left**2).sum()), rel=1e-9)
    assert result.largest == pytest.approx(left.max(), rel=1e-9)


def test_moves_along_one_axis_are_those_of_a_dense_solution():
    """Where no point may move otherwise what is wanted along other axes does not count."""
    surface = surface_of_sample("coaster")
    count, size = len(surface.mesh.points), size_of(surface)
    random = np.random.default_rng(SEED)
    for axis in range(3):
        others = np.delete(np.eye(3), axis, axis=0)
        reshape = hn.Reshape(
            surface,
            locked=[3, 4],
            held_points=np.tile(np.arange(count), 2),
            held_normals=np.repeat(others, count, axis=0),
        )
        shifts = 0.01 * size * random.normal(size=(len(reshape.positions), 3))
        moves = reshape.solve(shifts).moves
        assert not np.delete(moves, axis, axis=1).any() and not moves[[3, 4]].any()
        rows = dense_rows(surface, reshape)
        root = np.sqrt(reshape.areas / reshape.areas.sum())
        free = np.setdiff1d(np.arange(count), [3, 4])
        best = np.zeros(count)
        best[free] = np.linalg.lstsq(root[:, None] * rows[:, free], root * shifts[:, axis], None)[0]
        assert np.abs(rows @ (best - moves[:, axis])).max() < 1e-9 * size


def test_conditions_and_prescribed_moves_hold():
    surface = surface_of_sample("coaster")
    points = surface.mesh.points
    random = np.random.default_rng(SEED)
    slopes = random.normal(size=(3, 3))
    reshape = hn.Reshape(
        surface,
        prescribed=[5, 7],
        tied=[(8, 5)],
        tied_directions=[(0, 0, 1)],
        conditions=[([20, 21, 22], slopes)],
        stiffness=1e-3,
    )
    told = [(0.1, 0.0, 0.2), (0.0, 0.0, -0.1)]
    result = reshape.solve(np.zeros((len(reshape.positions), 3)), prescribed=told, values=[0.3])
    assert (result.moves[[5, 7]] == told).all()
    assert result.moves[8, 2] == pytest.approx(0.2, abs=1e-15)
    assert (slopes * result.moves[[20, 21, 22]]).sum() == pytest.approx(0.3, abs=1e-13)
    assert len(points) == len(result.moves)


def lean_along_keel(surface):
    """Largest y of the normals along edges in the centre plane, away from the edges' ends."""
    largest = 0.0
    for curve in hn.crease_curves(surface):
        t = np.linspace(0, curve.edge_count, 7 * curve.edge_count + 1)
        points = curve.evaluate(t)[0]
        if np.abs(points[:, 1]).max() > 1e-9 * size_of(surface):
            continue
        found = hn.SurfaceTree(surface).closest_points(points)
        largest = max(largest, np.abs(surface.normals(found.cells, found.uv)[:, 1]).max())
    return largest


def test_a_smooth_keel_stays_smooth():
    """A tube's half, square to the plane along its border below."""
    x, angle = np.meshgrid(np.linspace(0, 10, 9), np.linspace(0, np.pi / 2, 6), indexing="ij")
    y, z = np.sin(angle), -np.cos(angle)
    z[:, 1] = z[:, 0]
    points = np.stack([x, y, z], -1).reshape(-1, 3)
    a = (np.arange(8)[:, None] * 6 + np.arange(5)).ravel()
    faces = np.stack([a, a + 6, a + 7, a + 1], 1)
    surface = hn.LimitSurface(hn.ControlMesh(points, [4] * len(faces), faces.ravel()))
    tied, directions = hn.square_ties(surface)
    assert len(tied) == len(directions) == 2 * 7
    keel = np.flatnonzero(points[:, 1] == 0.0)
    limits = {
        "held_points": keel,
        "held_normals": np.tile([0.0, 1.0, 0.0], (len(keel), 1)),
        "locked": np.flatnonzero((points[:, 0] < 1) | (points[:, 0] > 9)),
    }
    lean = []
    for with_ties in ({"tied": tied, "tied_directions": directions}, {}):
        reshape = hn.Reshape(surface, **limits, **with_ties)
        p = reshape.positions
        shifts = 0.2 * np.stack([np.sin(p[:, 1]), np.cos(p[:, 2]), np.sin(2 * p[:, 1])], 1)
        lean.append(lean_along_keel(moved(surface, reshape.solve(shifts))))
    assert lean_along_keel(surface) < 1e-12 and lean[0] < 1e-12 < 1e-2 < lean[1]


def half_hull(name):
    """A half hull with the faces of a reference mesh, one less where that is closed: half of its
    border is the keel, along x, and all within two edges of the keel lies in z = 0, so that the
    surface is square to the centre plane. None where the faces are no disc. With the keel."""
    mesh = reference_mesh(name)
    ends = np.cumsum(mesh.face_sizes)
    faces = [f.tolist() for f in np.split(mesh.face_vertices, ends[:-1])]
    along = lambda fs: {(f[k - 1], f[k]) for f in fs for k in range(len(f))}  # noqa: E731
    half_edges = along(faces)
    if all((b, a) in half_edges for a, b in half_edges):
        faces = faces[1:]
        half_edges = along(faces)
    border = {a: b for a, b in half_edges if (b, a) not in half_edges}
    loop = [min(border)]
    while border[loop[-1]] != loop[0]:
        loop.append(border[loop[-1]])
    used = sorted({v for f in faces for v in f})
    edges = {tuple(sorted(e)) for e in half_edges}
    if len(loop) != len(border) or len(used) - len(edges) + len(faces) != 1 or len(loop) < 4:
        return None
    # A keel that turns at a point of one face would make that a face without area.
    owners = np.bincount(np.concatenate(faces), minlength=max(used) + 1)
    turns = [k for k, v in enumerate(loop) if owners[v] == 1]
    count = len(loop) // 2 + 1
    if turns:
        gaps = np.diff([*turns, turns[0] + len(loop)])
        first = turns[int(np.argmax(gaps))]
        loop, count = loop[first:] + loop[:first], min(count, int(gaps.max()) + 1)
    number = {v: i for i, v in enumerate(used)}
    faces = [[number[v] for v in f] for f in faces]
    loop, n = [number[v] for v in loop], len(used)
    # By Tutte 1963: inner points at the mean of their neighbours, within a convex border.
    matrix, right = np.eye(n), np.zeros((n, 2))
    near = np.zeros((n, n), bool)
    for a, b in edges:
        near[number[a], number[b]] = near[number[b], number[a]] = True
    for i in set(range(n)) - set(loop):
        matrix[i] -= near[i] / near[i].sum()
    right[loop[:count], 0] = np.linspace(-1, 1, count)
    angle = np.linspace(0, np.pi, len(loop) - count + 2)[1:-1]
    right[loop[count:]] = np.stack([np.cos(angle), np.sin(angle)], 1)
    plane = np.linalg.solve(matrix, right)
    keel = loop[:count]
    # Rows of quadrilaterals come to the keel square, as square_ties wants them.
    for v in keel:
        own = [f for f in faces if v in f]
        inwards = set(np.flatnonzero(near[v])) - set(loop)
        if len(own) == 2 and all(len(f) == 4 for f in own) and len(inwards) == 1:
            plane[inwards.pop(), 0] = plane[v, 0]
    reached = np.isin(np.arange(n), keel)
    for _ in range(2):
        reached |= near[reached].any(axis=0)
    z = np.where(reached, 0.0, 0.3 + plane[:, 1])
    sizes = [len(f) for f in faces]
    mesh = hn.ControlMesh(np.column_stack([plane, z]), sizes, np.concatenate(faces))
    return mesh, np.array(keel)


def leans(surface, keel):
    """|y| of the normals along the border's edges whose ends are both inside of the keel."""
    found = []
    for curve in hn.crease_curves(surface):
        vertices = curve.vertices.tolist()
        vertices += vertices[:1] if curve.closed else []
        for i, pair in enumerate(zip(vertices, vertices[1:])):
            if set(pair) <= set(keel[1:-1].tolist()):
                for place in (curve.left, curve.right):
                    cells, uv = place(np.linspace(i, i + 1, 13)[1:-1])
                    is_there = cells >= 0
                    normals = surface.normals(cells[is_there], uv[is_there])
                    found.extend(np.abs(normals[:, 1]))
    return np.array(found)


@pytest.mark.parametrize("scheme", ["biermann", "catmull_clark"])
def test_half_hulls_of_reference_meshes_stay_square_to_the_centre_plane(scheme):
    seen, worst_without = 0, 0.0
    for name in MESHES:
        made = half_hull(name)
        if made is None:
            continue
        mesh, keel = made
        surface = hn.LimitSurface(mesh, scheme)
        before = leans(surface, keel)
        if not len(before):
            continue
        assert before.max() < 1e-12, name
        seen += 1
        tied, directions = hn.square_ties(surface)
        held = {
            "held_points": np.flatnonzero(mesh.points[:, 1] == 0.0),
            "held_normals": np.tile([0.0, 1.0, 0.0], ((mesh.points[:, 1] == 0.0).sum(), 1)),
        }
        limits = {"tied": tied, "tied_directions": directions, "kept": hn.square_sums(surface)}
        random = np.random.default_rng([SEED, seen])
        for trial in range(3):
            for kept in (limits, {}):
                reshape = hn.Reshape(surface, **held, **kept)
                shifts = random.normal(0, 0.02, (4, 3)) @ random.normal(size=(3, 3))
                p = reshape.positions
                field = np.sin(np.column_stack([np.ones(len(p)), p]) @ shifts * 20) * 0.1
                now = leans(moved(surface, reshape.solve(field)), keel).max()
                if kept:
                    assert now < 1e-12, (name, trial, SEED)
                else:
                    worst_without = max(worst_without, now)
    assert seen >= 6 and worst_without > 1e-3


@pytest.mark.parametrize("name", SAMPLES)
def test_what_is_beyond_the_extent_stays_bit_by_bit(name):
    surface = surface_of_sample(name)
    places = hn.SurfacePlaces(surface)
    centre = places.positions[len(places.positions) // 3]
    radius = 0.15 * size_of(surface)
    distance = np.linalg.norm(places.positions - centre, axis=1) / radius
    shifts = np.clip(1 - distance, 0, None)[:, None] ** 3 * [0.0, 0.01 * radius, 0.02 * radius]
    beyond = places.points_beyond(shifts)
    # The rule, by weights had otherwise.
    found = hn.SurfaceTree(surface).closest_points(places.positions[distance < 1])
    begin, points, weights = hn.point_weights(surface, found.cells, found.uv)
    reached = np.unique(points[np.abs(weights) > 1e-12])
    assert not np.intersect1d(beyond, reached).size
    assert 0 < len(beyond) < len(surface.mesh.points)
    result = hn.Reshape(surface, places=places, locked=beyond).solve(shifts)
    after = surface.mesh.points + result.moves
    assert (after[beyond] == surface.mesh.points[beyond]).all()
    assert result.rms < 0.5 * np.sqrt(
        (places.areas * (shifts**2).sum(1)).sum() / places.areas.sum()
    )
    # Where all weights are of points beyond, so does the surface.
    found = hn.SurfaceTree(surface).closest_points(places.positions)
    begin, points, _ = hn.point_weights(surface, found.cells, found.uv)
    reached = np.add.reduceat(~np.isin(points, beyond), begin[:-1])
    now = hn.SurfacePlaces(moved(surface, result), places=places).positions
    assert (now == places.positions)[reached == 0].all()


def test_places_serve_all_surfaces_of_a_topology():
    surface = surface_of_sample("coaster")
    size = size_of(surface)
    random = np.random.default_rng(SEED)
    first = hn.SurfacePlaces(surface)
    other = hn.LimitSurface(
        surface.mesh.with_points(surface.mesh.points + random.normal(0, 1e-3 * size, (1, 3)))
    )
    again = hn.SurfacePlaces(other, places=first)
    anew = hn.SurfacePlaces(other)
    for one, two in ((again, anew), (hn.Reshape(other, places=first).places, anew)):
        assert (one.positions == two.positions).all() and (one.areas == two.areas).all()
    assert again.areas.sum() == pytest.approx(first.areas.sum(), rel=1e-9)
    field = 0.01 * size * np.sin(first.positions / size)
    results = [hn.Reshape(surface, **given).solve(field) for given in ({}, {"places": first})]
    assert (results[0].moves == results[1].moves).all()
    coarse = hn.SurfacePlaces(surface, per_side=2)
    assert len(coarse.positions) < 0.6 * len(first.positions)
    assert coarse.areas.sum() == pytest.approx(first.areas.sum(), rel=1e-3)
    smooth = hn.Reshape(surface, places=coarse).solve(0.01 * size * np.sin(coarse.positions / size))
    apart = (
        moved(surface, smooth).tessellate(3).points
        - moved(surface, results[0]).tessellate(3).points
    )
    assert np.abs(apart).max() < 2e-2 * 0.01 * size
    affine = hn.Reshape(surface, places=coarse).solve(0.1 * coarse.positions)
    assert affine.largest < 1e-13 * size
    with pytest.raises(ValueError, match="another surface"):
        hn.Reshape(surface_of_sample("barge"), places=first)
    with pytest.raises(ValueError, match="another surface"):
        hn.SurfacePlaces(hn.LimitSurface(surface.mesh, "catmull_clark"), places=first)
    with pytest.raises(ValueError, match="2 or 3 places"):
        hn.SurfacePlaces(surface, per_side=4)


def test_shifts_that_fold_space_are_refused_with_the_place():
    surface = surface_of_sample("coaster")
    reshape = hn.Reshape(surface)
    p, size = reshape.positions, size_of(surface)
    middle, steep = 0.6 * size, 1.2
    is_bent = p[:, 0] > middle
    shifts = np.zeros_like(p)
    shifts[is_bent, 0] = -steep * (p[is_bent, 0] - middle)
    gradients = np.zeros((len(p), 3, 3))
    gradients[is_bent, 0, 0] = -steep
    first = np.flatnonzero(is_bent)[0]
    assert hn.first_folded(gradients) == first
    with pytest.raises(ValueError, match=f"folds the hull at x {p[first, 0]:.6g}"):
        reshape.solve(shifts, gradients=gradients)
    assert hn.first_folded(0.3 * gradients) is None
    assert reshape.solve(0.3 * shifts, gradients=0.3 * gradients).folded_place is None
    gradients[:] = np.nan
    assert hn.first_folded(gradients) == 0
    with pytest.raises(ValueError, match="gradients, not"):
        reshape.solve(shifts, gradients=gradients[1:])
    with pytest.raises(ValueError, match="shape"):
        hn.first_folded(np.zeros((4, 3)))


def test_kept_sums_stay_zero():
    surface = surface_of_sample("roro")
    random = np.random.default_rng(SEED)
    kept = [([3, 4, 9], random.normal(size=(3, 3))), ([4, 9], random.normal(size=(2, 3)))]
    kept.append((kept[0][0], 2 * kept[0][1]))  # depends on another
    reshape = hn.Reshape(surface, kept=kept)
    size = size_of(surface)
    shifts = 0.01 * size * random.normal(size=reshape.positions.shape)
    free, result = hn.Reshape(surface).solve(shifts), reshape.solve(shifts)
    for points, slopes in kept:
        assert abs((slopes * result.moves[points]).sum()) < 1e-13 * size
        assert abs((slopes * free.moves[points]).sum()) > 1e-5 * size
    assert result.rms > free.rms
    # The same as conditions of no value, had another way.
    told = hn.Reshape(surface, conditions=kept[:2]).solve(shifts, values=[0.0, 0.0])
    assert np.abs(told.moves - result.moves).max() < 1e-9 * size
    with pytest.raises(ValueError, match=r"Kept sum 0 has the control point -1"):
        hn.Reshape(surface, kept=[([-1], [(1, 0, 0)])])


def creases_to_move(surface):
    kinds = surface.mesh.vertex_kinds
    return [
        (number, curve)
        for number, curve in enumerate(hn.crease_curves(surface))
        if curve.edge_count > 3 and (kinds[curve.vertices] != 1).all()
    ]


@pytest.mark.parametrize("name", SAMPLES)
def test_creases_move_as_told_and_others_stay(name):
    surface = surface_of_sample(name)
    size, points = size_of(surface), surface.mesh.points
    random = np.random.default_rng([SEED, SAMPLES.index(name)])
    number, curve = max(creases_to_move(surface), key=lambda found: found[1].edge_count)
    t = np.linspace(0, curve.edge_count, 6 * curve.edge_count + 1)
    # Of its own spline: the curve of the moved control points says where it is.
    told = np.zeros_like(points)
    told[curve.vertices] = 1e-3 * size * random.normal(size=(len(curve.vertices), 3))
    wanted = hn.LimitSurface(surface.mesh.with_points(points + told))
    before, after = curve.evaluate(t)[0], hn.crease_curves(wanted)[number].evaluate(t)[0]
    own, moves, distance, _ = hn.crease_moves(surface, number, t, after - before)
    assert (own == curve.vertices).all() and distance < 1e-12 * size
    # A shape that is no spline of its knots: by the best of NumPy from the curve's own points.
    shifts = 1e-2 * size * np.sin(5 * t)[:, None] * [0.0, 1.0, 0.5]
    _, _, left, at = hn.crease_moves(surface, number, t, shifts)
    assert left > 1e-4 * size and at in t
    others = [c for i, c in enumerate(hn.crease_curves(surface)) if i != number]
    kept = np.unique(np.concatenate([c.vertices for c in others] + [np.empty(0, int)]).astype(int))
    kept = np.setdiff1d(kept, own)
    reshape = hn.Reshape(surface, prescribed=own, locked=kept)
    result = reshape.solve(np.zeros_like(reshape.positions), prescribed=moves)
    now = hn.crease_curves(moved(surface, result))
    assert np.abs(now[number].evaluate(t)[0] - after).max() < 1e-12 * size
    for one, other in zip(hn.crease_curves(surface), now):
        if not np.intersect1d(one.vertices, own).size:
            s = np.linspace(0, one.edge_count, 50)
            if (surface.mesh.vertex_kinds[one.vertices] != 1).all():
                assert np.abs(one.evaluate(s)[0] - other.evaluate(s)[0]).max() < 1e-12 * size


@pytest.mark.parametrize("name", SAMPLES)
def test_staying_points_of_a_crease_stay_and_the_others_do_their_best(name):
    surface = surface_of_sample(name)
    size, random = size_of(surface), np.random.default_rng([SEED, SAMPLES.index(name)])
    number, curve = max(creases_to_move(surface), key=lambda found: found[1].edge_count)
    t = np.linspace(0, curve.edge_count, 6 * curve.edge_count + 1)
    shifts = 1e-3 * size * random.normal(size=(len(t), 3))
    staying = curve.vertices[::3]
    points, moves, distance, _ = hn.crease_moves(surface, number, t, shifts, staying=staying)
    stays = np.isin(points, staying)
    assert not moves[stays].any() and moves[~stays].any()
    got = hn.crease_shifts(surface, number, t, moves)
    assert distance == pytest.approx(np.linalg.norm(shifts - got, axis=1).max(), rel=1e-12)
    # What the curve of the moved control points does.
    after = surface.mesh.points.copy()
    after[points] += moves
    after = hn.LimitSurface(surface.mesh.with_points(after), surface.scheme)
    now = hn.crease_curves(after)[number].evaluate(t)[0] - curve.evaluate(t)[0]
    np.testing.assert_allclose(got, now, atol=1e-13 * size)
    # No other move of those that are free is nearer.
    free = np.flatnonzero(~stays)
    free = free if curve.closed else np.setdiff1d(free, (0, len(points) - 1))
    for k in free[:4]:
        for step in (1e-3, -1e-3):
            other = moves.copy()
            other[k, 1] += step * size
            left = shifts - hn.crease_shifts(surface, number, t, other)
            assert (left**2).sum() > ((shifts - got) ** 2).sum()
    with pytest.raises(ValueError, match="a move for each"):
        hn.crease_shifts(surface, number, t, moves[1:])


@pytest.mark.parametrize("name", SAMPLES)
def test_allowed_moves_are_the_nearest_and_never_refused(name):
    surface = surface_of_sample(name)
    size, random = size_of(surface), np.random.default_rng([SEED, SAMPLES.index(name)])
    count = len(surface.mesh.points)
    tied, directions = hn.square_ties(surface)
    centre = np.flatnonzero(np.abs(surface.mesh.points[:, 1]) < 1e-6 * size)
    limits = {
        "locked": random.choice(count, 3, replace=False),
        "held_points": centre,
        "held_normals": np.tile([0.0, 1.0, 0.0], (len(centre), 1)),
        "tied": tied,
        "tied_directions": directions,
        "kept": hn.square_sums(surface),
    }
    points = random.choice(count, min(count, 20), replace=False)
    told = 1e-3 * size * random.normal(size=(len(points), 3))
    moves = hn.allowed_moves(surface, points, told, **limits)
    assert not moves[np.isin(points, limits["locked"])].any()
    assert np.abs(moves[np.isin(points, centre), 1]).max(initial=0.0) < 1e-15 * size
    reshape = hn.Reshape(surface, **limits, prescribed=points)
    result = reshape.solve(np.zeros_like(reshape.positions), prescribed=moves)
    assert np.array_equal(result.moves[points], moves)
    # No other moves that are allowed are nearer: what is left is square to all of them.
    np.testing.assert_allclose(
        hn.allowed_moves(surface, points, moves, **limits), moves, atol=1e-13 * size
    )
    others = hn.allowed_moves(surface, points, random.normal(size=told.shape), **limits)
    assert abs(((told - moves) * others).sum()) < 1e-10 * size
    with pytest.raises(ValueError, match="a move for each"):
        hn.allowed_moves(surface, points, told[1:], **limits)


def test_crease_moves_are_the_least_squares_and_meet_the_ends():
    surface = surface_of_sample("coaster")
    number, curve = next(
        (i, c) for i, c in creases_to_move(surface) if not c.closed and c.edge_count > 4
    )
    t = np.linspace(0, curve.edge_count, 5 * curve.edge_count + 1)
    shifts = np.stack([np.sin(3 * t), np.cos(2 * t), t % 1], 1)
    points, moves, distance, at = hn.crease_moves(surface, number, t, shifts)
    assert (moves[0] == shifts[0]).all() and (moves[-1] == shifts[-1]).all()
    # The curve's basis by unit moves of its control points.
    basis = np.empty((len(t), len(points)))
    for k, point in enumerate(points):
        unit = surface.mesh.points.copy()
        unit[point, 0] += 1.0
        unit = hn.LimitSurface(surface.mesh.with_points(unit))
        one = hn.crease_curves(unit)[number].evaluate(t)[0] - curve.evaluate(t)[0]
        basis[:, k] = one[:, 0]
    rest = shifts - basis[:, [0, -1]] @ shifts[[0, -1]]
    best = np.linalg.lstsq(basis[:, 1:-1], rest, None)[0]
    assert np.abs(best - moves[1:-1]).max() < 1e-9
    left = np.linalg.norm(shifts - basis @ moves, axis=1)
    assert distance == pytest.approx(left.max()) and at == t[left.argmax()]
    with pytest.raises(ValueError, match="outside of"):
        hn.crease_moves(surface, number, t + 1, shifts)
    with pytest.raises(ValueError, match="a shift for each t"):
        hn.crease_moves(surface, number, t[1:], shifts)
    with pytest.raises(ValueError, match="no crease 999"):
        hn.crease_moves(surface, 999, t, shifts)


def tube_with_one_corner(k=8):
    """A round tube of k points around; its first border begins and ends in one corner."""
    angles = 2 * np.pi * np.arange(k) / k
    points = [np.stack([x + 0 * angles, np.sin(angles), -np.cos(angles)], 1) for x in range(4)]
    mesh = grid_mesh(np.array(points, dtype=float), is_round=True)
    sizes = np.full(3 * k, 4)
    return hn.LimitSurface(hn.ControlMesh(mesh.points, sizes, mesh.face_vertices, corners=[0]))


def test_a_crease_that_begins_and_ends_in_one_corner_moves_as_told():
    surface = tube_with_one_corner()
    number, curve = next((i, c) for i, c in enumerate(hn.crease_curves(surface)) if not c.closed)
    assert curve.vertices[0] == curve.vertices[-1] == 0
    t = np.linspace(0, curve.edge_count, 8 * curve.edge_count + 1)
    told = np.random.default_rng(SEED).normal(size=(8, 3))
    after = surface.mesh.points.copy()
    after[curve.vertices[:-1]] += told
    after = hn.LimitSurface(surface.mesh.with_points(after))
    shifts = hn.crease_curves(after)[number].evaluate(t)[0] - curve.evaluate(t)[0]
    points, moves, distance, _ = hn.crease_moves(surface, number, t, shifts)
    assert points.tolist() == curve.vertices[:-1].tolist() and distance < 1e-12
    np.testing.assert_allclose(moves, told, atol=1e-12)
    got = hn.crease_shifts(surface, number, t, moves)
    np.testing.assert_allclose(got, shifts, atol=1e-12)


def test_what_is_wrong_is_said():
    surface = surface_of_sample("coaster")
    count = len(surface.mesh.points)
    with pytest.raises(ValueError, match="as many tied_directions"):
        hn.Reshape(surface, tied=[(0, 1)])
    with pytest.raises(ValueError, match=rf"locked point is {count}"):
        hn.Reshape(surface, locked=[count])
    with pytest.raises(ValueError, match=r"conditions\[0\] must be"):
        hn.Reshape(surface, conditions=[3])
    with pytest.raises(ValueError, match="stiffness"):
        hn.Reshape(surface, stiffness=float("nan"))
    with pytest.raises(ValueError, match="No control point may move"):
        hn.Reshape(surface, locked=range(count), conditions=[([0], [(1, 0, 0)])])
    reshape = hn.Reshape(surface, locked=[3], prescribed=[3])
    none = np.zeros((len(reshape.positions), 3))
    with pytest.raises(ValueError, match="wanted shifts"):
        reshape.solve(none[1:], prescribed=[(0, 0, 0)])
    with pytest.raises(ValueError, match="Point 3 cannot move as prescribed"):
        reshape.solve(none, prescribed=[(1, 0, 0)])
    # 5 is tied to 3; 6 has a sum with 5 that 4 can keep.
    reshape = hn.Reshape(
        surface,
        tied=[(5, 3)],
        tied_directions=[(1, 0, 0)],
        kept=[([4, 5, 6], [(1, 0, 0)] * 3)],
        prescribed=[3, 5, 6],
    )
    none = np.zeros((len(reshape.positions), 3))
    with pytest.raises(ValueError, match="Points 3, 5 cannot all move as prescribed: some"):
        reshape.solve(none, prescribed=[(0, 0, 0), (1, 0, 0), (1, 0, 0)])
    with pytest.raises(ValueError, match="no number"):
        reshape.solve(none + np.nan, prescribed=np.zeros((3, 3)))
