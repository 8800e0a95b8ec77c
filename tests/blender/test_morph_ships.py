# SPDX-License-Identifier: GPL-3.0-or-later
"""Families of ships of two layouts: numbers, lines in pairs, layers, flats."""

import itertools

import bpy
import numpy as np
import pytest
from addon_under_test import make_active, mesh_points, part, state_of
from expect_morph import assert_is_member, boxes, exact_member, morph_of, select, set_weight, ships

pytestmark = pytest.mark.once


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
    assert np.array_equal(own.data.deck_edge(), theirs.data.deck_edge())
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
    side, bottom = sorted(
        part("features.constraints.flats").regions(copy), key=lambda region: region.plane[2]
    )
    assert bottom.plane.tolist() == [0.0, 0.0, 1.0, 0.0] and len(bottom.faces) == 8
    assert side.plane == pytest.approx([0.0, 1.0, 0.0, 0.37 * 25.5 + 0.63 * 29.0], abs=1e-4)
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
        assert (own.address, other.address) == (first.as_pointer(), second.as_pointer())
        assert own.colour == other.colour == tuple(pair.colour)
    for line in shown:
        hull = next(one for one in (first, second) if one.as_pointer() == line.address)
        tree = part("bridge.native").require().SurfaceTree(state_of(hull).ship.surface)
        assert tree.closest_points(line.polylines[0]).distances.max() < 1e-6
    made.hull.morph.feature = made.hull.morph.features[2].name
    bpy.context.view_layer.update()
    chosen = state_of(made).of(lines_of.PairLines).lines
    assert len(chosen) == len(shown) + 1
    assert (chosen[-1].address, chosen[-1].colour) == (first.as_pointer(), (1.0, 1.0, 1.0))
    assert np.array_equal(chosen[-1].polylines, shown[2 * 2].polylines)
    made.hull.morph.feature = ""
    bpy.context.view_layer.update()
    overlay = part("overlays.morph_pairs")
    views = [
        type("Shown", (), {"hull": hull, "state": state_of(hull)})()
        for hull in (made, first, second)
    ]
    assert len(overlay.wanted(views)) == len(shown)
    first.name = "Renamed"
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
