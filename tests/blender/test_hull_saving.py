# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull written as a hull file reads back as the same hull, loads and marks included."""

import json
import sys
from math import radians

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, mesh_points, part, state_of


def write(path):
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}


def read(path):
    bpy.ops.wm.read_homefile(use_empty=True)
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    return bpy.context.object


def loaded_hull():
    hull = add_hull()
    settings = hull.hull
    settings.draft, settings.trim_m, settings.heel = 1.1, -0.3, radians(2.5)
    settings.deck_closed, settings.water_density = False, 1.008
    settings.scheme, settings.source = "catmull_clark", "a test"
    loading = settings.loading
    loading.use_displacement, loading.mass_t, loading.kg = False, 33.3, 1.7
    loading.use_lcb, loading.lcg, loading.free_trim = False, 4.9, False
    loading.loaded, loading.loaded_case = "CASE", "ballast"
    for name, mass_t in (("ballast", 20.1), ("Ladung „voll“", 44.4)):
        assert bpy.ops.hull.add_load_case() == {"FINISHED"}
        case = loading.load_cases[-1]
        case.name, case.mass_t, case.lcg, case.tcg, case.vcg = name, mass_t, 5.1, -0.02, 1.3
    case.vcg_is_guess = True
    assert bpy.ops.hull.add_downflooding_point() == {"FINISHED"}
    loading.downflooding_points[0].name = "hatch"
    loading.downflooding_points[0].position = (3.3, 1.1, 3.1)
    wind = settings.wind
    wind.source, wind.pressure, wind.keel_area, wind.sharp_bilges = "GIVEN", 252.0, 1.25, True
    wind.lever, wind.roll_period = 3.3, 4.4
    assert bpy.ops.hull.add_wind_area() == {"FINISHED"}
    wind.areas[0].name, wind.areas[0].area, wind.areas[0].z = "house", 12.3, 4.5
    bpy.context.view_layer.update()
    return hull


def settings_of(hull):
    """All that a hull file keeps, read from the object."""
    settings, loading = hull.hull, hull.hull.loading
    names = ("length_pp", "beam", "draft", "depth", "water_density", "trim_m", "heel",
             "deck_closed", "scheme", "source", "half")  # fmt: skip
    loads = (
        "loaded",
        "loaded_case",
        "use_displacement",
        "mass_t",
        "kg",
        "kg_is_guess",
        "use_lcb",
        "lcg",
        "free_trim",
    )
    winds = ("source", "lever", "pressure", "keel_area", "sharp_bilges", "roll_period")
    return (
        [getattr(settings, name) for name in names]
        + [getattr(loading, name) for name in loads]
        + [(c.name, c.mass_t, c.lcg, c.tcg, c.vcg, c.vcg_is_guess) for c in loading.load_cases]
        + [(p.name, tuple(p.position)) for p in loading.downflooding_points]
        + [getattr(settings.wind, name) for name in winds]
        + [(one.name, one.area, one.z) for one in settings.wind.areas]
    )


def test_loads_openings_and_water_come_back(tmp_path):
    hull = loaded_hull()
    wanted, points = settings_of(hull), mesh_points(hull)
    results = part("features.analyses").result_of(hull, bpy.context.scene, "load_cases")
    write(tmp_path / "box.hull.json")
    again = read(tmp_path / "box.hull.json")
    assert settings_of(again) == wanted
    assert np.array_equal(mesh_points(again), points)
    assert part("features.analyses").result_of(again, bpy.context.scene, "load_cases") == results


def wanted_of(hull):
    """All that a hull file keeps of what is wanted, read from the object."""
    targets, curve = hull.hull.targets, hull.hull.area_target
    names = ("moving", "keep_profile", "keep_deck", "keep_side", "free_length", "length_change",
             "free_beam", "beam_change", "free_draft", "draft_change", "stiffness")  # fmt: skip
    row = ("use", "quantity", "station", "sense", "value", "tolerance")
    return (
        [getattr(targets, name) for name in names]
        + [[getattr(one, name) for name in row] for one in targets.rows]
        + [(point.x, point.area) for points in (curve.base, curve.area_points) for point in points]
        + [curve.source]
    )


def test_targets_and_the_area_curve_come_back(tmp_path):
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.object
    targets, curve = hull.hull.targets, hull.hull.area_target
    for quantity, sense, value in (("KMT", "at least", 6.346), ("SECTION_AREA", "equal", 61.7)):
        assert bpy.ops.hull.add_target() == {"FINISHED"}
        row = targets.rows[-1]
        row.quantity, row.sense, row.value = quantity, sense, value
        row.station, row.tolerance, row.use = 33.3, 0.01, quantity == "KMT"
    targets.moving, targets.keep_deck, targets.free_beam = "NONE", False, True
    targets.beam_change, targets.stiffness = 3.3, 0.07
    assert bpy.ops.hull.take_area_curve(handles=7) == {"FINISHED"}
    curve.area_points[3].area *= 1.07
    assert curve.source == "the hull as it was" and len(curve.base) > 20
    wanted = wanted_of(hull)
    write(tmp_path / "coaster.hull.json")
    content = json.loads((tmp_path / "coaster.hull.json").read_text())
    assert content["targets"]["rows"][0]["value"] == 6.346
    assert content["targets"]["staying"] == ["profile", "greatest_beam"]
    again = read(tmp_path / "coaster.hull.json")
    assert wanted_of(again) == wanted
    # What can be wanted in Blender can be written, and nothing else.
    items = part("features.targets.quantities").ITEMS
    known = sys.modules[part("features.hull.wanted_data").Targets.__module__].QUANTITIES
    assert sorted(known) == sorted(item[0].lower() for item in items)


def test_numbers_are_written_as_they_were_typed(tmp_path):
    loaded_hull()
    write(tmp_path / "box.hull.json")
    content = json.loads((tmp_path / "box.hull.json").read_text())
    assert content["particulars"]["draft"] == 1.1
    assert content["afloat"] == {"trim": -0.3, "heel_deg": 2.5, "deck_closed": False}
    assert content["load"] == {
        "mass_t": 33.3,
        "kg": 1.7,
        "lcg": 4.9,
        "free_trim": False,
        "loaded": "case",
        "case": "ballast",
    }
    assert content["load_cases"][0]["tcg"] == -0.02
    assert content["openings"] == [{"name": "hatch", "position": [3.3, 1.1, 3.1]}]


def test_tags_and_the_deck_edge_come_back(tmp_path):
    hull = add_hull()
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(hull.data)
    for edge in bm.edges:
        edge.select_set({v.index for v in edge.verts} == {3, 7})
    bmesh.update_edit_mesh(hull.data)
    assert bpy.ops.hull.mark_deck_edge() == {"FINISHED"}
    write(tmp_path / "box.hull.json")  # from edit mode
    again = read(tmp_path / "box.hull.json")
    marks = part("bridge.mesh.deck_edge_marks").stored_marks(again.data)
    assert [set(again.data.edges[i].vertices) for i in np.flatnonzero(marks)] == [{3, 7}]
    assert len(state_of(again).ship.source.deck_edge) == 1
    creases = part("bridge.blender.blender_versions").edge_creases(again.data)
    assert (creases == 1.0).all()


def test_imported_hulls_come_back(freeship_folder, tmp_path):
    for path in sorted(freeship_folder.glob("*.f[bt]m"))[:4]:
        hull = read(path)
        points, numbers = mesh_points(hull), state_of(hull).hydrostatics.values
        layers = [(layer.name, layer.in_hydrostatics) for layer in hull.hull.layers]
        write(tmp_path / "again.hull.json")
        again = read(tmp_path / "again.hull.json")
        assert np.array_equal(mesh_points(again), points), path.name
        assert state_of(again).hydrostatics.values == numbers, path.name
        assert [(one.name, one.in_hydrostatics) for one in again.hull.layers] == layers


def test_the_scene_scale_is_honoured(tmp_path):
    bpy.context.scene.unit_settings.scale_length = 0.01
    hull = add_hull()
    bpy.ops.hull.add_load_case()
    hull.hull.loading.load_cases[0].vcg = 150.0
    write(tmp_path / "box.hull.json")
    content = json.loads((tmp_path / "box.hull.json").read_text())
    assert content["particulars"]["length_pp"] == pytest.approx(0.1)
    assert content["load_cases"][0]["vcg"] == pytest.approx(1.5)
    again = read(tmp_path / "box.hull.json")
    assert again.hull.loading.load_cases[0].vcg == pytest.approx(1.5)


def test_the_ending_is_added_once(tmp_path):
    add_hull()
    write(tmp_path / "box")
    write(tmp_path / "box.hull.json")
    assert [path.name for path in tmp_path.iterdir()] == ["box.hull.json"]


def test_a_mesh_that_no_file_can_hold_says_why(tmp_path):
    hull = add_hull()
    hull.data.clear_geometry()
    with pytest.raises(RuntimeError, match="a hull has 1 to"):
        write(tmp_path / "box.hull.json")
    assert not list(tmp_path.iterdir())


def test_a_mesh_without_faces_has_none():
    hull = add_hull()
    bm = bmesh.new()
    bm.from_mesh(hull.data)
    bmesh.ops.delete(bm, geom=bm.faces[:], context="FACES_ONLY")
    bm.to_mesh(hull.data)
    bm.free()
    ship = part("features.hull.hull_to_data").ship_data(hull, 1.0)
    assert ship.faces == [] and ship.face_layers == []
