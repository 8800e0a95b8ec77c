# SPDX-License-Identifier: GPL-3.0-or-later
"""Fitting a hull: to the surface of another, to an STL file, to points; what is to stay stays."""

import dataclasses
import struct

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part, sample, state_of
from edited_hulls import centre_normals

SEED = 1122


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def shake(hull, by):
    """Moves points at random, those of the centre plane within it."""
    random = np.random.default_rng(SEED)
    points = points_of(hull)
    moves = by * random.normal(size=points.shape)
    moves[np.abs(points[:, 1]) < 1e-6, 1] = 0.0
    part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(points)), points + moves)
    bpy.context.view_layer.update()


def shape_of(surface, name="shape", n=12, both=True):
    """An object of flat faces between points of a surface, of both sides."""
    grid = surface.tessellate(n)
    points, quads = np.array(grid.points), np.array(grid.quads)
    if both:
        quads = np.concatenate([quads, quads[:, ::-1] + len(points)])
        points = np.concatenate([points, points * [1.0, -1.0, 1.0]])
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), [], quads.tolist())
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    return obj


def off(hull, surface):
    """The largest distance of a hull's surface from another."""
    now = state_of(hull).ship.surface
    places = now.evaluate_grid(4, 0)[0].reshape(-1, 3)
    return part("bridge.native").require().SurfaceTree(surface).closest_points(places).distances


def wanted(hull):
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    native = part("bridge.native").require()
    surface = state_of(hull).ship.surface
    return native.LimitSurface(surface.mesh.with_points(surface.mesh.points), surface.scheme)


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()


def test_a_hull_comes_back_to_its_shape():
    hull = sample()
    surface = wanted(hull)
    hull.hull.fit.target = shape_of(surface)
    hull.hull.fit.fairness = 1e-6
    hull.hull.fit.use_edges, hull.hull.fit.draw_border = True, False
    shake(hull, 0.05)
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, is_current = part("features.fitting.fitting").last_report(hull)
    assert is_current
    # The faces are flat between points of the surface: within it by some millimetres.
    assert report.rms < 0.006 and report.line_rms < 0.05
    distances = off(hull, surface)
    assert np.sqrt((distances**2).mean()) < 0.02
    on_centre = np.abs(before[:, 1]) < 1e-6
    assert (points_of(hull)[on_centre, 1] == before[on_centre, 1]).all()
    rows = dict(part("features.fitting.fitting").rows(report))
    assert rows["Points"] == str(report.counted)
    bpy.context.scene.cursor.location = (0.0, 0.0, 0.0)
    assert bpy.ops.hull.show_fit_worst() == {"FINISHED"}
    np.testing.assert_allclose(bpy.context.scene.cursor.location, report.place, atol=1e-4)
    shake(hull, 0.01)
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert part("features.fitting.fitting").last_report(hull) == (report, False)
    with pytest.raises(RuntimeError, match="press Fit"):
        bpy.ops.hull.show_fit_worst()


def test_the_target_counts_where_it_stands():
    hull = sample("barge")
    surface = wanted(hull)
    target = shape_of(surface)
    hull.location = (3.0, 4.0, 5.0)
    target.location = (3.0, 4.0, 5.5)
    target.data.flip_normals()  # which side of the faces is out does not matter
    hull.hull.fit.target = target
    bpy.context.view_layer.update()
    low = points_of(hull)[:, 2].min()
    assert bpy.ops.hull.fit() == {"FINISHED"}
    assert points_of(hull)[:, 2].min() == pytest.approx(low + 0.5, abs=0.05)


def test_locked_points_stay():
    hull = sample("barge")
    hull.hull.fit.target = shape_of(wanted(hull))
    shake(hull, 0.1)
    attribute = hull.data.attributes.new(
        part("features.constraints.point_locks").ATTRIBUTE, "INT", "POINT"
    )
    locked = [3, 7, 11]
    for index in locked:
        attribute.data[index].value = 1
    before = points_of(hull)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    moved = np.abs(points_of(hull) - before).max(axis=1)
    assert (moved[locked] == 0.0).all() and moved.max() > 0.05


@pytest.mark.parametrize("stay_square", [True, False])
def test_a_smooth_centre_line_stays_smooth_on_demand(stay_square):
    hull = sample("container_ship")
    surface = wanted(hull)
    points = surface.tessellate(6).points.copy()
    points[:, 2] -= 0.1 * np.maximum(0.0, 1.0 - points[:, 1] / 4.0)  # a V
    mesh = bpy.data.meshes.new("scan")
    mesh.from_pydata(points.tolist(), [], [])
    target = bpy.data.objects.new("scan", mesh)
    bpy.context.scene.collection.objects.link(target)
    hull.hull.fit.target, hull.hull.fit.stay_square = target, stay_square
    hull.hull.fit.fairness = hull.hull.fit.stiffness = 1e-6
    was_square = np.abs(centre_normals(surface)[:, 1]) < 1e-6
    assert bpy.ops.hull.fit() == {"FINISHED"}
    normals = centre_normals(state_of(hull).ship.surface)
    lean = np.abs(normals[was_square, 1]).max()
    assert lean < 1e-5 if stay_square else lean > 1e-2


def test_points_alone_are_a_target():
    hull = sample("barge")
    surface = wanted(hull)
    places = surface.evaluate_grid(3, 0)[0].reshape(-1, 3)
    mesh = bpy.data.meshes.new("cloud")
    mesh.from_pydata(places.tolist(), [], [])
    cloud = bpy.data.objects.new("cloud", mesh)
    bpy.context.collection.objects.link(cloud)
    hull.hull.fit.target = cloud
    hull.hull.fit.fairness = 0.0
    shake(hull, 0.02)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    assert part("features.fitting.fitting").last_report(hull)[0].rms < 0.004


def test_creases_go_along_lines():
    hull = add_hull()
    box = [(x, y, z) for x in (0.0, 10.0) for y in (0.0, 2.0) for z in (0.0, 3.0)]
    ends = [(2, 6), (3, 7)]  # bilge and deck edge
    mesh = bpy.data.meshes.new("lines")
    mesh.from_pydata([(x, y + 0.2, z) for x, y, z in box], ends, [])
    edges = bpy.data.objects.new("lines", mesh)
    bpy.context.collection.objects.link(edges)
    hull.hull.fit.lines = edges
    hull.hull.fit.target = shape_of(wanted(hull), both=False)
    hull.hull.fit.use_edges = False
    before = part("features.fitting.fitting").last_report(hull)
    assert before == (None, False)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report = part("features.fitting.fitting").last_report(hull)[0]
    assert 0.0 < report.line_rms < 0.19


def stl_of(points, triangles):
    corners = np.asarray(points, dtype="<f4")[np.asarray(triangles)]
    records = b"".join(bytes(12) + part.tobytes() + bytes(2) for part in corners)
    return bytes(80) + struct.pack("<I", len(corners)) + records


def test_a_hull_is_fitted_to_an_stl_file(tmp_path):
    hull = sample("barge")
    grid = wanted(hull).tessellate(6)
    quads = np.array(grid.quads)
    triangles = np.concatenate([quads[:, :3], quads[:, [0, 2, 3]]])
    path = tmp_path / "barge.stl"
    path.write_bytes(stl_of(np.array(grid.points) * 1000.0, triangles))
    assert bpy.ops.hull.load_stl(filepath=str(path), metres=0.001) == {"FINISHED"}
    assert bpy.context.view_layer.objects.active == hull
    target = hull.hull.fit.target
    assert target.name == "barge" and len(target.data.polygons) > 0.9 * len(triangles)
    shake(hull, 0.05)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    assert part("features.fitting.fitting").last_report(hull)[0].rms < 0.02
    (tmp_path / "broken.stl").write_bytes(path.read_bytes()[:-7])
    with pytest.raises(RuntimeError, match="broken.stl"):
        bpy.ops.hull.load_stl(filepath=str(tmp_path / "broken.stl"))


def test_what_is_missing_is_said():
    hull = add_hull()
    with pytest.raises(RuntimeError, match="Choose what the hull is fitted to"):
        bpy.ops.hull.fit()
    far = shape_of(wanted(hull))
    far.location.x = 1e4
    hull.hull.fit.target = far
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="No target counts"):
        bpy.ops.hull.fit()
    far.data.clear_geometry()
    with pytest.raises(RuntimeError, match="no points"):
        bpy.ops.hull.fit()


@pytest.mark.parametrize("setting", ("target", "lines"))
def test_what_has_no_shape_and_no_place_is_told_by_name(setting):
    hull = add_hull()
    hull.hull.fit.target = shape_of(wanted(hull), "whole")
    odd = shape_of(wanted(hull), "odd")
    setattr(hull.hull.fit, setting, odd)
    odd.data.vertices[3].co.x = float("nan")
    before = points_of(hull)
    with pytest.raises(RuntimeError, match='"odd" has points without a place: delete them'):
        bpy.ops.hull.fit()
    # By a script: the field lets choose meshes and curves alone.
    setattr(hull.hull.fit, setting, bpy.data.objects.new("empty", None))
    with pytest.raises(RuntimeError, match='^Error: "empty" has no shape: choose a mesh'):
        bpy.ops.hull.fit()
    assert (points_of(hull) == before).all()


@pytest.mark.parametrize("setting", ("target", "lines"))
def test_what_was_deleted_is_not_fitted_to(setting):
    hull = add_hull()
    hull.hull.fit.target = shape_of(wanted(hull))
    gone = shape_of(wanted(hull), "gone")
    setattr(hull.hull.fit, setting, gone)
    make_active(gone)
    bpy.ops.object.delete()
    make_active(hull)
    assert getattr(hull.hull.fit, setting) == gone  # as Blender has it
    with pytest.raises(RuntimeError, match='"gone" is in no scene any longer'):
        bpy.ops.hull.fit()


@pytest.mark.parametrize("setting", ("target", "lines"))
def test_edges_far_too_long_for_a_hull_are_refused(setting):
    hull = add_hull()
    hull.hull.fit.target = shape_of(wanted(hull))
    mesh = bpy.data.meshes.new("stray")
    mesh.from_pydata([(0, 0, 0), (1e12, 0, 0), (0, 1, 0)], [(0, 2), (0, 1)], [])
    stray = bpy.data.objects.new("stray", mesh)
    bpy.context.collection.objects.link(stray)
    setattr(hull.hull.fit, setting, stray)
    with pytest.raises(RuntimeError, match='edges of "stray" are .* times as long as the hull'):
        bpy.ops.hull.fit()


def test_a_target_that_is_hidden_counts_with_its_modifiers_or_is_refused():
    hull = add_hull()
    target = hull.hull.fit.target = shape_of(wanted(hull), both=False)
    shift = target.modifiers.new("shift", "DISPLACE")
    shift.direction, shift.mid_level, shift.strength = "Z", 0.0, 0.2
    low = points_of(hull)[:, 2].min()
    target.hide_viewport = True
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match='modifiers of "shape" do not count.*show it'):
        bpy.ops.hull.fit()
    assert points_of(hull)[:, 2].min() == low
    target.hide_viewport = False
    target.hide_set(True)  # by its eye
    bpy.context.view_layer.update()
    assert bpy.ops.hull.fit() == {"FINISHED"}
    assert points_of(hull)[:, 2].min() == pytest.approx(low + 0.2, abs=0.02)
    target.hide_viewport, shift.show_viewport = True, False
    bpy.context.view_layer.update()
    assert bpy.ops.hull.fit() == {"FINISHED"}
    assert points_of(hull)[:, 2].min() == pytest.approx(low, abs=0.02)


def test_it_is_cancelled_or_given_up_when_the_hull_changes():
    hull = sample("barge")
    hull.hull.fit.target = shape_of(wanted(hull))
    before = points_of(hull)
    fitting, jobs = part("features.fitting.fitting"), part("bridge.background.jobs")
    task = fitting.Fitting(hull, bpy.context.scene)
    task.cancel()
    with pytest.raises(jobs.Cancelled):
        task.write(bpy.context.scene)
    assert (points_of(hull) == before).all()
    task = fitting.Fitting(hull, bpy.context.scene)
    with pytest.raises(ValueError, match="under way"):
        part("features.conversion.conversions").begin(hull, bpy.context.scene)
    shake(hull, 0.01)
    changed = points_of(hull)
    with pytest.raises(ValueError, match="changed meanwhile"):
        task.write(bpy.context.scene)
    assert (points_of(hull) == changed).all()
    other = add_hull("other")
    make_active(other)
    assert fitting.last_report(other) == (None, False)


@pytest.mark.parametrize("setting, value", (("scheme", "catmull_clark"), ("half", False)))
def test_it_is_given_up_when_the_surface_is_another_by_a_setting(setting, value):
    hull = sample("barge")
    hull.hull.fit.target = shape_of(wanted(hull))
    before = points_of(hull)
    fitting = part("features.fitting.fitting")
    task = fitting.Fitting(hull, bpy.context.scene)
    setattr(hull.hull, setting, value)
    with pytest.raises(ValueError, match="changed meanwhile, and stays as it is: fit it again"):
        task.write(bpy.context.scene)
    assert (points_of(hull) == before).all()
    assert fitting.last_report(hull) == (None, False)


def test_it_is_given_up_when_the_scale_of_the_scene_is_another():
    """Or distances in other metres than the hull's were told."""
    hull = add_hull()
    hull.hull.fit.target = shape_of(wanted(hull))
    task = part("features.fitting.fitting").Fitting(hull, bpy.context.scene)
    bpy.context.scene.unit_settings.scale_length = 0.5
    with pytest.raises(ValueError, match="changed meanwhile, and stays as it is: fit it again"):
        task.write(bpy.context.scene)


def box_target(deck_too):
    """Port side and bottom of a box of 10 x 4.2 x 3 m, and a house on it."""
    points = [(x, y, z) for x in (0.0, 10.0) for y in (0.0, 2.1) for z in (0.0, 3.0)]
    faces = [(2, 3, 7, 6), (0, 2, 6, 4), (0, 1, 3, 2), (4, 6, 7, 5)]
    if deck_too:
        points += [(x, y, z) for x in (2.0, 8.0) for y in (0.0, 2.0) for z in (9.0, 19.0)]
        faces += [(10, 11, 15, 14), (8, 9, 11, 10), (12, 14, 15, 13)]
    mesh = bpy.data.meshes.new("target")
    mesh.from_pydata(points, [], faces)
    obj = bpy.data.objects.new("target", mesh)
    bpy.context.collection.objects.link(obj)
    return obj


def test_a_target_that_is_mostly_left_out_is_warned_of():
    hull = add_hull()
    hull.hull.fit.target = box_target(True)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    fitting = part("features.fitting.fitting")
    report, _ = fitting.last_report(hull)
    assert report.left_out > report.counted / 2 and report.is_mostly_beside
    assert "was left out" in fitting.warning(report) and "was left out" in fitting.summary(report)
    # A third is the most that may be: just that much is no warning yet.
    third = dataclasses.replace(report, counted=200, left_out=100)
    assert not fitting.warning(third) and "was left out" not in fitting.summary(third)
    above = dataclasses.replace(third, left_out=101)
    assert fitting.warning(above).startswith("34 % of the target was left out")
    assert fitting.summary(above).startswith(fitting.warning(above))
    # The house stands up to 16 m above the box's upper edge.
    assert report.target_largest == pytest.approx(16.0, abs=0.2)
    assert report.target_rms > 3.0 > report.rms


def test_a_target_all_of_which_counts_is_not_warned_of():
    hull = add_hull()
    hull.hull.fit.target = box_target(False)
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = part("features.fitting.fitting").last_report(hull)
    assert not part("features.fitting.fitting").warning(report)
    assert report.target_largest == pytest.approx(report.largest, abs=1e-4)


def test_borders_that_run_out_beyond_the_target_are_told_of():
    """No line of the target says where the sheer is, and a side that goes on is as near to it."""
    hull = add_hull()
    target, settings = shape_of(wanted(hull), n=8, both=False), hull.hull.fit
    points = points_of(hull)
    is_on_centre = points[:, 1] == 0.0
    points += np.random.default_rng(0).uniform(-0.05, 0.05, points.shape)
    points[is_on_centre, 1] = 0.0
    part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(points)), points)
    bpy.context.view_layer.update()
    settings.target, settings.draw_border, settings.use_edges = target, True, False
    before = points_of(hull)
    fitting = part("features.fitting.fitting")
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = fitting.last_report(hull)
    assert report.run_out > 1.0 and report.run_out == pytest.approx(
        hull.dimensions.z - 3.0, rel=0.1
    )
    assert "Creases to edges" in fitting.warning(report)
    assert fitting.warning(report) in fitting.summary(report)
    part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(before)), before)
    bpy.context.view_layer.update()
    settings.use_edges = True
    assert bpy.ops.hull.fit() == {"FINISHED"}
    report, _ = fitting.last_report(hull)
    assert report.run_out < 0.1 and fitting.warning(report) == ""
    assert hull.dimensions.z == pytest.approx(3.0, abs=1e-3)
