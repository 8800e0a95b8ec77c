# SPDX-License-Identifier: GPL-3.0-or-later
"""Tied points, groups and a wanted wave resistance in hull files: written and read, mirrored,
scaled, split, and refused where they are none."""

import json

import hull_io
import numpy as np
import pytest
from hull_io import hull_ties, mending, mirror
from test_hull_file import content

SEED = 1129
TIES = [
    {"kind": "line", "point": 4, "to": [3, 5], "share": 0.25},
    {"kind": "anchor", "point": 2, "to": [4], "distance": [10, 0.5, -3]},
    {"kind": "level", "point": 0, "to": [1]},
]
GROUPS = [{"name": "Side", "points": [5, 3, 3]}, {"name": "", "points": []}]


def test_ties_and_groups_are_written_and_read(read, tmp_path):
    data = read(content(ties=TIES, groups=GROUPS))
    assert data.ties == [
        hull_io.Tie("line", 4, (3, 5), 0.25),
        hull_io.Tie("anchor", 2, (4,), 0.0, (10.0, 0.5, -3.0)),
        hull_io.Tie("level", 0, (1,)),
    ]
    assert data.groups == [hull_io.PointGroup("Side", [3, 5]), hull_io.PointGroup("", [])]
    hull_io.write_hull_file(data, tmp_path / "again.hull.json")
    again = hull_io.read_hull_file(tmp_path / "again.hull.json")
    assert (again.ties, again.groups) == (data.ties, data.groups)
    data.ties, data.groups = [], []
    hull_io.write_hull_file(data, tmp_path / "none.hull.json")
    assert not set(hull_ties.KEYS) & set(json.loads((tmp_path / "none.hull.json").read_text()))


class Looked(dict):
    """Ties by points, with how often one was looked up."""

    count = 0

    def __getitem__(self, point):
        self.count += 1
        return super().__getitem__(point)


@pytest.mark.parametrize("order", [1, -1])
def test_each_tie_of_a_long_chain_is_followed_once(order):
    numbers = range(5000)[::order]
    ties = Looked({k: hull_io.Tie("line", k, (k + 1, max(k - 1, 0) + 10000)) for k in numbers})
    assert hull_ties.circle(ties) == set()
    assert ties.count == 5000
    ties[4999] = hull_io.Tie("level", 4999, (4000,))
    assert hull_ties.circle(ties) == set(range(4000, 5000))


def test_random_ties_have_a_circle_where_a_point_leads_to_itself():
    """By the closure of who follows whom."""
    random = np.random.default_rng(SEED)
    circles = 0
    for _ in range(300):
        points = random.permutation(8)[: random.integers(1, 8)].tolist()
        ties = {
            p: hull_io.Tie("line", p, tuple(random.integers(0, 12, 2).tolist())) for p in points
        }
        leads = np.zeros((12, 12), dtype=bool)
        for point, tie in ties.items():
            leads[point, list(tie.to)] = True
        for _ in range(4):
            leads |= leads.astype(int) @ leads.astype(int) > 0
        found = hull_ties.circle(ties)
        assert bool(found) == leads.diagonal().any()
        assert all(leads[a, b] for a in found for b in found)
        circles += bool(found)
    assert 50 < circles < 250, (SEED, circles)


@pytest.mark.parametrize(
    "ties, where",
    [
        ({}, "ties: "),
        ([{"kind": "rope", "point": 1, "to": [2]}], "ties[0].kind"),
        ([{"kind": "line", "point": 1, "to": [2]}], "ties[0].to"),
        ([{"kind": "anchor", "point": 1, "to": [6]}], "ties[0].to[0]"),
        ([{"kind": "anchor", "point": -1, "to": [2]}], "ties[0].point"),
        ([{"kind": "anchor", "to": [2]}], "ties[0].point: it is missing"),
        ([{"kind": "anchor", "point": 1, "to": [1]}], "ties[0]: its point would follow itself"),
        ([{"kind": "level", "point": 1, "to": [2]}] * 2, "ties[1].point: it follows others"),
        (
            [
                {"kind": "level", "point": 1, "to": [2]},
                {"kind": "line", "point": 2, "to": [0, 3]},
                {"kind": "level", "point": 3, "to": [1]},
            ],
            "would follow itself",
        ),
        ([{"kind": "line", "point": 1, "to": [2, 3], "share": 1.5}], "ties[0].share"),
        ([{"kind": "anchor", "point": 1, "to": [2], "distance": [0, 0]}], "ties[0].distance"),
    ],
)
def test_wrong_ties_are_named(read, ties, where):
    with pytest.raises(hull_io.HullFileError) as caught:
        read(content(ties=ties))
    assert where in str(caught.value)


def test_wrong_groups_are_named(read):
    for groups, where in (([{"name": "A", "points": [9]}], "groups[0].points[0]"), ({}, "groups")):
        with pytest.raises(hull_io.HullFileError) as caught:
            read(content(groups=groups))
        assert where in str(caught.value)


def test_the_other_side_is_tied_as_this_one(read):
    data = read(content(ties=TIES, groups=GROUPS))
    mirror.mirror_faces(data, range(len(data.faces)))
    points = data.points
    assert len(data.ties) == 5 and len(data.groups[0].points) == 4
    for port, other in zip(data.ties[:2], data.ties[3:]):
        assert points[other.point].tolist() == (points[port.point] * (1, -1, 1)).tolist()
        assert other.distance == (port.distance[0], -port.distance[1], port.distance[2])
        for one, image in zip(port.to, other.to):
            assert points[image].tolist() == (points[one] * (1, -1, 1)).tolist()


def test_distances_are_scaled(read):
    data = read(content(ties=TIES, groups=GROUPS))
    made = hull_io.scaled(data, (2.0, 3.0, 0.5))
    assert tuple(made.ties[1].distance) == (20.0, 1.5, -1.5)
    assert made.ties[0] == data.ties[0] and made.groups == data.groups


def test_split_points_have_them_once(read):
    data = read(content(ties=TIES, groups=GROUPS))
    # Two faces that share an edge with a third are parted there.
    data.points = np.vstack([data.points, [[0.0, 5.0, 0.0], [10.0, 5.0, 0.0]]])
    data.faces.append([3, 6, 7, 2])
    data.face_layers = [0, 0, 0]
    mending.part_shell(data)
    assert len({tie.point for tie in data.ties}) == len(data.ties) == 3
    assert all(0 <= point < len(data.points) for tie in data.ties for point in tie.to)
