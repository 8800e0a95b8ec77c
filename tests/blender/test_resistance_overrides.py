# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever a method of resistance asks of a ship can be given in place of what the hull has: of
each field it is said by which setting, and what is given arrives where the table is reckoned."""

import inspect
import math
from dataclasses import fields, replace
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, part, sample
from test_panels import Drawn, context
from test_resistance import KNOT, result_of


def by(expected, **settings):
    """What arrives of these settings, "of.in.it" as of__in__it below Object.hull."""
    return {name.replace("__", "."): value for name, value in settings.items()}, expected


def resistance(expected, **settings):
    return by(expected, **{f"resistance__{name}": value for name, value in settings.items()})


def holtrop(name, value):
    return resistance(value, **{f"holtrop__{name}": value})


def delft(name, value):
    return resistance(value, **{f"delft__{name}": value})


def propeller(expected, **settings):
    return resistance(expected, propeller_diameter=3.6, **settings)


# By the field: settings and what arrives, or why no setting is needed.
HOLTROP = {
    **{name: holtrop(name, value) for name, value in (
        ("length", 88.0), ("beam", 13.0), ("draft_forward", 5.6), ("draft_aft", 5.5),
        ("displaced_volume", 4500.0), ("lcb_percent", -1.5), ("midship", 0.97),
        ("waterplane", 0.83), ("wetted_surface", 1650.0), ("entrance_angle_deg", 25.0),
        ("bulb_area", 3.5), ("bulb_height", 2.0), ("transom_area", 1.5),
    )},
    "prismatic": "∇ / (CM L B T)",
    "block": "∇ / (L B T)",
    "appendages": resistance(((2.0, 1.4),), appendage_area=2.0, appendage_factor=1.4),
    "stern_coefficient": resistance(-25.0, stern="-25"),
    "thruster_diameter": resistance(1.2, thruster_diameter=1.2),
    "thruster_coefficient": resistance(0.008, thruster_diameter=1.2, thruster_coefficient=0.008),
    "side_by_side": resistance(True, hulls="BESIDE"),
}  # fmt: skip
PROPELLER = {
    "diameter": propeller(3.6),
    "area_ratio": propeller(0.75, blade_area_ratio=0.75),
    "pitch_ratio": propeller(1.2, twin_screw=True, pitch_ratio=1.2),
    "screws": propeller(2, twin_screw=True),
    "open_stern": propeller(True, open_stern=True),
    "open_water_efficiency": propeller(0.65, open_water_efficiency=0.65),
    "shaft_efficiency": propeller(0.96, open_water_efficiency=0.65, shaft_efficiency=0.96),
}
YACHT = {name: delft(name, value) for name, value in (
    ("length", 88.0), ("beam", 13.0), ("draft", 5.0), ("volume", 4500.0),
    ("waterplane_area", 900.0), ("wetted_surface", 1650.0), ("prismatic", 0.6), ("midship", 0.9),
    ("lcb", 40.0), ("lcf", 41.0),
)}  # fmt: skip
YACHT["side_by_side"] = resistance(True, hulls="BESIDE")
KEEL = {
    **{name: delft(f"keel_{name}", value) for name, value in (
        ("wetted_surface", 60.0), ("chord", 5.0), ("thickness", 0.15), ("volume", 12.0),
        ("total_draft", 9.0), ("centre", -0.5),
    )},
    "name": "it is told in Remarks, and nothing is reckoned by it",
}  # fmt: skip
RUDDER = {
    **{name: delft(f"rudder_{name}", value) for name, value in (
        ("wetted_surface", 20.0), ("chord", 2.5), ("thickness", 0.17),
    )},
    "volume": "the series has no waves of rudders",
    "total_draft": "the series has no waves of rudders",
    "centre": "the series has no waves of rudders",
    "name": "it is told in Remarks, and nothing is reckoned by it",
}  # fmt: skip
MICHELL = {
    "body": "the hull itself",
    "speeds": resistance((9.0 * KNOT, 12.0 * KNOT), speed_from=9.0, speed_to=12.0, speed_step=3.0),
    "draft": by(5.0, draft=5.0),
    "trim": by(math.atan(0.5 / 80.0), trim_m=0.5, length_pp=80.0),
    "draft_at": by(40.0, length_pp=80.0),
    "form_factor": resistance(1.2, form_factor=1.2),
    "length": resistance(80.0, michell__length=80.0),
    "wetted_surface": resistance(1650.0, michell__wetted_surface=1650.0),
    "water_density": by(1.01, water_density=1.01),
    "viscosity": "that of water of the density",
    "tolerance": "of the integral's end: what is left out is told",
}  # fmt: skip
PLANING = {
    "mass_t": resistance(20.0, planing_mass_t=20.0),
    "beam": resistance(3.2, chine_beam=3.2),
    "deadrise_deg": resistance(20.0, deadrise=math.radians(20.0)),
    "lcg": resistance(4.0, planing_lcg=4.0),
    "vcg": by(1.1, loading__kg=1.1),
    "thrust_angle_deg": resistance(5.0, shaft_angle=math.radians(5.0)),
    "thrust_arm": resistance(-0.1, thrust_arm=-0.1),
    "side_by_side": resistance(True, hulls="BESIDE"),
}
# The method, what says how it is given, the table's function, and its argument that has it.
KINDS = {
    "HoltropShip": ("HOLTROP", HOLTROP, "holtrop_rows", lambda args: args["ship"]),
    "Propeller": ("HOLTROP", PROPELLER, "holtrop_rows", lambda args: args["how"]["propeller"]),
    "DelftYacht": ("DELFT", YACHT, "delft_table", lambda args: args["yacht"]),
    "keel": ("DELFT", KEEL, "delft_table", lambda args: args["how"]["keel"][0]),
    "rudder": ("DELFT", RUDDER, "delft_table", lambda args: args["how"]["rudder"][0]),
    "michell_table": ("MICHELL", MICHELL, "michell_table", lambda a: SimpleNamespace(**a)),
    "PlaningBoat": ("SAVITSKY", PLANING, "savitsky_table", lambda args: args["boat"]),
}


def native():
    return part("bridge.native").require()


def names_of(kind):
    """Of hull_native, what a method asks."""
    if kind == "michell_table":
        return set(inspect.signature(native().michell_table).parameters)
    cls = getattr(native(), {"keel": "DelftFin", "rudder": "DelftFin"}.get(kind, kind))
    return {each.name for each in fields(cls)}


@pytest.mark.parametrize("kind", KINDS)
def test_of_each_field_it_is_said_how_it_is_given(kind):
    """A new field fails here until it has a setting, or a reason why it needs none."""
    assert names_of(kind) == set(KINDS[kind][1])
    assert all(said for said in KINDS[kind][1].values())


def ship_of(method):
    """The hull by a method; with the Delft series it has a keel and a rudder."""
    hull = sample("planing_boat" if method == "SAVITSKY" else "coaster")
    own = hull.hull.resistance
    own.method = method
    own.speed_from, own.speed_to, own.speed_step = (
        (25.0, 30.0, 5.0) if method == "SAVITSKY" else (10.0, 12.0, 2.0)
    )
    if method == "DELFT":
        for kind in ("FIN_KEEL", "RUDDER"):
            make_active(hull)
            assert bpy.ops.hull.add_appendage(kind=kind) == {"FINISHED"}
        make_active(hull)
    return hull


def holder_of(hull, path):
    group, _, name = path.rpartition(".")
    return hull.hull.path_resolve(group) if group else hull.hull, name


def value_of(hull, path):
    return getattr(*holder_of(hull, path))


def give(hull, settings):
    for path, value in settings.items():
        setattr(*holder_of(hull, path), value)
    bpy.context.view_layer.update()


def drawn(panel):
    one = Drawn(getattr(part("panels.resistance"), panel))
    one.draw(context())
    return one.layout.noted


@pytest.fixture
def asked_of(monkeypatch):
    """(table's function) → a list that gets the arguments of each call of it."""

    def watch(function):
        table, calls = getattr(native(), function), []
        signature = inspect.signature(table)

        def watched(*args, **how):
            bound = signature.bind(*args, **how)
            bound.apply_defaults()
            calls.append(dict(bound.arguments))
            return table(*args, **how)

        monkeypatch.setattr(native(), function, watched)
        return calls

    return watch


def given_one_by_one(hull, said):
    """(name of a field, what arrives) with its settings given, which go back afterwards."""
    for name, how in said.items():
        if isinstance(how, str):
            continue
        settings, wanted = how
        before = {path: value_of(hull, path) for path in settings}
        give(hull, settings)
        yield name, settings, wanted
        give(hull, before)


def is_same(found, wanted):
    if isinstance(wanted, tuple):
        return np.shape(found) == np.shape(wanted) and np.allclose(found, wanted, rtol=1e-6)
    return found == (pytest.approx(wanted, rel=1e-6) if isinstance(wanted, float) else wanted)


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_given_arrives(kind, asked_of):
    method, said, function, holder = KINDS[kind]
    hull, calls = ship_of(method), asked_of(function)
    result_of(hull)
    own, lost = holder(calls[-1]), {}
    for name, _, wanted in given_one_by_one(hull, said):
        result_of(hull)
        found = getattr(holder(calls[-1]), name)
        if not is_same(found, wanted):
            lost[name] = found
        # So that the hull's own does not pass for it; without a propeller there is none.
        assert own is None or not is_same(getattr(own, name), wanted), name
    assert not lost


@pytest.mark.parametrize("kind", KINDS)
def test_the_panels_have_a_field_for_it(kind):
    method, said, _, _ = KINDS[kind]
    hull, missing = ship_of(method), []
    for _, settings, _ in given_one_by_one(hull, said):
        noted = drawn("HULL_PT_resistance") + drawn("HULL_PT_resistance_inputs")
        names = [path.rpartition(".")[2] for path in settings if path.startswith("resistance")]
        missing += [name for name in names if f"property {name}" not in noted]
    assert not missing


@pytest.mark.parametrize(
    "method, name, function, found",
    [
        ("HOLTROP", "lcb_percent", "holtrop_rows", lambda args: args["ship"].lcb_percent),
        ("HOLTROP", "bulb_area", "holtrop_rows", lambda args: args["ship"].bulb_area),
        ("HOLTROP", "transom_area", "holtrop_rows", lambda args: args["ship"].transom_area),
        ("DELFT", "keel_centre", "delft_table", lambda args: args["how"]["keel"][0].centre),
        ("SAVITSKY", "deadrise_deg", "savitsky_table", lambda args: args["boat"].deadrise_deg),
    ],
)
def test_zero_arrives(method, name, function, found, asked_of):
    hull, calls = ship_of(method), asked_of(function)
    hull.hull.resistance.zeros = {name}
    result_of(hull)
    assert found(calls[-1]) == 0.0


def test_all_zeros_are_tried():
    marks = test_zero_arrives.pytestmark[0].args[1]
    known = part("features.flotation.resistance_data").ZERO_INPUTS
    assert {name for _, name, _, _ in marks} == set(known)


def test_coefficients_follow_what_they_are_quotients_of(asked_of):
    """Those that have no setting: each follows the numbers it is made of."""
    hull, calls = ship_of("HOLTROP"), asked_of("holtrop_rows")
    for name in ("length", "beam", "draft_forward", "draft_aft", "displaced_volume", "midship"):
        give(hull, HOLTROP[name][0])
    result_of(hull)
    ship = calls[-1]["ship"]
    assert (ship.prismatic, ship.block) == (None, None)
    box = 88.0 * 13.0 * 5.55
    assert ship.completed().block == pytest.approx(4500.0 / box, rel=1e-6)
    assert ship.completed().prismatic == pytest.approx(4500.0 / (0.97 * box), rel=1e-6)


def test_rudders_have_no_waves(asked_of):
    hull, calls = ship_of("DELFT"), asked_of("delft_table")
    rows = result_of(hull).rows
    args = calls[-1]
    bare = {"volume": None, "total_draft": None, "centre": None}
    how = {**args["how"], "rudder": [replace(fin, **bare) for fin in args["how"]["rudder"]]}
    assert native().delft_table(args["yacht"], args["speeds"], **how) == rows


def test_a_keel_can_be_given_to_a_hull_without_one(asked_of):
    hull = sample("coaster")
    own, calls = hull.hull.resistance, asked_of("delft_table")
    own.method, own.speed_from, own.speed_to, own.speed_step = "DELFT", 10.0, 12.0, 2.0
    before = result_of(hull)
    assert before.measured["keel_chord"] == 0.0 and before.rows[0]["keel_kN"] == 0.0
    own.delft.keel_wetted_surface = 60.0
    with pytest.raises(ValueError, match="no keel joined to it"):
        result_of(hull)
    own.delft.keel_chord = 5.0
    after = result_of(hull)
    (keel,) = calls[-1]["how"]["keel"]
    assert (keel.wetted_surface, keel.chord, keel.volume) == (60.0, 5.0, None)
    assert after.rows[0]["keel_kN"] > 0.0 and "Keel: keel" in after.remarks()
    part("features.analyses").outcome_of(hull, bpy.context.scene, "resistance_curves")
    assert "0.00 m" in drawn("HULL_PT_resistance_inputs")
