# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of several bodies as parents: a yacht's hull, keel and rudder come onto those of another
one, however each is laid out; what has no counterpart is named.

HULL_ALL_PAIRS=1: a yacht's hull alone and one of FREE!ship's, each layout on the other, too.
"""

import os
import re
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest
import vessels

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "hulls" / "freeship"
YACHTS = ("FREE!ship demo 7", "Parent 22_Oort")
APPENDAGES = ("Keel", "Rudder")
# Of the length, both ways: the tolerance of fit_layout().
MET = 1e-4


def of_freeship(name):
    path = FOLDER / f"{name}.fbm"
    if not path.exists():
        pytest.skip(f"{path} is not here")
    return vessels.surface_of(hull_io.read_hull(path))


def sailing_yacht(without=()):
    data = vessels.vessel("sailing_yacht").data
    for layer in data.layers:
        layer.in_hydrostatics = layer.name not in without
    return vessels.surface_of(data)


def length_of(surface):
    return np.ptp(surface.mesh.points[:, 0])


def faces_of(mesh):
    return np.split(mesh.face_vertices, np.cumsum(mesh.face_sizes)[:-1])


def bodies_of(mesh):
    """Of each point the number of its body."""
    body = np.arange(len(mesh.points))
    for _ in body:
        before = body.copy()
        for face in faces_of(mesh):
            body[face] = body[face].min()
        if np.array_equal(body, before):
            break
    return np.unique(body, return_inverse=True)[1]


def parts_of(mesh, wanted):
    """ControlMesh arguments of the points that are wanted, and what is theirs."""
    number = np.cumsum(wanted) - 1
    faces = [number[face] for face in faces_of(mesh) if wanted[face[0]]]
    creases = number[[pair for pair in mesh.creases if wanted[pair[0]]]]
    corners = number[[k for k in np.flatnonzero(mesh.vertex_kinds >= 3) if wanted[k]]]
    return mesh.points[wanted], faces, creases, corners


def together(*parts):
    """A control mesh of the parts_of() several."""
    shifts = np.cumsum([0, *(len(part[0]) for part in parts)])
    shifted = [
        ([face + shift for face in faces], creases + shift, corners + shift)
        for (_, faces, creases, corners), shift in zip(parts, shifts)
    ]
    faces = [face for part in shifted for face in part[0]]
    return hn.ControlMesh(
        np.concatenate([part[0] for part in parts]),
        [len(face) for face in faces],
        np.concatenate(faces),
        np.concatenate([part[1] for part in shifted]),
        np.concatenate([part[2] for part in shifted]).astype(int),
    )


def other_yacht():
    """A longer, beamier one with a deeper keel farther aft; her keel has four times the faces, so
    that the two have no layout in common."""
    own = sailing_yacht()
    bodies = bodies_of(own.mesh)
    low = [own.mesh.points[bodies == k, 2].min() for k in range(bodies.max() + 1)]
    keel = int(np.argmin(low))
    fine = own.refined_mesh()
    fine_bodies = bodies_of(fine)
    lowest = [fine.points[fine_bodies == k, 2].min() for k in range(fine_bodies.max() + 1)]
    others = parts_of(own.mesh, bodies != keel)
    points, *rest = parts_of(fine, fine_bodies == int(np.argmin(lowest)))
    points = points * [1.0, 1.0, 1.15] - [0.2, 0.0, 0.15 * points[:, 2].max()]
    mesh = together(others, (points, *rest))
    return hn.LimitSurface(mesh.with_points(mesh.points * [1.1, 1.05, 1.0]), own.scheme)


def test_hull_keel_and_rudder_come_onto_those_of_another_yacht():
    first, second = sailing_yacht(), other_yacht()
    assert hn.feature_graph(first).body_count == hn.feature_graph(second).body_count == 3
    for one, other in ((first, second), (second, first)):
        fit = hn.fit_layout(one, other)
        print(fit.rms / length_of(other), fit.rms_back / length_of(other), fit.shortfall)
        assert max(fit.rms, fit.rms_back) <= MET * length_of(other)
        assert fit.fold is None and fit.shortfall == ""
        # Each body lies on its own counterpart, not on a neighbour that is near.
        graphs = hn.feature_graph(one), hn.feature_graph(other)
        for i, j, *_ in fit.match.pairs:
            assert graphs[0].features[i].role == graphs[1].features[j].role
        bodies = bodies_of(fit.second.mesh)
        lows = sorted(fit.second.mesh.points[bodies == k, 2].min() for k in range(3))
        theirs = bodies_of(other.mesh)
        wanted = sorted(other.mesh.points[theirs == k, 2].min() for k in range(3))
        assert lows == pytest.approx(wanted, abs=1e-2)


@pytest.mark.parametrize("name", YACHTS)
def test_a_keel_and_a_rudder_without_counterpart_are_named(name):
    yacht, other = sailing_yacht(), of_freeship(name)
    for hulls, which in (((yacht, other), "first"), ((other, yacht), "second")):
        with pytest.raises(ValueError) as raised:
            hn.fit_layout(*hulls)
        text = str(raised.value)
        print(text)
        named = f"leave out of the {which} the body between .* and the body between"
        assert re.search(named, text), text


@pytest.mark.skipif(os.environ.get("HULL_ALL_PAIRS") != "1", reason="HULL_ALL_PAIRS is not set")
@pytest.mark.parametrize("is_first", (True, False))
def test_her_hull_alone_comes_onto_another_yacht_or_it_is_said_what_to_do(is_first):
    hulls = sailing_yacht(without=APPENDAGES), of_freeship(YACHTS[0])
    first, second = hulls if is_first else hulls[::-1]
    fit = hn.fit_layout(first, second)
    off = max(fit.rms, fit.rms_back) / length_of(second)
    print(off, fit.fold, fit.shortfall)
    assert (fit.shortfall == "") == (off <= MET and fit.fold is None)
    if fit.shortfall:
        assert "pair" in fit.shortfall and "take the layout" in fit.shortfall
