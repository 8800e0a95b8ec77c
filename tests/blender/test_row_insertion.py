# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of control points inserted: the surface stays nearly as it is, and so do tags."""

import re

import bpy
import numpy as np
import pytest
from addon_under_test import ROOT, part, state_of
from edited_hulls import edit, select


def new_hull():
    bpy.ops.hull.add_hull(kind="ROUND_BILGE", length=80.0, beam=13.0, draft=5.0, depth=7.0)
    return bpy.context.view_layer.objects.active


def edge_at(hull, place):
    """The edge along the ship whose middle is nearest to a place."""
    points = part("bridge.mesh.mesh_points").read(hull.data)
    edges = np.array([edge.vertices[:] for edge in hull.data.edges])
    along = np.abs(np.diff(points[edges], axis=1)[:, 0, 0]) > 1.0
    distances = np.linalg.norm(points[edges].mean(axis=1) - place, axis=1)
    return edges[np.argmin(np.where(along, distances, np.inf))].tolist()


def insert(hull, *edges):
    edit(hull, (False, True, False))
    select(hull, "edge", edges)
    found = part("features.modelling.row_insertion").insert_rows(hull, bpy.context.scene)
    bpy.ops.object.mode_set(mode="OBJECT")
    return found


@pytest.mark.parametrize("place", [(64.0, 5.0, 3.0), (8.0, 6.0, 3.0), (38.0, 6.0, 3.0)])
def test_the_surface_stays_nearly(place):
    hull = new_hull()
    old = state_of(hull).ship.source.new_surface()
    volume, count = state_of(hull).hydrostatics.values.displaced_volume, len(hull.data.vertices)
    found = insert(hull, edge_at(hull, place))
    state = state_of(hull)
    assert not state.status and len(hull.data.vertices) == count + found.count > count
    points = state.ship.surface.tessellate(7).points
    native = part("bridge.native").require()
    distance = native.SurfaceTree(old).closest_points(points).distances.max()
    assert distance == pytest.approx(found.change, rel=0.2)
    assert found.change < min(3e-3, found.cut_change)
    assert found.cut_change < 10e-3 or found.change < 0.05 * found.cut_change
    assert abs(state.hydrostatics.values.displaced_volume - volume) < 0.1


def surface_changes(old, volume, hull):
    """(mm, m³) by how much a hull's surface and displacement are others than a surface of before
    and its volume."""
    state = state_of(hull)
    tree = part("bridge.native").require().SurfaceTree(old)
    distances = tree.closest_points(state.ship.surface.tessellate(7).points).distances
    changed = state.hydrostatics.values.displaced_volume - volume
    return 1e3 * distances.max(), abs(changed)


def new_rows(edge):
    """What a row across an edge changes on the new hull of the docs, (mm, m³): by Insert Row, and
    by Blender's loop cut."""
    for is_cut in (False, True):
        assert bpy.ops.hull.add_hull() == {"FINISHED"}
        hull = bpy.context.view_layer.objects.active
        old = state_of(hull).ship.source.new_surface()
        volume = state_of(hull).hydrostatics.values.displaced_volume
        if not is_cut:
            insert(hull, edge)
        else:
            edit(hull, (False, True, False))
            select(hull, "edge", [edge])
            bpy.ops.mesh.loop_multi_select(ring=True)
            bpy.ops.mesh.subdivide_edgering(number_cuts=1, interpolation="LINEAR", smoothness=0.0)
            bpy.ops.object.mode_set(mode="OBJECT")
            bpy.context.view_layer.update()
        yield surface_changes(old, volume, hull)


def test_the_docs_tell_what_rows_change():
    text = " ".join((ROOT / "docs/first-hull.md").read_text(encoding="utf-8").split())
    most = float(re.search(r"but for at most (\d+) mm that the message tells", text).group(1))
    quoted = re.search(
        r"by ([\d.]+) mm and ([\d.]+) m³ at x = (\d+) m, where \*Insert Row\* changes it by "
        r"([\d.]+) mm and ([\d.]+) m³, and by ([\d.]+) mm at x = (\d+) m, where that changes it by "
        r"([\d.]+) mm",
        text,
    )
    cut, cut_volume, x, row, row_volume, worst_cut, worst_x, worst_row = map(float, quoted.groups())
    bpy.ops.hull.add_hull()
    hull = bpy.context.view_layer.objects.active
    assert hull.hull.length_pp == 80.0
    for at, numbers in ((x, (row, row_volume, cut, cut_volume)), (worst_x, (worst_row, worst_cut))):
        (inserted, by_row), (looped, by_cut) = new_rows(edge_at(hull, (at, 1.0, 0.5)))
        found = (inserted, by_row, looped, by_cut) if at == x else (inserted, looped)
        for value, told in zip(found, numbers):
            assert told == pytest.approx(value, rel=0.03, abs=2e-3)
    rows = {}
    points = part("bridge.mesh.mesh_points").read(hull.data)
    for edge in hull.data.edges:
        ends = points[list(edge.vertices)]
        if abs(ends[0, 0] - ends[1, 0]) > 1.0 and (ends[:, 1] > 0.5).all():
            rows.setdefault(round(float(ends[:, 0].mean()) / 3.0), list(edge.vertices))
    assert len(rows) >= 12
    for edge in rows.values():
        inserted, _ = next(new_rows(edge))
        assert inserted <= most and inserted < worst_row + 0.05


def test_the_docs_send_nobody_to_ctrl_r_without_a_warning():
    for path in sorted((ROOT / "docs").rglob("*.md")):
        for paragraph in path.read_text(encoding="utf-8").split("\n\n"):
            if re.search(r"Ctrl R\b", paragraph):
                assert "Insert Row" in paragraph, f"{path.name}: {paragraph}"


def test_rows_may_cross():
    hull = new_hull()
    points = part("bridge.mesh.mesh_points").read(hull.data)
    along = edge_at(hull, (38.0, 6.0, 3.0))
    edges = [edge.vertices[:] for edge in hull.data.edges]
    across = next(
        edge
        for edge in edges
        if along[0] in edge and abs(points[edge[0], 0] - points[edge[1], 0]) < 1e-3
    )
    before = len(hull.data.vertices)
    found = insert(hull, along, list(across))
    assert len(hull.data.vertices) == before + found.count and not state_of(hull).status


def test_locked_points_and_flats_stay():
    bpy.ops.hull.load_sample(name="bulk_carrier")
    hull = bpy.context.view_layer.objects.active
    middle = 0.5 * max(hull.dimensions)
    insert(hull, edge_at(hull, (middle, 0.4 * hull.dimensions[1], 0.5 * hull.hull.draft)))
    flats = part("features.constraints.flats")
    points = part("bridge.mesh.mesh_points").read(hull.data)
    for indices, plane in flats.flat_planes(hull):
        off = points[np.array(indices)] @ np.array(plane[:3]) - plane[3]
        assert np.abs(off).max() < 1e-4


def test_what_is_missing_is_said():
    hull = new_hull()
    edit(hull, (False, True, False))
    with pytest.raises(RuntimeError, match="Select an edge"):
        bpy.ops.hull.insert_row()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_so_many_points_that_it_would_take_long_are_refused():
    hull = new_hull()
    bpy.ops.hull.subdivide_exactly()
    before = part("bridge.mesh.mesh_points").read(hull.data).tobytes()
    edit(hull, (False, True, False))
    bpy.ops.mesh.select_all(action="SELECT")
    with pytest.raises(RuntimeError, match="more than 200 points: .* Subdivide Exactly"):
        bpy.ops.hull.insert_row()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert part("bridge.mesh.mesh_points").read(hull.data).tobytes() == before
