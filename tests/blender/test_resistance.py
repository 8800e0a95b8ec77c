# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel Resistance: what it asks for is what hull_native gives, and what is wrong is told."""

import bpy
import pytest
from addon_under_test import make_active, part, sample
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


@pytest.mark.parametrize("method", ["HOLTROP", "MICHELL", "DELFT", "SAVITSKY"])
def test_fresh_water_has_its_own_viscosity(method):
    """Of all four methods: friction of the panel's numbers is by the viscosity of fresh water."""
    hull, own = planing() if method == "SAVITSKY" else yacht()
    own.method, hull.hull.water_density = method, 1.0
    result, native = result_of(hull), part("bridge.native").require()
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    where = result.given.where
    position = {"draft": where.draft, "trim": where.trim, "draft_at": where.draft_at}
    water = {"water_density": 1.0, "viscosity": 1.13902e-6}
    body, speeds = state.ship.body, [row["speed_m_s"] for row in result.rows]
    if method == "HOLTROP":
        given = {"stern_coefficient": float(own.stern)}
        wanted = native.holtrop_table(body, speeds, given=given, **position, **water)
    elif method == "MICHELL":
        factor = result.given.form_factor
        wanted = native.michell_table(body, speeds, form_factor=factor, **position, **water)
    elif method == "DELFT":
        form = native.delft_yacht(body, **position)
        wanted = native.delft_table(form, speeds, form_factor=result.given.form_factor, **water)
    else:
        given = {**dict(result.given.planing), **dict(result.given.given), **position}
        given["water_density"] = 1.0
        wanted = native.savitsky_table(native.planing_boat(body, **given), speeds, **water)
    assert len(wanted) == len(result.rows) > 1
    for row, expected in zip(result.rows, wanted):
        # By 4 % of the viscosity friction changes by some 0.6 %.
        assert row["friction_kN"] == pytest.approx(expected["friction_kN"], rel=1e-5)
        assert row["total_kN"] == pytest.approx(expected["total_kN"], rel=1e-5)


def test_delft_series_takes_the_appendages():
    """Keel and rudder of the Add menu, at a heel; what counts as what is told. (The sample yacht
    has a keel of her own.)"""
    hull = sample("coaster")
    own = hull.hull.resistance
    own.speed_from, own.speed_to, own.speed_step = 7.0, 9.0, 1.0
    own.method, own.heel, own.form_factor = "DELFT", 0.3, 1.1
    (told,) = [text for text in result_of(hull).remarks() if "keel" in text]
    assert told.startswith("No keel, no rudder")
    for kind in ("FIN_KEEL", "RUDDER"):
        make_active(hull)
        assert bpy.ops.hull.add_appendage(kind=kind) == {"FINISHED"}
    result = result_of(hull)
    assert {"Keel: Fin Keel", "Rudder: Rudder"} <= set(result.remarks())
    native = part("bridge.native").require()
    body = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene).ship.body
    where = result.given.where
    position = {"draft": where.draft, "trim": where.trim, "draft_at": where.draft_at}
    fins = native.delft_fins(body, **position)
    wanted = native.delft_table(
        native.delft_yacht(body, **position),
        [7.0 * KNOT, 8.0 * KNOT, 9.0 * KNOT],
        heel_deg=17.188734,
        keel=fins.keels,
        rudder=fins.rudders,
        form_factor=1.1,
        water_density=where.water_density,
    )
    for row, expected in zip(result.rows, wanted):
        assert row["keel_kN"] > 0.0 and row["rudder_kN"] > 0.0
        # Live bodies are exact to 1e-8 of the whole, of which a fin is a hundredth.
        for name in ("friction_kN", "residuary_kN", "keel_kN", "rudder_kN", "heel_kN", "total_kN"):
            assert row[name] == pytest.approx(expected[name], rel=5e-5), name
    curves = part("features.resistance.resistance_curves")
    assert "keel [kN]" in curves.header(result)
    curves.plot(result, "yacht")
    make_active(hull)
    Drawn(part("panels.resistance").HULL_PT_resistance).draw(context())


def planing():
    """The planing boat from 10 to 40 knots by Savitsky."""
    hull = sample("planing_boat")
    own = hull.hull.resistance
    own.method = "SAVITSKY"
    own.speed_from, own.speed_to, own.speed_step = 2.0, 40.0, 1.0
    own.deadrise, own.thrust_arm = 0.3, 0.2
    return hull, own


def test_savitsky_is_that_of_hull_native():
    hull, own = planing()
    result = result_of(hull)
    native = part("bridge.native").require()
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    where = result.given.where
    boat = native.planing_boat(
        state.ship.body,
        draft=where.draft,
        trim=where.trim,
        draft_at=where.draft_at,
        water_density=where.water_density,
        deadrise_deg=17.188734,
        vcg=hull.hull.loading.kg,
        thrust_arm=0.2,
    )
    speeds = [row["speed_m_s"] for row in result.rows]
    wanted = native.savitsky(boat, speeds, water_density=where.water_density)
    assert 10 < len(speeds) <= 39
    for row, found in zip(result.rows, wanted):
        assert row["total_kN"] == pytest.approx(found.total, rel=1e-5)
        assert row["friction_kN"] + row["pressure_kN"] == pytest.approx(row["total_kN"])
        assert row["trim_deg"] == pytest.approx(found.trim_deg, rel=1e-5)
    curves = part("features.resistance.resistance_curves")
    assert "trim [deg]" in curves.header(result) and "keel draft [m]" in curves.header(result)
    curves.plot(result, "boat")
    drawn = Drawn(part("panels.resistance").HULL_PT_resistance)
    drawn.draw(context())


def test_speeds_without_equilibrium_are_told():
    hull, own = planing()
    assert not [remark for remark in result_of(hull).remarks() if "left out" in remark]
    own.thrust_arm = 7.0
    result = result_of(hull)
    (told,) = [remark for remark in result.remarks() if "left out" in remark]
    assert 39 - len(result.rows) == told.count(",") > 3
    own.thrust_arm = 50.0
    with pytest.raises(ValueError, match="is in equilibrium"):
        result_of(hull)


def numbers_of(group):
    return [name for name in group.bl_rna.properties.keys() if name not in ("rna_type", "name")]


def test_hull_files_and_variants_keep_the_settings(tmp_path):
    hull, own = planing()
    own.stern, own.twin_screw, own.propeller_diameter, own.chine_beam = "10", True, 0.5, 3.25
    own.open_water_efficiency, own.shaft_efficiency, own.roughness_um = 0.6, 0.97, 200.0
    own.thruster_diameter, own.planing_mass_t, own.planing_lcg = 0.4, 12.5, 3.1
    own.wave_speed_kn, own.hulls, own.open_stern = 9.0, "ONE", True
    own.blade_area_ratio, own.pitch_ratio, own.thruster_coefficient = 0.7, 1.1, 0.004
    for group in (own.holtrop, own.delft, own.michell):
        for i, name in enumerate(numbers_of(group)):
            setattr(group, name, 0.25 + 0.05 * i)
    path = str(tmp_path / "boat.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.object.hull.resistance
    assert again.id_data is not hull
    for name in own.bl_rna.properties.keys():
        if name in ("holtrop", "delft", "michell"):
            for each in numbers_of(getattr(own, name)):
                found, wanted = (getattr(getattr(one, name), each) for one in (again, own))
                assert found == pytest.approx(wanted, rel=1e-6) and found > 0.2, (name, each)
        elif name not in ("rna_type", "name"):
            wanted = getattr(own, name)
            is_number = isinstance(wanted, float)
            assert getattr(again, name) == (pytest.approx(wanted) if is_number else wanted), name
    bpy.ops.hull.keep_variant(name="A")
    kept = bpy.context.object.hull.variants.kept[0].resistance
    assert kept.holtrop.bulb_height == again.holtrop.bulb_height > 0.0


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
