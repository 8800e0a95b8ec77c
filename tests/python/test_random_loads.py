# SPDX-License-Identifier: GPL-3.0-or-later
"""Many random loads of the samples and of an odd lump come to rest, or say why not."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]

HEELS = np.radians(np.arange(0, 95, 5))


def sample_body(name):
    data = hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json")
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.HullBody(hn.LimitSurface(mesh), mirrored=True), data.particulars


def odd_body():
    """A closed lump without any symmetry, rounded but for a few creases."""
    random = np.random.default_rng(5)
    corners = [(x, y, z) for x in (0, 20) for y in (-4, 4) for z in (0, 5)]
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    points = np.array(corners) + random.uniform(-1, 1, (8, 3))
    mesh = hn.ControlMesh(points, [4] * 6, np.ravel(faces), creases=[(0, 1), (1, 3), (4, 6)])
    return hn.HullBody(hn.LimitSurface(mesh), mirrored=False)


def check_rests(body, whole_t, length, beam, depth, count, seed):
    """Random loads come to a stable rest, or sink because they are too heavy."""
    random = np.random.default_rng(seed)
    masses = whole_t * random.uniform(0.02, 1.05, count)
    middle = np.array([length / 2, 0, depth / 2])
    spread = np.array([0.15 * length, 0.15 * beam, 0.4 * depth])
    centres = middle + spread * random.uniform(-1, 1, (count, 3))
    # A third has its centre of gravity in the centre plane, where upright rests are.
    centres[::3, 1] = 0
    rests = hn.equilibria(body, masses_t=masses, centres_of_gravity=centres, water_density=1.0)
    assert len(rests) == count
    for i, (mass, rest) in enumerate(zip(masses, rests)):
        where = f"seed {seed}, load {i}: {rest.status}: {rest.message}"
        if rest.status == "sinks":
            assert mass >= whole_t, where
            continue
        assert mass < whole_t, where
        assert rest.status == "stable", where
        assert abs(rest.volume_residual) < 1e-8 and rest.lever_residual < 1e-7, where
        assert rest.iterations <= 40, where


@pytest.mark.parametrize("name", ["barge", "coaster"])
def test_random_loads_of_samples(name):
    body, particulars = sample_body(name)
    depth = particulars.depth
    whole = hn.equilibrium(body, mass_t=1e9, centre_of_gravity=(0, 0, 0), water_density=1.0)
    check_rests(body, whole.whole_volume, particulars.length_pp, particulars.beam, depth, 400, 11)


def test_random_loads_of_an_odd_body():
    body = odd_body()
    whole = hn.equilibrium(body, mass_t=1e9, centre_of_gravity=(0, 0, 0), water_density=1.0)
    check_rests(body, whole.whole_volume, 20, 8, 5, 200, 12)


def test_levers_of_a_ship_with_free_trim_take_few_immersions():
    body, particulars = sample_body("coaster")
    volume = hn.upright_hydrostatics(body.surface, draft=particulars.draft, mirrored=True)
    levers = hn.righting_levers(
        body,
        mass_t=1.025 * volume.displaced_volume,
        centre_of_gravity=(volume.lcb, 0, 5.0),
        heels=HEELS,
    )
    assert levers.curve_evaluations <= 3.5 * len(HEELS) + 8
    assert levers.has_deck_edge
    assert 0 < levers.deck_edge_heel < np.radians(40)
    assert levers.gm == pytest.approx(volume.km_transverse - 5.0, abs=1e-6)
