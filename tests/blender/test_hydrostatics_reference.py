# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics of imported hulls against independently integrated values.

The tolerances follow from the error estimates that come with the values: 1e-6
for volume and its centre,
1e-5 for areas.
"""

import json

import bpy
import pytest
from addon_under_test import state_of

pytestmark = pytest.mark.once

VOLUME_TOLERANCE = 1e-6
AREA_TOLERANCE = 1e-5


def test_five_hulls_agree_with_the_reference(reference_folder, freeship_folder):
    cases = json.loads((reference_folder / "hydrostatics.json").read_text())
    assert len(cases) == 5
    for case in cases:
        bpy.ops.wm.read_homefile(use_empty=True)
        bpy.ops.hull.import_hull(filepath=str(freeship_folder / case["file"]))
        hull = bpy.context.object
        hull.hull.draft = case["waterline_z"]
        for scheme in ("biermann", "catmull_clark"):
            hull.hull.scheme = scheme
            bpy.context.view_layer.update()
            compare(state_of(hull).hydrostatics.values, case[scheme], f"{case['file']}, {scheme}")


def compare(found, wanted, name):
    values = {
        "displaced_volume": (found.displaced_volume, VOLUME_TOLERANCE),
        "LCB": (found.lcb, VOLUME_TOLERANCE),
        "KB": (found.kb, VOLUME_TOLERANCE),
        "wetted_surface": (found.wetted_surface, AREA_TOLERANCE),
        "waterplane_area": (found.waterplane_area, AREA_TOLERANCE),
    }
    for key, (value, tolerance) in values.items():
        assert value == pytest.approx(wanted[key], rel=tolerance), f"{name}: {key}"
