# SPDX-License-Identifier: GPL-3.0-or-later
"""Control curves: named chains of edges, each with its comb and smoothing, that last."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from addon_under_test import part, state_of
from edited_hulls import at, edit, grid_hull, keys, select, selected

pytestmark = pytest.mark.once

COLUMNS, ROWS = 9, 7


def line(j, columns=COLUMNS):
    return [(at(i, j, ROWS), at(i + 1, j, ROWS)) for i in range(columns - 1)]


def edges_of(hull, name):
    marks = part("bridge.mesh.curve_marks")
    return keys(marks.edges_of(hull.data, hull.hull.fairness.curves[name].number))


def shown(hull):
    group = state_of(hull).fairness.combs.get("row")
    return 0 if group is None else len(group.rows)


def with_two():
    """A hull in edit mode with the curves "chine", a whole row by one edge, and "sheer", a part."""
    hull = grid_hull(COLUMNS, ROWS)
    edit(hull, (False, True, False))
    select(hull, "edge", line(2)[3:4])
    assert bpy.ops.hull.add_curve(name="chine") == {"FINISHED"}
    select(hull, "edge", line(4)[:5])
    assert bpy.ops.hull.add_curve(name="sheer") == {"FINISHED"}
    return hull


def listed(hull):
    """Names of the curves that the list in the panel shows."""
    shows = bpy.types.HULL_UL_curves.filter_items
    view = SimpleNamespace(filter_name="", bitflag_filter_item=1)
    flags, _ = shows(view, bpy.context, hull.hull.fairness, "curves")
    return [curve.name for curve, flag in zip(hull.hull.fairness.curves, flags) if flag]


def test_curves_come_and_go_with_undo_in_edit_mode():
    """It is of the mesh alone there."""
    hull = with_two()
    edges = edges_of(hull, "chine")
    marks = part("bridge.mesh.curve_marks")
    scene = bpy.context.scene
    first = marks.numbered(hull.data)
    marks.give(hull.data, line(4)[:5], 0)  # as where adding it is undone
    assert listed(hull) == ["chine"]
    with pytest.raises(RuntimeError, match="Choose a curve"):
        bpy.ops.hull.select_curve()
    assert len(part("features.hull.hull_to_data").hull_data(hull, scene).curves) == 1
    marks.give(hull.data, line(4)[:5], 2)  # and done again
    assert listed(hull) == ["chine", "sheer"]
    hull.hull.fairness.active_curve = 0
    bpy.ops.hull.remove_curve()
    assert listed(hull) == ["sheer"] and hull.hull.fairness.active_curve == 1
    marks.give(hull.data, line(2), 1)  # as where that is undone
    assert listed(hull) == ["chine", "sheer"] and edges_of(hull, "chine") == edges
    assert sorted(first[1].tolist()) == sorted(marks.numbered(hull.data)[1].tolist())
    select(hull, "edge", line(3))
    marks.give(hull.data, line(2), 0)
    bpy.ops.hull.add_curve()
    assert listed(hull) == ["sheer", "Curve 3"]  # none gets the number of one that may come back


def test_undo_of_adding_and_removing_in_edit_mode():
    hull = with_two()
    bpy.ops.ed.undo_push(message="before")
    select(hull, "edge", line(3))
    bpy.ops.ed.undo_push(message="selected")
    bpy.ops.hull.add_curve(name="knuckle")
    bpy.ops.ed.undo_push(message="added")
    hull = bpy.context.object
    assert listed(hull) == ["chine", "sheer", "knuckle"]
    bpy.ops.ed.undo()
    assert listed(bpy.context.object) == ["chine", "sheer"]
    bpy.ops.ed.redo()
    hull = bpy.context.object
    assert listed(hull) == ["chine", "sheer", "knuckle"]
    hull.hull.fairness.active_curve = 1
    bpy.ops.hull.remove_curve()
    bpy.ops.ed.undo_push(message="removed")
    assert listed(bpy.context.object) == ["chine", "knuckle"]
    bpy.ops.ed.undo()
    hull = bpy.context.object
    assert listed(hull) == ["chine", "sheer", "knuckle"]
    assert edges_of(hull, "sheer") == keys(line(4)[:5])


def test_curves_have_names_switches_and_edges():
    hull = with_two()
    fairness = hull.hull.fairness
    assert [curve.name for curve in fairness.curves] == ["chine", "sheer"]
    assert edges_of(hull, "chine") == keys(line(2)) and edges_of(hull, "sheer") == keys(line(4)[:5])
    assert shown(hull) == 2
    fairness.curves["chine"].is_shown = False
    bpy.context.view_layer.update()
    assert shown(hull) == 1
    # Rows that are shown besides come and go without them.
    select(hull, "edge", line(3)[:1])
    bpy.ops.hull.show_rows()
    assert shown(hull) == 2
    fairness.curves["chine"].is_shown = True
    bpy.context.view_layer.update()
    assert shown(hull) == 3
    fairness.active_curve = 1
    bpy.ops.hull.select_curve()
    assert keys(selected(hull, "edge")) == keys(line(4)[:5])
    fairness.active_curve = 0
    bpy.ops.hull.select_curve(extend=True)
    assert keys(selected(hull, "edge")) == keys(line(4)[:5] + line(2))
    bpy.ops.hull.remove_curve()
    assert listed(hull) == ["sheer"] and shown(hull) == 2
    bpy.ops.object.mode_set(mode="OBJECT")
    assert edges_of(hull, "sheer") == keys(line(4)[:5])


def test_a_curve_is_faired_by_itself():
    hull = with_two()
    points = part("bridge.mesh.mesh_points")
    start = points.read(hull.data)
    dented = start.copy()
    dented[at(4, 2, ROWS), 1] -= 0.05
    dented[at(2, 4, ROWS), 1] -= 0.05
    points.write(hull.data, np.arange(len(dented)), dented)
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    dented = points.read(hull.data)
    hull.hull.fairness.active_curve = 0
    assert bpy.ops.hull.fair_curve(deviation_mm=20.0) == {"FINISHED"}
    moved = np.flatnonzero((points.read(hull.data) != dented).any(axis=1))
    assert len(moved) and set(moved) <= {at(i, 2, ROWS) for i in range(COLUMNS)}
    bpy.ops.object.mode_set(mode="OBJECT")


def test_curves_last_through_edits_copies_and_files(tmp_path):
    hull = with_two()
    select(hull, "edge", line(2)[:1])
    bpy.ops.mesh.subdivide(number_cuts=1)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(edges_of(hull, "chine")) == COLUMNS and len(edges_of(hull, "sheer")) == 5
    hull.hull.fairness.curves["sheer"].is_shown = False
    bpy.ops.object.duplicate()
    copy = bpy.context.view_layer.objects.active
    assert copy is not hull and [c.name for c in copy.hull.fairness.curves] == ["chine", "sheer"]
    assert len(edges_of(copy, "chine")) == COLUMNS
    data = part("features.hull.hull_to_data").hull_data(hull, bpy.context.scene)
    assert [(c.name, c.shown, len(c.edges)) for c in data.curves] == [
        ("chine", True, COLUMNS), ("sheer", False, 5)
    ]  # fmt: skip
    name = hull.name
    path = str(tmp_path / "curves.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    with bpy.data.libraries.load(path) as (there, wanted):
        wanted.objects = [name]
    loaded = wanted.objects[0]
    assert [c.name for c in loaded.hull.fairness.curves] == ["chine", "sheer"]
    assert len(edges_of(loaded, "chine")) == COLUMNS


def test_each_half_of_a_subdivided_edge_is_of_the_curve():
    hull = with_two()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    assert len(edges_of(hull, "chine")) == 2 * (COLUMNS - 1)
    assert len(edges_of(hull, "sheer")) == 10
    assert shown(hull) == 2


def test_hull_files_bring_them_back():
    hull = with_two()
    bpy.ops.object.mode_set(mode="OBJECT")
    curves = part("features.hull.curve_data")
    faces = [face.vertices[:] for face in hull.data.polygons]
    kept = curves.take_curves(hull, faces)
    other = grid_hull(COLUMNS, ROWS)
    curves.give_curves(other, kept)
    assert curves.take_curves(other, faces) == kept
    rows = part("bridge.mesh.row_marks")
    assert keys(rows.marked(other.data)) == keys(line(2) + line(4)[:5])
    # Edges that are not the shell's are left out.
    assert curves.take_curves(hull, faces[:0])[0].edges == []


def test_variants_in_hull_files_have_the_rows_that_were_shown(tmp_path):
    hull = with_two()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.keep_variant(name="as it was") == {"FINISHED"}
    path = str(tmp_path / "with.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    read = bpy.context.object
    assert read is not hull and read.hull.fairness.comb_rows
    marked = part("bridge.mesh.row_marks").marked
    wanted = keys(marked(hull.data))
    assert keys(marked(read.data)) == keys(marked(read.hull.variants.kept[0].mesh)) == wanted


def test_what_is_no_chain_is_refused():
    hull = grid_hull(COLUMNS, ROWS)
    edit(hull, (False, True, False))
    for words, edges in [
        ("Select the edges", []),
        ("branch", [*line(3), (at(4, 3, ROWS), at(4, 4, ROWS))]),
        ("are apart", line(3)[:2] + line(3)[4:6]),
    ]:
        select(hull, "edge", edges)
        with pytest.raises(RuntimeError, match=words):
            bpy.ops.hull.add_curve()
    for operator in (bpy.ops.hull.select_curve, bpy.ops.hull.remove_curve, bpy.ops.hull.fair_curve):
        with pytest.raises(RuntimeError, match="Choose a curve of the list"):
            operator()
    assert not len(hull.hull.fairness.curves)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_joined_hulls_keep_the_curves_of_both():
    first, second = with_two(), None
    bpy.ops.object.mode_set(mode="OBJECT")
    second = with_two()
    bpy.ops.object.mode_set(mode="OBJECT")
    curves = second.hull.fairness.curves
    curves[0].name, curves[1].name, curves[1].is_shown = "tangent", "rail", False
    for vertex in second.data.vertices:
        vertex.co.z += 20.0
    second.data.update()
    second.update_tag(refresh={"DATA"})
    bpy.context.view_layer.update()
    count = len(first.data.vertices)
    second.select_set(True)
    bpy.context.view_layer.objects.active = first
    first.select_set(True)
    bpy.ops.object.join()
    bpy.context.view_layer.update()
    assert listed(first) == ["chine", "sheer", "tangent", "rail"]
    moved = np.array(line(4)[:5]) + count
    assert edges_of(first, "sheer") == keys(line(4)[:5]) and edges_of(first, "rail") == keys(moved)
    assert [curve.is_shown for curve in first.hull.fairness.curves] == [True, True, True, False]


def test_read_hulls_have_curves_of_their_own(tmp_path):
    hull = with_two()
    bpy.ops.object.mode_set(mode="OBJECT")
    path = str(tmp_path / "after.hull.json")
    assert bpy.ops.hull.export_hull(filepath=path) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=path) == {"FINISHED"}
    again = bpy.context.object
    assert again != hull and listed(again) == listed(hull) == ["chine", "sheer"]
    numbers = [{curve.number for curve in one.hull.fairness.curves} for one in (hull, again)]
    assert not numbers[0] & numbers[1]
