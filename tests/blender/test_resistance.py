# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel Resistance: what it asks for is what hull_native gives, and what is wrong is told."""

import bpy
import pytest
from addon_under_test import part, sample
from test_panels import Drawn, context

KNOT = 1852.0 / 3600.0


def yacht():
    """The sample, and its settings of resistance."""
    hull = sample("sailing_yacht")
    own = hull.hull.resistance
    own.speed_from, own.speed_to, own.speed_step = 7.0, 9.0, 1.0
    return hull, own


def result_of(hull):
    analyses = part("features.analyses")
    return analyses.result_of(hull, bpy.context.scene, "resistance_curves")


@pytest.mark.parametrize("method", ["HOLTROP", "MICHELL"])
def test_rows_are_those_of_hull_native(method):
    hull, own = yacht()
    own.method, own.form_factor, own.stern = method, 1.25, "10"
    own.appendage_area, own.appendage_factor = 2.0, 1.5
    own.propeller_diameter, own.twin_screw = 0.6, True
    result = result_of(hull)
    native = part("bridge.native").require()
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    where = result.given.where
    position = {"draft": where.draft, "trim": where.trim, "draft_at": where.draft_at}
    position["water_density"] = where.water_density
    speeds = [7.0 * KNOT, 8.0 * KNOT, 9.0 * KNOT]
    if method == "MICHELL":
        wanted = native.michell_table(state.ship.body, speeds, form_factor=1.25, **position)
    else:
        wanted = native.holtrop_table(
            state.ship.body,
            speeds,
            given={"stern_coefficient": 10.0, "appendages": ((2.0, 1.5),)},
            propeller=native.Propeller(0.6, screws=2),
            **position,
        )
    assert len(result.rows) == 3
    for row, expected in zip(result.rows, wanted):
        for name, value in expected.items():
            assert row[name] == pytest.approx(value, rel=1e-5), name


@pytest.mark.parametrize(
    "change, said",
    [
        ({"speed_from": 0.0}, "first speed must be more than zero"),
        ({"speed_step": 0.0}, "must be more than 0"),
        ({"speed_to": 3.0}, "must be greater than the first"),
    ],
)
def test_wrong_speeds_are_told(change, said):
    hull, own = yacht()
    for name, value in change.items():
        setattr(own, name, value)
    with pytest.raises(ValueError, match=said):
        result_of(hull)


def test_heel_and_draft_are_told():
    hull, own = yacht()
    hull.hull.heel = 0.1
    with pytest.raises(ValueError, match="set the heel to zero"):
        result_of(hull)
    hull.hull.heel = 0.0
    hull.hull.draft = -50.0
    with pytest.raises(ValueError, match="out of the water"):
        result_of(hull)


def test_the_panel_shows_rows_and_remarks():
    hull, own = yacht()
    own.speed_from, own.speed_to, own.speed_step = 4.0, 40.0, 0.5
    analyses = part("features.analyses")
    analyses.outcome_of(hull, bpy.context.scene, "resistance_curves")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance)
    drawn.draw(context())
    curves = part("features.resistance.resistance_curves")
    assert curves.shown(73, 12)[0] == 0 and curves.shown(73, 12)[-1] == 72
    assert len(curves.shown(73, 12)) == 12 and curves.shown(3, 12) == [0, 1, 2]
    remarks = list(result_of(hull).remarks())
    assert any("Froude number" in remark for remark in remarks)
    assert len(remarks) == len(set(remarks)) <= 4
