# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools that change a form by numbers, on foreign hulls and on copies of them as other programs
might have left them: each does what it says, or refuses in one sentence and leaves the hull as it
is.

HULL_ALL_COPIES=1 tries all hulls with all copies, not one of each small one.
"""

import os

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import SHARED, hull_io, make_active, mesh_points, part, state_of
from test_hulls_of_others import hulls_of_others

pytestmark = pytest.mark.once

FOLDER = SHARED / "hulls" / "freeship"
ALL = os.environ.get("HULL_ALL_COPIES") == "1"
MOST_POINTS = 10**9 if ALL else 150
KINDS = ("as read", "noise", "to starboard", "refined")
SEED = 1723


def copy_of(path, kind):
    data = hull_io().read_hull(path)
    if kind == "noise":
        return hulls_of_others.noisy(data, 1e-6, SEED)
    return hulls_of_others.to_starboard(data) if kind == "to starboard" else data


def pairs():
    paths = sorted(FOLDER.glob("*.f[bt]m"))
    small = [path for path in paths if len(hull_io().read_hull(path).points) <= MOST_POINTS]
    for name, kind in hulls_of_others.chosen([path.name for path in small], KINDS, 0 if ALL else 1):
        yield pytest.param((FOLDER / name, kind), id=f"{name}-{kind}")


@pytest.fixture(params=pairs())
def hull(request):
    path, kind = request.param
    scene = bpy.context.scene
    made = part("features.exchange.hull_files").hull_object(
        copy_of(path, kind), scene, scene.collection
    )
    make_active(made)
    if kind == "refined":
        assert bpy.ops.hull.subdivide_exactly() == {"FINISHED"}
    yield bpy.context.object
    part("features.conversion.conversions").stop()


def works_or_refuses(action):
    """Whether it works; a refusal is one sentence, and the hull is as it was."""
    before = mesh_points(bpy.context.object)
    try:
        action()
    except RuntimeError as error:
        text = str(error).removeprefix("Error: ").strip()
        assert text and "Traceback" not in text and "\n" not in text, text
        bpy.ops.object.mode_set(mode="OBJECT")
        assert np.array_equal(mesh_points(bpy.context.object), before)
        return False
    bpy.ops.object.mode_set(mode="OBJECT")
    assert np.isfinite(mesh_points(bpy.context.object)).all()
    return True


def values():
    return state_of(bpy.context.object).hydrostatics.values


def test_dimensions_and_shifts(hull):
    settings, before = hull.hull, values()
    length = 1.05 * settings.length_pp
    assert works_or_refuses(lambda: bpy.ops.hull.set_dimensions(length=length))
    assert hull.hull.length_pp == pytest.approx(length, rel=1e-6)
    if before is None:
        with pytest.raises(RuntimeError):
            bpy.ops.hull.shift_sections(measure="BLOCK", block=0.5)
        return
    block, lcb = 1.005 * before.project_block, before.lcb_percent + 0.1
    if works_or_refuses(
        lambda: bpy.ops.hull.shift_sections(
            measure="BLOCK", block=block, lcb_as="PERCENT", lcb_percent=lcb
        )
    ):
        assert values().project_block == pytest.approx(block, rel=1e-5)
        assert values().lcb_percent == pytest.approx(lcb, abs=1e-3)


def test_targets_and_area_curves(hull):
    before = values()

    def solve():
        bpy.ops.hull.add_target()
        row = hull.hull.targets.rows[-1]
        row.quantity, row.value = "VOLUME", 1.01 * before.displaced_volume if before else 1.0
        bpy.ops.hull.solve_targets()

    if works_or_refuses(solve) and part("features.targets.reports").last_report(hull)[0].is_met:
        assert values().displaced_volume == pytest.approx(1.01 * before.displaced_volume, rel=1e-5)

    def match():
        bpy.ops.hull.take_area_curve()
        points = hull.hull.area_target.area_points
        points[len(points) // 2].area *= 1.01
        bpy.ops.hull.transform_to_area_curve(by="INFLATE")

    works_or_refuses(match)


def choose_around_a_point():
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(bpy.context.object.data)
    inner = [vertex for vertex in bm.verts if vertex.link_faces and not vertex.is_boundary]
    middle = inner[len(inner) // 2]
    for vertex in (middle, *(edge.other_vert(middle) for edge in middle.link_edges)):
        vertex.select = True
    bm.select_flush_mode()
    bmesh.update_edit_mesh(bpy.context.object.data)


def choose_an_edge():
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(bpy.context.object.data)
    sizes = ([len(face.verts) for face in edge.link_faces] for edge in bm.edges)
    next(edge for edge, found in zip(bm.edges, sizes) if found == [4, 4]).select = True
    bm.select_mode = {"EDGE"}
    bm.select_flush_mode()
    bmesh.update_edit_mesh(bpy.context.object.data)
    bpy.context.tool_settings.mesh_select_mode = (False, True, False)


def test_fairing_and_rows(hull):
    choose_around_a_point()
    # Edit mode has put points on the centre plane that were beside it by noise.
    bpy.ops.object.mode_set(mode="OBJECT")

    def fair():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.hull.fair_region(deviation_mm=hull.hull.beam)

    works_or_refuses(fair)
    count, said = len(hull.data.vertices), state_of(hull).status

    def insert():
        choose_an_edge()
        bpy.ops.hull.insert_row()

    try:
        insert()
    except RuntimeError as error:
        assert "Traceback" not in str(error)
    bpy.ops.object.mode_set(mode="OBJECT")
    assert len(bpy.context.object.data.vertices) >= count
    assert state_of(bpy.context.object).status == said


def test_variants_and_files(hull, tmp_path):
    before = mesh_points(hull)
    assert bpy.ops.hull.keep_variant(name="as read") == {"FINISHED"}
    assert bpy.ops.hull.set_dimensions(beam=1.02 * hull.hull.beam) == {"FINISHED"}
    path = tmp_path / "foreign.hull.json"
    assert bpy.ops.hull.export_hull(filepath=str(path)) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    again = bpy.context.object
    assert [entry.name for entry in again.hull.variants.kept] == ["as read"]
    assert bpy.ops.hull.go_back_to_variant(variant="as read") == {"FINISHED"}
    assert np.array_equal(mesh_points(bpy.context.object), before)
