# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the 3D view can be told from what is behind it in both of Blender's themes."""

import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

ADDON = Path(__file__).resolve().parents[2] / "addon" / "hull_tools"
FILE = ADDON / "bridge" / "blender" / "palette.py"

# sRGB: the shell, which is the light ground, where light does not reach it, half lit, and lit.
SHELL = ((0.365, 0.380, 0.395), (0.420, 0.440, 0.460), (0.750, 0.760, 0.770))
# The 3D view in the themes Blender Dark and Blender Light, which is no light ground either.
VIEWS = ((58 / 255,) * 3, (100 / 255,) * 3)
# Differences in CIELAB: of lines and symbols, some dots wide, which are seen at a glance; of the
# control net, which is to recede. 2.3 is what is just noticed between two fields side by side.
AT_A_GLANCE, RECEDING = 30.0, 20.0


@pytest.fixture(scope="module")
def palette():
    spec = importlib.util.spec_from_file_location("palette_under_test", FILE)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # where dataclasses look
    spec.loader.exec_module(module)
    yield module
    del sys.modules[spec.name]


def lab(colour):
    """CIE 1976 L*a*b* of sRGB under D65 (IEC 61966-2-1; CIE 15)."""
    parts = np.asarray(colour, dtype=np.float64)
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    to_xyz = np.array(
        [
            [0.4124564, 0.3575761, 0.1804375],
            [0.2126729, 0.7151522, 0.0721750],
            [0.0193339, 0.1191920, 0.9503041],
        ]
    )
    shares = to_xyz @ linear / to_xyz.sum(axis=1)
    x, y, z = np.where(
        shares > (6 / 29) ** 3, np.cbrt(shares), shares / (3 * (6 / 29) ** 2) + 4 / 29
    )
    return np.array([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])


def difference(one, other):
    return float(np.linalg.norm(lab(one) - lab(other)))


def test_the_measure_itself():
    assert lab((1.0, 1.0, 1.0)) == pytest.approx([100.0, 0.0, 0.0], abs=1e-9)
    assert lab((0.0, 0.0, 0.0)) == pytest.approx([0.0, 0.0, 0.0], abs=1e-9)
    # Of sRGB's red, as tables have it.
    assert lab((1.0, 0.0, 0.0)) == pytest.approx([53.24, 80.09, 67.20], abs=0.05)


@pytest.mark.parametrize("group", ["lines", "ghost", "net", "combs", "marks", "tags"])
def test_inks_can_be_told_from_their_grounds(palette, group):
    least = RECEDING if group == "net" else AT_A_GLANCE
    for kind, ink in palette.GROUPS[group][1].items():
        if kind == "locked":
            continue  # its pins have a white halo
        for ground in SHELL:
            assert difference(ink.on_light, ground) >= least, (kind, "on the shell", ground)
        for ground in VIEWS:
            on_dark = ink.on_light if ink.on_dark is None else ink.on_dark
            assert difference(on_dark, ground) >= least, (kind, "on the view", ground)


def test_marks_can_be_told_from_one_another_and_from_the_lines_they_are_on(palette):
    marks, lines = palette.GROUPS["marks"][1], palette.GROUPS["lines"][1]
    kinds = list(marks)
    for place, kind in enumerate(kinds):
        for other in [marks[name] for name in kinds[place + 1 :]] + [lines["station"]]:
            assert difference(marks[kind].on_light, other.on_light) >= AT_A_GLANCE, kind
            assert difference(marks[kind].on_dark, other.on_dark) >= AT_A_GLANCE, kind


def test_the_ghost_can_be_told_from_whatever_is_drawn_with_it(palette):
    ghost = palette.GROUPS["ghost"][1]["ghost"]
    for name in ("lines", "combs", "marks", "tags"):
        for kind, ink in palette.GROUPS[name][1].items():
            assert difference(ghost.on_light, ink.on_light) >= AT_A_GLANCE, (name, kind)
            if ink.on_dark is not None:
                assert difference(ghost.on_light, ink.on_dark) >= AT_A_GLANCE, (name, kind)
