# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls between parents: boxes, whose numbers have closed forms, and ships of two layouts."""

import itertools

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import (
    DEPTH,
    HALF_BREADTH,
    LENGTH,
    add_hull,
    make_active,
    mesh_points,
    part,
    state_of,
)
from edited_hulls import edit
from expect_morph import assert_is_member, boxes, exact_member, morph_of, select, set_weight


def test_a_morph_lies_between_its_parents():
    first, second = boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5))
    before = [mesh_points(hull).tobytes() for hull in (first, second)]
    made = morph_of(first, second)
    assert bpy.context.object == made and made not in (first, second)
    assert [entry.weight for entry in made.hull.morph.parents] == [0.5, 0.5]
    size = np.ptp(mesh_points(made), axis=0)
    assert np.array_equal(size, [1.5 * LENGTH, 1.25 * HALF_BREADTH, 0.75 * DEPTH])
    assert made.hull.half and made.hull.draft == pytest.approx(0.5 * (1.8 + 0.9))
    volume = state_of(made).hydrostatics.values.displaced_volume
    assert volume == pytest.approx(1.5 * LENGTH * 2.5 * HALF_BREADTH * made.hull.draft, rel=1e-7)
    assert [mesh_points(hull).tobytes() for hull in (first, second)] == before
    assert not part("features.morphing.parents").changed(made.hull.morph)


def test_a_weight_takes_the_others_along():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5)))
    weights = made.hull.morph.parents
    set_weight(made, 0, 0.25)
    assert weights[1].weight == 0.75
    assert_is_member(made)
    set_weight(made, 1, 1.5)
    assert weights[0].weight == -0.5
    assert np.ptp(mesh_points(made)[:, 0]) == pytest.approx(2.5 * LENGTH)
    assert_is_member(made)


def test_a_whole_weight_is_the_parent_bit_by_bit():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    made = morph_of(first, second)
    for number, parent in enumerate((first, second)):
        set_weight(made, number, 1.0)
        assert mesh_points(made).tobytes() == mesh_points(parent).tobytes()
        assert made.hull.length_pp == parent.hull.length_pp


def test_three_parents_share_what_one_leaves():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.0, 1.0), (1.0, 2.0, 1.0)))
    parents = made.hull.morph.parents
    bpy.ops.hull.set_weights(weights="0.2 0.6 0.2")
    set_weight(made, 0, 0.6)
    assert [round(entry.weight, 6) for entry in parents] == [0.6, 0.3, 0.1]
    set_weight(made, 0, 1.0)
    assert [entry.weight for entry in parents] == [1.0, 0.0, 0.0]
    set_weight(made, 0, 0.2)  # the others have the proportions of before
    assert [round(entry.weight, 6) for entry in parents] == [0.2, 0.6, 0.2]
    assert_is_member(made)


def test_others_scaled_sums_to_one_at_random():
    weights, limits = part("features.morphing.weights"), part("bridge.limits")
    random = np.random.default_rng(20)
    for _ in range(2000):
        count = int(random.integers(2, 6))
        found = random.uniform(-0.3, 0.8, count)
        found *= 1.0 / found.sum() if abs(found.sum()) > 0.3 else 1.0
        moved = int(random.integers(count))
        found[moved] = random.uniform(-0.9, 1.9)
        values = weights.others_scaled(found.tolist(), moved, random.random(count).tolist())
        assert sum(values) == pytest.approx(1.0, abs=1e-12)
        others = [value for k, value in enumerate(values) if k != moved]
        assert all(limits.MORPH_WEIGHTS[0] <= value <= limits.MORPH_WEIGHTS[1] for value in others)


def test_a_folded_member_is_refused_and_told():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.0, 4.0, 1.0)))
    set_weight(made, 0, 1.2)
    points, weight = mesh_points(made).tobytes(), made.hull.morph.parents[0].weight
    set_weight(made, 0, 1.6)  # 1.6 - 0.6 * 4 of a breadth
    member = part("features.morphing.members").told(made)
    assert "folds, at x" in member.problem and "the weights stay" in member.problem
    assert mesh_points(made).tobytes() == points
    assert made.hull.morph.parents[0].weight == weight
    with pytest.raises(RuntimeError, match="folds"):
        bpy.ops.hull.set_weights(weights="1.6 -0.6")
    assert made.hull.morph.parents[0].weight == weight
    set_weight(made, 0, 0.5)
    assert member.problem == ""
    assert_is_member(made)


def test_weights_by_script():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5)))
    bpy.ops.hull.set_weights(weights="0.75, 0.25")
    assert_is_member(made)
    assert made.hull.morph.parents[1].weight == 0.25
    bpy.ops.hull.set_weights()
    assert made.hull.morph.parents[1].weight == 0.5
    for wrong, told in (("1", "2 parents"), ("0.5 0.6", "sum to"), ("a b", "no weights"),
                        ("3 -2", "A weight")):  # fmt: skip
        with pytest.raises(RuntimeError, match=told):
            bpy.ops.hull.set_weights(weights=wrong)
    assert made.hull.morph.parents[1].weight == 0.5


def test_what_is_no_pair_of_parents_is_refused():
    first, second = boxes((1.0, 1.0, 1.0), (2.0, 1.0, 1.0))
    make_active(first)
    assert not bpy.ops.hull.make_morph.poll()
    second.hull.half = False
    select(first, second)
    count = len(bpy.data.objects)
    with pytest.raises(RuntimeError, match="half hull.*Make Whole"):
        bpy.ops.hull.make_morph()
    second.hull.half, second.hull.scheme = True, "catmull_clark"
    with pytest.raises(RuntimeError, match="different schemes"):
        bpy.ops.hull.make_morph()
    assert len(bpy.data.objects) == count


def test_hulls_with_other_bodies_are_refused_by_name():
    bpy.ops.hull.load_sample(name="sailing_yacht")
    yacht = bpy.context.object
    bpy.ops.hull.load_sample(name="coaster")
    coaster = bpy.context.object
    if coaster.hull.half != yacht.hull.half:
        pytest.skip("of other sides")
    select(coaster, yacht)
    with pytest.raises(RuntimeError, match=f'"{yacht.name}" has no part in the family'):
        bpy.ops.hull.make_morph()


def test_drafts_follow_unless_they_are_not_to():
    first, second = boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5))
    first.hull.draft, second.hull.draft = 1.0, 0.5
    first.hull.loading.kg, second.hull.loading.kg = 2.0, 1.0
    made = morph_of(first, second)
    set_weight(made, 0, 0.25)
    assert made.hull.draft == pytest.approx(0.625) and made.hull.loading.kg == pytest.approx(1.25)
    made.hull.morph.follows_particulars = False
    made.hull.draft = 0.7
    set_weight(made, 0, 0.5)
    assert made.hull.draft == pytest.approx(0.7)
    made.hull.morph.follows_particulars = True
    assert made.hull.draft == pytest.approx(0.75)


def test_a_hull_of_its_own_keeps_its_mesh():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    set_weight(made, 0, 0.3)
    points, values = mesh_points(made).tobytes(), state_of(made).hydrostatics.values
    assert bpy.ops.hull.leave_family() == {"FINISHED"}
    assert not made.hull.morph.parents
    bpy.context.view_layer.update()
    assert mesh_points(made).tobytes() == points
    assert state_of(made).hydrostatics.values == values
    assert not bpy.ops.hull.leave_family.poll()


def test_each_step_is_undone():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    select(first, second)
    bpy.ops.ed.undo_push(message="begin")
    name = morph_of(first, second).name
    bpy.ops.ed.undo_push(message="morph")
    made = bpy.data.objects[name]
    points = mesh_points(made).tobytes()
    set_weight(made, 0, 0.2)
    bpy.ops.ed.undo_push(message="weight")
    moved = mesh_points(made).tobytes()
    bpy.ops.hull.leave_family()
    bpy.ops.ed.undo_push(message="own")
    bpy.ops.ed.undo()
    made = bpy.data.objects[name]
    assert len(made.hull.morph.parents) == 2 and mesh_points(made).tobytes() == moved
    assert_is_member(made)
    bpy.ops.ed.undo()
    made = bpy.data.objects[name]
    assert mesh_points(made).tobytes() == points and made.hull.morph.parents[0].weight == 0.5
    assert_is_member(made)
    bpy.ops.ed.redo()
    made = bpy.data.objects[name]
    assert mesh_points(made).tobytes() == moved
    assert made.hull.morph.parents[0].weight == np.float32(0.2)
    assert_is_member(made)
    bpy.ops.ed.undo()
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects


def test_a_family_is_saved_with_the_file(tmp_path):
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    set_weight(made, 0, 0.3)
    name, points = made.name, mesh_points(made).tobytes()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "family.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "family.blend"))
    made = bpy.data.objects[name]
    make_active(made)
    bpy.context.view_layer.update()
    assert mesh_points(made).tobytes() == points
    assert_is_member(made)
    set_weight(made, 0, 0.6)
    assert_is_member(made)


def test_deleted_parents_stay_as_they_were_fitted(tmp_path):
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    made = morph_of(first, second)
    bpy.data.objects.remove(second)
    bpy.context.view_layer.update()
    parents = part("features.morphing.parents")
    assert parents.gone(made.hull.morph) == [made.hull.morph.parents[1].name]
    set_weight(made, 0, 0.1)
    assert_is_member(made)
    with pytest.raises(RuntimeError, match="was deleted"):
        bpy.ops.hull.pair_again()
    make_active(first)
    bpy.ops.object.delete()
    assert len(parents.gone(made.hull.morph)) == 2
    make_active(made)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "alone.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "alone.blend"))
    made = next(obj for obj in bpy.data.objects if len(obj.hull.morph.parents))
    make_active(made)
    set_weight(made, 0, 0.7)
    assert_is_member(made)


def test_a_duplicate_is_a_member_of_its_own():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    assert copy != made and copy.hull.morph.parents[0].mesh == made.hull.morph.parents[0].mesh
    bpy.context.view_layer.update()
    points = mesh_points(made).tobytes()
    set_weight(copy, 0, 0.8)
    assert mesh_points(made).tobytes() == points
    assert_is_member(copy)
    assert_is_member(made)
    set_weight(made, 0, 0.1)
    assert_is_member(copy)
    assert_is_member(made)


def test_hulls_that_share_a_mesh_are_refused():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    bpy.ops.object.duplicate(linked=True)
    bpy.context.view_layer.update()
    set_weight(made, 0, 0.8)
    assert "share the mesh" in part("features.morphing.members").told(made).problem
    assert made.hull.morph.parents[0].weight == 0.5


def moved_by_hand(hull):
    bm = edit(hull)
    bm.verts.ensure_lookup_table()
    bm.verts[0].co.z -= 0.25
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")


def extruded(hull):
    bm = edit(hull)
    bmesh.ops.subdivide_edges(bm, edges=bm.edges[:], cuts=1, use_grid_fill=True)
    bmesh.update_edit_mesh(hull.data)
    bpy.ops.object.mode_set(mode="OBJECT")


def joined(hull):
    other = add_hull("other")
    select(hull, other)
    bpy.ops.object.join()


def with_shape_keys(hull):
    hull.shape_key_add(name="Basis")
    hull.shape_key_add(name="Key")
    hull.data.shape_keys.key_blocks[1].data[0].co.x += 1.0
    hull.data.vertices[0].co.x += 1.0


def creased(hull):
    part("bridge.blender.blender_versions").set_creases(hull.data, [0], [0, 1, 2])


@pytest.mark.parametrize("change", (moved_by_hand, extruded, joined, with_shape_keys, creased))
def test_a_mesh_changed_by_hand_goes_back_or_becomes_its_own(change):
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    set_weight(made, 0, 0.3)
    members = part("features.morphing.members")
    before = part("bridge.objects.hull_mesh").read(made)
    change(made)
    make_active(made)
    bpy.context.view_layer.update()
    members.follow(made, bpy.context.scene)
    points = mesh_points(made).tobytes()
    assert not members.told(made).is_of_family
    set_weight(made, 0, 0.9)
    assert mesh_points(made).tobytes() == points
    assert made.hull.morph.parents[0].weight == np.float32(0.3)
    assert bpy.ops.hull.back_to_family() == {"FINISHED"}
    after = part("bridge.objects.hull_mesh").read(made)
    assert (before.topology, before.points_digest) == (after.topology, after.points_digest)
    bpy.context.view_layer.update()
    assert_is_member(made)
    set_weight(made, 0, 0.9)
    assert_is_member(made)
    change(made)
    made_points = mesh_points(made).tobytes()
    if change is not with_shape_keys:
        assert bpy.ops.hull.leave_family() == {"FINISHED"}
        assert mesh_points(made).tobytes() == made_points


def test_back_to_family_waits_for_the_end_of_edit_mode():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9)))
    edit(made)
    assert not bpy.ops.hull.back_to_family.poll()
    set_weight(made, 0, 0.3)  # by a script
    assert_is_member(made)
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    assert_is_member(made)


def test_animated_weights_are_followed():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.0, 1.0)))
    parents = made.hull.morph.parents
    for number, values in enumerate(((1.0, 0.0), (0.0, 1.0))):
        for frame, value in zip((1, 11), values):
            with part("features.morphing.weights").writing():
                parents[number].weight = value
            path = f"hull.morph.parents[{number}].weight"
            made.keyframe_insert(path, frame=frame)
    for curve in made.animation_data.action.fcurves:
        for point in curve.keyframe_points:
            point.interpolation = "LINEAR"
    for frame, length in ((1, 1.0), (6, 1.5), (11, 2.0)):
        bpy.context.scene.frame_set(frame)
        assert np.ptp(mesh_points(made)[:, 0]) == pytest.approx(length * LENGTH)


def test_a_changed_parent_is_told_and_fitted_again():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    made = morph_of(first, second)
    set_weight(made, 0, 0.25)
    parents = part("features.morphing.parents")
    second.data.vertices[0].co.z = -0.5
    second.data.update()
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert parents.changed(made.hull.morph) == [second.name]
    assert bpy.ops.hull.pair_again() == {"FINISHED"}
    assert parents.changed(made.hull.morph) == []
    assert made.hull.morph.parents[0].weight == 0.25
    assert_is_member(made)
    set_weight(made, 1, 1.0)
    assert mesh_points(made).tobytes() == mesh_points(second).tobytes()
    first.hull.draft *= 0.5
    bpy.context.view_layer.update()
    assert parents.changed(made.hull.morph) == [first.name]


def test_in_a_scene_of_other_units():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    bpy.context.scene.unit_settings.scale_length = 0.001
    bpy.context.view_layer.update()
    made = morph_of(first, second)
    for number, parent in enumerate((first, second)):
        set_weight(made, number, 1.0)
        assert mesh_points(made).tobytes() == mesh_points(parent).tobytes()
    assert_is_member(made)


def ships(*names):
    found = []
    for name in names:
        assert bpy.ops.hull.load_sample(name=name) == {"FINISHED"}
        found.append(bpy.context.object)
    return found


@pytest.fixture(scope="module")
def paper_pair(tmp_path_factory):
    """A file with the container ship and the bulk carrier, and a morph of them; made once."""
    bpy.ops.wm.read_homefile(use_empty=True)
    first, second = ships("container_ship", "bulk_carrier")
    made = morph_of(first, second)
    path = tmp_path_factory.mktemp("pair") / "pair.blend"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    return path, made.name, first.name, second.name


def opened(pair):
    path, *names = pair
    bpy.ops.wm.open_mainfile(filepath=str(path))
    found = [bpy.data.objects[name] for name in names]
    make_active(found[0])
    bpy.context.view_layer.update()
    return found


def test_the_papers_pair(paper_pair):
    made, first, _ = opened(paper_pair)
    assert made.hull.morph.subdivisions == 0
    for weight in (0.0, 0.25, 0.5, 1.0, 1.05):
        set_weight(made, 1, weight)
        assert_is_member(made)
        values = state_of(made).hydrostatics.values
        assert values is not None
    set_weight(made, 0, 1.0)
    assert np.array_equal(mesh_points(made), mesh_points(first))
    own, theirs = (part("bridge.objects.hull_mesh").read(hull) for hull in (made, first))
    assert (own.data.edge_creases > 0).sum() <= (theirs.data.edge_creases > 0).sum()
    assert np.array_equal(own.data.deck_edges, theirs.data.deck_edges)
    assert state_of(made).hydrostatics.values == state_of(first).hydrostatics.values


def test_numbers_of_a_member_by_itself(paper_pair):
    """The same from a hull of its own, made of the points alone."""
    made, *_ = opened(paper_pair)
    set_weight(made, 0, 0.37)
    values = state_of(made).hydrostatics.values
    bpy.ops.object.duplicate()
    bpy.ops.hull.leave_family()
    copy = bpy.context.object
    assert np.array_equal(mesh_points(copy), exact_member(made, [0.37, 0.63]))
    bpy.ops.hull.update()
    bpy.context.view_layer.update()
    assert np.array_equal(mesh_points(copy), exact_member(made, [0.37, 0.63]))
    (bottom,) = part("features.constraints.flats").regions(copy)
    assert bottom.plane.tolist() == [0.0, 0.0, 1.0, 0.0]
    again = state_of(copy).hydrostatics.values
    for name in ("displaced_volume", "lcb", "kmt", "wetted_surface"):
        assert getattr(again, name) == pytest.approx(getattr(values, name), rel=1e-6)


def test_all_lines_and_plots_on_while_weights_move(paper_pair):
    """Whatever follows a hull follows a member too, and comes to its end."""
    made, *_ = opened(paper_pair)
    lines, plots = made.hull.lines, made.hull.plots
    for group in (lines, plots):
        for prop in group.bl_rna.properties:
            if prop.type == "BOOLEAN" and not prop.is_readonly:
                setattr(group, prop.identifier, True)
    lines.waterline_spacing, lines.buttock_spacing, lines.diagonals = 1.0, 1.0, "8/40"
    bpy.context.view_layer.update()
    for weight in (0.4, 0.6, 0.55):
        set_weight(made, 0, weight)
        assert_is_member(made)
    live, worker = part("features.analyses.live_analyses"), part("bridge.background.worker")
    live.show_plots(made, bpy.context.scene)
    worker.finish()
    assert state_of(made).lines.groups


def test_a_third_hull_gives_the_layout():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    (third,) = boxes((3.0, 1.0, 1.0))
    third.name = "layout"
    select(first, second)
    assert bpy.ops.hull.make_morph(layout="layout") == {"FINISHED"}
    made = bpy.context.object
    assert made.hull.morph.layout_name == "layout" and len(made.hull.morph.parents) == 2
    assert_is_member(made)
    with pytest.raises(RuntimeError, match="no hull"):
        select(first, second)
        bpy.ops.hull.make_morph(layout="nobody")


def test_layers_out_of_the_shell_are_left_out():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    for hull in (first, second):
        for index, name in enumerate(("shell", "deck")):
            hull.data.materials.append(bpy.data.materials.new(name))
        hull.data.polygons[3].material_index = 1
        layer = hull.hull.layers.add()
        layer.material, layer.in_hydrostatics = hull.data.materials[1], False
        hull.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    made = morph_of(first, second)
    assert len(made.data.polygons) == 3
    assert [slot.material.name for slot in made.material_slots] == [
        material.name for material in first.data.materials
    ]
    assert_is_member(made)


def test_a_subdivided_layout_keeps_its_tags():
    layout_mesh, native = part("features.morphing.layout_mesh"), part("bridge.native")
    for name in ("coaster", "container_ship"):
        (hull,) = ships(name)
        found = part("bridge.objects.hull_mesh").read(hull)
        control = found.control(1.0)
        surface = state_of(hull).ship.source.new_surface()
        layout = layout_mesh.subdivided(layout_mesh.layout_of(hull, found, control), surface, 2)
        bpy.ops.hull.subdivide_exactly()
        bpy.ops.hull.subdivide_exactly()
        own = part("bridge.objects.hull_mesh").read(hull)
        other = own.control(1.0)
        fine = surface
        for _ in range(2):
            fine = native.require().LimitSurface(fine.refined_mesh(), fine.scheme)
        points = fine.mesh.points

        def places(where, pairs):
            ends = np.sort(np.round(where[np.asarray(pairs, dtype=int)], 3), axis=1)
            return sorted(map(tuple, ends.reshape(len(ends), -1).tolist()))

        for theirs, ours in (
            (other.creases, layout.creases),
            (other.deck_edge, layout.deck_edge),
            (np.stack([other.corners] * 2, 1), np.stack([layout.corners] * 2, 1)),
        ):
            assert len(theirs) == len(ours)
            if not len(ours):
                continue
            difference = np.array(places(other.points, theirs)) - np.array(places(points, ours))
            assert np.abs(difference).max() <= 2e-3
        slots = own.data.face_slots[other.face_ids]
        assert sorted(itertools.chain(slots)) == sorted(itertools.chain(layout.slots))


def test_lines_are_held_apart_and_paired_by_hand(paper_pair):
    made, first, second = opened(paper_pair)
    pairs = part("features.morphing.pairs")
    morph = made.hull.morph
    with pytest.raises(RuntimeError, match="gave the layout"):
        bpy.ops.hull.remove_pair()
    morph.active_parent = 1
    entry = morph.parents[1]
    found = {(pair.first, pair.second) for pair in entry.pairs}
    assert len(found) > 3
    rims = [k for k, pair in enumerate(entry.pairs) if "rim" in pair.name]
    entry.active_pair = rims[0]
    held = entry.pairs[rims[0]].first, entry.pairs[rims[0]].second
    assert bpy.ops.hull.remove_pair() == {"FINISHED"} and morph.has_other_pairs
    assert [(pair.first, pair.second) for pair in entry.apart] == [held]
    weight = morph.parents[0].weight
    assert bpy.ops.hull.pair_again() == {"FINISHED"}
    entry = morph.parents[1]
    assert held not in {(pair.first, pair.second) for pair in entry.pairs}
    assert morph.parents[0].weight == weight and not morph.has_other_pairs
    assert_is_member(made)
    morph.active_parent = 1
    with pytest.raises(RuntimeError, match="Choose a line of the layout"):
        bpy.ops.hull.add_pair()
    morph.feature = morph.features[held[0]].name
    entry.feature = entry.features[held[1]].name
    assert bpy.ops.hull.add_pair() == {"FINISHED"}
    assert not entry.apart and entry.pairs[entry.active_pair].is_given
    assert {(pair.first, pair.second) for pair in entry.pairs} == found
    assert [pair.is_given for pair in entry.pairs].count(True) == 1
    assert pairs.corrections(morph) == ({0: [], 1: [held]}, {0: [], 1: []})
    assert bpy.ops.hull.forget_pairs() == {"FINISHED"}
    assert pairs.corrections(morph) == ({0: [], 1: []}, {0: [], 1: []})


def test_pairs_are_shown_on_both_hulls(paper_pair):
    made, first, second = opened(paper_pair)
    lines_of = part("features.morphing.pair_lines")
    made.hull.morph.active_parent, made.hull.morph.show_pairs = 1, True
    bpy.context.view_layer.update()
    shown = state_of(made).of(lines_of.PairLines).lines
    pairs = made.hull.morph.parents[1].pairs
    assert len(shown) == 2 * len(pairs)
    for pair, (own, other) in zip(pairs, zip(shown[::2], shown[1::2])):
        assert (own.hull, other.hull) == (first.name, second.name)
        assert own.colour == other.colour == tuple(pair.colour)
    for line in shown:
        hull = bpy.data.objects[line.hull]
        tree = part("bridge.native").require().SurfaceTree(state_of(hull).ship.surface)
        assert tree.closest_points(line.polylines[0]).distances.max() < 1e-6
    made.hull.morph.feature = made.hull.morph.features[2].name
    bpy.context.view_layer.update()
    chosen = state_of(made).of(lines_of.PairLines).lines
    assert len(chosen) == len(shown) + 1
    assert (chosen[-1].hull, chosen[-1].colour) == (first.name, (1.0, 1.0, 1.0))
    assert np.array_equal(chosen[-1].polylines, shown[2 * 2].polylines)
    made.hull.morph.feature = ""
    bpy.context.view_layer.update()
    overlay = part("overlays.morph_pairs")
    views = [
        type("Shown", (), {"hull": hull, "state": state_of(hull)})()
        for hull in (made, first, second)
    ]
    assert len(overlay.wanted(views)) == len(shown)
    second.data.vertices[0].co.z += 1.0
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert len(overlay.wanted(views)) == len(pairs)  # those of the changed hull are of before
    made.hull.morph.show_pairs = False
    bpy.context.view_layer.update()
    assert not state_of(made).of(lines_of.PairLines).lines


def test_pairing_again_where_the_member_would_be_none_shows_the_first_parent():
    first, second = boxes((1.0, 1.0, 1.0), (1.0, 1.5, 1.0))
    made = morph_of(first, second)
    set_weight(made, 0, 1.5)
    for vertex in second.data.vertices:
        vertex.co.y *= 4.0  # 1.5 - 0.5 * 6 of a breadth
    second.data.update()
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    assert bpy.ops.hull.pair_again() == {"FINISHED"}
    assert [entry.weight for entry in made.hull.morph.parents] == [1.0, 0.0]
    assert mesh_points(made).tobytes() == mesh_points(first).tobytes()
    bpy.context.view_layer.update()
    assert_is_member(made)


def test_flats_are_kept_again_by_a_hull_of_its_own():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    flats = part("features.constraints.flats")
    for faces, plane in (([0], (0.0, 1.0, 0.0, 2.0)), ([2], (-1.0, 0.0, 0.0, 0.0))):
        flats.mark(first, faces, plane)
    made = morph_of(first, second)
    assert not flats.regions(made)  # a slider moves all of it
    set_weight(made, 0, 0.3)
    points = mesh_points(made).tobytes()
    assert bpy.ops.hull.leave_family() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert mesh_points(made).tobytes() == points
    found = sorted((region.kind, region.faces.tolist()) for region in flats.regions(made))
    assert [faces for _, faces in found] in ([[0], [2]], [[2], [0]])
    y = next(region.plane for region in flats.regions(made) if region.faces.tolist() == [0])
    assert y == pytest.approx([0.0, 1.0, 0.0, 0.3 * 2.0 + 0.7 * 2.6], abs=1e-6)


def test_flats_that_are_turned_are_not_kept():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    part("features.constraints.flats").mark(first, [0], (0.0, 1.0, 0.0, 2.0))
    for vertex in second.data.vertices:  # its side is no plane any longer
        vertex.co.y *= 1.0 + 0.01 * vertex.co.x * vertex.co.z
    second.data.update()
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    made = morph_of(first, second)
    points = mesh_points(made).tobytes()
    assert bpy.ops.hull.leave_family() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert not part("features.constraints.flats").regions(made)
    assert mesh_points(made).tobytes() == points
