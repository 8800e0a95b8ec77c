# SPDX-License-Identifier: GPL-3.0-or-later
"""Why FREE!ship's wetted surface of a model of its own may be too large, as docs/coming-from.md has
it: a crease point goes to half of its place and a quarter of each neighbour along a crease, and
some are tagged without one. The numbers there, of "FREE!ship demo 3"."""

from collections import Counter

import hull_io
import hull_native
import numpy as np
import pytest
from hull_io import freeship, subdivision
from hull_io.freeship_points import CREASE, border_edges
from hull_io.hull_data import edge_key

MODEL = "FREE!ship demo 3.fbm"


class Kinds(freeship.BinaryCursor):
    """A cursor that keeps what kinds the points of a file are tagged as."""

    def record(self, layout):
        values = super().record(layout)
        if self.element.startswith("point ") and layout.startswith("i"):
            self.kinds.append(values[0])
        return values


def without_crease(path):
    """(hull_io.HullData of a file of FREE!ship, [indices of crease points without a crease])."""
    data, kinds = hull_io.read_hull(path), []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(freeship, "BinaryCursor", Kinds)
        patch.setattr(Kinds, "kinds", kinds, raising=False)
        freeship.read_freeship(path.read_bytes(), path.name)
    creases = border_edges(data.faces) | {edge_key(*edge) for edge in data.creases}
    ends = Counter(point for edge in creases for point in edge)
    used = {point for face in data.faces for point in face}
    return data, [point for point in sorted(used) if kinds[point] == CREASE and not ends[point]]


@pytest.fixture(scope="module")
def model(freeship_files):
    return without_crease(next(path for path in freeship_files if path.name == MODEL))


def subdivided(data, levels, drawn):
    """Triangles (n, 3, 3) after some steps; points `drawn` go half of the way to the origin."""
    loops = np.concatenate([np.asarray(face) for face in data.faces])
    mesh = (
        data.points,
        np.array([len(face) for face in data.faces]),
        loops,
        np.array(data.creases),
        np.array(data.corners, dtype=np.int64),
    )
    for _ in range(levels):
        before = mesh[0]
        mesh = subdivision._step(*mesh)
        mesh[0][drawn] = 0.5 * before[drawn]
    quads = mesh[0][mesh[2].reshape(-1, 4)]
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def wetted(triangles, height):
    """Area of triangles below a height."""
    highest, lowest = triangles[:, :, 2].max(axis=1), triangles[:, :, 2].min(axis=1)
    cut = [below(each, height) for each in triangles[(lowest < height) & (highest > height)]]
    return area(triangles[highest <= height]) + sum(
        area(np.array([(kept[0], b, c) for b, c in zip(kept[1:], kept[2:])])) for kept in cut
    )


def area(triangles):
    sides = triangles[:, 1:] - triangles[:, :1]
    return 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum()


def below(triangle, height):
    kept = []
    for a, b in zip(triangle, np.roll(triangle, -1, axis=0)):
        if a[2] <= height:
            kept.append(a)
        if (a[2] - height) * (b[2] - height) < 0.0:
            kept.append(a + (height - a[2]) / (b[2] - a[2]) * (b - a))
    return kept


def test_of_twelve_models_one_has_such_points(freeship_files):
    """As the page counts them: the binary files among the reference data."""
    binary = [path for path in freeship_files if path.suffix == ".fbm"]
    having = [path.name for path in binary if without_crease(path)[1]]
    assert (len(binary), having) == (12, [MODEL])


def test_seven_points_of_the_keel_are_tagged_without_a_crease(model):
    data, drawn = model
    assert len(drawn) == 7
    assert (data.points[drawn, 0] > 105.0).all()
    assert np.abs(data.points[drawn, 1:]).max() < 1e-6


@pytest.mark.parametrize("levels, percent", [(2, 0.90), (3, 0.76), (4, 0.71)])
def test_they_make_the_wetted_surface_too_large(model, levels, percent):
    data, drawn = model
    draft = data.particulars.draft
    right, drawn_out = (wetted(subdivided(data, levels, some), draft) for some in ([], drawn))
    assert 100.0 * (drawn_out / right - 1.0) == pytest.approx(percent, abs=0.005)


def test_the_surface_that_is_read_has_none_of_it(model):
    """Four steps leave the exact surface by less than a hundredth of what the points add."""
    data, _ = model
    shell = hull_io.shell_arrays(data)
    surface = hull_native.LimitSurface(hull_native.ControlMesh(*shell.arguments()))
    body = hull_native.HullBody(surface, mirrored=True)
    exact = body.immersion(np.array([0.0, 0.0, 1.0]), data.particulars.draft).wetted_surface
    faceted = 2.0 * wetted(subdivided(data, 4, []), data.particulars.draft)
    assert faceted == pytest.approx(exact, rel=7e-5)
