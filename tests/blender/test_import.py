# SPDX-License-Identifier: GPL-3.0-or-later
"""Files become hull objects, one for each; a file that cannot be read changes nothing."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from addon_under_test import hull_io, mesh_points, part, state_of

FILE_COUNT = 13


def data_counts():
    kinds = ("objects", "meshes", "curves", "materials")
    return {kind: len(getattr(bpy.data, kind)) for kind in kinds}


def test_every_file_arrives_as_one_hull(freeship_folder):
    files = sorted(freeship_folder.glob("*.f[bt]m"))
    assert len(files) == FILE_COUNT
    for path in files:
        bpy.ops.wm.read_homefile(use_empty=True)
        assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}, path.name
        check_imported(bpy.context.object, hull_io().read_hull(path))


def test_files_of_geometry_are_sent_to_hull_from_file(tmp_path):
    """Of all endings that Hull from File offers but those that both read; it reads them."""
    operators = part("operators.geometry")
    (glob,) = (
        annotation.keywords["default"]
        for name, annotation in operators.HULL_OT_hull_from_file.__annotations__.items()
        if name == "filter_glob"
    )
    endings = [pattern.lstrip("*.") for pattern in glob.split(";")]
    assert {"geo", "stl", "step"} <= set(endings)
    before = data_counts()
    for ending in set(endings) - {"fbm", "ftm", "txt"}:
        path = tmp_path / f"ship.{ending}"
        path.write_bytes(b"[TShipLines]")
        with pytest.raises(RuntimeError, match="with Hull from File, which lays a hull"):
            bpy.ops.hull.import_hull(filepath=str(path))
    assert data_counts() == before


def test_hull_files_are_mended_as_models_of_others_are(tmp_path):
    """A half to starboard, with a wall on it, which a script reads as it is."""
    points = [(x, y, z) for x in (0.0, 5.0, 10.0) for y in (0.0, -2.0) for z in (0.0, 3.0)]
    faces = [[2, 6, 7, 3], [6, 10, 11, 7], [0, 4, 6, 2], [4, 8, 10, 6], [4, 5, 7, 6]]
    data = hull_io().HullData("box", points, faces, half=True)
    path = tmp_path / "box.hull.json"
    hull_io().write_hull_file(data, path)
    assert hull_io().read_hull(path).notes == []
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    hull = bpy.context.object
    assert not state_of(hull).status and not state_of(hull).ship.check.errors
    assert mesh_points(hull)[:, 1].min() == 0.0 and mesh_points(hull)[:, 1].max() == 2.0
    operator = part("operators.import_hull")
    told = []
    reports = SimpleNamespace(tell=lambda level, text: told.append((level, text)))
    operator._import(reports, bpy.context, str(path))
    said = [text for level, text in told if level == "WARNING"]
    assert any("mirrored to port" in text for text in said)
    assert any("were split" in text for text in said)


def check_imported(hull, wanted):
    """The object against what the file holds."""
    assert [obj for obj in bpy.data.objects if obj.type == "MESH" and obj.hull.is_hull] == [hull]
    assert np.array_equal(mesh_points(hull), wanted.points.astype(np.float32))
    assert [list(polygon.vertices) for polygon in hull.data.polygons] == wanted.faces
    assert len(hull.material_slots) == len(wanted.layers)
    assert [polygon.material_index for polygon in hull.data.polygons] == list(wanted.face_layers)
    assert crease_pairs(hull) == {tuple(sorted(pair)) for pair in wanted.creases}
    corners = np.flatnonzero(part("bridge.blender.blender_versions").vertex_creases(hull.data))
    assert corners.tolist() == sorted(wanted.corners)
    assert hull.hull.half == wanted.half
    assert hull.hull.draft == pytest.approx(wanted.particulars.draft or hull.hull.draft)
    assert hull.hull.length_pp == pytest.approx(wanted.particulars.length_pp)
    state = state_of(hull)
    assert not state.status and state.ship.surface is not None
    assert len(hull.hull.surface_object.data.polygons) > 0


def crease_pairs(hull):
    values = part("bridge.blender.blender_versions").edge_creases(hull.data)
    return {tuple(sorted(hull.data.edges[i].vertices)) for i in np.flatnonzero(values)}


def test_layers_outside_hydrostatics_are_no_shell(freeship_folder):
    for path in sorted(freeship_folder.glob("*.f[bt]m")):
        wanted = hull_io().shell_arrays(hull_io().read_hull(path))
        bpy.ops.wm.read_homefile(use_empty=True)
        bpy.ops.hull.import_hull(filepath=str(path))
        mesh = state_of(bpy.context.object).ship.surface.mesh
        assert mesh.face_count == len(wanted.face_sizes), path.name
        size = np.ptp(wanted.points, axis=0).max()
        assert np.abs(mesh.points - wanted.points).max() <= 1e-6 * size


@pytest.mark.parametrize("length", [0, 9, 100, 5000])
def test_a_cut_file_changes_nothing(freeship_folder, tmp_path, length):
    data = (freeship_folder / "FREE!ship demo 6.fbm").read_bytes()
    path = tmp_path / "cut.fbm"
    path.write_bytes(data[:length])
    before = data_counts()
    with pytest.raises(RuntimeError) as caught:
        bpy.ops.hull.import_hull(filepath=str(path))
    assert "cut.fbm" in str(caught.value) and "Traceback" not in str(caught.value)
    assert data_counts() == before


def test_a_missing_file_is_one_message(tmp_path):
    before = data_counts()
    with pytest.raises(RuntimeError) as caught:
        bpy.ops.hull.import_hull(filepath=str(tmp_path / "none.fbm"))
    assert "none.fbm" in str(caught.value) and "Traceback" not in str(caught.value)
    assert data_counts() == before


def test_the_scene_scale_is_honoured(freeship_folder):
    bpy.context.scene.unit_settings.scale_length = 0.01
    path = freeship_folder / "FREE!ship demo 6.fbm"
    bpy.ops.hull.import_hull(filepath=str(path))
    hull = bpy.context.object
    wanted = hull_io().read_hull(path)
    assert mesh_points(hull)[:, 0].max() == pytest.approx(100.0 * wanted.points[:, 0].max())
    assert hull.hull.draft == pytest.approx(100.0 * wanted.particulars.draft)


def test_import_is_one_undo_step(freeship_folder):
    bpy.ops.ed.undo_push(message="nothing")
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "Motorboat.fbm"))
    bpy.ops.ed.undo_push(message="imported")
    bpy.ops.ed.undo()
    assert not len(bpy.data.objects)


def test_every_sample_loads():
    names = part("features.hull.samples").sample_files()
    assert len(names) >= 2
    for name in names:
        assert bpy.ops.hull.load_sample(name=name) == {"FINISHED"}
        state = state_of(bpy.context.object)
        assert not state.status and not state.ship.check.problems
        assert state.hydrostatics.values.displaced_volume > 0.0
