# SPDX-License-Identifier: GPL-3.0-or-later
"""No label of the panel Resistance is cut off, whatever the method and however much is shown."""

import bpy
import pytest
from addon_under_test import make_active, part, sample
from layout_widths import SIDEBAR
from test_label_widths import drawn_panels


@pytest.mark.parametrize("system", ["METRIC", "IMPERIAL"])
@pytest.mark.parametrize("method", ["HOLTROP", "MICHELL", "SAVITSKY", "DELFT"])
def test_each_method(method, system):
    hull = sample("planing_boat" if method == "SAVITSKY" else "coaster")
    bpy.context.scene.unit_settings.system = system
    own = hull.hull.resistance
    own.method, own.speed_to, own.speed_from = method, 14.0, 10.0
    own.propeller_diameter, own.open_water_efficiency, own.thruster_diameter = 3.625, 0.65, 1.125
    if method == "DELFT":
        for kind in ("FIN_KEEL", "RUDDER"):
            make_active(hull)
            assert bpy.ops.hull.add_appendage(kind=kind) == {"FINISHED"}
        make_active(hull)
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    found = {
        f"{cls.__name__}: {fault}"
        for is_twin in (False, True)
        for cls, layout in drawn_after(own, is_twin)
        for fault in layout.faults(SIDEBAR)
    }
    assert not found, "\n".join(sorted(found))


def drawn_after(own, is_twin):
    own.twin_screw = is_twin
    return [(cls, layout) for cls, layout in drawn_panels() if "resistance" in cls.__name__]
