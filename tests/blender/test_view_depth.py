# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines on a surface are drawn nearer than it by what a view can tell apart."""

from types import SimpleNamespace

import numpy as np
import pytest
from addon_under_test import part


def depth(distance, near, far=1e4):
    """What the graphics card keeps of a distance: a number of 24 bits."""
    return np.round((far + near - 2 * far * near / distance) / (far - near) * 2**23)


@pytest.mark.parametrize("near", [0.01, 0.1, 1.0])
@pytest.mark.parametrize("distance", [10.0, 100.0, 400.0, 1500.0])
def test_a_line_is_told_from_its_surface(near, distance):
    shift = part("bridge.blender.view_depth").nearer_by(0.15, distance, near)
    assert shift >= 0.15
    assert depth(distance - shift, near) < depth(distance, near) - 1


def test_views_are_made_to_suit_and_else_left():
    suit = part("bridge.blender.view_depth").suit
    space = SimpleNamespace(clip_start=0.01, clip_end=1000.0)
    suit(space, SimpleNamespace(dimensions=(300.0, 40.0, 25.0)))
    assert space.clip_start == pytest.approx(0.3) and space.clip_end == pytest.approx(9000.0)
    suit(space, SimpleNamespace(dimensions=(10.0, 3.0, 2.0)))
    assert space.clip_start == pytest.approx(0.3) and space.clip_end == pytest.approx(9000.0)
