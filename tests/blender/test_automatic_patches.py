# SPDX-License-Identifier: GPL-3.0-or-later
"""Automatic conversion: exact patches, but one a cell where exact ones make a much larger file, as
those of triangles do."""

import bpy
import numpy as np
import pytest
from addon_under_test import add_hull, make_active, part

# Of the goal, for the file of a half hull.
MOST_BYTES_A_TRIANGLE = 10e6 / 1000


def sheet_of_triangles(n):
    """Half a hull of 2 n² triangles."""
    s, t = (a.ravel() for a in np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1)))
    y = 10 * np.sin(np.pi * (0.05 + 0.9 * s)) * np.sqrt(0.01 + t)
    points = np.stack([100 * s, np.where(t > 0, y, 0.0), 10 * t**2], 1)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = np.concatenate(
        [np.stack([a, a + 1, a + n + 2], 1), np.stack([a, a + n + 2, a + n + 1], 1)]
    )
    return points, faces


def add_triangles(n):
    points, faces = sheet_of_triangles(n)
    mesh = bpy.data.meshes.new("Triangles")
    mesh.from_pydata(points.tolist(), [], faces.tolist())
    hull = bpy.data.objects.new("Triangles", mesh)
    bpy.context.collection.objects.link(hull)
    make_active(hull)
    assert bpy.ops.hull.make_hull(half=True) == {"FINISHED"}
    return hull


def converted(hull, conversion):
    hull.hull.export.conversion = conversion
    assert bpy.ops.hull.convert() == {"FINISHED"}
    return part("features.conversion.conversions").last_outcome(hull)[0].converted


def remark(hull, made):
    return part("features.exchange.step_size").remark(hull, made)


def step_size(hull, conversion, path):
    hull.hull.export.conversion = conversion
    assert bpy.ops.hull.export_step(filepath=str(path)) == {"FINISHED"}
    return path.stat().st_size


def in_megabytes(text):
    """The sizes that a sentence tells."""
    return [float(before.split()[-1]) for before in text.split(" MB")[:-1]]


@pytest.mark.once
def test_triangles_take_one_patch_a_cell_and_say_so(tmp_path):
    hull, patches = add_triangles(9), part("features.conversion.patches")
    settings, asked = hull.hull.export, patches.asked_of(hull.hull.export)
    assert settings.conversion == "AUTOMATIC"
    settings.extent = "HALF"
    size = step_size(hull, "AUTOMATIC", tmp_path / "automatic.step")
    triangles = len(hull.data.polygons)
    assert size < MOST_BYTES_A_TRIANGLE * triangles
    made = converted(hull, "AUTOMATIC")
    assert made.quality.patch_count == made.cell_count == 3 * triangles
    # What was taken, why, and how far it is from the surface.
    assert dict(patches.rows(made))["Conversion"] == "one a cell"
    text, _ = patches.summary(made, asked)
    distance = part("bridge.blender.units").format_mm(made.quality.largest_distance)
    assert "one a cell" in text and f"distance {distance}" in text
    exact_size = step_size(hull, "EXACT", tmp_path / "exact.step")
    assert exact_size > 2.0 * size
    told = in_megabytes(remark(hull, made))
    assert told == pytest.approx([size / 1e6, exact_size / 1e6], rel=0.15)


@pytest.mark.once
def test_exact_patches_of_triangles_can_be_had(tmp_path):
    hull = add_triangles(9)
    exact = converted(hull, "EXACT")
    assert exact.is_exact and exact.quality.largest_distance_per_length < 1e-6
    hull.hull.export.extent = "HALF"
    assert remark(hull, exact) == ""
    hull.hull.export.extent = "BOTH"
    sizes = [step_size(hull, name, tmp_path / f"{name}.step") for name in ("EXACT", "PER_CELL")]
    assert in_megabytes(remark(hull, exact)) == pytest.approx(np.array(sizes) / 1e6, rel=0.15)
    assert remark(hull, converted(hull, "PER_CELL")) == ""


def test_patches_for_other_systems_are_exact_ones():
    hull = add_triangles(5)
    choice_of = part("features.conversion.patches").choice_of
    for name, value in (("matched_knots", True), ("bezier", True), ("most_control_points", 400)):
        usual = getattr(hull.hull.export, name)
        assert choice_of(hull.hull.export).conversion == "AUTOMATIC"
        setattr(hull.hull.export, name, value)
        assert choice_of(hull.hull.export).conversion == "EXACT"
        setattr(hull.hull.export, name, usual)


def test_small_files_of_triangles_are_exact():
    hull = add_triangles(2)
    assert converted(hull, "AUTOMATIC").is_exact


def test_usual_hulls_are_exact_and_nothing_is_remarked():
    hull = add_hull()
    made = converted(hull, "AUTOMATIC")
    assert made.is_exact and remark(hull, made) == ""
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    coaster = bpy.context.view_layer.objects.active
    assert converted(coaster, "AUTOMATIC").is_exact


def test_files_of_before_keep_their_choice():
    """Blender keeps the numbers of choices."""
    settings = add_hull().hull.export
    for number, name in enumerate(("EXACT", "PER_CELL", "AUTOMATIC")):
        settings["conversion"] = number
        assert settings.conversion == name
