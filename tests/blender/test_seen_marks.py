# SPDX-License-Identifier: GPL-3.0-or-later
"""Count Marks: what hull_fairness finds on the surface is told, shown and accepted."""

import importlib

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, mesh_points, module_name, part, state_of
from edited_hulls import at, edit, grid_hull, selected


def seen():
    return part("features.fairing.seen_marks")


def counted(hull):
    assert bpy.ops.hull.count_marks() == {"FINISHED"}
    report, is_current = seen().last_report(hull)
    assert is_current
    return report


def test_marks_are_counted_shown_and_accepted():
    hull = grid_hull(9, 7)
    points = mesh_points(hull)
    first = counted(hull)
    judging = importlib.import_module(f"{module_name()}.hull_fairness.lines")
    beam = 2.0 * np.abs(points[:, 1]).max()
    own = judging.judged(state_of(hull).ship.surface, beam)
    assert first.counts == {
        mark: count
        for mark in seen().NAMES
        if (count := sum(found.mark == mark for line in own for found in line.found))
    }
    assert first.before is None and first.least == pytest.approx(2e-4 * beam)

    # All that is there is meant: what is counted then is new.
    assert bpy.ops.hull.accept_marks(all=True) == {"FINISHED"}
    report, _ = seen().last_report(hull)
    assert not report.places and report.accepted == len(first.places)
    with pytest.raises(RuntimeError, match="no marks but accepted"):
        bpy.ops.hull.show_mark()
    edit(hull)
    place = points[at(4, 3, 7)]
    part("bridge.mesh.mesh_points").write(hull.data, [at(4, 3, 7)], [place - (0.0, 0.3, 0.0)])
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    assert not seen().last_report(hull)[1]
    dented = counted(hull)
    assert dented.before == {} and dented.counts["inflection"] > 4
    rows = dict(seen().rows(dented))
    assert rows["Inflections"] == f"0 → {dented.counts['inflection']}"

    assert bpy.ops.hull.show_mark() == {"FINISHED"}
    number, (line, found) = seen().shown_place(hull)
    assert number == 0 and len(selected(hull, "vertex")) in (3, 4)
    np.testing.assert_allclose(bpy.context.scene.cursor.location, found.point, atol=1e-4)
    bpy.ops.hull.show_mark(step=-1)
    assert seen().shown_place(hull)[0] == len(dented.places) - 1
    bpy.ops.hull.accept_marks()
    assert len(seen().last_report(hull)[0].places) < len(dented.places)
    bpy.ops.hull.accept_no_marks()
    assert len(seen().last_report(hull)[0].places) >= len(first.places)
    bpy.ops.object.mode_set(mode="OBJECT")


def test_nothing_is_shown_before_it_is_counted():
    add_hull()
    with pytest.raises(RuntimeError, match="press Count Marks first"):
        bpy.ops.hull.show_mark()
    with pytest.raises(RuntimeError, match="press Count Marks first"):
        bpy.ops.hull.accept_marks(all=True)


def form_before():
    return part("features.hull.form_before")


@pytest.mark.parametrize("change", ["shift_sections", "inflate_section", "solve_targets"])
def test_what_changes_the_form_keeps_the_form_before(change):
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.view_layer.objects.active
    with pytest.raises(RuntimeError, match="transform it first"):
        bpy.ops.hull.count_marks(compare=True)
    before = mesh_points(hull)
    if change == "shift_sections":
        bpy.ops.hull.shift_sections(measure="BLOCK", block=0.74, lcb_as="NONE")
    elif change == "inflate_section":
        bpy.ops.hull.inflate_section(place=40.0, percent=2.0, extent=20.0)
    else:
        bpy.ops.hull.add_target()
        hull.hull.targets.rows[0].value *= 1.01
        bpy.ops.hull.solve_targets()
    assert not np.array_equal(mesh_points(hull), before)
    assert np.array_equal(form_before().of_hull(hull).mesh.points, before)


def test_what_undo_brings_back_is_compared_with_what_was_before_that():
    bpy.ops.hull.load_sample(name="coaster")
    hull, scene = bpy.context.view_layer.objects.active, bpy.context.scene
    forms = [mesh_points(hull)]
    for block in (0.74, 0.745):
        bpy.ops.hull.shift_sections(measure="BLOCK", block=block, lcb_as="NONE")
        forms.append(mesh_points(hull))

    def back_to(number):
        part("bridge.mesh.mesh_points").write(hull.data, np.arange(len(forms[0])), forms[number])
        part("features.hull.hull_state").follow_edit(hull, scene)

    for number in (1, 2):
        back_to(number)
        assert np.array_equal(form_before().of_hull(hull).mesh.points, forms[number - 1])
    back_to(0)
    assert not form_before().is_known(hull)
    bpy.ops.hull.shift_sections(measure="BLOCK", block=0.73, lcb_as="NONE")
    assert np.array_equal(form_before().of_hull(hull).mesh.points, forms[0])


def test_new_marks_are_told_from_those_of_the_form_before():
    hull = grid_hull(5, 5)
    form_before().note(hull, state_of(hull).ship.source.new_surface())
    edit(hull)
    place = mesh_points(hull)[at(2, 2, 5)]
    part("bridge.mesh.mesh_points").write(hull.data, [at(2, 2, 5)], [place - (0.0, 0.4, 0.0)])
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    assert bpy.ops.hull.count_marks(compare=True) == {"FINISHED"}
    report, is_current = seen().last_report(hull)
    assert is_current and report.new_count > 0
    assert all(map(report.is_new, report.places[: report.new_count]))
    assert dict(seen().rows(report))[seen().CHANGE] == seen().change_text(report)
    assert seen().change_text(report).startswith(f"{report.new_count} new, ")
    # What is accepted is new no longer.
    new_count = report.new_count
    bpy.ops.hull.show_mark(step=1)
    bpy.ops.hull.accept_marks()
    assert seen().last_report(hull)[0].new_count < new_count

    # Of another mesh no mark has a place on the form before.
    bpy.ops.object.mode_set(mode="OBJECT")
    assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    with pytest.raises(RuntimeError, match="mesh itself was changed"):
        bpy.ops.hull.count_marks(compare=True)


def test_marks_of_a_hull_renamed_meanwhile_are_its_own():
    hull = add_hull()
    as_it_was = part("features.hull.as_it_was").AsItWas(hull, bpy.context.scene, "count again")
    hull.name = "Another name"
    other = add_hull()
    other.name = "Hull"
    assert as_it_was.checked(bpy.context.scene) == hull
    bpy.data.objects.remove(hull)
    assert part("features.hull.hull_state").hull_with(as_it_was.state, bpy.context.scene) is None
    with pytest.raises(ValueError, match="changed meanwhile"):
        as_it_was.checked(bpy.context.scene)
