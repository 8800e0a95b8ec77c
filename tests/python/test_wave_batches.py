# SPDX-License-Identifier: GPL-3.0-or-later
"""Waves at many points take no more memory than at few, and name what they cannot take."""

import hull_native as hn
import numpy as np
import pytest
from hull_native.resistance import wave_pattern
from test_michell import speed_at, wigley


def integral():
    return hn.MichellIntegral(hn.HullBody(wigley(11, 7), mirrored=True), draft=0.0)


def test_few_points_are_taken_at_once_where_nodes_are_many(monkeypatch):
    speed = speed_at(0.3)
    points = np.column_stack([np.linspace(-300.0, -100.0, 64), np.linspace(0.0, 40.0, 64)])
    how = {"gravity": hn.GRAVITY, "steepest": 1.2}
    wanted = hn.wave_heights(integral(), speed, points, **how)
    sizes, exp = [], np.exp
    monkeypatch.setattr(wave_pattern, "_MOST_AT_ONCE", 20_000)
    monkeypatch.setattr(np, "exp", lambda values: (sizes.append(values.size), exp(values))[1])
    found = hn.wave_heights(integral(), speed, points, **how)
    assert len(sizes) > 4 and max(sizes) <= 20_000
    np.testing.assert_allclose(found, wanted, rtol=0.0, atol=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize("name", ["speed", "gravity"])
def test_waves_behind_name_what_is_not_above_zero(name):
    how = {"speed": 2.0, "gravity": hn.GRAVITY, name: 0.0}
    with pytest.raises(ValueError, match=f"{name} must be a number above zero, not 0.0"):
        hn.waves_behind(integral(), stern=0.0, **how)
