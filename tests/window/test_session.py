# SPDX-License-Identifier: GPL-3.0-or-later
"""A person at work: moves kept and dropped, tags, undo and redo in random order. What is shown is
always of the mesh as it is, and undo finds each state as it was."""

import random

import numpy as np
from editing import editing_a_hull, hull_at_hand, select
from expect import are_equal, assert_follows, edited_points, snapshot

SEED, STEPS = 20261, 40


class Session:
    """The states that undo and redo lead to."""

    def __init__(self, hull):
        self._states, self._now = [snapshot(hull)], 0

    @property
    def now(self):
        return self._states[self._now]

    def keep(self, state):
        self._states[self._now + 1 :] = [state]
        self._now += 1

    def can_undo(self):
        return self._now > 0

    def can_redo(self):
        return self._now + 1 < len(self._states)

    def step(self, by):
        self._now += by


def move(window, chance):
    """A move by the mouse, of whatever is selected; whether it is kept."""
    window.press("G")
    window.press(chance.choice("XYZ"))
    window.move_by(chance.choice((-1, 1)) * chance.randint(4, 12), chance.randint(4, 12))
    is_kept = chance.random() < 0.7
    window.press("LEFTMOUSE" if is_kept else "RIGHTMOUSE")
    return is_kept


def type_move(window, chance):
    window.press("G")
    window.press(chance.choice("XYZ"))
    window.write(f"{chance.uniform(0.05, 0.4):.2f}")
    window.press("RET")
    return True


def tag(window, chance):
    """Corner, or no corner, from the pie menu."""
    window.pie("Q", 0, chance.choice((-120, 120)), shift=True)
    return True


def test_a_session(window):
    print("seed", SEED, flush=True)
    chance = random.Random(SEED)
    hull = editing_a_hull(window)
    points = edited_points(hull)
    side = np.flatnonzero((points[:, 1] > 1.0) & (points[:, 2] > 2.0))
    select(hull, *chance.sample(side.tolist(), 4))
    yield
    session = Session(hull)
    for _ in range(STEPS):
        action = chance.choice((move, type_move, tag, "undo", "undo", "redo"))
        if action == "undo" and session.can_undo():
            window.undo()
            session.step(-1)
        elif action == "redo" and session.can_redo():
            window.redo()
            session.step(1)
        elif callable(action):
            is_kept = action(window, chance)
            yield
            window.move_to_middle()
            if is_kept:
                session.keep(snapshot(hull_at_hand()))
        yield
        assert are_equal(snapshot(hull_at_hand()), session.now)
        assert_follows(hull_at_hand())
