# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for FREE!ship, GHS, Archimedes, Michlet and as text, by the operators; chines imported."""


import bpy
import numpy as np
import pytest
from addon_under_test import LENGTH, add_hull, hull_io, mesh_points, part, sample, state_of
from chine_boats import carlson, curves
from edited_hulls import edit, keys, select
from section_file_readers import read_archimedes, read_ghs, read_michlet, read_section_text


@pytest.fixture
def box():
    hull = add_hull()
    hull.hull.length_pp, hull.hull.beam, hull.hull.draft = LENGTH, 4.0, 2.0
    hull.hull.lines.station_count = 4
    return hull


def test_freeship_files_read_back(tmp_path):
    hull = sample("coaster")
    path = tmp_path / "coaster.fbm"
    points, draft = mesh_points(hull), hull.hull.draft
    assert bpy.ops.hull.export_freeship(filepath=str(path)) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    again = bpy.context.object
    assert again is not hull and np.array_equal(mesh_points(again), points)
    assert again.hull.draft == pytest.approx(draft, rel=1e-6)
    assert len(again.material_slots) == len(hull.material_slots)


@pytest.mark.parametrize("ending", ["fbm", "hull.json"])
def test_locks_plating_and_rows_come_back(tmp_path, ending):
    """Set in the panels, written by the operators and read again; rows are shown with combs."""
    hull = sample("coaster")
    locks, rows = part("features.constraints.point_locks"), part("bridge.mesh.row_marks")
    locks.write(hull.data, [3, 40, 41])
    entry = hull.hull.layers[0]
    entry.thickness, entry.density = 0.0125, 2.75
    edit(hull, (False, True, False))
    select(hull, "edge", [tuple(hull.data.edges[200].vertices)])
    assert bpy.ops.hull.show_rows() == {"FINISHED"}
    marked = keys(rows.marked(hull.data))
    assert len(marked) > 3
    combs = state_of(hull).fairness.combs["row"].rows
    bpy.ops.object.mode_set(mode="OBJECT")
    path = tmp_path / f"coaster.{ending}"
    export = bpy.ops.hull.export_freeship if ending == "fbm" else bpy.ops.hull.export_hull
    assert export(filepath=str(path)) == {"FINISHED"}
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    again = bpy.context.object
    assert again is not hull and locks.locked_points(again.data).tolist() == [3, 40, 41]
    assert keys(rows.marked(again.data)) == marked and again.hull.fairness.comb_rows
    found = state_of(again).fairness.combs["row"].rows
    assert [row.points.tolist() for row in found] == [row.points.tolist() for row in combs]
    own = again.hull.layers[0]
    assert (own.thickness, own.density) == (pytest.approx(0.0125), pytest.approx(2.75))


def test_control_curves_of_freeship_are_rows(freeship_folder):
    assert bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo tug.fbm")) == {
        "FINISHED"
    }
    hull = bpy.context.object
    assert len(part("bridge.mesh.row_marks").marked(hull.data)) == 75
    assert len(state_of(hull).fairness.combs["row"].rows) >= 12


def test_an_imperial_scene_writes_feet(box, tmp_path):
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    path = tmp_path / "box.fbm"
    bpy.ops.hull.export_freeship(filepath=str(path))
    read = hull_io().read_hull(path)
    assert read.units == "ft"
    np.testing.assert_allclose(read.points, mesh_points(box), atol=1e-6)
    assert read.particulars.water_density == pytest.approx(box.hull.water_density, rel=1e-6)
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "box.gf"))
    header, sections, _ = read_ghs((tmp_path / "box.gf").read_bytes().decode())
    assert header["P"] == "F"
    np.testing.assert_allclose([x for x, _ in sections], [10, 7.5, 5, 2.5, 0], atol=1e-5)


@pytest.mark.parametrize("scale", [1.0, 0.3048, 0.0254])
def test_imperial_scenes_read_their_own_files_back(tmp_path, scale):
    """Whatever the scene's unit is, a metre, a foot or an inch: the FREE!ship file brings the same
    points back, and GHS' file, in feet, the text, in metres, and the table of offsets, in the
    scene's unit, are of the same stations as a metric scene has."""
    hull, scene = sample("coaster"), bpy.context.scene
    hull.hull.lines.station_count = 5
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "metric.txt"))
    _, metric = read_section_text((tmp_path / "metric.txt").read_text())
    points = mesh_points(hull)
    scene.unit_settings.system, scene.unit_settings.scale_length = "IMPERIAL", scale
    assert bpy.ops.hull.export_hull(filepath=str(tmp_path / "coaster.hull.json")) == {"FINISHED"}
    in_metres = hull_io().read_hull(tmp_path / "coaster.hull.json")
    np.testing.assert_allclose(in_metres.points, points * scale, rtol=2e-6)
    assert bpy.ops.hull.export_freeship(filepath=str(tmp_path / "coaster.fbm")) == {"FINISHED"}
    read = hull_io().read_hull(tmp_path / "coaster.fbm")
    assert read.units == "ft"
    np.testing.assert_allclose(read.points, points * scale, atol=1e-6 * 90.0 * scale)
    assert bpy.ops.hull.import_hull(filepath=str(tmp_path / "coaster.fbm")) == {"FINISHED"}
    again = bpy.context.object
    np.testing.assert_allclose(mesh_points(again), points, atol=1e-6 * 90.0)
    assert again.hull.draft == pytest.approx(hull.hull.draft, rel=1e-6)
    bpy.context.view_layer.objects.active = hull
    hull.select_set(True)
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.gf"))
    header, feet, _ = read_ghs((tmp_path / "coaster.gf").read_bytes().decode())
    assert header["P"] == "F"
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.txt"))
    _, own = read_section_text((tmp_path / "coaster.txt").read_text())
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.hll"))
    root, both_sides = read_archimedes((tmp_path / "coaster.hll").read_text())
    wanted = hull.hull.draft * scale
    assert float(root.find("MID_DRAUGHT_MARK").text) == pytest.approx(wanted, abs=1e-5)
    assert len(own) == len(feet) == len(both_sides) == len(metric)
    for (_, one), (_, other) in zip(both_sides, own):
        np.testing.assert_allclose(one[-len(other) :], other[:, :2], atol=1.1e-5)
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.mlt"))
    _, _, values = read_michlet((tmp_path / "coaster.mlt").read_bytes().decode())
    metres = state_of(hull).hydrostatics.values
    for value, known in zip(values, (metres.displaced_volume, metres.waterline_length)):
        assert float(value) == pytest.approx(known, rel=1e-4)
    for sections in (feet, own, both_sides):  # of feet the reader makes metres
        found = sorted(x for x, _ in sections)
        wanted = sorted(x * scale for x, _ in metric)
        np.testing.assert_allclose(found, wanted, atol=2e-5 * 90.0 * scale)
    for (_, one), (_, other) in zip(own, metric):
        highest, wanted = one[:, :2].max(axis=0), scale * other[:, :2].max(axis=0)
        np.testing.assert_allclose(highest, wanted, atol=2e-5 * 90.0 * scale)


def test_panels_in_feet_say_what_panels_in_metres_do():
    """The same ship in a scene of feet: the same text of each number but for its unit."""
    hull, scene = sample("coaster"), bpy.context.scene
    units = part("bridge.blender.units")
    found = part("features.hull.hull_state").state_of(hull).hydrostatics.values
    scene.unit_settings.system = "IMPERIAL"
    assert units.format_value(scene, found.displaced_volume, "m3") == (
        f"{found.displaced_volume / 0.3048**3:.0f} ft³"
    )
    assert units.format_value(scene, found.displacement_t, "t").endswith(" LT")
    assert units.format_value(scene, 3.048, "m").split() == ["10.000", "ft"]
    before = found.displaced_volume
    scene.unit_settings.scale_length = 0.3048  # now the same numbers are feet
    part("features.hull.hull_state").refresh(hull, scene)
    after = part("features.hull.hull_state").state_of(hull).hydrostatics.values.displaced_volume
    assert after == pytest.approx(before * 0.3048**3, rel=1e-6)


def test_sections_of_a_box(box, tmp_path):
    corner = [(0.0, 0.0), (2.0, 0.0), (2.0, 3.0)]
    for ending in ("gf", "hll", "txt", "mlt"):
        path = str(tmp_path / f"box.{ending}")
        assert bpy.ops.hull.export_sections(filepath=path) == {"FINISHED"}
    _, sections, _ = read_ghs((tmp_path / "box.gf").read_bytes().decode())
    assert [round(x, 5) for x, _ in sections] == [10.0, 7.5, 5.0, 2.5, 0.0]
    for _, points in sections:
        assert {tuple(p) for p in points.round(5).tolist()} >= {*corner, (0.0, 3.0)}
    _, sections = read_archimedes((tmp_path / "box.hll").read_text())
    for _, points in sections:
        assert (points.min(), points[:, 1].max()) == (-2.0, 3.0)
    _, sections = read_section_text((tmp_path / "box.txt").read_text())
    for _, rows in sections:
        assert rows[(rows[:, :2] == (2.0, 0.0)).all(axis=1), 2] == [1.0]
    _, offsets, values = read_michlet((tmp_path / "box.mlt").read_bytes().decode())
    assert offsets.shape == (81, 41) and (offsets[1:-1, 1:] == 2.0).all()
    assert [float(value) for value in values[:3]] == pytest.approx([80.0, 10.0, 2.0])


@pytest.mark.parametrize("name", ["coaster", "naval_vessel"])
def test_michlet_files_of_samples_read_back(name, tmp_path):
    """Half-breadths as rays from abeam find them, and with them the volume of the hydrostatics."""
    hull = sample(name)
    path = tmp_path / f"{name}.mlt"
    assert bpy.ops.hull.export_sections(filepath=str(path)) == {"FINISHED"}
    _, offsets, values = read_michlet(path.read_bytes().decode())
    native, ship = part("bridge.native").require(), state_of(hull).ship
    water = native.hydrostatics(ship.body, draft=hull.hull.draft)
    volume, length, draft = (float(value) for value in values[:3])
    assert volume == pytest.approx(water.displaced_volume, rel=1e-4)
    assert length == pytest.approx(water.waterline_length, abs=1e-4)
    x = np.linspace(water.waterline_forward, water.waterline_aft, 81)
    z = hull.hull.draft - water.immersed_draft * np.linspace(1.0, 0.0, 41)
    abeam = np.stack(np.broadcast_arrays(x[:, None], 1e3, z), axis=-1).reshape(-1, 3)
    hits = native.SurfaceTree(ship.surface).ray_hits(
        abeam, np.tile([0.0, -1.0, 0.0], (len(abeam), 1))
    )
    found = np.nan_to_num(hits.points[:, 1]).reshape(offsets.shape)
    # Within the ends and above the keel; where the surface lies flat, further off along z.
    inner = (slice(1, -1), slice(1, -1))
    places = np.stack(np.broadcast_arrays(x[:, None], offsets, z), axis=-1)[inner]
    wet = places[..., 1] > 0.0
    tree, size = native.SurfaceTree(ship.surface), np.linalg.norm(np.ptp(mesh_points(hull), axis=0))
    assert tree.closest_points(places[wet]).distances.max() < 1e-7 * size + 0.5e-5
    assert np.abs(offsets - found)[inner].max() < 2e-3 and wet.sum() > 1900
    weights = [np.where(np.arange(n) % 2, 4, 2) / 3.0 for n in offsets.shape]
    for each, size in zip(weights, (length / 80, draft / 40)):
        each[[0, -1]] = 1.0 / 3.0
        each *= size
    assert 2.0 * weights[0] @ offsets @ weights[1] == pytest.approx(volume, rel=0.01)


def test_an_ending_is_added(box, tmp_path):
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "box"), format=".hll")
    assert [path.name for path in tmp_path.iterdir()] == ["box.hll"]


def test_an_ending_that_names_no_program_is_refused(box, tmp_path):
    sections = part("features.exchange.program_files").export_sections
    for name in ("box.pdf", ".gf"):
        with pytest.raises(ValueError, match=r"does not say for which program .* \.gf, \.hll"):
            sections(box, bpy.context.scene, tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_sides_that_differ_are_refused(tmp_path):
    hull = sample("coaster")
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.txt"))
    hull.data.vertices[0].co.y += 1.0
    hull.data.update()
    with pytest.raises(RuntimeError, match="two sides differ"):
        bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.gf"))


def test_two_hulls_are_refused(tmp_path):
    sample("catamaran")
    with pytest.raises(RuntimeError, match="parts beside one another"):
        bpy.ops.hull.export_sections(filepath=str(tmp_path / "catamaran.gf"))
    assert not list(tmp_path.iterdir())


def test_a_hull_without_stations_is_told(box, tmp_path):
    box.hull.length_pp = 0.0
    with pytest.raises(RuntimeError, match="There are no stations"):
        bpy.ops.hull.export_sections(filepath=str(tmp_path / "box.gf"))


def test_chines_become_a_hull(tmp_path):
    path = tmp_path / "skiff.hul"
    path.write_text(carlson(curves()))
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    hull = bpy.context.object
    assert hull.name.startswith("Skiff") and hull.hull.half
    state = part("features.hull.hull_state").state_of(hull)
    assert not state.status and state.ship.surface is not None


def test_noise_makes_no_sides_that_differ(tmp_path):
    """As files of others have, whose coordinates are rounded here and there."""
    hull = sample("coaster")
    assert bpy.ops.hull.make_whole() == {"FINISHED"}
    points = mesh_points(hull)
    size = np.linalg.norm(np.ptp(points, axis=0))
    noise = np.random.default_rng(6).uniform(-1e-5, 1e-5, points.shape) * size
    hull.data.vertices.foreach_set("co", (points + noise).astype(np.float32).ravel())
    hull.data.update()
    bpy.ops.hull.export_sections(filepath=str(tmp_path / "coaster.txt"))
    assert (tmp_path / "coaster.txt").exists()
