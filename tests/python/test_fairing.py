# SPDX-License-Identifier: GPL-3.0-or-later
"""Fair Region: the deviation is met, limits hold, the optimum is that of a dense solution and
stationary by differences.
"""

import hull_native as hn
import numpy as np
import pytest

SEED = 20261123
ENERGIES = ("lengthwise", "blend", "thin_plate", "curvature", "variation")


def slopes_of(function, x, step=1e-6):
    """By differences forward."""
    here = function(x)
    return np.array([function(moved) - here for moved in x + step * np.eye(len(x))]) / step


def bulging_sheet(columns=9, rows=7, noise=0.02):
    """A smooth sheet of quadrilaterals with noise, without creases but its border."""
    random = np.random.default_rng(SEED)
    x, y = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    z = 0.1 * x * (columns - 1 - x) + 0.15 * y * (rows - 1 - y)
    points = np.stack([x, y, z + random.normal(0.0, noise, z.shape)], axis=2).reshape(-1, 3)
    a = (np.arange(columns - 1)[:, None] * rows + np.arange(rows - 1)).ravel()
    faces = np.stack([a, a + rows, a + rows + 1, a + 1], axis=1)
    mesh = hn.ControlMesh(points.astype(float), np.full(len(faces), 4), faces.ravel())
    inner = np.flatnonzero(((x > 1) & (x < columns - 2) & (y > 1) & (y < rows - 2)).ravel())
    return hn.LimitSurface(mesh), inner


def with_moves(surface, moves):
    return hn.LimitSurface(surface.mesh.with_points(surface.mesh.points + moves), surface.scheme)


def shifts(surface, moves):
    """(rms over where it shifts, largest) of a surface's shift by area, summed up over samples."""
    places = hn.Reshape(surface)
    found = hn.SurfaceTree(surface).closest_points(places.positions)
    start, points, weights = hn.point_weights(surface, found.cells, found.uv)
    rows = np.repeat(np.arange(len(places.areas)), np.diff(start))
    shift = np.zeros((len(places.areas), 3))
    np.add.at(shift, rows, weights[:, None] * moves[points])
    is_in = np.zeros(len(places.areas), dtype=bool)
    is_in[rows[moves[points].any(axis=1) & (weights != 0.0)]] = True
    square = (shift**2).sum(axis=1)
    area = places.areas[is_in]
    return np.sqrt((area * square[is_in]).sum() / area.sum()), np.sqrt(square.max())


@pytest.mark.parametrize("energy", ENERGIES)
def test_the_deviation_is_met(energy):
    surface, inner = bulging_sheet()
    region = hn.FairRegion(surface, inner, energy=energy)
    for deviation in (1e-4, 1e-3, 4e-3):
        faired = region.solve(deviation)
        assert faired.bound == "deviation" and faired.settled
        assert faired.rms == pytest.approx(deviation, rel=1e-9)
        rms, largest = shifts(surface, faired.moves)
        assert rms == pytest.approx(deviation, rel=1e-6)
        assert largest == pytest.approx(faired.largest, rel=1e-6)
        assert faired.energy_after < faired.energy_before
        others = np.setdiff1d(np.arange(len(surface.mesh.points)), inner)
        assert not faired.moves[others].any() and not faired.moves[:, 0].any()
    # The energies told are those of the surface, but for what lies outside the region.
    if energy in ("curvature", "variation"):
        gain = hn.fair_energy(surface, energy) - hn.fair_energy(
            with_moves(surface, faired.moves), energy
        )
        assert faired.energy_before - faired.energy_after == pytest.approx(gain, rel=1e-6)


@pytest.mark.parametrize("energy", ENERGIES)
def test_the_largest_shift_bounds(energy):
    surface, inner = bulging_sheet()
    region = hn.FairRegion(surface, inner, energy=energy)
    free = region.solve(0.004)
    bound = region.solve(0.004, largest=0.5 * free.largest)
    assert bound.bound == "largest"
    assert bound.largest == pytest.approx(0.5 * free.largest, rel=1e-6) and bound.rms < 0.004
    assert free.energy_after < bound.energy_after < bound.energy_before


def test_more_than_is_of_use_is_not_taken():
    surface, inner = bulging_sheet()
    region = hn.FairRegion(surface, inner)
    faired = region.solve(1e3)
    assert faired.bound == "nothing" and faired.rms < 10.0
    more = region.solve(0.5 * faired.rms)
    assert more.bound == "deviation" and more.energy_after > faired.energy_after
    assert not region.solve(0.0).moves.any()


@pytest.mark.parametrize("energy", ("lengthwise", "thin_plate"))
def test_quadratic_energies_are_those_of_a_dense_solution(energy):
    """Energies by second derivatives of the surface with NumPy, shifts by weights of points."""
    surface, inner = bulging_sheet(6, 6)
    held = {"energy": energy, "keep_stations": False, "along_normals": False}
    deviation = 0.004
    faired = hn.FairRegion(surface, inner, **held).solve(deviation)
    count = 3 * len(inner)

    def moves_of(x):
        moves = np.zeros_like(surface.mesh.points)
        moves[inner] = x.reshape(-1, 3)
        return moves

    places = hn.Reshape(surface)
    found = hn.SurfaceTree(surface).closest_points(places.positions)
    start, points, weights = hn.point_weights(surface, found.cells, found.uv)
    rows = np.zeros((len(places.areas), len(surface.mesh.points)))
    for i in range(len(rows)):
        rows[i, points[start[i] : start[i + 1]]] = weights[start[i] : start[i + 1]]
    is_in = (rows[:, inner] != 0.0).any(axis=1)
    share = places.areas[is_in] / places.areas[is_in].sum()
    mass = np.kron((rows[is_in][:, inner].T * share) @ rows[is_in][:, inner], np.eye(3))
    x = faired.moves[inner].ravel()
    assert np.sqrt(x @ mass @ x) == pytest.approx(deviation, rel=1e-6)
    # Any other move of the same length has more.
    random = np.random.default_rng(SEED)
    best = _quadratic(energy, surface, faired.moves)
    assert best == pytest.approx(faired.energy_after - faired.energy_before, rel=1e-6)
    for size in (1e-2, 1e-1, 1.0):
        for _ in range(20):
            other = x + size * deviation * random.normal(size=count)
            other *= deviation / np.sqrt(other @ mass @ other)
            assert _quadratic(energy, surface, moves_of(other)) > best


def _quadratic(name, surface, moves):
    """How much more of a quadratic energy the surface has with moves, to the metric as it was: by
    second derivatives at Gauss's places of each cell of a sheet without irregular points."""
    nodes, shares = np.polynomial.legendre.leggauss(3)
    u = 0.5 * (nodes + 1.0)
    uv = np.stack(np.meshgrid(u, u, indexing="ij"), axis=2).reshape(-1, 2)
    weights = 0.25 * np.outer(shares, shares).ravel()
    cells = np.repeat(np.arange(surface.cell_count), len(uv))
    places = (cells, np.tile(uv, (surface.cell_count, 1)))
    _, s, t, ss, st, tt = surface.evaluate(*places, 2)
    moved = with_moves(surface, moves).evaluate(*places, 2)
    area = np.linalg.norm(np.cross(s, t), axis=1)
    metric = np.stack([(s * s).sum(1), (s * t).sum(1), (s * t).sum(1), (t * t).sum(1)], 1)
    inverse = np.linalg.inv(metric.reshape(-1, 2, 2))
    along_x = np.einsum("kij,kj->ki", inverse, np.stack([s[:, 0], t[:, 0]], axis=1))

    def energy(seconds, ms, mt):
        def covariant(second, base):
            along = np.stack([(base * s).sum(1), (base * t).sum(1)], axis=1)
            symbols = np.einsum("kij,kj->ki", inverse, along)
            return second - symbols[:, :1] * ms - symbols[:, 1:] * mt

        bends = [covariant(*pair) for pair in zip(seconds, (ss, st, tt))]
        full = np.stack([bends[0], bends[1], bends[1], bends[2]], 1).reshape(-1, 2, 2, 3)
        if name == "lengthwise":
            bent = np.einsum("ki,kj,kijc->kc", along_x, along_x, full)
            return (np.tile(weights, surface.cell_count) * area * (bent**2).sum(1)).sum()
        raised = np.einsum("kia,kjb,kijc->kabc", inverse, inverse, full)
        return (np.tile(weights, surface.cell_count) * area * (raised * full).sum((1, 2, 3))).sum()

    return energy(moved[3:], moved[1], moved[2]) - energy((ss, st, tt), s, t)


@pytest.mark.parametrize("energy", ("curvature", "variation"))
def test_geometric_optima_are_stationary(energy):
    """The energy's slope, by differences, is against that of the mean squared shift; a minimiser
    that knows values alone finds nothing better."""
    surface, inner = bulging_sheet(7, 7)
    deviation = 0.002
    faired = hn.FairRegion(surface, inner, energy=energy, most_steps=200).solve(deviation)
    # Along normals within stations each point has one direction, in which it has moved.
    directions = faired.moves[inner] / np.linalg.norm(faired.moves[inner], axis=1)[:, None]
    x = (faired.moves[inner] * directions).sum(axis=1)

    def moves_of(x):
        moves = np.zeros_like(surface.mesh.points)
        moves[inner] = x[:, None] * directions
        return moves

    def value(x):
        return hn.fair_energy(with_moves(surface, moves_of(x)), energy)

    def rms(x):
        return shifts(surface, moves_of(x))[0]

    assert rms(x) == pytest.approx(deviation, rel=1e-6)
    slope, of_rms = slopes_of(value, x), slopes_of(rms, x)
    across = slope - (slope @ of_rms) / (of_rms @ of_rms) * of_rms
    assert np.linalg.norm(across) < 2e-3 * np.linalg.norm(slope)
    assert slope @ of_rms < 0.0


def test_conditions_and_limits_hold():
    surface, inner = bulging_sheet()
    slopes = np.tile([0.0, 0.0, 1.0], (len(inner), 1))
    locked, held = inner[:2], inner[2:4]
    region = hn.FairRegion(
        surface,
        inner,
        along_normals=False,
        locked=locked,
        held_points=held,
        held_normals=np.tile([0.0, 0.0, 1.0], (len(held), 1)),
        conditions=[(inner, slopes)],
    )
    for value in (0.0, 1e-3):
        faired = region.solve(0.005, values=[value])
        assert faired.rms == pytest.approx(0.005, rel=1e-9)
        assert faired.moves[inner, 2].sum() == pytest.approx(value, abs=1e-15)
        assert not faired.moves[locked].any() and not faired.moves[held, 2].any()


@pytest.mark.parametrize("energy", ["thin_plate", "lengthwise", "curvature"])
def test_conditions_that_need_longer_moves_than_asked_for_are_refused(energy):
    surface, inner = bulging_sheet()
    condition = (inner, np.tile([0.0, 0.0, 1.0], (len(inner), 1)))
    region = hn.FairRegion(
        surface, inner, along_normals=False, conditions=[condition], energy=energy
    )
    # A mean of 10 mm.
    values = [0.01 * len(inner)]
    assert region.solve(0.05, values=values).rms <= 0.05 * (1.0 + 1e-9)
    for deviation in (0.001, 0.0):
        with pytest.raises(ValueError, match="more than the deviation: give a larger one"):
            region.solve(deviation, values=values)
    with pytest.raises(ValueError, match="more than the largest shift: give a larger one"):
        region.solve(0.05, largest=0.002, values=values)
    assert not region.solve(0.0, values=[0.0]).moves.any()


def test_creases_are_kept_unless_told():
    surface, _ = bulging_sheet()
    kinds = np.asarray(surface.mesh.vertex_kinds)
    everything = np.arange(len(kinds))
    kept = hn.FairRegion(surface, everything).solve(0.005)
    assert not kept.moves[kinds != 0].any() and kept.moves[kinds == 0].any()
    freed = hn.FairRegion(surface, everything, keep_creases=False).solve(0.005)
    assert freed.moves[kinds != 0].any() and not freed.moves[:, 0].any()


def test_moves_along_normals():
    surface, inner = bulging_sheet()
    faired = hn.FairRegion(surface, inner, keep_stations=False).solve(0.005)
    corners = surface.mesh.face_vertices.tolist()
    cells = [corners.index(point) for point in inner]
    normals = surface.normals(cells, np.zeros((len(cells), 2)))
    moves = faired.moves[inner]
    assert np.abs(np.cross(moves, normals)).max() < 1e-15


@pytest.mark.parametrize(
    "points, options, solve, words",
    [
        ([], {}, {}, "Choose"),
        ([10**6], {}, {}, "chosen point"),
        ([0], {}, {}, "None of the chosen points may move"),
        ([31], {"energy": "least"}, {}, "energy must be"),
        ([31], {}, {"deviation": -1.0}, "must not be negative"),
        ([31], {}, {"deviation": np.nan}, "must not be negative"),
        ([31], {}, {"deviation": np.inf}, "must not be negative"),
        ([31], {}, {"deviation": 1.0, "largest": 0.0}, "above zero"),
        ([31], {}, {"deviation": 1.0, "values": [1.0]}, "values of conditions"),
        ([31], {"conditions": [([0], [[0.0, 0.0, 1.0]])]}, {}, "may not move"),
    ],
)
def test_nonsense_is_refused(points, options, solve, words):
    surface, _ = bulging_sheet()
    with pytest.raises(ValueError, match=words):
        hn.FairRegion(surface, points, **options).solve(**{"deviation": 0.01, **solve})
