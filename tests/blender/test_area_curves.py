# SPDX-License-Identifier: GPL-3.0-or-later
"""Sectional area curves that are wanted: where they come from, and hulls brought to them."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, compute, make_active, part, sample, state_of
from test_panels import texts, value_after

# Points and handles are kept in single precision.
SINGLE = 3e-6


def points_of(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def areas_at(hull, places):
    area = part("features.transformation.inflating").section_area
    return np.array([area(hull, bpy.context.scene, x) for x in places])


def live(hull):
    bpy.context.view_layer.update()
    return part("features.area_curves.live_target").known(hull)


def volume(hull):
    return state_of(hull).hydrostatics.values.displaced_volume


def test_the_present_curve_is_met_as_it_is():
    hull = sample()
    before = points_of(hull)
    assert bpy.ops.hull.take_area_curve(handles=9) == {"FINISHED"}
    found = live(hull)
    assert len(hull.hull.area_target.area_points) == 9 and hull.hull.plots.sectional_areas
    # By sums over stations, here and there.
    assert found.volume == pytest.approx(volume(hull), rel=1e-4)
    places = np.linspace(5.0, 80.0, 7)
    assert found.curve.at(places) == pytest.approx(areas_at(hull, places), rel=2e-4)
    bpy.ops.hull.transform_to_area_curve()
    assert np.array_equal(points_of(hull), before)


@pytest.mark.parametrize("by, tolerance", [("LEAST", 2.1e-3), ("INFLATE", 1e-2)])
def test_a_hull_is_brought_to_its_target(by, tolerance):
    hull = sample()
    before = points_of(hull)
    bpy.ops.hull.take_area_curve()
    points = hull.hull.area_target.area_points
    points[8].area *= 1.05
    points[2].area *= 0.98
    curve = live(hull).curve
    # 21 stations, a hundredth of the length from the ends on.
    first, last = np.array(curve.ends) + 0.01 * np.ptp(curve.ends) * np.array([1.0, -1.0])
    places = np.linspace(first, last, 21)[1:-1]
    assert np.abs(areas_at(hull, places) - curve.at(places)).max() > 0.03 * curve.areas.max()
    assert bpy.ops.hull.transform_to_area_curve(by=by) == {"FINISHED"}
    lacks = areas_at(hull, places) - curve.at(places)
    assert np.abs(lacks).max() < tolerance * curve.areas.max()
    moves = points_of(hull) - before
    on_centre = before[:, 1] == 0.0
    assert np.array_equal(moves[on_centre, 1], np.zeros(on_centre.sum()))
    if by == "LEAST":  # profile and greatest beam stay
        assert not moves[on_centre].any()
        assert not moves[before[:, 1] == before[:, 1].max(), 1].any()


def test_half_the_way():
    hull = sample()
    bpy.ops.hull.take_area_curve()
    hull.hull.area_target.area_points[8].area *= 1.05
    x = hull.hull.area_target.area_points[8].x
    (present,) = areas_at(hull, [x])
    wanted = live(hull).curve.at([x])[0]
    bpy.ops.hull.transform_to_area_curve(way=50.0, tolerance=0.02)
    (half,) = areas_at(hull, [x])
    # Between stations of the 21.
    assert (half - present) / (wanted - present) == pytest.approx(0.5, abs=0.05)


def test_one_that_folds_is_refused_with_what_can_be_had():
    hull = sample()
    bpy.ops.hull.take_area_curve()
    hull.hull.area_target.area_points[6].area *= 1.3
    before = points_of(hull)
    with pytest.raises(RuntimeError, match="of the way can be gone so"):
        bpy.ops.hull.transform_to_area_curve(by="SHIFT")
    assert np.array_equal(points_of(hull), before)


def test_the_curve_of_another_hull_is_scaled():
    other, hull = sample("research_vessel"), sample()
    bpy.ops.hull.take_other_area_curve(other=other.name)
    target = live(hull)
    assert target.volume == pytest.approx(volume(hull), rel=SINGLE)
    ratio = hull.hull.length_pp / other.hull.length_pp
    settings = hull.hull.area_target
    assert settings.area_points[0].x == pytest.approx(-4.0 * ratio, rel=1e-4)
    bpy.ops.hull.take_other_area_curve(other=other.name, areas_as="LARGEST")
    (largest,) = areas_at(hull, [42.0])
    assert live(hull).curve.base_areas.max() == pytest.approx(largest, rel=1e-4)
    bpy.ops.hull.take_other_area_curve(other=other.name, areas_as="SAME", to_length=False)
    places = np.linspace(5.0, 95.0, 5)
    assert live(hull).curve.at(places) == pytest.approx(areas_at(other, places), rel=1e-3)
    for name in ("", "nobody", hull.name):
        with pytest.raises(RuntimeError, match="Choose another hull"):
            bpy.ops.hull.take_other_area_curve(other=name)


def test_tables_are_read_and_scaled(tmp_path):
    hull = sample()
    path = tmp_path / "areas.csv"
    path.write_text("x;area\n-2,5;0\n10;40\n30;70\n60;70\n84;0\n")
    assert bpy.ops.hull.load_area_curve(filepath=str(path), handles=5) == {"FINISHED"}
    curve = live(hull).curve
    assert curve.at([10.0, 45.0, -2.6, 84.1]).tolist() == pytest.approx([40.0, 70.0, 0.0, 0.0])
    bpy.ops.hull.scale_area_curve()
    assert live(hull).volume == pytest.approx(volume(hull), rel=SINGLE)
    bpy.ops.hull.scale_area_curve(volume=4000.0)
    assert live(hull).volume == pytest.approx(4000.0, rel=SINGLE)
    path.write_text("0;1\n1;x\n2;1\n")
    with pytest.raises(RuntimeError, match="areas.csv: line 2"):
        bpy.ops.hull.load_area_curve(filepath=str(path))
    assert live(hull).volume == pytest.approx(4000.0, rel=SINGLE)
    bpy.ops.hull.clear_area_curve()
    assert live(hull).curve is None


def test_the_panel_measures_the_curve_by_the_hull_without_its_appendages():
    hull = sample()
    bpy.ops.hull.add_appendage(kind="TUNNEL", x=70.0, z=2.0, radius=1.0)
    make_active(hull)
    bpy.ops.hull.take_area_curve()
    bpy.context.view_layer.update()
    compute([(hull.name, "sectional_areas")])
    noted = texts()["HULL_PT_area_curve"]
    assert float(value_after(noted, "∇").split()[0]) == pytest.approx(0.0, abs=0.02)
    assert float(value_after(noted, "LCB").split()[0]) == pytest.approx(0.0, abs=0.01)


def test_a_handle_stays_between_neighbours_that_leave_it_no_room():
    hull = sample()
    bpy.ops.hull.drag_area_curve(points="0 0; 40 70; 40.05 71; 40.1 70; 80 0")
    drag = part("features.area_curves.handles").Drag(hull, bpy.context.scene)
    for x in (0.0, 40.0, 80.0):
        drag.move(2, (x, 60.0))
        assert 40.0 < hull.hull.area_target.area_points[2].x < 40.1
        assert live(hull).status == ""


def test_the_volume_of_a_hull_that_heels_is_not_taken():
    hull = sample()
    bpy.ops.hull.take_area_curve()
    before = live(hull).volume
    hull.hull.heel = 0.6
    with pytest.raises(RuntimeError, match="set the heel to zero"):
        bpy.ops.hull.scale_area_curve()
    assert live(hull).volume == before
    bpy.ops.hull.scale_area_curve(volume=4000.0)
    assert live(hull).volume == pytest.approx(4000.0, rel=SINGLE)


def test_a_table_of_a_ship_at_one_end_is_read(tmp_path):
    hull = sample()
    path = tmp_path / "areas.csv"
    path.write_text("x,area\n0,0\n20,50\n40,0\n60,0\n80,0\n")
    assert bpy.ops.hull.load_area_curve(filepath=str(path), handles=9) == {"FINISHED"}
    assert live(hull).curve.at([20.0, 60.0]).tolist() == pytest.approx([50.0, 0.0])
    with pytest.raises(RuntimeError, match="no area at any of 3 handles: take more"):
        bpy.ops.hull.load_area_curve(filepath=str(path), handles=3)


def test_our_own_table_is_read(tmp_path):
    hull = sample()
    path = str(tmp_path / "areas.csv")
    bpy.ops.hull.export_table(filepath=path, analysis="sectional_areas")
    bpy.ops.hull.load_area_curve(filepath=path)
    assert live(hull).volume == pytest.approx(volume(hull), rel=1e-4)


def test_the_target_is_in_the_plot_and_its_axes_hold_it():
    hull = sample()
    bpy.ops.hull.take_area_curve(handles=5)
    hull.hull.area_target.area_points[2].area = 100.0
    bpy.context.view_layer.update()
    analyses, areas = part("features.analyses"), part("features.curves_of_form.sectional_areas")
    result = analyses.result_of(hull, bpy.context.scene, "sectional_areas")
    others = analyses.others_beside(state_of(hull), "sectional_areas")
    assert [curve.name for curve in others] == ["Target"]
    (left, right), (low, high) = areas.frame(result, others)
    assert low == 0.0 and high > 100.0 and left < -2.5 and right > 84.0
    plot = analyses.plot_of("sectional_areas", result, "hull", others)
    assert plot.curve_names == ["Sectional area", "Target"]
    found = live(hull).difference(result.areas)
    x = hull.hull.area_target.area_points[2].x
    assert found.at == pytest.approx(x, abs=1.0)
    assert found.largest == pytest.approx(areas_at(hull, [x])[0] / 100.0 - 1.0, abs=5e-3)
    hull.hull.area_target.show_target = False
    bpy.context.view_layer.update()
    assert analyses.others_beside(state_of(hull), "sectional_areas") == ()


def test_points_come_and_go():
    hull = sample()
    bpy.ops.hull.take_area_curve(handles=4)
    before = live(hull).curve
    places = np.linspace(*before.ends, 50)
    bpy.ops.hull.add_area_point()
    points = hull.hull.area_target.area_points
    assert len(points) == 5 and hull.hull.area_target.active_area_point == 1
    assert live(hull).curve.at(places) == pytest.approx(before.at(places), abs=1e-3)
    points[1].area += 5.0
    bpy.ops.hull.remove_area_point()
    assert live(hull).curve.at(places) == pytest.approx(before.at(places), abs=1e-3)
    hull.hull.area_target.active_area_point = 0
    with pytest.raises(RuntimeError, match="ends stay"):
        bpy.ops.hull.remove_area_point()
    points[1].x = points[2].x
    assert "Point 3" in live(hull).status and live(hull).curve is None
    with pytest.raises(RuntimeError, match="have the points in order"):
        bpy.ops.hull.transform_to_area_curve()


def test_a_hull_that_is_scaled_scales_its_target():
    hull = sample()
    bpy.ops.hull.drag_area_curve(points="0 0; 40 60; 80 10")
    bpy.ops.hull.set_dimensions(length=1.1 * 84.0, beam=1.2 * hull.hull.beam)
    points = hull.hull.area_target.area_points
    assert [point.x for point in points] == pytest.approx([0.0, 44.0, 88.0], rel=SINGLE)
    assert [point.area for point in points] == pytest.approx([0.0, 72.0, 12.0], rel=SINGLE)


def test_a_target_is_measured_by_the_scenes_unit():
    hull = sample()
    bpy.ops.hull.take_area_curve()
    before = live(hull).curve
    bpy.context.scene.unit_settings.scale_length = 0.5
    after = live(hull).curve
    assert after.ends == pytest.approx([0.5 * end for end in before.ends])
    assert live(hull).volume == pytest.approx(0.5 * before.volume()[0])


def test_nonsense_is_refused():
    hull = add_hull()
    hull.hull.length_pp, hull.hull.beam, hull.hull.draft = 10.0, 4.0, 1.0
    for points in ("", "1 2; 3", "0 0; 1 x; 2 0", "0 0; 1 1"):
        with pytest.raises(RuntimeError, match="Points"):
            bpy.ops.hull.drag_area_curve(points=points)
    for points in ("0 0; 2 1; 1 0", "0 0; nan 1; 2 0", "0 0; 1 inf; 2 0"):
        with pytest.raises(RuntimeError, match="in order|is no number|Points"):
            bpy.ops.hull.drag_area_curve(points=points)
    assert not hull.hull.area_target.area_points
    for name in ("transform_to_area_curve", "scale_area_curve", "clear_area_curve"):
        with pytest.raises(RuntimeError):
            getattr(bpy.ops.hull, name)()
    hull.hull.draft = -1.0
    with pytest.raises(RuntimeError, match="Error: "):
        bpy.ops.hull.take_area_curve()
    hull.hull.draft = 1.0
    bpy.ops.hull.take_area_curve(handles=3)
    before = points_of(hull)
    for x, area in ((5.0, 1e30), (float("nan"), 1.0), (1e30, 1.0)):
        bpy.ops.hull.take_area_curve(handles=3)
        point = hull.hull.area_target.area_points[1]
        point.x, point.area = x, area
        bpy.context.view_layer.update()
        with pytest.raises(RuntimeError, match="Error: "):
            bpy.ops.hull.transform_to_area_curve()
    bpy.ops.hull.take_area_curve(handles=3)
    hull.hull.heel = 0.1
    with pytest.raises(RuntimeError, match="set the heel to zero"):
        bpy.ops.hull.transform_to_area_curve()
    assert np.array_equal(points_of(hull), before)


def test_one_undo_step_in_edit_mode_too():
    hull = sample()
    bpy.ops.hull.take_area_curve()
    hull.hull.area_target.area_points[8].area *= 1.04
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.ed.undo_push(message="taken")
    before = points_of(hull)
    bpy.ops.hull.transform_to_area_curve()
    bpy.ops.ed.undo_push(message="transformed")
    assert np.abs(points_of(hull) - before).max() > 0.01
    bpy.ops.ed.undo()
    assert np.array_equal(points_of(bpy.context.view_layer.objects.active), before)


def test_a_curve_that_is_not_taken_shows_no_plot():
    hull = add_hull()
    hull.hull.plots.sectional_areas = False
    with pytest.raises(RuntimeError):
        bpy.ops.hull.load_area_curve(filepath="/no/such/table.csv")
    assert not hull.hull.plots.sectional_areas
