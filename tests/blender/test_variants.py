# SPDX-License-Identifier: GPL-3.0-or-later
"""Variants come back bit by bit, whatever has become of the hull meanwhile, and go where the hull
goes: undo, files, copies."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, mesh_points, part, state_of
from edited_hulls import edit, find
from test_hull_saving import loaded_hull, settings_of

SAMPLE = "roro"


def variants_of(hull):
    return part("features.variants.kept_hulls"), hull.hull.variants


def layers_of(bm):
    """The layers of one kind of elements, by name."""
    found = {}
    for kind in ("float", "int", "bool", "deform", "uv", "string"):
        layers = getattr(bm, kind, None)
        found.update({(kind, name): layer for name, layer in layers.items()} if layers else {})
    return found


def geometry_of(hull):
    """Whatever the mesh of a hull is, to the last bit; the hull is in object mode."""
    read = part("bridge.mesh.mesh_arrays").read_mesh(hull.data)
    marks = part("features.constraints.flat_marks").read(hull.data)
    locked = part("features.constraints.point_locks").locked_points(hull.data)
    arrays = [getattr(read, name) for name in type(read).__dataclass_fields__ if name != "ties"]
    flat = [] if marks is None else [marks.faces, marks.regions]
    materials = [slot.material.name for slot in hull.material_slots]
    tied = part("features.constraints.ties").stored_ties(hull.data)
    return [array.tobytes() for array in (*arrays, *flat, locked)] + [materials, tied]


def planes_of(hull):
    return [(one.region, tuple(one.normal), one.offset) for one in hull.hull.flats]


def places_of(hull):
    lines = hull.hull.lines
    names = ("station_count", "stations", "stations_in", "frame_spacing", "waterline_spacing",
             "waterlines", "buttock_spacing", "buttocks", "diagonals")  # fmt: skip
    planes = [(one.name, tuple(one.normal), tuple(one.point)) for one in lines.planes]
    layers = [(one.material.name, one.in_hydrostatics) for one in hull.hull.layers]
    return [getattr(lines, name) for name in names] + [planes, layers, hull.hull.keep_centre]


def all_of(hull):
    return geometry_of(hull), planes_of(hull), settings_of(hull), places_of(hull)


def sample(name=SAMPLE):
    assert bpy.ops.hull.load_sample(name=name) == {"FINISHED"}
    hull = bpy.context.object
    hull.hull.samples = 1
    lock_some(hull)
    return hull


def lock_some(hull):
    bm = edit(hull)
    for vertex in list(bm.verts)[::7]:
        vertex.select_set(True)
    bm.select_flush_mode()
    bmesh.update_edit_mesh(hull.data)
    assert bpy.ops.hull.lock_points() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")


def spoil(hull):
    """Another form, other faces, other settings."""
    bm = edit(hull)
    edges = [edge for edge in bm.edges if len(edge.link_faces) == 2][:5]
    bmesh.ops.subdivide_edges(bm, edges=edges, cuts=1, use_grid_fill=True)
    for vertex in bm.verts:
        vertex.co.x *= 1.1
        vertex.co.z += 0.01 * vertex.co.x
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")
    settings = hull.hull
    settings.draft, settings.trim_m, settings.scheme = 1.0, 0.25, "catmull_clark"
    settings.loading.kg, settings.lines.stations = 5.5, "1 2 3"
    settings.flats.clear()
    hull.data.attributes.remove(hull.data.attributes["hull_flat"])
    settings.loading.load_cases.clear()
    bpy.context.view_layer.update()


def test_a_variant_comes_back_bit_by_bit():
    hull = sample()
    bpy.ops.hull.add_load_case()
    bpy.ops.hull.add_plane()
    before = all_of(hull)
    numbers = state_of(hull).hydrostatics.values
    assert len(planes_of(hull)) > 0 and len(geometry_of(hull)[-2]) > 0
    assert bpy.ops.hull.keep_variant(name="as built") == {"FINISHED"}
    spoil(hull)
    assert all(ours != theirs for ours, theirs in zip(all_of(hull), before))
    assert bpy.ops.hull.go_back_to_variant() == {"FINISHED"}
    assert all_of(hull) == before
    bpy.context.view_layer.update()  # whatever follows leaves it so
    assert all_of(hull) == before
    assert state_of(hull).status == "" and state_of(hull).hydrostatics.values == numbers


def test_every_setting_comes_back():
    hull = loaded_hull()
    wanted = settings_of(hull)
    bpy.ops.hull.keep_variant()
    hull.hull.loading.load_cases.clear()
    hull.hull.wind.areas.clear()
    hull.hull.wind.source, hull.hull.loading.kg = "NONE", 0.5
    hull.hull.loading.downflooding_points[0].name = "window"
    hull.hull.half = hull.hull.deck_closed = True
    hull.hull.property_unset("draft")
    bpy.ops.hull.go_back_to_variant()
    assert settings_of(hull) == wanted


def test_all_shared_settings_are_those_of_the_hull_and_of_its_variants():
    """None is forgotten: what is not shared is the view's, or of the hull as an object."""
    settings = part("features.variants.ship_settings")
    rna = bpy.types.Object.bl_rna.properties["hull"].fixed_type
    of_variant = rna.properties["variants"].fixed_type.properties["kept"].fixed_type
    own = {"name", "note", "mesh", "rna_type"}
    assert set(settings.SHARED) == set(of_variant.properties.keys()) - own
    assert set(settings.SHARED) <= set(rna.properties.keys())


def test_what_is_the_views_own_stays():
    hull = add_hull()
    bpy.ops.hull.keep_variant()
    hull.hull.lines.show_stations, hull.hull.lines.width = False, 3.0
    hull.hull.samples = 7
    bpy.ops.hull.go_back_to_variant()
    assert not hull.hull.lines.show_stations and hull.hull.lines.width == 3.0
    assert hull.hull.samples == 7


def test_it_is_one_step_of_undo():
    bpy.ops.ed.undo_push(message="begin")
    hull = sample()
    bpy.ops.hull.keep_variant(name="A")
    before = all_of(hull)
    bpy.ops.ed.undo_push(message="kept")
    spoil(hull)
    spoilt = all_of(hull)
    bpy.ops.ed.undo_push(message="spoilt")
    bpy.ops.hull.go_back_to_variant()
    bpy.ops.ed.undo_push(message="back")
    bpy.ops.ed.undo()
    assert all_of(bpy.context.object) == spoilt
    bpy.ops.ed.redo()
    assert all_of(bpy.context.object) == before
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert all_of(bpy.context.object) == before
    assert [one.name for one in bpy.context.object.hull.variants.kept] == ["A"]


def test_it_is_saved_with_the_file(tmp_path):
    hull = sample()
    bpy.ops.hull.keep_variant(name="A", note="as in the contract")
    before = all_of(hull)
    spoil(hull)
    path = str(tmp_path / "kept.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=path)
    hull = bpy.context.object
    entry = hull.hull.variants.kept[0]
    assert (entry.name, entry.note) == ("A", "as in the contract")
    assert entry.mesh.users == 1 and not entry.mesh.use_fake_user
    bpy.ops.hull.go_back_to_variant(variant="A")
    assert all_of(hull) == before


def kept_of(hull):
    """All of a hull's variants, but for the numbers of their flats, which belong to a session."""
    found, variants = variants_of(hull)
    told = []
    for entry in variants.kept:
        ship = found.as_hull(hull, entry)
        geometry, planes, settings, places = all_of(ship)
        regions = part("features.constraints.flats").regions(ship)
        flat = sorted((one.faces.tolist(), one.plane.tolist()) for one in regions)
        marked = 2 if regions else 0
        arrays = geometry[: -2 - marked]
        kept = part("features.constraints.kept_points").read(entry.mesh)
        axes = [kept.along(axis).tolist() for axis in range(3)]
        told.append((entry.name, entry.note, arrays, geometry[-2:], flat, axes, settings, places))
        assert len(planes) == len(flat)
    return told


def test_they_come_back_from_a_hull_file(tmp_path):
    hull = sample()
    hull.hull.loading.kg = 9.125
    found, _ = variants_of(hull)
    found.keep(hull, "as built", "of the contract")
    locks = part("features.constraints.point_locks")
    locks.write(hull.data, [3, 5])
    part("features.constraints.kept_points").set_axes(hull.data, [7], (0,), True)
    hull.data.vertices[20].co.y += 0.1
    hull.hull.draft *= 0.9
    bpy.context.view_layer.update()
    found.keep(hull, "fuller")
    before = kept_of(hull)
    count = len(bpy.data.materials)
    assert bpy.ops.hull.export_hull(filepath=str(tmp_path / "roro.hull.json")) == {"FINISHED"}
    bpy.ops.wm.read_homefile(use_empty=True)
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "roro.hull.json")) == {"FINISHED"}
    hull = bpy.context.object
    assert kept_of(hull) == before
    assert len(bpy.data.materials) == count
    found, variants = variants_of(hull)
    found.go_back(hull, bpy.context.scene, variants.kept[0])
    assert hull.hull.loading.kg == 9.125 and not state_of(hull).status


def test_a_variant_whose_mesh_is_gone_is_told_before_anything_is_written(tmp_path):
    hull = sample()
    found, variants = variants_of(hull)
    found.keep(hull, "A")
    bpy.data.meshes.remove(variants.kept[0].mesh)
    path = tmp_path / "roro.hull.json"
    with pytest.raises(RuntimeError, match='variant "A" was deleted: remove the variant'):
        bpy.ops.hull.export_hull(filepath=str(path))
    assert not path.exists()


def test_it_comes_along_when_the_object_is_appended(tmp_path):
    hull = sample()
    bpy.ops.hull.keep_variant(name="A")
    before, name = all_of(hull), hull.name
    spoil(hull)
    path = str(tmp_path / "kept.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    for link in (False, True):
        bpy.ops.wm.read_homefile(use_empty=True)
        with bpy.data.libraries.load(path, link=link) as (_, wanted):
            wanted.objects = [name]
        hull = wanted.objects[0]
        bpy.context.collection.objects.link(hull)
        bpy.context.view_layer.update()
        make_active(hull)
        if link:  # it is shown and measured, and cannot be changed; a copy of it can
            assert not bpy.ops.hull.go_back_to_variant.poll()
            with pytest.raises(ValueError, match="linked"):
                kept, variants = variants_of(hull)
                kept.go_back(hull, bpy.context.scene, variants.kept[0])
            bpy.ops.hull.duplicate_variant(variant="A")
            assert geometry_of(bpy.context.object) == before[0]
        else:
            bpy.ops.hull.go_back_to_variant(variant="A")
            assert all_of(hull) == before


def test_copies_of_the_object_have_it_each_for_itself():
    hull = sample()
    bpy.ops.hull.keep_variant(name="A")
    before = all_of(hull)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    spoil(copy)
    bpy.ops.hull.remove_variant()
    assert not len(copy.hull.variants.kept) and hull.hull.variants.kept[0].mesh is not None
    make_active(hull)
    spoil(hull)
    bpy.ops.hull.go_back_to_variant()
    assert all_of(hull) == before


def test_the_list():
    hull = add_hull()
    variants = hull.hull.variants
    for name in ("", "", "B"):
        bpy.ops.hull.keep_variant(name=name)
    assert [one.name for one in variants.kept] == ["Variant 1", "Variant 2", "B"]
    assert variants.active == 2
    variants.kept[0].name = "A"
    variants.active = 1
    bpy.ops.hull.remove_variant()
    assert [one.name for one in variants.kept] == ["A", "B"] and variants.active == 1
    bpy.ops.hull.remove_variant(variant="A")
    assert [one.name for one in variants.kept] == ["B"] and variants.active == 0
    with pytest.raises(RuntimeError, match='no variant "A"'):
        bpy.ops.hull.remove_variant(variant="A")
    bpy.ops.hull.remove_variant()
    assert not bpy.ops.hull.remove_variant.poll() and not bpy.ops.hull.go_back_to_variant.poll()


def test_the_present_hull_can_be_kept_first():
    hull = add_hull()
    bpy.ops.hull.keep_variant(name="low")
    hull.data.vertices[1].co.z += 1.0
    high = mesh_points(hull)
    bpy.ops.hull.go_back_to_variant(keep_present=True)
    kept, variants = variants_of(hull)
    assert len(variants.kept) == 2 and kept.chosen(hull).name == "low"
    bpy.ops.hull.go_back_to_variant(variant=variants.kept[1].name)
    assert np.array_equal(mesh_points(hull), high)


def test_it_is_kept_as_it_is_being_edited():
    hull = add_hull()
    bm = edit(hull)
    bm.verts.ensure_lookup_table()
    bm.verts[find(hull, 10.0, 2.0, 3.0)].co.x = 11.0
    bmesh.update_edit_mesh(hull.data)
    assert bpy.ops.hull.keep_variant() == {"FINISHED"}
    assert not bpy.ops.hull.go_back_to_variant.poll()  # Tab first
    bpy.ops.object.mode_set(mode="OBJECT")
    wanted = mesh_points(hull)
    assert wanted[:, 0].max() == 11.0
    hull.data.vertices[0].co.x = -5.0
    bpy.ops.hull.go_back_to_variant()
    assert np.array_equal(mesh_points(hull), wanted)


def test_what_a_mesh_carries_beside_comes_back():
    """Weights, UV, loose edges and points, creases between none and full."""
    hull = add_hull()
    bm = edit(hull)
    loose = bm.verts.new((20.0, 0.0, 0.0)), bm.verts.new((21.0, 0.0, 0.0))
    bm.edges.new(loose)
    bm.verts.layers.deform.verify()
    uv = bm.loops.layers.uv.verify()
    next(iter(bm.faces)).loops[0][uv].uv = (0.25, 0.75)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")
    hull.vertex_groups.new(name="stem").add([1, 2], 0.5, "REPLACE")
    before, uvs = geometry_of(hull), [tuple(one.uv) for one in hull.data.uv_layers[0].data]
    bpy.ops.hull.keep_variant()
    hull.data.clear_geometry()
    bpy.ops.hull.go_back_to_variant()
    assert geometry_of(hull) == before and len(hull.data.vertices) == 10
    assert [tuple(one.uv) for one in hull.data.uv_layers[0].data] == uvs
    assert [len(vertex.groups) for vertex in hull.data.vertices] == [0, 1, 1] + 7 * [0]


def test_a_variant_becomes_an_object_of_its_own():
    hull = sample()
    hull.location.y = 30.0
    hull.hull.lines.show_buttocks = False
    bpy.ops.hull.keep_variant(name="A")
    before = all_of(hull)
    spoil(hull)
    spoilt = all_of(hull)
    assert bpy.ops.hull.duplicate_variant() == {"FINISHED"}
    made = bpy.context.object
    assert made != hull and made.location.y == 30.0 and not made.hull.lines.show_buttocks
    assert all_of(made) == before and all_of(hull) == spoilt
    assert state_of(made).status == "" and made.hull.surface_object.parent == made
    assert made.data != hull.hull.variants.kept[0].mesh


def test_what_cannot_be_says_why():
    hull = add_hull()
    bpy.ops.hull.keep_variant(name="A")
    twin = bpy.data.objects.new("twin", hull.data)
    bpy.context.collection.objects.link(twin)
    with pytest.raises(RuntimeError, match="2 objects share the mesh"):
        bpy.ops.hull.go_back_to_variant()
    bpy.data.objects.remove(twin)
    bpy.data.meshes.remove(hull.hull.variants.kept[0].mesh)
    for run in (bpy.ops.hull.go_back_to_variant, bpy.ops.hull.duplicate_variant):
        with pytest.raises(RuntimeError, match='mesh of the variant "A" was deleted'):
            run()
    assert bpy.ops.hull.remove_variant() == {"FINISHED"}


def test_numbers_of_flats_in_variants_are_not_given_again():
    """Else a flat that comes back would be one with a flat that was made meanwhile."""
    hull = sample()
    numbers = {one.region for one in hull.hull.flats}
    bpy.ops.hull.keep_variant()
    hull.hull.flats.clear()
    hull.data.attributes.remove(hull.data.attributes["hull_flat"])
    assert part("features.constraints.flats").new_number(hull) == 1 + max(numbers)


def test_file_size(tmp_path):
    """A variant costs its mesh: some 30 kB of a sample of 150 points, and no more."""
    hull = sample()
    sizes = []
    for count in (0, 10):
        for _ in range(count):
            bpy.ops.hull.keep_variant()
        path = tmp_path / f"{count}.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True, compress=False)
        sizes.append(path.stat().st_size)
    assert hull.hull.variants.kept[9].mesh is not None
    assert (sizes[1] - sizes[0]) / 10 < 300 * len(hull.data.vertices)
