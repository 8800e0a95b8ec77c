# SPDX-License-Identifier: GPL-3.0-or-later
"""Hull from Mesh and Hull from File: what is made, told, taken back and refused."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, hull_io, make_active, part, sample
from mathutils import Vector
from test_panels import texts

pytestmark = pytest.mark.once

BUDGET, PARTS = 90, 6


def surface_of(hull):
    return part("features.hull.hull_state").up_to_date(hull, bpy.context.scene).ship.surface


def triangles_of(hull):
    facets = surface_of(hull).tessellate(PARTS)
    quads = facets.quads
    return np.array(facets.points), np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def mesh_object(name, points, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(np.asarray(points).tolist(), [], np.asarray(faces).tolist())
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(obj)
    make_active(obj)
    return obj


def report_of(hull):
    return part("features.geometry.making").last_report(hull)


def test_a_mesh_becomes_a_hull_that_stands_upon_it():
    coaster = sample("coaster")
    surface, length = surface_of(coaster), coaster.dimensions.x
    source = mesh_object("scan", *triangles_of(coaster))
    source.location = (200.0, 30.0, 5.0)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="before")
    before = {obj.name for obj in bpy.data.objects}
    assert bpy.ops.hull.hull_from_mesh(points=BUDGET, draft=5.0) == {"FINISHED"}
    hull = bpy.context.view_layer.objects.active
    assert hull.name == "scan hull" and hull.hull.is_hull and hull.hull.half
    assert len(hull.data.vertices) <= BUDGET and hull.hull.draft == pytest.approx(5.0)
    # The base line is through the lowest point, the after perpendicular at the after end.
    assert hull.location.y == pytest.approx(30.0, abs=1e-4)
    shift = np.array(hull.location) - np.array(source.location)
    points = triangles_of(coaster)[0]
    np.testing.assert_allclose(shift, [points[:, 0].min(), 0.0, points[:, 2].min()], atol=2e-4)
    report, is_current = report_of(hull)
    assert is_current and report.told["points"] == len(hull.data.vertices)
    # By another way: of places of the surface that the triangles are of.
    tree = part("bridge.native").require().SurfaceTree(surface_of(hull))
    apart = np.asarray(tree.closest_points(surface.tessellate(3).points - shift).distances)
    assert np.sqrt(np.mean(apart**2)) < 2e-4 * length
    assert hull.hull.fit.target == source
    said = texts()["HULL_PT_made_of"]
    assert "scan" in said and str(len(hull.data.vertices)) in said
    assert bpy.ops.hull.show_source_miss() == {"FINISHED"}
    place = np.array(bpy.context.scene.cursor.location) - np.array(hull.location)
    assert tree.closest_points([place]).distances[0] == pytest.approx(
        report.told["distances"]["largest"], abs=2e-4
    )
    hull.data.vertices[0].co.z += 0.1
    hull.data.update()
    bpy.context.view_layer.update()
    surface_of(hull)
    assert not report_of(hull)[1]
    assert any("as it was made" in text for text in texts()["HULL_PT_made_of"])
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    assert {obj.name for obj in bpy.data.objects} == before


def test_a_mesh_is_known_after_it_was_renamed_meanwhile():
    making, sources = part("features.geometry.making"), part("features.geometry.sources")
    source = mesh_object("scan", *triangles_of(sample("barge")))
    source.location = (200.0, 30.0, 5.0)
    bpy.context.view_layer.update()
    scene = bpy.context.scene
    task = making.Making(sources.of_object(source, scene), making.Asked(BUDGET))
    source.name = "another name"
    other = mesh_object("scan", np.eye(3), [(0, 1, 2)])
    hull, _ = task.write(scene, bpy.context.collection)
    assert hull.hull.fit.target == source != other
    assert hull.location.y == pytest.approx(30.0, abs=1e-4)
    assert hull.location.x > 190.0


def test_the_dialog_is_in_the_units_of_the_scene(monkeypatch):
    """Of a box of 30.48 by 2 · 3.048 by 6.096 m."""
    operators, said = part("operators.geometry"), []
    box = [(x, y, z) for x in (0, 30.48) for y in (-3.048, 3.048) for z in (0, 6.096)]
    mesh_object("box", box, [(2, 3, 7, 6), (0, 4, 5, 1), (0, 2, 6, 4), (0, 1, 3, 2), (4, 6, 7, 5)])
    scene = bpy.context.scene
    scene.unit_settings.system = "IMPERIAL"
    source = part("features.geometry.sources").of_object(bpy.context.object, scene)
    column = SimpleNamespace(label=lambda text: said.append(text))
    layout = SimpleNamespace(column=lambda align: column)
    dialog = SimpleNamespace(_source=source, known=lambda: {}, layout=layout)
    monkeypatch.setattr(operators.FromGeometry, "draw", lambda *_: None)
    operators.HULL_OT_hull_from_mesh._understand(dialog)
    operators.HULL_OT_hull_from_mesh.draw(dialog, bpy.context)
    assert said[0] == "100 ft long, 20 ft broad, 20 ft deep"
    assert said[1].startswith("Lpp 100 ft, forward")


def made_while_another_is_edited(*_):
    mesh_object("edited", np.eye(3), [(0, 1, 2)])
    bpy.ops.object.mode_set(mode="EDIT")
    made = bpy.data.objects.new("made", bpy.data.meshes.new("made"))
    bpy.context.scene.collection.objects.link(made)
    return made, SimpleNamespace(is_within=True)


def test_what_is_edited_meanwhile_stays_the_active_object(monkeypatch):
    write = SimpleNamespace(result=lambda: None, write=made_while_another_is_edited)
    making, to_hull = part("features.geometry.making"), part("features.networks.to_hull")
    for feature, task, told in ((making, "Making", ("", False)), (to_hull, "Laying", "")):
        monkeypatch.setattr(feature, task, lambda *_: write)
        monkeypatch.setattr(feature, "summary", lambda _, told=told: told)
    mesh_object("scan", np.eye(3), [(0, 1, 2)])
    for operator in (bpy.ops.hull.hull_from_mesh, bpy.ops.hull.network_to_hull):
        if not operator.poll():
            assert bpy.ops.hull.new_network() == {"FINISHED"}
        assert operator() == {"FINISHED"}
        assert bpy.context.mode == "EDIT_MESH" and bpy.context.object.name == "edited"
        bpy.ops.object.mode_set(mode="OBJECT")
        bpy.data.objects.remove(bpy.context.object)


def test_misses_are_shown_out_of_a_cameras_view(monkeypatch):
    place, scene = Vector((1.0, 2.0, 3.0)), bpy.context.scene
    monkeypatch.setattr(part("features.geometry.making"), "place_of", lambda *_: place)
    monkeypatch.setattr(part("features.networks.to_hull"), "place_of", lambda *_: place)
    of_source = part("operators.geometry").HULL_OT_show_source_miss.run_on
    of_network = part("operators.network_hull").HULL_OT_show_network_miss.run
    hull = add_hull()
    for show in (
        lambda context: of_source(None, hull, context),
        lambda context: of_network(SimpleNamespace(index=0), context),
    ):
        scene.cursor.location = (0.0, 0.0, 0.0)
        view = SimpleNamespace(view_perspective="CAMERA", view_location=None)
        show(SimpleNamespace(scene=scene, object=hull, region_data=view))
        assert (view.view_perspective, view.view_location) == ("PERSP", place)
        assert scene.cursor.location == place


def test_a_file_becomes_a_hull_on_a_ships_axes(tmp_path):
    coaster = sample("coaster")
    points, triangles = triangles_of(coaster)
    low = points.min(axis=0)
    # mm, forward along -y, up along x, from a corner.
    turned = 1e3 * (points - low)[:, [2, 0, 1]] * [1.0, -1.0, 1.0]
    path = tmp_path / "my boat.stl"
    hull_io().write_stl(path, turned, triangles)
    made = bpy.ops.hull.hull_from_file(
        filepath=str(path), points=BUDGET, forward="-y", up="+x", sides="HALF", unit="mm"
    )
    assert made == {"FINISHED"}
    hull = bpy.context.view_layer.objects.active
    assert hull.name == "my boat" and tuple(hull.location) == (0.0, 0.0, 0.0)
    assert hull.dimensions.x == pytest.approx(np.ptp(points[:, 0]), rel=2e-3)
    report, _ = report_of(hull)
    assert report.told["distances"]["rms"] < 2e-4 * hull.dimensions.x
    source = hull.hull.fit.target
    assert source.name == "my boat source" and not source.visible_get()
    assert source.dimensions.y == pytest.approx(np.ptp(points[:, 1]), rel=1e-5)
    made = report.told["displaced_volume"]
    assert made["hull"] == pytest.approx(made["source"], rel=1e-3)


def refused(words, operator, **given):
    before = {block.name for block in bpy.data.objects}
    with pytest.raises(RuntimeError, match=words):
        operator(**given)
    assert {block.name for block in bpy.data.objects} == before


def test_what_makes_no_hull_is_refused_and_nothing_is_left(tmp_path):
    from_mesh, from_file = bpy.ops.hull.hull_from_mesh, bpy.ops.hull.hull_from_file
    refused("Select a mesh object that is no hull first", from_mesh)
    add_hull()
    refused("Select a mesh object that is no hull first", from_mesh)
    mesh_object("cloud", [(0, 0, 0), (1, 2, 3), (4, 5, 9)], np.empty((0, 3), dtype=int))
    refused("has no faces", from_mesh)
    mesh_object("square", [(0, 0, 0), (9, 0, 0), (9, 2, 0), (0, 2, 0)], [(0, 1, 2, 3)])
    refused("in one plane", from_mesh)
    missing = str(tmp_path / "none.stl")
    refused("none.stl", from_file, filepath=missing)
    (tmp_path / "words.csv").write_text("hello\n")
    refused("words.csv: no two points", from_file, filepath=str(tmp_path / "words.csv"))
    box = mesh_object(
        "open box",
        [
            (0, -2, 0),
            (9, -2, 0),
            (9, 2, 0),
            (0, 2, 0),
            (0, -2, 3),
            (9, -2, 3),
            (9, 2, 3),
            (0, 2, 3),
        ],
        [(3, 2, 1, 0), (0, 1, 5, 4), (2, 3, 7, 6)],
    )
    refused("forward is \\+x and up is \\+x", from_mesh, forward="+x", up="+x")
    refused("Draft in m is", from_mesh, draft=1e6)
    box.data.vertices[0].co.x = float("nan")
    refused("points without a place", from_mesh)
