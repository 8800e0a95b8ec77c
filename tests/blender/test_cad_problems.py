# SPDX-License-Identifier: GPL-3.0-or-later
"""What keeps STEP and IGES files from being written is named, selected and has a button; what was
probably not meant is a warning."""

import bpy
import pytest
from addon_under_test import add_hull, part, state_of
from test_panels import texts

FILES = [("STEP", "ship.step"), ("IGES", "ship.igs")]


def export(file_format, path):
    return getattr(bpy.ops.hull, f"export_{file_format.lower()}")(filepath=str(path))


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()


def test_what_keeps_a_file_from_being_written_is_selected(tmp_path):
    """Away from the centre plane, and with a corner of its deck raised, the half has a border
    neither flat nor symmetric."""
    hull = add_hull()
    hull.hull.half = False
    for vertex in hull.data.vertices:
        vertex.co.y += 1.0
    max(hull.data.vertices, key=lambda vertex: sum(vertex.co)).co.z += 0.5
    hull.data.update()
    hull.hull.export.extent = "SOLID"
    with pytest.raises(
        RuntimeError, match=r"neither flat nor symmetric.*\(face \d+ of the control"
    ):
        export("STEP", tmp_path / "box.step")
    assert not list(tmp_path.iterdir())
    problem = part("features.exchange.cad_files").problem_of(hull)
    assert bpy.ops.hull.select_cad_problem() == {"FINISHED"}
    assert hull.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [face.index for face in hull.data.polygons if face.select] == list(problem.elements)
    # Of another hull than was refused there is nothing to select.
    hull.data.vertices[0].co.z -= 0.1
    hull.data.update()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert part("features.exchange.cad_files").problem_of(hull) is None
    with pytest.raises(RuntimeError, match="no longer there"):
        bpy.ops.hull.select_cad_problem()


def with_a_point_beside_the_centre_plane(distance):
    """The coaster with one point of her keel so far, in parts of her size, off the centre plane;
    returns the hull and the point's index."""
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.object
    on_line = [vertex for vertex in hull.data.vertices if vertex.co.y == 0.0]
    point = min(on_line, key=lambda vertex: abs(vertex.co.x - 40.0) + abs(vertex.co.z))
    point.co.y = distance * state_of(hull).ship.surface.mesh.size
    hull.data.update()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    return hull, point.index


@pytest.mark.parametrize("file_format, name", FILES)
def test_points_beside_the_centre_plane_are_selected_and_put_there(tmp_path, file_format, name):
    hull, index = with_a_point_beside_the_centre_plane(1e-5)
    with pytest.raises(RuntimeError, match="use Put on Centre Plane, or set y to 0 there"):
        export(file_format, tmp_path / name)
    assert not list(tmp_path.iterdir())
    # The button is below the message, in the panel "Export".
    assert bpy.ops.hull.put_on_centre_plane.get_rna_type().name == "Put on Centre Plane"
    buttons = ["operator hull.select_cad_problem", "operator hull.put_on_centre_plane"]
    assert texts()["HULL_PT_export"][-2:] == buttons
    assert bpy.ops.hull.select_cad_problem() == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    assert [vertex.index for vertex in hull.data.vertices if vertex.select] == [index]
    assert bpy.ops.hull.put_on_centre_plane() == {"FINISHED"}
    export(file_format, tmp_path / name)
    read = part("bridge.native").require().read_cad_report(tmp_path / name)
    assert read["valid"] and read["shells"] == 1


@pytest.mark.parametrize("file_format, name", FILES)
def test_a_gap_in_the_centre_line_is_a_warning(tmp_path, file_format, name, capfd):
    with_a_point_beside_the_centre_plane(1.5e-4)
    export(file_format, tmp_path / name)
    told = capfd.readouterr().out
    assert "Warning: a control point" in told and "the two sides are not joined there" in told
    bpy.context.object.hull.export.extent = "HALF"
    export(file_format, tmp_path / name)
    assert "not joined" not in capfd.readouterr().out
