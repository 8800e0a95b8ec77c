# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics at the draft, trim and heel of the settings, against closed forms of a box."""

from math import atan, cos, pi, radians, tan

import bpy
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_hull, make_active, part, state_of

BEAM = 2.0 * HALF_BREADTH


def settings_of_afloat_box(**settings):
    hull = add_hull()
    hull.hull.draft = 1.0
    for name, value in settings.items():
        assert name in hull.hull.bl_rna.properties  # Python would keep any other, too
        setattr(hull.hull, name, value)
    bpy.context.view_layer.update()
    return hull


def test_trim_is_the_difference_of_drafts_at_the_perpendiculars():
    found = state_of(settings_of_afloat_box(trim_m=0.5)).hydrostatics.values
    assert (found.draft_aft, found.draft_forward) == (1.25, 0.75)
    assert found.displaced_volume == pytest.approx(LENGTH * BEAM * 1.0, rel=1e-12)
    # The centre of a trapezium with the sides 1.25 and 0.75.
    assert found.lcb == pytest.approx(LENGTH / 2 - LENGTH * 0.5 / 12.0, rel=1e-12)


def test_trim_of_a_heeled_hull_is_measured_on_her_own_vertical():
    afloat = part("features.flotation.afloat")
    hull = settings_of_afloat_box(trim_m=0.5, heel=radians(30.0))
    where = afloat.afloat(hull.hull, 1.0)
    assert where.heel == radians(30.0)
    assert LENGTH * tan(where.trim) / cos(where.heel) == pytest.approx(0.5, rel=1e-14)
    assert where.trim == pytest.approx(atan(0.05 * cos(radians(30.0))), rel=1e-14)


def test_heel_to_starboard_brings_the_buoyancy_there():
    heel = radians(10.0)
    found = state_of(settings_of_afloat_box(heel=heel)).hydrostatics.values
    # B² tan(heel) / 12 T of a box whose bilge and deck stay where they are.
    assert found.tcb == pytest.approx(-(BEAM**2) * tan(heel) / 12.0, rel=1e-12)
    assert found.heel == pytest.approx(heel, rel=1e-14)


def test_values_are_those_of_the_native_function():
    hull = settings_of_afloat_box(trim_m=0.25, heel=radians(5.0), water_density=1.0)
    hydrostatics = part("features.flotation.hydrostatics")
    where = part("features.flotation.afloat").afloat(hull.hull, 1.0)
    wanted = (
        part("bridge.native")
        .require()
        .hydrostatics(
            state_of(hull).ship.body,
            draft=1.0,
            trim=where.trim,
            heel=where.heel,
            draft_at=5.0,
            length_pp=LENGTH,
            beam=BEAM,
            water_density=1.0,
        )
    )
    assert state_of(hull).hydrostatics.values == hydrostatics.described(wanted, where)
    assert state_of(hull).hydrostatics.values.bmt == wanted.bm_transverse


def test_coefficients_stand_on_project_or_on_actual_dimensions():
    found = state_of(settings_of_afloat_box(length_pp=20.0)).hydrostatics.values
    assert found.project_block == pytest.approx(0.5, rel=1e-12)
    assert found.immersed_block == pytest.approx(1.0, rel=1e-12)


def test_what_needs_a_length_is_undefined_without_one():
    found = state_of(settings_of_afloat_box(length_pp=0.0)).hydrostatics.values
    for name in ("lcb_percent", "lcf_percent", "mtc", "midship_area", "project_block"):
        assert getattr(found, name) is None
    assert found.immersed_block == pytest.approx(1.0, rel=1e-12)
    hull = settings_of_afloat_box(length_pp=0.0, trim_m=0.5)
    assert state_of(hull).hydrostatics.values is None
    assert "Give Lpp first" in state_of(hull).hydrostatics.status


def test_an_open_deck_floods_and_a_closed_one_does_not():
    hull = settings_of_afloat_box(heel=radians(60.0), deck_closed=False)
    assert state_of(hull).hydrostatics.values is None
    assert "floods at" in state_of(hull).hydrostatics.status
    hull.hull.deck_closed = True
    bpy.context.view_layer.update()
    assert state_of(hull).hydrostatics.values.displaced_volume > 0.0
    assert not state_of(hull).hydrostatics.status


def test_nothing_under_water_is_said():
    hull = settings_of_afloat_box(draft=0.0)
    for vertex in hull.data.vertices:
        vertex.co.z += 0.5
    hull.data.update_tag()
    bpy.context.view_layer.update()
    assert "Nothing is under water" in state_of(hull).hydrostatics.status


def two_flared_sides():
    """A whole hull of two sides, hollow below, 10 m long, that are 0.2 m apart along the keel."""
    section = ((0.1, 0.0), (0.2, 1.5), (2.0, 3.0), (2.0, 10.0))
    points, faces = [], []
    for sign in (1.0, -1.0):
        first = len(points)
        for x in (0.0, 10.0):
            points += [(x, sign * y, z) for y, z in section]
        for low in range(first, first + 3):
            face = [low, low + 1, low + 5, low + 4]
            faces.append(face if sign > 0.0 else face[::-1])
    mesh = bpy.data.meshes.new("sides")
    mesh.from_pydata(points, [], faces)
    part("bridge.blender.blender_versions").set_creases(mesh, range(len(mesh.edges)), [])
    sides = bpy.data.objects.new("sides", mesh)
    bpy.context.collection.objects.link(sides)
    make_active(sides)
    assert bpy.ops.hull.make_hull(half=False) == {"FINISHED"}
    return sides


def test_a_shell_open_along_the_keel_is_said_with_what_helps():
    hull = two_flared_sides()
    hull.hull.draft = 1.5
    bpy.context.view_layer.update()
    status = state_of(hull).hydrostatics.status
    assert "not closed below the water" in status and "Select › Creases › Borders" in status
    with pytest.raises(ValueError, match="not closed below the water"):
        table = part("features.curves_of_form.hydrostatic_table")
        ship = state_of(hull).ship.source.new_ship()
        where = part("features.flotation.afloat").afloat(hull.hull, 1.0)
        table.compute(ship, table.Inputs((1.0, 1.5), (0.0,), where))
    bpy.ops.object.mode_set(mode="EDIT")
    assert bpy.ops.hull.select_creases(kind="BORDER") == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    low = [v for v in hull.data.vertices if v.select and v.co.z == 0.0]
    assert len(low) == 4
    for vertex in low:
        vertex.co.y = 0.0
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.remove_doubles()
    bpy.ops.object.mode_set(mode="OBJECT")
    found = part("features.hull.hull_state").refresh(hull, bpy.context.scene).hydrostatics.values
    assert found.displaced_volume == pytest.approx(10.0 * 0.2 * 1.5, rel=1e-6)


def test_faces_turned_inwards_are_said():
    hull = add_hull()
    hull.data.flip_normals()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert state_of(hull).hydrostatics.values is None
    assert "inwards" in state_of(hull).hydrostatics.status


def test_every_value_is_written_with_its_unit():
    hull = settings_of_afloat_box()
    units, hydrostatics = part("bridge.blender.units"), part("features.flotation.hydrostatics")
    scene = bpy.context.scene
    for quantity in hydrostatics.QUANTITIES:
        value = getattr(state_of(hull).hydrostatics.values, quantity.name)
        assert units.format_value(scene, value, quantity.unit), quantity.name
    scene.unit_settings.system = "METRIC"
    assert units.format_value(scene, 12.3456, "t/cm") == "12.346 t/cm"
    assert units.format_value(scene, 0.5 * pi, "deg") == "90.00°"
    assert units.format_value(scene, None, "m") == "–"
    assert units.format_value(scene, -1e-9, "m") == "0.000 m"
    scene.unit_settings.system = "IMPERIAL"
    assert units.format_value(scene, 0.3048, "m") == "1.000 ft"
    # A long ton an inch is 1.016 t in 2.54 cm.
    assert units.format_value(scene, 1.0160469088 / 2.54, "t/cm") == "1.000 LT/in"


def test_the_hull_is_as_deep_as_it_was_modelled():
    assert state_of(settings_of_afloat_box(draft=DEPTH)).hydrostatics.values.kb == pytest.approx(
        1.5
    )
