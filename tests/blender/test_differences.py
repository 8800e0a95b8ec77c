# SPDX-License-Identifier: GPL-3.0-or-later
"""Differences between a hull and another one, in numbers and in colours, follow both."""

import csv
import math

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, compute, make_active, part, state_of
from edited_hulls import edit
from test_panels import texts


def result_of(hull, name="differences"):
    return part("features.analyses").result_of(hull, bpy.context.scene, name)


def afloat_box(draft=1.0):
    hull = add_hull()
    hull.hull.length_pp, hull.hull.draft = 10.0, draft
    bpy.context.view_layer.update()
    return hull


def wider_box():
    """Half a metre wider than its variant on each side, and half a metre deeper in the water."""
    hull = afloat_box()
    bpy.ops.hull.keep_variant(name="narrow")
    stretch(hull, 1, 1.25)
    hull.hull.draft = 1.5
    bpy.context.view_layer.update()
    return hull


def stretch(hull, axis, factor):
    for vertex in hull.data.vertices:
        vertex.co[axis] *= factor
    hull.data.update()
    bpy.context.view_layer.update()


def test_differences_of_boxes():
    hull = wider_box()
    found = result_of(hull).by
    own, same = found["OWN"].rows, found["SAME"].rows
    assert own["displaced_volume"].value == pytest.approx(75.0)
    assert own["displaced_volume"].difference == pytest.approx(35.0)
    assert own["displaced_volume"].percent == pytest.approx(87.5)
    assert same["displaced_volume"].difference == pytest.approx(15.0)
    assert same["displaced_volume"].percent == pytest.approx(25.0)
    assert own["kb"].difference == pytest.approx(0.25) and abs(same["kb"].difference) < 1e-9
    assert own["tcb"].percent is None and own["lcb"].percent == pytest.approx(0.0, abs=1e-9)
    assert found["OWN"].areas.largest == pytest.approx(3.5)
    assert found["SAME"].areas.largest == pytest.approx(1.5)


def test_they_are_those_of_both_hulls_own_panels():
    hull = wider_box()
    hull.hull.trim_m = hull.hull.variants.kept[0].trim_m = 0.2
    bpy.context.view_layer.update()
    rows = result_of(hull).by["OWN"].rows
    bpy.ops.hull.duplicate_variant()
    other = bpy.context.object
    quantities = part("features.flotation.hydrostatics").QUANTITIES
    here, there = (state_of(one).hydrostatics.values for one in (hull, other))
    for quantity in quantities:
        value, beside = getattr(here, quantity.name), getattr(there, quantity.name)
        row = rows[quantity.name]
        if None in (value, beside):
            assert row.difference is None
        else:
            # Live numbers are to 1e-8 of the whole.
            assert row.difference == pytest.approx(value - beside, rel=1e-6, abs=1e-6)
    make_active(hull)
    hull.hull.variants.compared_with, hull.hull.variants.other_hull = "HULL", other
    again = result_of(hull).by["OWN"].rows
    assert {k: r.difference for k, r in again.items()} == {k: r.difference for k, r in rows.items()}


def test_a_variant_has_the_appendages_of_the_hull():
    """It differs by its form alone."""
    hull = afloat_box()
    bpy.ops.hull.add_appendage(kind="TUNNEL", x=7.0, z=0.5, radius=0.3)
    bpy.context.view_layer.update()
    make_active(hull)
    bpy.ops.hull.keep_variant(name="as it is")
    volume = state_of(hull).hydrostatics.values.displaced_volume
    assert volume == pytest.approx(40.0 - math.pi * 0.3**2 * 4.0, rel=1e-6)  # the tunnel counts
    rows = result_of(hull).by["SAME"].rows
    assert abs(rows["displaced_volume"].difference) < 1e-6 * volume


def test_tables(tmp_path):
    hull = wider_box()
    hull.hull.lines.stations = "0.5 5"
    tables = {}
    for name in ("differences", "area_differences"):
        path = tmp_path / f"{name}.csv"
        assert bpy.ops.hull.export_table(analysis=name, filepath=str(path)) == {"FINISHED"}
        with open(path, newline="", encoding="utf-8-sig") as stream:
            tables[name] = list(csv.reader(stream))
    head, *rows = tables["differences"]
    assert head[:4] == [
        "quantity",
        "unit",
        "this hull [see unit]",
        "other hull, own draft [see unit]",
    ]
    volume = next(row for row in rows if row[0] == "displaced volume")
    assert [float(cell) for cell in volume[2:-1]] == pytest.approx([75, 40, 35, 87.5, 60, 15, 25])
    head, *rows = tables["area_differences"]
    assert [[float(cell) for cell in row] for row in rows] == [
        pytest.approx([x, 7.5, 4.0, 3.5, 6.0, 1.5]) for x in (0.5, 5.0)
    ]


def test_what_cannot_be_compared_says_why():
    hull = afloat_box()
    for name in ("differences", "area_differences"):
        with pytest.raises(ValueError, match="Keep the hull as a variant first"):
            result_of(hull, name)
    bpy.ops.hull.keep_variant(name="dry")
    hull.hull.variants.kept[0].draft = -1.0
    found = result_of(hull).by
    assert found["OWN"].message.startswith("dry: Nothing is under water") and not found["OWN"].rows
    assert found["SAME"].rows["displaced_volume"].difference == 0.0
    header, rows = (getattr(part("features.variants.differences"), n) for n in ("header", "rows"))
    assert all(len(row) == len(header(result_of(hull))) for row in rows(result_of(hull)))


def test_the_panel_tells_them():
    hull = wider_box()
    compute([(hull.name, "differences")])
    said = texts()["HULL_PT_differences"]
    assert said[said.index("∇") + 1] == "+35.000 m³  +87.50 %"
    assert said[said.index("Area, most") + 1] == "+3.500 m²"
    hull.hull.variants.afloat = "SAME"
    said = texts()["HULL_PT_differences"]
    assert said[said.index("∇") + 1] == "+15.000 m³  +25.00 %"
    hull.hull.variants.kept[0].draft = -1.0
    hull.hull.variants.afloat = "OWN"
    bpy.context.view_layer.update()
    compute([(hull.name, "differences")])
    assert any("Nothing is under water" in text for text in texts()["HULL_PT_differences"])


def coloured():
    hull = wider_box()
    hull.hull.fairness.colours = "DISTANCE"
    bpy.context.view_layer.update()
    return hull


def colours_of(hull):
    shown = part("bridge.objects.shown_objects").surface_of(hull)
    attribute = shown.data.color_attributes.get("Hull colours")
    if attribute is None:
        return None
    values = np.empty(4 * len(shown.data.loops), dtype=np.float32)
    attribute.data.foreach_get("color", values)
    return values.reshape(-1, 4)[:, :3]


def test_distances_colour_the_surface():
    hull = coloured()
    found = state_of(hull).shown.distances
    assert found.outwards == pytest.approx(0.5, abs=1e-9) and found.inwards is None
    assert state_of(hull).shown.colour_scale.unit == "mm"
    assert len(np.unique(colours_of(hull).round(3), axis=0)) > 3
    assert "+0.5" not in texts()["HULL_PT_distances"]
    said = texts()["HULL_PT_distances"]
    assert said[said.index("Outside") + 1] == "0.500 m"
    assert said[said.index("Inside") + 1] == "–"
    hull.hull.fairness.colours = "NONE"
    bpy.context.view_layer.update()
    assert colours_of(hull) is None and state_of(hull).shown.distances is None


def test_distances_follow_both_hulls():
    hull, other = coloured(), None
    stretch(hull, 1, 1.2)
    assert state_of(hull).shown.distances.outwards == pytest.approx(1.0, abs=1e-6)
    bpy.ops.hull.duplicate_variant()
    other = bpy.context.object
    hull.hull.variants.compared_with, hull.hull.variants.other_hull = "HULL", other
    stretch(other, 1, 2.0)
    found = state_of(hull).shown.distances
    assert found.inwards == pytest.approx(-1.0, abs=1e-6) and found.outwards is None
    bpy.ops.object.delete()
    bpy.context.view_layer.update()
    assert state_of(hull).shown.distances is None and colours_of(hull) is None
    make_active(hull)
    assert any("in no scene" in text for text in texts()["HULL_PT_distances"])


def test_while_points_move_the_colours_wait_for_the_pause():
    hull = coloured()
    shown = state_of(hull).shown
    bm = edit(hull)
    before, counted = shown.distances, []
    following = part("features.variants.following")
    ask, following.ask = following.ask, lambda after: counted.append(1)
    try:
        for vertex in bm.verts:
            vertex.co.y *= 1.1
        bmesh.update_edit_mesh(hull.data)
        bpy.context.view_layer.update()
        assert counted and shown.distances is before
    finally:
        following.ask = ask
    part("features.variants.distances").follow(hull, bpy.context.scene, state_of(hull))
    assert shown.distances.outwards == pytest.approx(0.75, abs=1e-6)


def test_limit_is_in_the_legends_unit():
    hull = coloured()
    hull.hull.fairness.colour_limit = 250.0
    bpy.context.view_layer.update()
    assert state_of(hull).shown.colour_scale.high == pytest.approx(0.25)
    legend = part("overlays.legend").legend_of(hull)
    assert legend.unit == "mm" and legend.title == "Distance"


@pytest.mark.parametrize("scale", [0.01, 0.3048])
def test_distances_are_metres_in_any_unit(scale):
    bpy.context.scene.unit_settings.scale_length = scale
    hull = coloured()
    assert state_of(hull).shown.distances.outwards == pytest.approx(0.5 * scale, rel=1e-6)
