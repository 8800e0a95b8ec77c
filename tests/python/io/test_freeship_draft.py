# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the water lies of a FREE!ship file, whose draft is from the lowest point of the shell."""

import hull_io
import numpy as np
import pytest
from freeship_writer import binary_file, box_model
from hull_io.subdivision import subdivided


@pytest.fixture
def read(tmp_path):
    def read_model(model):
        path = tmp_path / "box.fbm"
        path.write_bytes(binary_file(model, 335))
        return hull_io.read_hull(path)

    return read_model


def creased_box(by):
    """The box moved up, all its edges knuckles, so that its surface is the box."""
    model = box_model()
    model["points"] = [(x, y, z + by, 0) for x, y, z, _ in model["points"]]
    sides = {
        tuple(sorted(edge)) for face, _ in model["faces"] for edge in zip(face, face[1:] + face[:1])
    }
    model["edges"] = [(a, b, True) for a, b in sorted(sides)]
    return model


def notes_of_draft(hull):
    return [note for note in hull.notes if "draft" in note]


def test_draft_from_a_keel_on_the_base_line_is_as_stored(read):
    hull = read(creased_box(0.0))
    assert hull.particulars.draft == 1.3 and not notes_of_draft(hull)


@pytest.mark.parametrize("keel", [-0.5, 2.0])
def test_draft_is_from_the_lowest_point(read, keel):
    hull = read(creased_box(keel))
    assert hull.points[:, 2].min() == keel
    assert hull.particulars.draft == pytest.approx(keel + 1.3, rel=1e-12)
    assert notes_of_draft(hull) == [
        f"The file's draft of 1.3 m is from the lowest point, at z = {keel:g} m: the water lies at "
        f"z = {keel + 1.3:.4g} m."
    ]


def test_a_hull_below_the_base_line_is_moved_up(read):
    hull = read(creased_box(-3.0))
    assert hull.points[:, 2].min() == 0.0 and hull.points[:, 2].max() == 3.0
    assert hull.particulars.draft == 1.3
    assert "moved up" in notes_of_draft(hull)[0]


def test_only_the_shell_counts(read):
    model = creased_box(0.0)
    model["points"] += [(0.0, 0.0, -4.0, 0), (5.0, 0.0, -4.0, 0), (5.0, 0.0, 0.0, 0)]
    model["faces"].append(([8, 9, 10], 1))
    hull = read(model)
    assert hull.particulars.draft == 1.3 and not notes_of_draft(hull)


def test_the_lowest_point_is_that_of_the_smooth_shell(read):
    """A keel of three points, the middle one down: subdivided it hangs less."""
    model = box_model()
    xs, drop, levels = (0.0, 5.0, 10.0), -1.0, 3
    model["points"] = [
        (x, y, drop if (x, z) == (5.0, 0.0) else z, 0)
        for x in xs
        for y, z in ((0, 0), (2, 0), (2, 3))
    ]
    model["faces"] = [([3 * i, 3 * i + 3, 3 * i + 4, 3 * i + 1], 0) for i in (0, 1)]
    model["faces"] += [([3 * i + 1, 3 * i + 4, 3 * i + 5, 3 * i + 2], 0) for i in (0, 1)]
    model.update(edges=[], curves=[], precision=levels - 1)
    hull = read(model)
    # On the border the point goes to a quarter of its ends, half of itself, each time.
    lowest, ends = drop, 0.0
    for _ in range(levels):
        lowest, ends = 0.75 * lowest + 0.25 * ends, 0.5 * (lowest + ends)
    assert hull.particulars.draft == pytest.approx(1.3 + lowest, rel=1e-6)


def test_dimensions_that_nobody_set_are_not_given(read):
    model = creased_box(0.0)
    model["dimensions_set"] = False
    found = read(model)
    assert (found.particulars.length_pp, found.particulars.beam, found.particulars.draft) == (
        0,
        0,
        0,
    )
    assert any("main dimensions" in note for note in found.notes)


def test_subdivided_points_come_to_their_limits():
    """The middle of a cube's side is a point of four faces after a step, whose limit is known:
    (16 v + 4 (points across edges) + (points across faces)) / 36."""
    corners = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float)
    faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    first = subdivided(corners, faces, [], [], 1)
    middle = first[np.argmax(first[:, 2])]
    upper = first[first[:, 2] > 0.3]
    across_edges = upper[(np.abs(upper) < 1e-12).sum(axis=1) == 1]
    across_faces = upper[(np.abs(upper) < 1e-12).sum(axis=1) == 0]
    assert len(across_edges) == 4 and len(across_faces) == 4
    limit = (16 * middle + 4 * across_edges.sum(axis=0) + across_faces.sum(axis=0)) / 36
    found = subdivided(corners, faces, [], [], 6)
    assert found[:, 2].max() == pytest.approx(limit[2], rel=1e-3)
