# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures: what is hidden of a control mesh, labels that leave each other room, files."""

from types import SimpleNamespace

import numpy as np
import pytest

cairo = pytest.importorskip("cairo")
import vessels  # noqa: E402
from figures import control_mesh, labels, lines_plan, paper, sections_plan  # noqa: E402


def cube():
    """A closed cube of six faces turned outwards."""
    points = np.array([(x, y, z) for z in (0, 1) for y in (-1, 0) for x in (0, 1)], dtype=float)
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return SimpleNamespace(points=points, faces=faces, creases=[(0, 1)], half=False)


def test_the_far_edges_of_a_cube_are_hidden():
    mesh = control_mesh._Mesh(cube())
    camera = control_mesh._Camera(mesh.points, np.radians(-42.0))
    hidden = control_mesh._hidden_pieces(mesh, camera).all(axis=1)
    seen = ~control_mesh._hidden_points(mesh, camera)
    # From ahead to starboard below, the corner abaft to port above is hidden, with its edges.
    far = 6
    assert [bool(s) for s in seen] == [i != far for i in range(8)]
    assert {edge for edge, is_hidden in zip(mesh.edges, hidden) if is_hidden} == {
        edge for edge in mesh.edges if far in edge
    }


def test_irregular_points_are_those_without_four_edges():
    assert control_mesh._irregular(cube().faces, 8) == set(range(8))
    strip = [[0, 1, 4, 3], [1, 2, 5, 4]]
    assert control_mesh._irregular(strip, 6) == set()


@pytest.mark.parametrize("name", vessels.names())
def test_labels_leave_each_other_room(name, tmp_path, monkeypatch):
    made = []
    monkeypatch.setattr(
        sections_plan, "Labels", lambda *a: made.append(labels.Labels(*a)) or made[-1]
    )
    sections_plan.draw(vessels.vessel(name), tmp_path / "plan")
    placed = made[0]
    # Three, where the sections of a slender demihull leave little room.
    assert len(placed.boxes) == len(placed.ends) + len(placed.on_lines) >= 3
    for i, (low, high) in enumerate(placed.boxes):
        for bottom, top in placed.boxes[:i]:
            assert not ((low < top).all() and (bottom < high).all())
    assert (tmp_path / "plan.pdf").read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("name", ["barge", "sailing_yacht"])
def test_lines_plans_fit_their_sheet(name, tmp_path):
    lines_plan.draw(vessels.vessel(name), tmp_path / "lines")
    assert {path.name for path in tmp_path.iterdir()} == {"lines.pdf", "lines.png"}


def test_pictures_lose_their_background_and_become_small(tmp_path):
    def paint(context):
        paper.line(context, [(10.0, 50.0), (90.0, 50.0)], 2.0, paper.BLACK)

    paper.draw(tmp_path / "line", 100.0, 100.0, paint)
    paper.put_below([tmp_path / "line.png"] * 2, tmp_path / "two.png", margin=4)
    height = cairo.ImageSurface.create_from_png(str(tmp_path / "two.png")).get_height()
    assert height == pytest.approx(2 * (2.0 * paper.DOTS_PER_MM + 8), abs=4)
    paper.make_small(tmp_path / "line.png", tmp_path / "small.png", 200)
    assert cairo.ImageSurface.create_from_png(str(tmp_path / "small.png")).get_width() == 200
