# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings that a panel would not take, set as files, drivers and scripts set them: a sentence
comes at once, or as much as Blender can show."""

import time

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of

# Of the processor; what takes longer than this would hold up the window.
# No measure of speed: without a limit these take minutes, or have no end.
HANG_S = 60.0


@pytest.fixture
def hull():
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    bpy.context.view_layer.update()
    return bpy.context.object


def put(hull, path, value):
    """Past the limits of the property."""
    *groups, name = path.split(".")
    owner = hull.hull
    for group in groups:
        owner = getattr(owner, group)
    owner[name] = value
    hull.update_tag(refresh={"DATA"})


def refreshed_status(hull):
    return part("features.hull.hull_state").refresh(hull, bpy.context.scene).status


def refreshed(hull):
    """The HullState after an update that has an end."""
    start = time.process_time()
    bpy.context.view_layer.update()
    state = part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert time.process_time() - start < HANG_S
    assert not state.status
    return state


def refusal_of(hull, name):
    """What is said instead of an analysis, without computing it."""
    start = time.process_time()
    with pytest.raises(ValueError) as refused:
        part("features.analyses").result_of(hull, bpy.context.scene, name)
    assert time.process_time() - start < HANG_S
    return str(refused.value)


@pytest.mark.parametrize("wanted", [32, 256, 10**9])
def test_samples_are_as_many_as_can_be_shown(hull, wanted, capfd):
    put(hull, "samples", wanted)
    state = refreshed(hull)
    faces = len(hull.hull.surface_object.data.polygons)
    assert 100_000 < faces <= part("bridge.limits").MOST_SHOWN_FACES
    assert any(f"for {wanted}" in remark for remark in state.remarks)
    assert "Traceback" not in capfd.readouterr().err


def test_fewer_are_shown_while_points_can_be_moved(hull):
    most = part("bridge.limits").MOST_MOVING_FACES
    put(hull, "samples", 12)
    refreshed(hull)
    shown = hull.hull.surface_object.data
    faces = len(shown.polygons)
    assert faces > most
    bpy.ops.object.mode_set(mode="EDIT")
    state = refreshed(hull)
    assert most / 4 < len(shown.polygons) <= most
    assert any("while points can be moved" in remark for remark in state.remarks)
    assert part("features.hull.hull_state").state_of(hull).shown.is_as_left(hull)
    bpy.ops.object.mode_set(mode="OBJECT")
    state = refreshed(hull)
    assert len(shown.polygons) == faces
    assert not any("while points can be moved" in remark for remark in state.remarks)


def test_samples_below_one_show_the_surface_too(hull):
    put(hull, "samples", -5)
    refreshed(hull)
    assert len(hull.hull.surface_object.data.polygons) == 2 * state_of(hull).ship.surface.cell_count


def test_a_mesh_too_fine_for_its_surface_is_refused(hull):
    """Such as a surface object's own, which somebody gives to the hull."""
    put(hull, "samples", 32)
    refreshed(hull)
    control, shown = hull.data, hull.hull.surface_object
    before = len(shown.data.polygons)
    hull.data = shown.data.copy()
    bpy.context.view_layer.update()
    assert "too fine" in state_of(hull).status
    assert len(hull.hull.surface_object.data.polygons) == before
    # Nor is a part of it shown where there was nothing before.
    part("features.hull.hull_state").forget_all()
    assert "too fine" in refreshed_status(hull) and state_of(hull).ship.surface is None
    hull.data = control
    bpy.context.view_layer.update()
    assert not state_of(hull).status


def sheet(squares, of_triangles):
    """Control arrays of a half hull's side as a plane of squares² faces, or two triangles each."""
    points = np.indices((squares + 1, squares + 1)).reshape(2, -1).T
    points = np.column_stack([points[:, 0], np.ones(len(points)), points[:, 1]]).astype(float)
    index = np.arange(len(points)).reshape(squares + 1, squares + 1)
    corners = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    faces = np.stack([corner.reshape(-1) for corner in corners], axis=1)
    if of_triangles:
        faces = faces[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    return points, faces


@pytest.mark.parametrize("squares, of_triangles, refused", [
    (155, False, False), (160, False, True), (75, True, False), (85, True, True)
])  # fmt: skip
def test_triangles_make_a_mesh_too_fine_sooner(hull, squares, of_triangles, refused):
    """Half hulls of 24,025 and 25,600 squares, of 11,250 and 14,450 triangles."""
    points, faces = sheet(squares, of_triangles)
    mesh = bpy.data.meshes.new("sheet")
    mesh.from_pydata(points.tolist(), [], faces.tolist())
    arrays = part("bridge.mesh.mesh_arrays")
    control = arrays.control_arrays(arrays.read_mesh(mesh), 1.0)
    assert part("bridge.mesh.mesh_check").is_too_fine(control, True) == refused
    if refused:
        before, hull.data = hull.data, mesh
        bpy.context.view_layer.update()
        assert "too fine" in state_of(hull).status and "coarser" in state_of(hull).status
        hull.data = before


HYDROSTATICS = [
    ("length_pp", 1e30, "Lpp"),
    ("length_pp", float("nan"), "Lpp"),
    ("beam", -1.0, "Beam"),
    ("draft", float("inf"), "Draft"),
    ("trim_m", 1e9, "Trim"),
    ("heel", 100.0, "Heel"),
    ("water_density", 0.0, "Density"),
]


@pytest.mark.parametrize("path, value, name", HYDROSTATICS)
def test_dimensions_that_no_ship_has(hull, path, value, name, capfd):
    put(hull, path, value)
    state = refreshed(hull)
    assert name in state.hydrostatics.status and state.hydrostatics.values is None
    assert name in refusal_of(hull, "sectional_areas")
    assert "Traceback" not in capfd.readouterr().err


LINES = [
    ("length_pp", 1e30, "Lpp"),
    ("lines.station_count", 10**9, "spaces"),
    ("lines.station_count", -3, "spaces"),
    ("lines.waterline_spacing", -1.0, "waterlines"),
    ("lines.buttock_spacing", 1e-9, "buttocks"),
    ("lines.waterlines", "0:1:0.003 1:2:0.003", "waterlines"),
    ("lines.diagonals", " ".join(["5/35"] * 1000), "diagonals"),
]


@pytest.mark.parametrize("path, value, name", LINES)
def test_more_lines_than_anybody_draws(hull, path, value, name, tmp_path, capfd):
    put(hull, path, value)
    assert name in refreshed(hull).lines.status
    start = time.process_time()
    with pytest.raises(RuntimeError, match=name):
        bpy.ops.hull.export_lines(filepath=str(tmp_path / "plan.pdf"))
    assert time.process_time() - start < HANG_S
    assert not list(tmp_path.iterdir())
    assert "Traceback" not in capfd.readouterr().err


FAIRNESS = [
    ({"fairness.show_isophotes": 1, "fairness.isophote_spacing": 0.0}, "isophotes"),
    ({"fairness.show_reflections": 1, "fairness.reflection_spacing": 1e-9}, "reflection lines"),
    ({"fairness.show_silhouette": 1, "fairness.divisions": 10**6}, "Fineness"),
    ({"fairness.comb_stations": 1, "fairness.comb_step": 1e-6}, "teeth"),
]


@pytest.mark.parametrize("settings, name", FAIRNESS)
def test_finer_lines_than_can_be_told_apart(hull, settings, name, capfd):
    for path, value in settings.items():
        put(hull, path, value)
    assert name in refreshed(hull).fairness.status
    assert "Traceback" not in capfd.readouterr().err


ANALYSES = [
    ("hydrostatic_table", "table.trims", "-1:1:0.004", "drafts at all trims"),
    ("hydrostatic_table", "table.draft_step", -1.0, "step"),
    ("hydrostatic_table", "table.draft_step", float("nan"), "step"),
    ("hydrostatic_table", "table.draft_to", 1e30, "draft"),
    ("bonjean_curves", "depth", 1e30, "Depth"),
    ("bonjean_curves", "lines.station_count", 10**9, "spaces"),
    ("righting_levers", "loading.heel_step", -0.1, "step"),
    ("righting_levers", "loading.heel_step", 0.0, "step"),
    ("righting_levers", "loading.heel_greatest", 1e6, "heel"),
    ("righting_levers", "loading.kg", 1e30, "VCG"),
    ("cross_curves", "loading.displacement_count", 10**9, "Displacements"),
    ("cross_curves", "loading.greatest_t", float("nan"), "greatest"),
    ("offset_table", "lines.stations", "0:1:0.002", "stations"),
]


@pytest.mark.parametrize("name, path, value, said", ANALYSES)
def test_analyses_of_more_than_anybody_reads(hull, name, path, value, said, capfd):
    put(hull, path, value)
    assert said in refusal_of(hull, name)
    assert "Traceback" not in capfd.readouterr().err


def test_a_thousand_load_cases_are_refused(hull):
    for _ in range(1000):
        hull.hull.loading.load_cases.add()
    assert "1000 load cases" in refusal_of(hull, "load_cases")


WIND = [
    ("lever", float("nan"), "lever"),
    ("pressure", float("nan"), "pressure"),
    ("keel_area", float("nan"), "keels"),
    ("roll_period", float("nan"), "roll's period"),
    ("area", float("nan"), "Wind area 1"),
    ("z", float("nan"), "Wind area 1"),
    ("z", 1e30, "Wind area 1"),
]


@pytest.mark.parametrize("name, value, said", WIND)
def test_wind_that_no_ship_meets(hull, name, value, said):
    """A number that is none is unlike itself: what depends on it would be out of date for ever."""
    hull.hull.wind.source = "HULL"
    bpy.ops.hull.add_wind_area()
    owner = hull.hull.wind.areas[0] if name in ("area", "z") else hull.hull.wind
    owner[name] = value
    assert said in refusal_of(hull, "criteria")
    analyses, scene = part("features.analyses"), bpy.context.scene
    assert analyses.last_outcome(hull, scene, "criteria")[1]


def test_a_full_table_is_quick(hull):
    hull.hull.table.trims = "-1:1:0.0202"
    start = time.process_time()
    result = part("features.analyses").result_of(hull, bpy.context.scene, "hydrostatic_table")
    assert time.process_time() - start < HANG_S
    assert len(result.hydrostatics) > 900


def test_a_fit_to_more_points_than_memory_holds(hull):
    bpy.ops.mesh.primitive_cube_add()
    target = bpy.context.object
    hull.hull.fit.target = target
    put(hull, "fit.samples", 10**9)
    with pytest.raises(ValueError, match="Points"):
        part("features.fitting.fitting").Fitting(hull, bpy.context.scene)
