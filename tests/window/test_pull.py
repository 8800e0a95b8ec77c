# SPDX-License-Identifier: GPL-3.0-or-later
"""Pulling the surface with the mouse: it is where it was dragged to, Esc and Ctrl-Z take
it back."""

import bpy
import numpy as np
from addon_under_test import part, state_of
from bpy_extras.view3d_utils import location_3d_to_region_2d
from editing import editing_a_hull, hull_at_hand
from expect import are_equal, assert_follows, edited_points, snapshot
from mathutils import Vector
from window import FROM_AHEAD, FROM_PORT


def begin(window, *kinds, angles=FROM_PORT):
    """A hull in edit mode that shows these lines, and the Grip of a point of its side amidships."""
    hull = editing_a_hull(window)
    for kind, switch in part("features.lines.lines").SWITCHES.items():
        setattr(hull.hull.lines, switch, kind in kinds)
    window.look(hull, angles)
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    bpy.ops.ed.undo_push(message="shown")
    pull = part("features.modelling.pulling").SurfacePull(hull, bpy.context.scene)
    return hull, pull.nearest((0.55 * max(hull.dimensions), 50.0, 2.5))


def surface_point(hull, grip):
    """Where the place is on the surface that the add-on shows, in m."""
    return state_of(hull).ship.surface.positions([grip.cell], grip.uv[None])[0]


def start_pulling(window):
    window.search("Pull Surface")


def held(hull):
    pulled = part("features.modelling.pull_lines").shown(bpy.context.view_layer)
    if pulled is None:
        return None
    assert pulled[0] == hull
    return pulled[1]


def test_a_drag_pulls_the_surface_and_all_follows(window):
    hull, grip = begin(window, "feature")
    before = snapshot(hull)
    yield
    start_pulling(window)
    yield
    window.move_to_point(hull, Vector(grip.point))
    yield
    mark = held(hull)
    assert np.linalg.norm(np.array(mark.now) - grip.point) < 0.5
    window.hold("LEFTMOUSE")
    for _ in range(3):
        last = snapshot(hull)
        window.move_by(3, 8)
        yield
        assert not are_equal(snapshot(hull), last)
        assert_follows(hull)
    window.let_go("LEFTMOUSE")
    yield
    assert held(hull) is None
    after = snapshot(hull)
    assert not are_equal(after, before)
    assert_follows(hull)
    window.undo()
    yield
    hull = hull_at_hand()
    assert hull.mode == "EDIT" and are_equal(snapshot(hull), before)
    window.redo()
    yield
    hull = hull_at_hand()
    assert are_equal(snapshot(hull), after)
    assert_follows(hull)


def pull_away(window, hull, grip):
    """Pulls, and does not let go; the snapshot of before. To be used by `yield from`."""
    before = snapshot(hull)
    yield
    start_pulling(window)
    window.move_to_point(hull, Vector(grip.point))
    yield
    window.hold("LEFTMOUSE")
    window.move_by(40, 40)
    yield
    assert not are_equal(snapshot(hull), before)
    return before


def test_escape_leaves_all_as_it_was(window):
    hull, grip = begin(window, "feature")
    before = yield from pull_away(window, hull, grip)
    window.press("ESC")
    window.let_go("LEFTMOUSE")
    yield
    assert np.array_equal(edited_points(hull), before["points"])
    assert are_equal(snapshot(hull), before)
    assert held(hull) is None
    assert_follows(hull)


def test_a_typed_coordinate_is_exact(window):
    hull, grip = begin(window)
    yield
    start_pulling(window)
    window.move_to_point(hull, Vector(grip.point))
    yield
    grip = (
        part("features.modelling.pulling")
        .SurfacePull(hull, bpy.context.scene)
        .nearest(held(hull).now)
    )
    window.click()
    window.press("Y")
    window.write("6.125")
    yield
    window.press("RET")
    yield
    wanted = [grip.point[0], 6.125, grip.point[2]]
    assert np.linalg.norm(surface_point(hull, grip) - wanted) < 1e-5
    assert_follows(hull)


def test_a_section_line_is_pulled_in_its_plane(window):
    hull, _ = begin(window, "station", angles=FROM_AHEAD)
    yield
    section = state_of(hull).lines.groups["station"].sections[10]
    curve = max(section.curves, key=lambda one: len(one.points))
    point = curve.points[len(curve.points) // 2]
    hull.show_in_front = False
    start_pulling(window)
    window.move_to_point(hull, Vector(point))
    yield
    start = np.array(held(hull).now)
    window.hold("LEFTMOUSE")
    window.move_by(25, -20)
    yield
    now = np.array(held(hull).now)
    assert np.linalg.norm(now - start) > 0.05
    planes = [one.cut.plane for one in state_of(hull).lines.groups["station"].sections]
    assert min(abs(now[0] - plane[3]) for plane in planes) < 1e-5
    window.press("L")
    window.let_go("LEFTMOUSE")
    yield
    assert_follows(hull)


def test_in_object_mode_and_with_ctrl_on_the_surface(window):
    hull, grip = begin(window, "station", "waterline", "feature")
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.ed.undo_push(message="object mode")
    before = snapshot(hull)
    yield
    start_pulling(window)
    window.hold("LEFT_CTRL")
    window.move_to_point(hull, Vector(grip.point))
    yield
    window.press("LEFTMOUSE", ctrl=True)  # held by a click
    window.let_go("LEFT_CTRL")
    window.press("N")
    window.write("0.5")
    yield
    moved = np.array(held(hull).now) - held(hull).start
    assert abs(np.linalg.norm(moved) - 0.5) < 1e-5
    window.press("RET")
    yield
    assert hull.mode == "OBJECT" and not are_equal(snapshot(hull), before)
    assert_follows(hull)
    window.undo()
    yield
    assert are_equal(snapshot(hull_at_hand()), before)


def test_each_view_of_four_is_pulled_in(window):
    """In a quad view the mouse is in one of four pictures."""
    hull, _ = begin(window, "feature")
    pull = part("features.modelling.pulling").SurfacePull(hull, bpy.context.scene)
    # At the bow, where it is in no picture on the outline.
    grip = pull.nearest((0.9 * max(hull.dimensions), 50.0, 4.0))
    with window.in_view():
        bpy.ops.screen.region_quadview()
    yield
    views = [region for region in window.area.regions if region.type == "WINDOW"]
    four = window.space.region_quadviews
    assert len(views) == len(four) == 4
    seen = 0
    for region, view in zip(views, four):
        dots = location_3d_to_region_2d(region, view, hull.matrix_world @ Vector(grip.point))
        if not (0 < dots.x < region.width and 0 < dots.y < region.height):
            continue
        before = snapshot(hull)
        start_pulling(window)
        window.move_to(region.x + dots.x, region.y + dots.y)
        yield
        start = held(hull).now
        again = location_3d_to_region_2d(region, view, hull.matrix_world @ Vector(start))
        assert (again - dots).length < 2.0
        window.hold("LEFTMOUSE")
        window.move_by(8, 8)
        yield
        now = location_3d_to_region_2d(region, view, hull.matrix_world @ Vector(held(hull).now))
        assert (now - again - Vector((8.0, 8.0))).length < 2.0
        window.press("ESC")
        window.let_go("LEFTMOUSE")
        yield
        assert are_equal(snapshot(hull), before)
        seen += 1
    with window.in_view():
        bpy.ops.screen.region_quadview()
    assert seen >= 3


def test_what_ends_the_pull_leaves_all_as_it_was(window):
    """Blender ends it itself where another file is loaded, or the window is closed."""
    ended = []
    operator_class = part("operators.pull").HULL_OT_pull_surface
    take_back = operator_class.take_back

    def noted(operator, context):
        take_back(operator, context)
        ended.append((operator._pull.obj.name, edited_points(operator._pull.obj)))

    hull, grip = begin(window, "feature")
    name = hull.name
    operator_class.take_back = noted
    before = yield from pull_away(window, hull, grip)
    bpy.ops.wm.read_homefile()
    yield
    operator_class.take_back = take_back
    assert [one for one, _ in ended] == [name]
    assert np.array_equal(ended[0][1], before["points"])
    window.let_go("LEFTMOUSE")
    yield


def turn(window, key, times):
    """Turns the wheel, or presses a page key, step by step."""
    for _ in range(times):
        window.hold(key)
    if key.startswith("PAGE"):
        window.let_go(key)


def test_the_wheel_and_page_keys_change_the_radius(window):
    hull, grip = begin(window, "feature")
    before = edited_points(hull)
    yield
    start_pulling(window)
    window.move_to_point(hull, Vector(grip.point))
    yield
    pull = part("features.modelling.pulling").SurfacePull(hull, bpy.context.scene)
    least = pull.smallest_radius(pull.nearest(held(hull).now))
    window.click()
    window.move_by(6, 12)
    yield
    target = held(hull).now
    assert held(hull).radius == 0.0 and "Radius" not in held(hull).text
    narrow = edited_points(hull)
    steps, counts = 0, [moved(before, narrow)]
    for key, times in (("WHEELDOWNMOUSE", 1), ("WHEELDOWNMOUSE", 6), ("PAGE_UP", 1)):
        turn(window, key, times)
        yield
        steps += times
        assert abs(held(hull).radius / (least * 1.1 ** (steps - 1)) - 1.0) < 1e-4
        assert f"Radius {held(hull).radius:.3f} m" in held(hull).text
        assert held(hull).now == target
        counts.append(moved(before, edited_points(hull)))
        assert_follows(hull)
    assert counts[0] <= counts[1] < counts[2] <= counts[3]
    for key, times in (("WHEELUPMOUSE", 2), ("PAGE_DOWN", 1), ("WHEELUPMOUSE", 4)):
        turn(window, key, times)
        yield
        steps -= times
        assert abs(held(hull).radius / (least * 1.1 ** (steps - 1)) - 1.0) < 1e-3
    # Below the least one there is none, and none less.
    for key in ("WHEELUPMOUSE", "WHEELUPMOUSE", "PAGE_DOWN"):
        turn(window, key, 1)
        yield
        assert held(hull).radius == 0.0 and "Radius" not in held(hull).text
        assert np.allclose(edited_points(hull), narrow, atol=1e-6)
    turn(window, "PAGE_UP", 1)
    yield
    assert abs(held(hull).radius / least - 1.0) < 1e-4
    window.press("ESC")
    yield
    assert np.array_equal(edited_points(hull), before)
    assert held(hull) is None


def moved(before, after):
    """How many points are elsewhere."""
    return int((np.abs(after - before).max(axis=1) > 1e-6).sum())
