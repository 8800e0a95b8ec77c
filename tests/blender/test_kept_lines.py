# SPDX-License-Identifier: GPL-3.0-or-later
"""When a point moves, sections, combs and sectional areas that it does not reach are kept."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, lined_hull, part, state_of


@pytest.fixture
def hull():
    """A box of many faces in edit mode, with lines, combs and the sectional area curve."""
    hull = lined_hull()
    hull.hull.lines.station_count = 20
    hull.hull.fairness.comb_stations = hull.hull.fairness.comb_waterlines = True
    hull.hull.plots.sectional_areas = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide(number_cuts=10)
    bpy.context.view_layer.update()
    return hull


def pull_forward_end(hull):
    """Moves a point of the side near the forward end; within its box, so that the size stays."""
    bm = bmesh.from_edit_mesh(hull.data)
    side = (vertex for vertex in bm.verts if vertex.co.y == 2.0 and 1.0 < vertex.co.z < 1.5)
    vertex = min(side, key=lambda vertex: abs(vertex.co.x - 0.9 * LENGTH))
    vertex.co.y -= 0.2
    bmesh.update_edit_mesh(hull.data)
    bpy.context.view_layer.update()


def test_stations_and_their_combs_stay_where_nothing_moved(hull):
    before = state_of(hull)
    stations, combs = (
        before.lines.groups["station"].sections,
        before.fairness.combs["station"].sections,
    )
    pull_forward_end(hull)
    for old, new in (
        (stations, before.lines.groups["station"]),
        (combs, before.fairness.combs["station"]),
    ):
        kept = [a is b for a, b in zip(old, new.sections)]
        assert len(kept) == 21 and all(kept[:12]) and not any(kept[17:20])
    assert len(before.lines.groups["station"].sections) == 21


def test_waterlines_that_pass_by_the_point_are_cut_again(hull):
    before = state_of(hull).lines.groups["waterline"].sections
    pull_forward_end(hull)
    after = state_of(hull).lines.groups["waterline"].sections
    assert [section.cut for section in before] == [section.cut for section in after]
    assert any(a is not b for a, b in zip(before, after))


def test_only_areas_near_the_point_are_integrated_again(hull, monkeypatch):
    areas = part("features.curves_of_form.sectional_areas")
    counts, computed = [], areas._computed

    def counted(ship, stations, where):
        counts.append(len(stations))
        return computed(ship, stations, where)

    monkeypatch.setattr(areas, "_computed", counted)
    outcome_of = part("features.analyses").outcome_of
    outcome_of(hull, bpy.context.scene, "sectional_areas")
    counts.clear()
    pull_forward_end(hull)
    shown = outcome_of(hull, bpy.context.scene, "sectional_areas").result.areas
    assert len(counts) == 1 and 0 < counts[0] < len(shown.areas) / 2
    fresh = part("features.analyses").result_of(hull, bpy.context.scene, "sectional_areas").areas
    assert np.allclose(shown.areas, fresh.areas, rtol=0.0, atol=1e-7)


def test_lines_cut_for_the_view_are_not_cut_again_for_combs(hull, monkeypatch):
    moves, cut = part("bridge.mesh.moves").Moves, []
    sections = moves.sections

    def counted(own, surface, planes, *tolerances):
        cut.append(set(map(tuple, planes.tolist())))
        return sections(own, surface, planes, *tolerances)

    monkeypatch.setattr(moves, "sections", counted)
    pull_forward_end(hull)
    assert len(cut) == 1  # for the view
    hull.hull.lines.show_stations = False
    cut.clear()
    pull_forward_end(hull)
    of_view, of_combs = cut
    assert of_view and of_combs and not of_view & of_combs


def test_combs_are_judged_again_only_where_points_have_moved(hull):
    """To the last bit as of a fresh surface."""
    native = part("bridge.native").require()
    for _ in range(3):
        pull_forward_end(hull)
        state = state_of(hull)
        for group in state.fairness.combs.values():
            planes = np.array([one.cut.plane for one in group.sections])
            fresh = native.LimitSurface(state.ship.surface.mesh, state.ship.source.scheme)
            wanted = native.section_fairness(fresh, planes, **group.rules)
            for one, curves in zip(group.sections, wanted):
                for own, other in zip(one.curves, curves, strict=True):
                    assert np.array_equal(own.points, other.points)
                    assert np.array_equal(own.curvatures, other.curvatures)
                    assert np.array_equal(own.marks.points, other.marks.points)
