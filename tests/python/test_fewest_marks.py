# SPDX-License-Identifier: GPL-3.0-or-later
"""Of several ways to what is wanted the one that leaves the fewest new marks; fairing that may move
points along the ship leaves what is held."""

from dataclasses import dataclass
from types import SimpleNamespace

import numpy as np
import pytest
from hull_fairness import fair_changes, fewest_marks
from transformation_hulls import Sample, wigley_areas


@dataclass
class Counted:
    """Stands for a changes.Known: as many marks are new as a point of the hull is high."""

    surface: object
    beam: float = 1.0

    def compared(self, lines, surface, wanted):
        height = surface.mesh.points[0, 2] - self.surface.mesh.points[0, 2]
        return SimpleNamespace(new=[None] * round(height))


@pytest.fixture
def known(monkeypatch):
    monkeypatch.setattr(fewest_marks, "judged", lambda surface, beam: [])
    return Counted(wigley_areas(3)[0])


def raised(known, height):
    moves = np.zeros_like(known.surface.mesh.points)
    moves[0, 2] = height
    return moves


def refused():
    raise ValueError("Cb can be 0.5 to 0.6 here")


def fairing(known, changes, seen):
    """Takes as many marks out as `changes` tells, by those that there are."""

    def fair(surface, progress):
        made = len(known.compared([], surface, ()).new)
        seen.append(made)
        progress(0.5)
        moves = raised(known, -changes[made])
        return SimpleNamespace(moves=moves, new=[None] * (made - changes[made]), rms=0.1)

    return fair


def found(known, heights, changes):
    ways = {str(height): (lambda h=height: raised(known, h)) for height in heights}
    ways["far"] = refused
    shares, seen = [], []
    fair = fairing(known, changes, seen)
    tried = fewest_marks.fewest_marks(known, ways, fair, progress=shares.append)
    assert shares == sorted(shares) and shares[-1] == 1.0
    assert tried[-1].name == "far" and tried[-1].refusal.startswith("Cb can be")
    return tried, seen


def test_a_way_without_new_marks_is_taken_as_it_is(known):
    tried, seen = found(known, (3, 0), {})
    assert [one.name for one in tried] == ["0", "3", "far"] and not seen
    assert tried[0].rms == 0.0 and not tried[0].new


def test_the_way_with_the_fewest_is_faired_first_and_ends_it(known):
    tried, seen = found(known, (7, 2), {2: 2})
    assert seen == [2] and tried[0].name == "2" and (tried[0].made, tried[0].new) == (2, ())
    assert (tried[0].moves == 0.0).all() and tried[0].rms == 0.1
    assert (tried[1].moves == raised(known, 7)).all()


def test_what_is_left_after_fairing_counts(known):
    tried, seen = found(known, (2, 7), {2: 0, 7: 6})
    assert seen == [2, 7]
    assert [(one.name, one.made, len(one.new)) for one in tried[:2]] == [("7", 7, 1), ("2", 2, 2)]


def test_where_no_way_leads_the_reasons_are_told(known):
    tried = fewest_marks.fewest_marks(known, {"far": refused}, None)
    assert [one.refusal for one in tried] == ["Cb can be 0.5 to 0.6 here"]


def test_held_form_keeps_knuckles_across_in_their_stations():
    """The barge's: at the ends of its run and of its bow. Its swim may move along the ship."""
    surface = Sample("barge").surface
    points, creases = surface.mesh.points, np.asarray(surface.mesh.creases)[:, :2].astype(int)
    held, normals = fair_changes.held_form(surface)
    stay = np.zeros(len(points), dtype=bool)
    stay[held[normals[:, 0] == 1.0]] = True
    across = np.ptp(points[creases, 0], axis=1) == 0.0
    assert across.sum() > 10 and stay[creases[across]].all()
    assert set(points[~stay, 0].tolist()) == {58.0, 67.5}
