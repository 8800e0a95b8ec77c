# SPDX-License-Identifier: GPL-3.0-or-later
"""No set of shape fields folds a surface: what would is refused, and nothing else is.

HULL_FIELD_SETS is the number of sets of all samples together, 100 when not said; 500 take a minute.
"""

import os

import hull_native as hn
import numpy as np
import pytest
from transformation_hulls import SAMPLES, Sample

SEED = 20261126
SETS = int(os.environ.get("HULL_FIELD_SETS", 100))


def random_field(random, low, high, points):
    """One that works on the hull: from gentle to far beyond what its extent allows."""
    size = high - low
    base = points[random.integers(len(points))] + 0.05 * size * random.normal(size=3)
    extent = size[0] * random.uniform(0.05, 0.5)
    how = {"extent": extent, "falloff": random.uniform(0.05, 0.95)}
    if random.random() < 0.3:
        return hn.ShapeField.at_point(base, (0, 0, 0), protects=True, **how)
    shift = random.normal(size=3)
    shift *= extent * random.uniform(0.02, 0.9) / np.linalg.norm(shift)
    if random.random() < 0.5:
        return hn.ShapeField.at_point(base, shift, **how)
    along = base + size * [0.2, 0.0, 0.1] * random.normal(size=3)
    curve = hn.FieldCurve([base, 0.5 * (base + along) + 0.01 * size, along])
    return hn.ShapeField.along(curve, shift, **how)


def folds_where(fields, place, step):
    """Whether space is folded at a place, by what neighbouring points become: no derivative is
    asked for."""
    columns = []
    for unit in np.eye(3):
        ends = np.array([place + step * unit, place - step * unit])
        moved = ends + fields.at(ends)[0]
        columns.append((moved[0] - moved[1]) / (2.0 * step))
    return np.linalg.det(np.stack(columns, axis=1)) < 1e-6


def seen_folds(surface, moved, n=7):
    """Of points all over the surface: where the normal turned by a right angle or more."""
    u = (np.arange(n) + 0.5) / n
    uv = np.stack(np.meshgrid(u, u), axis=-1).reshape(-1, 2)
    cells = np.repeat(np.arange(surface.cell_count), len(uv))
    uv = np.tile(uv, (surface.cell_count, 1))
    return (surface.normals(cells, uv) * moved.normals(cells, uv)).sum(axis=1) <= 0.0


@pytest.mark.parametrize("name", SAMPLES)
def test_nothing_folds_and_each_refusal_is_right(name):
    sample = Sample(name)
    surface, points = sample.surface, sample.mesh.points
    low, high = points.min(axis=0), points.max(axis=0)
    reshape = hn.Reshape(surface)
    refused = folded = followed = 0
    for trial in range(SETS // len(SAMPLES)):
        random = np.random.default_rng([SEED, SAMPLES.index(name), trial])
        own = [random_field(random, low, high, points) for _ in range(random.integers(1, 4))]
        blend = ("exact", "sum")[trial % 2]
        fields = hn.ShapeFields(own, mirrored=sample.half, blend=blend)
        shifts, gradients = fields.at(reshape.positions)
        try:
            result = reshape.solve(shifts, gradients=gradients)
        except ValueError as error:
            assert "fold" in str(error)
            worst = int(np.argmax(np.linalg.det(np.eye(3) + gradients) <= 0.0))
            assert folds_where(fields, reshape.positions[worst], 1e-6 * (high - low).max())
            refused += 1
            continue
        moved = hn.LimitSurface(surface.mesh.with_points(points + result.moves))
        if result.folded_place is not None:  # who applies the fields refuses it
            at = hn.SurfaceTree(surface).closest_points(result.folded_place[None])
            turned = surface.normals(at.cells, at.uv) * moved.normals(at.cells, at.uv)
            assert turned.sum() < 1e-6, (name, trial)
            folded += 1
            continue
        assert not seen_folds(surface, moved).any(), (name, trial)
        followed += 1
    print(name, "refused", refused, "folded", folded, "followed", followed)
    assert refused > 0 and followed > 0
