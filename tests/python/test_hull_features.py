# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of creases and borders by their role to the ship, paired between hulls; hulls renumbered,
and one hull's control mesh brought to another."""

import hull_native as hn
import numpy as np
import pytest
from test_form_numbers import SAMPLES, Sample
from test_hull_families import without_a_crease

SEED = 20261124
SEAGOING = (
    "bulk_carrier",
    "coaster",
    "container_ship",
    "naval_vessel",
    "research_vessel",
    "roro",
)


def graph_of(name):
    return hn.feature_graph(Sample(name).surface)


def roles(graph):
    return [feature.role for feature in graph.features]


def renumbered(surface, random):
    """(the same surface with other numbers, the old number of each vertex)."""
    mesh = surface.mesh
    order = random.permutation(len(mesh.points))
    number = np.argsort(order)
    ends = np.cumsum(mesh.face_sizes)
    faces = [np.roll(f, random.integers(4)) for f in np.split(mesh.face_vertices, ends[:-1])]
    faces = [faces[i] for i in random.permutation(len(faces))]
    made = hn.ControlMesh(
        mesh.points[order],
        [len(f) for f in faces],
        number[np.concatenate(faces)],
        number[mesh.creases],
        number[np.flatnonzero(mesh.vertex_kinds >= 3)],
    )
    return hn.LimitSurface(made, surface.scheme), order


@pytest.mark.parametrize("name", SAMPLES)
def test_every_crease_and_border_is_in_one_feature(name):
    surface = Sample(name).surface
    graph = hn.feature_graph(surface)
    chains = np.concatenate([feature.chains for feature in graph.features])
    assert sorted(chains) == list(range(len(hn.crease_curves(surface))))
    for feature in graph.features:
        assert len(feature.nodes) == len(feature.lengths) == len(feature.chains) + 1
        assert feature.curve.length == pytest.approx(feature.lengths[-1], rel=1e-9)


@pytest.mark.parametrize("name", SEAGOING)
def test_roles_of_seagoing_hulls(name):
    found = roles(graph_of(name))
    for role in (
        "centre line",
        "deck edge",
        "transom's edge",
        "rim of the transom",
        "middle of the transom",
    ):
        assert found.count(role) == 1, found


def test_features_run_forward_upwards_or_outwards():
    for feature in graph_of("research_vessel").features:
        begin, end = feature.curve.points_at([0.0, feature.curve.length])
        axis = np.abs(end - begin).argmax()
        assert end[axis] > begin[axis]


def test_container_ship_and_bulk_carrier_are_paired_by_role():
    first, second = graph_of("container_ship"), graph_of("bulk_carrier")
    match = hn.match_features(first, second)
    for i, j, distance, is_given in match.pairs:
        assert first.features[i].role == second.features[j].role
        assert 0 <= distance < 0.6 and not is_given
    paired = [first.features[i].role for i, *_ in match.pairs]
    assert "rim of the flat bottom" in paired and len(paired) == 7
    # The knuckle along the container ship's flare, and the rim of the bulk carrier's flat side.
    assert [first.features[i].role for i in match.alone_in_first] == ["knuckle"]
    assert [second.features[j].role for j in match.alone_in_second] == ["knuckle"]
    assert len(match.remarks) == 2
    assert "pair it by hand" in match.remarks[0]


def test_pairs_that_are_given_come_first():
    first, second = graph_of("container_ship"), graph_of("bulk_carrier")
    automatic = hn.match_features(first, second)
    pair = (automatic.alone_in_first[0], automatic.alone_in_second[0])
    match = hn.match_features(first, second, [pair])
    assert [(i, j) for i, j, _, is_given in match.pairs if is_given] == [pair]
    assert match.alone_in_first == [] and match.alone_in_second == []
    with pytest.raises(ValueError, match="in two pairs"):
        hn.match_features(first, second, [pair, pair])
    with pytest.raises(ValueError, match="no feature 99"):
        hn.match_features(first, second, [(99, 0)])


def test_pairs_that_are_held_apart_are_made_if_given_only():
    first, second = graph_of("container_ship"), graph_of("bulk_carrier")
    automatic = hn.match_features(first, second)
    held = [(i, j) for i, j, *_ in automatic.pairs if first.features[i].role.startswith("rim")]
    assert held
    match = hn.match_features(first, second, apart=held)
    others = [pair[:2] for pair in automatic.pairs if pair[:2] not in held]
    assert [pair[:2] for pair in match.pairs] == others
    assert {i for i, _ in held} <= set(match.alone_in_first)
    match = hn.match_features(first, second, [held[0]], held)
    assert [pair[:2] for pair in match.pairs if pair[3]] == [held[0]]
    assert len(match.pairs) == len(others) + 1


@pytest.mark.parametrize("name", SAMPLES)
def test_a_renumbered_hull_is_found_again(name):
    surface = Sample(name).surface
    random = np.random.default_rng([SEED, SAMPLES.index(name)])
    other, order = renumbered(surface, random)
    found = hn.renumbering(surface.mesh, other.mesh)
    assert np.array_equal(order[found], np.arange(len(order)))


def tube_with_a_crease(around=14, rows=9):
    """An oval tube along the ship, open at both ends, with a crease around its middle."""
    angle = 2 * np.pi * np.arange(around) / around
    ring = np.stack([0.4 * np.sin(angle), 5 + 3 * np.cos(angle), 2 * np.sin(angle)], axis=1)
    points = np.concatenate([ring + [3.0 * k, 0, 0.1 * k] for k in range(rows)])
    number = np.arange(around * rows).reshape(rows, around)
    beside = np.roll(number, -1, axis=1)
    faces = np.stack([number[:-1], beside[:-1], beside[1:], number[1:]], axis=2).reshape(-1, 4)
    middle = rows // 2
    creases = np.stack([number[middle], beside[middle]], axis=1)
    mesh = hn.ControlMesh(points, [4] * len(faces), faces.ravel(), creases)
    return hn.LimitSurface(mesh)


def closed_hulls():
    return [tube_with_a_crease(), Sample("sailing_yacht").surface]


@pytest.mark.parametrize("surface", closed_hulls(), ids=["tube", "yacht"])
def test_closed_lines_begin_and_run_whatever_the_numbers(surface):
    graph = hn.feature_graph(surface)
    size = np.ptp(surface.mesh.points, axis=0).max()
    assert any(f.nodes[0] == f.nodes[-1] for f in graph.features)
    ours = sorted(graph.features, key=lambda f: (f.role, list(f.nodes)))
    for seed in range(6):
        other, order = renumbered(surface, np.random.default_rng([SEED, seed]))
        again = hn.feature_graph(other)
        # By their control points: bodies, and with them features, go by numbers.
        theirs = sorted(again.features, key=lambda f: (f.role, list(order[f.nodes])))
        for one, same in zip(ours, theirs, strict=True):
            assert one.role == same.role and np.array_equal(order[same.nodes], one.nodes)
            assert np.abs(np.subtract(same.lengths, one.lengths)).max() <= 1e-9 * size
            shares = np.linspace(0, one.curve.length, 7)
            off = same.curve.points_at(shares) - one.curve.points_at(shares)
            assert np.abs(off).max() <= 1e-9 * size
        distances = [distance for _, _, distance, _ in hn.match_features(graph, again).pairs]
        assert len(distances) == len(ours) and max(distances) <= 1e-9


def test_another_topology_is_no_renumbering():
    surface = Sample("coaster").surface
    mesh = surface.mesh
    assert hn.renumbering(mesh, Sample("roro").surface.mesh) is None
    assert hn.renumbering(mesh, without_a_crease(surface).mesh) is None


def test_a_renumbered_hull_is_its_own_family():
    sample = Sample("roro")
    other, _ = renumbered(sample.surface, np.random.default_rng(SEED))
    fit = hn.fit_layout(sample.surface, other)
    assert fit.subdivisions == 0
    assert np.array_equal(fit.second.mesh.points, sample.surface.mesh.points)
    assert fit.rms <= 1e-9 * sample.size and fit.rms_back <= 1e-9 * sample.size


def test_other_bodies_are_refused():
    with pytest.raises(ValueError, match="bodies"):
        hn.fit_layout(Sample("coaster").surface, Sample("sailing_yacht").surface)
