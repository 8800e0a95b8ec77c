# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls between parents: boxes, whose numbers have closed forms."""

import bpy
import numpy as np
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, make_active, mesh_points, part, state_of
from expect_morph import assert_is_member, boxes, morph_of, select, set_weight


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


def test_hulls_are_known_after_they_were_renamed_meanwhile():
    first, second = boxes((1.0, 1.0, 1.0), (2.0, 1.5, 0.5))
    kept, gone = (bpy.data.materials.new(name) for name in ("kept", "gone"))
    for material in (kept, gone):
        first.data.materials.append(material)
    scene, making = bpy.context.scene, part("features.morphing.making")
    task = making.Morphing(first, [first, second], first, scene)
    second.name, first.name = "another name", "box"
    bpy.data.materials.remove(gone)
    kept.name = "as well"
    made = task.write(scene)
    assert [entry.source for entry in made.hull.morph.parents] == [first, second]
    assert made.data.materials[:] == [kept, None]
    task = part("features.morphing.refitting").Refitting(made, scene)
    made.name = "renamed"
    task.write(scene)
    assert_is_member(made)


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
    said = f'"{yacht.name}" has no part in the family. "{coaster.name}" has 1 body and '
    with pytest.raises(
        RuntimeError, match=f'{said}"{yacht.name}" . bodies: leave out of "{yacht.name}"'
    ):
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


def test_in_a_scene_of_other_units():
    first, second = boxes((1.0, 1.0, 1.0), (1.7, 1.3, 0.9))
    bpy.context.scene.unit_settings.scale_length = 0.001
    bpy.context.view_layer.update()
    made = morph_of(first, second)
    for number, parent in enumerate((first, second)):
        set_weight(made, number, 1.0)
        assert mesh_points(made).tobytes() == mesh_points(parent).tobytes()
    assert_is_member(made)
