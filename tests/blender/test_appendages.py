# SPDX-License-Identifier: GPL-3.0-or-later
"""Appendages in Blender: what they take off and add is what closed forms say, wherever they are."""

import math
import warnings

import bpy
import pytest
from addon_under_test import add_hull, hull_io, make_active, part, sample
from mathutils import Quaternion

RADIUS = 0.4


def add(hull, kind, **values):
    make_active(hull)
    assert bpy.ops.hull.add_appendage(kind=kind, **values) == {"FINISHED"}
    bpy.context.view_layer.update()
    return bpy.context.view_layer.objects.active


def volume(hull):
    bpy.context.view_layer.update()
    return part("features.hull.hull_state").state_of(hull).hydrostatics.values.displaced_volume


def not_joined(hull):
    return part("features.hull.hull_state").state_of(hull).ship.not_joined


@pytest.fixture
def box():
    hull = add_hull()
    hull.hull.draft = 2.5
    return hull


def test_tunnel(box):
    """πr²B less; moved out of the hull it takes nothing off, deleted likewise."""
    whole, hole = volume(box), math.pi * RADIUS**2 * 4.0
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    assert tunnel.parent == box and tunnel.hull.appendage.is_cut
    assert tunnel.hide_render and tunnel.display_type == "WIRE"
    assert volume(box) == pytest.approx(whole - hole, rel=1e-7)
    assert not part("features.hull.hull_state").state_of(box).hydrostatics.values.remark
    tunnel.location.x = 20.0
    assert volume(box) == pytest.approx(whole, rel=1e-7)
    tunnel.location.x = 5.0
    tunnel.hull.appendage.radius = 0.5
    assert volume(box) == pytest.approx(whole - math.pi * 0.5**2 * 4.0, rel=1e-7)
    tunnel.hull.appendage.counts = False
    assert volume(box) == pytest.approx(whole, rel=1e-7)
    tunnel.hull.appendage.counts = True
    assert volume(box) < whole - 3.0
    bpy.data.objects.remove(tunnel)
    assert volume(box) == pytest.approx(whole, rel=1e-7)


@pytest.mark.parametrize(
    "kind", ["FIN_KEEL", "BULB_KEEL", "RUDDER", "SKEG", "SHAFT", "BRACKET", "CYLINDER"]
)
def test_kinds_on_a_sample(kind):
    """Each is placed where it meets the hull, and adds less than its own volume."""
    hull = sample("coaster")
    before = volume(hull)
    first = add(hull, kind)
    native = part("features.flotation.appendages")
    bodies = part("bridge.objects.appendages").read(hull)
    own = sum((1 + b.is_mirrored) * native.native_body(b, 1.0).volume for b in bodies)
    assert not_joined(hull) == ""
    assert 0.0 < volume(hull) - before < own
    assert len(first.data.polygons) > 100 and not first.hide_render
    assert first.hull.appendage.is_mirrored == (kind in ("SHAFT", "BRACKET"))


def test_moved_points_keep_appendages(box):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    before = volume(box)
    for vertex in box.data.vertices:
        vertex.co.y *= 1.05  # the tunnel ends 5 % of the beam outside
    box.data.update()
    box.update_tag()
    assert volume(box) == pytest.approx(1.05 * before, rel=1e-7)


def test_bad_sections_are_told_of(box):
    keel = add(box, "FIN_KEEL")
    with_keel = volume(box)
    keel.hull.appendage.section = "0012x"
    without = volume(box)
    assert "is no section that is known" in not_joined(box) and keel.name in not_joined(box)
    assert without == pytest.approx(100.0) and without < with_keel
    assert len(keel.data.polygons) == 0
    keel.hull.appendage.section = "0012"
    assert volume(box) > 100.01 and not_joined(box) == ""


@pytest.mark.parametrize("section", ["63-412 a=0.8", "64A212", "0012-64", "23112", "65(2)-215"])
def test_sections_of_all_families_count(box, section):
    """A keel of each is joined, and adds something else than another section does."""
    whole = volume(box)
    keel = add(box, "FIN_KEEL", section=section)
    more = volume(box) - whole
    assert not not_joined(box) and more > 0.0
    keel.hull.appendage.section = "0012"
    other = volume(box) - whole
    assert other == pytest.approx(more, rel=0.5) and other != pytest.approx(more, rel=1e-4)


def test_surfaces_in_one_another_are_told_of(box):
    """A keel whose root is in the plane of the bottom; raised into the hull it counts."""
    keel = add(box, "FIN_KEEL")
    keel.location.z = 0.0
    assert volume(box) == pytest.approx(100.0)
    assert "let them cross at an angle, as by an end well within the hull" in not_joined(box)
    keel.location.z = 0.5
    assert volume(box) > 100.01 and not_joined(box) == ""


def test_what_could_not_be_joined_is_where_points_have_moved(box):
    """A keel whose root is in the plane of the bottom, which is lowered and raised."""
    add(box, "FIN_KEEL").location.z = 0.0
    for lowered in (0.0, 0.5, 0.0, 0.25):
        alone = 100.0 * (1.0 + lowered / 2.5)
        for vertex in box.data.vertices:
            vertex.co.z = -lowered if vertex.co.z < 0.1 else vertex.co.z
        box.data.update()
        box.update_tag()
        assert (volume(box) > alone + 0.01) == (lowered > 0.0)
        assert bool(not_joined(box)) == (lowered == 0.0)


def test_a_body_that_is_scaled_unevenly_is_told_of(box):
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    tunnel.scale = (1.0, 1.5, 1.0)
    assert volume(box) == pytest.approx(100.0)
    assert "is scaled unevenly or mirrored: clear its scale (Alt S)" in not_joined(box)
    tunnel.scale = (1.5, 1.5, 1.5)
    assert volume(box) == pytest.approx(100.0 - math.pi * (1.5 * RADIUS) ** 2 * 4.0, rel=1e-7)


def test_wetted_surface_and_heeled_water_have_the_body(box):
    """The wall of the tunnel is wet, its mouths are none; heeled the body is what plain Python
    has."""
    native = part("bridge.native").require()
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    volume(box)
    found = part("features.hull.hull_state").state_of(box).hydrostatics.values
    wet = 40.0 + 28.0 * 2.5 + 2.0 * math.pi * RADIUS * (4.0 - RADIUS)
    assert found.wetted_surface == pytest.approx(wet, rel=1e-7)
    ship = part("features.hull.hull_state").state_of(box).ship.source.new_ship()
    assert ship.body.joined_volume == pytest.approx(-math.pi * RADIUS**2 * 4.0, rel=1e-6)
    assert len(ship.body.surface.mesh.points) == len(box.data.vertices)
    body = native.HullBody(ship.body.surface, mirrored=True)
    body.join([native.cylinder((7, -2.2, 1.2), (7, 2.2, 1.2), RADIUS, cut=True)])
    water = {"draft": 2.5, "heel": 0.3}
    ours, other = (native.hydrostatics(each, **water) for each in (ship.body, body))
    assert ours.displaced_volume == pytest.approx(other.displaced_volume, rel=1e-7)
    assert ours.bm_transverse == pytest.approx(other.bm_transverse, rel=1e-6)
    assert ours.tcb == pytest.approx(other.tcb, rel=1e-6)


def test_hull_files_keep_appendages(box, tmp_path):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    add(box, "BULB_KEEL", x=6.0)
    add(box, "BRACKET", x=3.0, y=0.8).hull.appendage.lean = 0.2
    before = volume(box)
    path = tmp_path / "box.hull.json"
    make_active(box)
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    again = bpy.context.view_layer.objects.active
    assert again != box
    assert volume(again) == pytest.approx(before, rel=2e-6)
    names = [obj.name.split(".")[0] for obj in part("bridge.objects.appendages").of_hull(again)]
    assert sorted(names) == ["Bulb", "Bulb Keel", "Shaft Bracket", "Thruster Tunnel"]
    assert not_joined(again) == ""


def test_appendages_follow_main_dimensions(box):
    """Scaled with the hull a tunnel's volume and a keel's go as hers."""
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    keel = add(box, "FIN_KEEL", x=6.0)
    whole = volume(box)
    factors = (1.2, 1.1, 0.9)
    part("features.dimensions.dimensions").scale_hull(box, bpy.context.scene, factors)
    # The keel keeps the thickness of its section, which is of the chord, not of the beam.
    keel.hull.appendage.thickness = 0.12 * 1.1 / 1.2
    keel.hull.appendage.tip_thickness = 0.12 * 1.1 / 1.2
    assert volume(box) == pytest.approx(1.2 * 1.1 * 0.9 * whole, rel=1e-4)
    assert not_joined(box) == ""


def test_each_is_listed_and_can_be_left_out(box):
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    keel = add(box, "FIN_KEEL", x=5.0)
    with_both = volume(box)
    keel.hull.appendage.counts = False
    assert volume(box) < with_both
    assert bpy.ops.hull.select_appendage(name=tunnel.name) == {"FINISHED"}
    assert bpy.context.view_layer.objects.active == tunnel
    assert bpy.ops.hull.select_appendage() == {"FINISHED"}
    assert bpy.context.view_layer.objects.active == box
    with pytest.raises(RuntimeError, match='no appendage "Rudder"'):
        bpy.ops.hull.select_appendage(name="Rudder")


def test_undone(box):
    whole = volume(box)
    bpy.ops.ed.undo_push(message="Before")
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    bpy.ops.ed.undo_push(message="Tunnel")
    assert volume(box) < whole - 1.0
    bpy.ops.ed.undo()
    assert volume(bpy.data.objects["box"]) == pytest.approx(whole, rel=1e-9)
    bpy.ops.ed.redo()
    assert volume(bpy.data.objects["box"]) < whole - 1.0


def test_other_extents_say_that_they_are_without(box, tmp_path, capfd):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    make_active(box)
    assert bpy.ops.hull.export_iges(filepath=str(tmp_path / "box.igs")) == {"FINISHED"}
    assert "without appendages, which are in closed solids only" in capfd.readouterr().out


def test_off_the_hull(box):
    make_active(box)
    with pytest.raises(RuntimeError, match="There is no hull over"):
        bpy.ops.hull.add_appendage(kind="FIN_KEEL", x=30.0)
    assert len(box.children) == 1  # the surface


def test_on_a_hull_without_a_surface(box):
    before = set(bpy.data.objects)
    box.data.clear_geometry()
    bpy.context.view_layer.update()
    make_active(box)
    with pytest.raises(RuntimeError, match="no faces") as refused:
        bpy.ops.hull.add_appendage(kind="FIN_KEEL")
    assert "Traceback" not in str(refused.value)
    assert set(bpy.data.objects) == before


def test_no_half_of_one_is_left(box):
    before, meshes = set(bpy.data.objects), set(bpy.data.meshes)
    make_active(box)
    with pytest.raises(RuntimeError, match="length|radius"):
        bpy.ops.hull.add_appendage(kind="BULB_KEEL", x=6.0, radius=0.0)
    assert set(bpy.data.objects) == before and set(bpy.data.meshes) == meshes


@pytest.mark.parametrize("values", [{"overlap": 1e30}, {"span": 1e30}, {"chord": 1e9}])
def test_out_of_all_proportion(box, values):
    before = volume(box)
    make_active(box)
    assert bpy.ops.hull.add_appendage(kind="FIN_KEEL", x=6.0, **values) == {"FINISHED"}
    assert "times the hull's size" in not_joined(box)
    assert volume(box) == before


def test_saved_and_read(box, tmp_path):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    name, before = box.name, volume(box)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "box.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "box.blend"))
    assert volume(bpy.data.objects[name]) == pytest.approx(before, rel=1e-9)


def test_step_file(box, tmp_path):
    add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    box.hull.export.extent = "SOLID"
    make_active(box)
    path = tmp_path / "box.step"
    assert bpy.ops.hull.export_step(filepath=str(path)) == {"FINISHED"}
    report = part("bridge.native").require().read_cad_report(str(path))
    assert report["valid"] and report["solids"] == 1
    assert report["volume"] == pytest.approx(120.0 - math.pi * RADIUS**2 * 4.0, rel=1e-8)


def test_step_file_of_a_sample_with_fin_keel_and_rudder(tmp_path):
    """One valid solid with the volume of all that is joined, which is more than the hull's."""
    hull = sample("planing_boat")
    up, far = (0.0, 0.0, 1.0), 100.0

    def whole():
        bpy.context.view_layer.update()
        return part("features.hull.hull_state").state_of(hull).ship.body.immersion(up, far).volume

    alone = whole()
    for kind in ("FIN_KEEL", "RUDDER"):
        add(hull, kind)
    hull.hull.export.extent = "SOLID"
    make_active(hull)
    path = tmp_path / "boat.step"
    assert bpy.ops.hull.export_step(filepath=str(path)) == {"FINISHED"}
    report = part("bridge.native").require().read_cad_report(str(path))
    assert report["valid"] and report["closed"] and report["solids"] == 1
    assert report["volume"] == pytest.approx(whole(), rel=1e-7)
    assert whole() > alone * (1.0 + 1e-4)


def test_appendages_wait_while_points_are_dragged(box):
    """Each step has the hull alone, and says so; at a pause all count again. Steps that move
    nothing leave them joined."""
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    hull_state, scene = part("features.hull.hull_state"), bpy.context.scene
    joined, hole = volume(box), math.pi * RADIUS**2 * 4.0
    hull_state.follow_edit(box, scene, may_wait=True)
    assert volume(box) == joined and not hull_state.state_of(box).ship.waits
    for vertex in box.data.vertices:
        vertex.co.x *= 1.1
    state = hull_state.follow_edit(box, scene, may_wait=True)
    assert state.ship.waits and "rest" in not_joined(box)
    alone = state.hydrostatics.values.displaced_volume
    assert alone == pytest.approx(1.1 * (joined + hole), rel=1e-6)
    hull_state.follow_edit(box, scene, may_wait=True)
    assert hull_state.state_of(box).ship.waits
    part("features.hull.late_joining").join()
    assert not hull_state.state_of(box).ship.waits and not_joined(box) == ""
    assert volume(box) == pytest.approx(alone - hole, rel=1e-7)
    assert tunnel.parent == box


def test_a_tunnel_beside_the_hull_is_told_of(box):
    """The others count all the same."""
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    keel = add(box, "FIN_KEEL", x=5.0)
    remarks = lambda: part("features.hull.hull_state").state_of(box).remarks  # noqa: E731
    with_both, hole = volume(box), math.pi * RADIUS**2 * 4.0
    assert not any("cuts nothing" in remark for remark in remarks())
    tunnel.location.z = 20.0
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # the panel tells; nobody reads the console
        assert volume(box) == pytest.approx(with_both + hole, rel=1e-7)
        part("features.hull.hull_state").state_of(box).ship.source.new_ship()
    (told,) = [remark for remark in remarks() if "cuts nothing" in remark]
    assert told.startswith(f"{tunnel.name} cuts nothing out of the hull") and not_joined(box) == ""
    bpy.data.objects.remove(tunnel)
    assert volume(box) > 100.01 and keel.hull.appendage.counts
    assert not any("cuts nothing" in remark for remark in remarks())


@pytest.mark.parametrize("mode", ["XYZ", "ZYX", "QUATERNION", "AXIS_ANGLE"])
def test_a_body_is_turned_as_before_when_its_hull_is_scaled(box, mode):
    rudder = add(box, "RUDDER", x=1.0)
    rudder.rotation_mode = mode
    if mode in ("XYZ", "ZYX"):
        rudder.rotation_euler = (0.3, 0.2, 0.1)
    elif mode == "AXIS_ANGLE":
        rudder.rotation_axis_angle = (0.4, 0.6, 0.0, 0.8)
    else:
        rudder.rotation_quaternion = Quaternion((0.6, 0.0, 0.8), 0.4)
    bpy.context.view_layer.update()
    before = rudder.matrix_basis.to_quaternion()
    make_active(box)
    scale = hull_io().scaling.Scale((2.0, 2.0, 2.0))
    part("features.hull.appendage_data").follow(box, scale)
    bpy.context.view_layer.update()
    assert rudder.matrix_basis.to_quaternion().rotation_difference(before).angle < 1e-6


def test_a_copy_that_shares_its_mesh_is_changed_by_itself(box):
    """As Alt D makes one."""
    made = add(box, "RUDDER")
    before = len(made.data.vertices), made.dimensions.copy()
    copied = made.copy()
    bpy.context.collection.objects.link(copied)
    assert copied.data == made.data
    copied.hull.appendage.chord *= 2.0
    bpy.context.view_layer.update()
    assert copied.data != made.data
    assert (len(made.data.vertices), made.dimensions) == before
    assert copied.dimensions.x > 1.2 * made.dimensions.x


def test_a_body_without_a_place_is_told_of_once(box):
    """A number that is none is unlike itself: the hull would be made anew at each look."""
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    whole = volume(box)
    tunnel.location.x = math.nan
    assert volume(box) > whole and tunnel.name in not_joined(box)
    hull_state, scene = part("features.hull.hull_state"), bpy.context.scene
    body = hull_state.state_of(box).ship.body
    assert hull_state.refresh(box, scene).ship.body is body
    assert hull_state.with_other_appendages(bpy.context.view_layer) == []
    tunnel.location.x = 7.0
    assert volume(box) == pytest.approx(whole, rel=1e-9) and not_joined(box) == ""


def test_an_animated_body_is_followed(box):
    tunnel = add(box, "TUNNEL", x=7.0, z=1.2, radius=RADIUS)
    joined, hole = volume(box), math.pi * RADIUS**2 * 4.0
    for frame, x in ((1, 7.0), (11, 50.0)):
        tunnel.location.x = x
        tunnel.keyframe_insert("location", frame=frame)
    state_of = part("features.hull.hull_state").state_of
    for frame, wanted in ((11, joined + hole), (1, joined), (11, joined + hole)):
        bpy.context.scene.frame_set(frame)
        found = state_of(box).hydrostatics.values.displaced_volume
        assert found == pytest.approx(wanted, rel=1e-7)
