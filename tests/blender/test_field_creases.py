# SPDX-License-Identifier: GPL-3.0-or-later
"""Creases and borders on which shape fields are based come where fields want them, exactly where
their own points can; else their distance is told, and right."""

from pathlib import Path

import bpy
import numpy as np
import pytest
from addon_under_test import part
from test_fields import add, points_of, sample

SAMPLES = sorted(
    path.name.split(".")[0]
    for path in (Path(__file__).resolve().parents[2] / "samples").glob("*.hull.json")
)


def native():
    return part("bridge.native").require()


def prepared(hull):
    return part("features.fields.prepared").of_hull(
        hull, part("bridge.objects.hull_mesh").read(hull), 1.0
    )


def solved(hull):
    """(prepared.Prepared, shaping.Applied, the surface then in double precision, the
    hull_native.ShapeFields)."""
    own = prepared(hull)
    rows = part("features.fields.field_list").in_use(hull)
    applied = part("features.fields.shaping").solve(hull, rows, own)
    mesh = own.surface.mesh
    after = native().LimitSurface(
        mesh.with_points(mesh.points + applied.result.moves), own.surface.scheme
    )
    fields = [part("features.fields.bases").shape_field(row, hull, own) for row in rows]
    return own, applied, after, native().ShapeFields(fields, mirrored=True)


def upper_edge(hull):
    """A point amidships of the upper border, as nearly as there is one."""
    points = points_of(hull).astype(np.float64)
    parts = (points - points.min(axis=0)) / np.ptp(points, axis=0)
    return points[np.argmax(parts @ (0.0, 0.1, 1.0) - np.abs(parts[:, 0] - 0.5))]


def crease_of(hull, own, row=0):
    return part("features.fields.base_curves").base_crease(
        hull.hull.fields.fields[row], own.surface, own.scale
    )


def lines_of(own, after, number, samples):
    """(points before, points after) along a crease."""
    curves = (native().crease_curves(surface)[number] for surface in (own.surface, after))
    before, now = (
        curve.evaluate(np.linspace(0.0, curve.edge_count, samples * curve.edge_count + 1))[0]
        for curve in curves
    )
    return before, now


@pytest.mark.parametrize("name", SAMPLES)
def test_a_crease_that_is_shifted_as_a_whole_is_there_exactly(name):
    hull = sample(name)
    shift = np.array([0.0, 0.0, 0.02 * np.ptp(points_of(hull)[:, 2])])
    part("features.constraints.flats").release(hull, range(len(hull.data.polygons)))
    extent = 0.5 * np.ptp(points_of(hull)[:, 2])
    add(hull, upper_edge(hull), base="CREASE", extent=extent, shift=shift, falloff=0.9)
    own, applied, after, _ = solved(hull)
    number, _ = crease_of(hull, own)
    before, now = lines_of(own, after, number, 20)
    size = own.surface.mesh.size
    typed = part("bridge.blender.units").as_typed
    wanted = before + [typed(value) for value in hull.hull.fields.fields[0].shift]
    assert np.abs(now - wanted).max() < 1e-12 * size
    assert applied.crease_distance < 1e-12 * size
    assert np.array_equal(after.mesh.creases, own.surface.mesh.creases)


@pytest.mark.parametrize("name", SAMPLES)
def test_how_far_another_crease_is_from_where_it_is_wanted_is_told(name):
    """A shift that is no spline of the crease's own knots: a part of the crease is protected."""
    hull = sample(name)
    part("features.constraints.flats").release(hull, range(len(hull.data.polygons)))
    place, size = upper_edge(hull), np.ptp(points_of(hull), axis=0)
    shift = (0.0, 0.0, 0.02 * size[2])
    add(hull, place, base="CREASE", extent=0.5 * size[2], shift=shift, falloff=0.8)
    add(hull, place, role="PROTECT", extent=0.2 * size[0], falloff=0.8)
    own, applied, after, fields = solved(hull)
    number, crease = crease_of(hull, own)
    before, now = lines_of(own, after, number, 64)
    target = before + fields.at(before)[0]
    if crease.closed:
        target = target[:-1]
    away = native().FieldCurve(target, closed=crease.closed).distances(now).max()
    print(name, "told", applied.crease_distance, "found", away)
    assert away > 1e-6 * size[0]
    assert applied.crease_distance == pytest.approx(away, rel=0.01)


def test_it_is_told_with_what_was_applied():
    hull = sample()
    place = upper_edge(hull)
    add(hull, place, base="CREASE", extent=4.0, shift=(0.0, 0.0, 0.2))
    shaping = part("features.fields.shaping")
    own, applied, *_ = solved(hull)
    assert "creases off theirs by" in shaping.summary(applied)
    hull.hull.fields.fields[0].base = "POINT"
    _, applied, *_ = solved(hull)
    assert applied.crease_distance is None and "creases" not in shaping.summary(applied)


def test_what_holds_points_is_stronger_than_a_crease():
    """Locked points of the crease stay, and those in flats in their planes."""
    assert bpy.ops.hull.add_hull(kind="ROUND_BILGE") == {"FINISHED"}
    hull = bpy.context.view_layer.objects.active
    before = points_of(hull)
    add(hull, upper_edge(hull), base="CREASE", extent=5.0, shift=(0.0, 0.3, 0.2))
    own = prepared(hull)
    _, crease = crease_of(hull, own)
    locked = own.control.vertex_ids[crease.vertices[len(crease.vertices) // 2]]
    part("features.constraints.point_locks").write(hull.data, [int(locked)])
    assert bpy.ops.hull.apply_fields() == {"FINISHED"}
    after = points_of(hull)
    assert np.array_equal(after[locked], before[locked]) and not np.array_equal(after, before)
    planes = part("features.constraints.flats").regions(hull)
    tolerance = part("features.constraints.planes")
    assert planes
    for region in planes:
        own_points = np.unique(
            [v for face in region.faces.tolist() for v in hull.data.polygons[face].vertices]
        )
        heights = tolerance.heights(after[own_points].astype(np.float64), region.plane)
        assert np.abs(heights).max() < 1e-5


def test_a_crease_protected_on_one_axis_keeps_it():
    hull = sample("naval_vessel")
    points = points_of(hull)
    knuckle = points[np.argmax(points @ (0.1, 0.0, 1.0))]
    low = points[np.argmin(np.abs(points - knuckle).sum(axis=1))]
    add(hull, low - (20.0, 0.0, 2.0), extent=40.0, shift=(0.0, 0.4, 0.4))
    add(hull, knuckle, base="CREASE", role="PROTECT", extent=5.0, axes=(False, True, False))
    own, applied, after, _ = solved(hull)
    number, _ = crease_of(hull, own, 1)
    before, now = lines_of(own, after, number, 20)
    size = own.surface.mesh.size
    assert np.abs((now - before)[:, 1]).max() < 1e-12 * size
    assert np.abs((now - before)[:, 2]).max() > 1e-4 * size
