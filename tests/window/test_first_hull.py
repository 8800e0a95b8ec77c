# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of docs/first-hull.md, by the keys it names."""

import bmesh
import bpy
import numpy as np
from addon_under_test import part, state_of
from editing import hull_at_hand, selected_indices
from expect import are_equal, assert_follows, edited_points, snapshot
from mathutils import Vector
from test_new_hull import TO_BEAM, TO_LENGTH, type_in_panel
from window import FROM_PORT


def a_new_hull(window):
    """Step 1: Add > Mesh > Ship Hull, then length and beam in the panel of the last operation."""
    window.move_to_middle()
    window.search("round bilge")
    yield
    yield from type_in_panel(window, TO_LENGTH, "72")
    yield from type_in_panel(window, TO_BEAM, "12.5")
    hull = hull_at_hand()
    settings = hull.hull
    assert (settings.length_pp, settings.beam) == (72.0, 12.5)
    assert_follows(hull)
    return hull


def test_a_first_hull(window):
    hull = yield from a_new_hull(window)

    # Step 2: a point at the side forward is moved athwartships.
    window.look(hull, FROM_PORT)
    window.press("TAB")
    window.press("A", alt=True)
    yield
    points = edited_points(hull)
    place = points.max(axis=0) * [0.75, 1.0, 0.5]
    index = int(np.linalg.norm(points - place, axis=1).argmin())
    window.move_to_point(hull, Vector(points[index].tolist()))
    window.click()
    yield
    assert selected_indices(hull) == [index]
    window.press("G")
    window.press("Y")
    window.write("0.25")
    window.press("RET")
    yield
    moved = edited_points(hull) - points
    assert abs(moved[index, 1] - 0.25) < 1e-5 and np.count_nonzero(moved) == 1
    assert_follows(hull)

    # Step 3: a knuckle along a row of edges, and smooth again.
    before = snapshot(hull)
    window.press("TWO")
    edge = edge_along(hull)
    window.move_to_point(hull, sum((v.co for v in edge.verts), Vector()) / 2.0)
    window.click(alt=True)
    yield
    assert len([e for e in bmesh.from_edit_mesh(hull.data).edges if e.select]) > 5
    window.pie("Q", -120, 0, shift=True)
    yield
    assert not are_equal(snapshot(hull), before)
    assert_follows(hull)
    window.pie("Q", 120, 0, shift=True)
    yield
    assert are_equal(snapshot(hull), before)

    # Steps 4 and 5: what the panels switch on, and a deeper draft.
    window.press("TAB")
    yield
    settings = hull.hull
    settings.fairness.colours, settings.fairness.comb_stations = "GAUSSIAN", True
    settings.plots.sectional_areas = True
    volume = state_of(hull).hydrostatics.values.displaced_volume
    settings.draft += 0.5
    yield
    yield lambda: part("features.analyses").last_outcome(
        hull, bpy.context.scene, "sectional_areas"
    )[1]
    assert state_of(hull).fairness.combs["station"].segments(1.0)[1] > 0
    assert state_of(hull).shown.colour_scale is not None
    assert state_of(hull).hydrostatics.values.displaced_volume > volume
    assert_follows(hull)


def edge_along(hull):
    """The edge of a row along the hull that is nearest to a place at the side."""
    place = Vector((0.5 * hull.dimensions.x, hull.dimensions.y, 0.4 * hull.dimensions.z))
    edges = [e for e in bmesh.from_edit_mesh(hull.data).edges if len(e.link_faces) == 2]
    along = [e for e in edges if abs(e.verts[0].co.x - e.verts[1].co.x) > 0.7 * e.calc_length()]
    return min(along, key=lambda e: ((e.verts[0].co + e.verts[1].co) / 2.0 - place).length)
