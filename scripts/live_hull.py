# SPDX-License-Identifier: GPL-3.0-or-later
"""The hull by which scripts/live_benchmark.py measures: that of native/benchmarks/half_hull.h."""

import math

import bpy
import numpy as np
from enabled_addon import part


def half_hull(stations, girth):
    """(points, faces, creases) of native/benchmarks/half_hull.h with so many spaces each way."""
    points, faces, creases = [], [], []
    for i in range(stations + 1):
        fullness = max(math.sin(3.14159265 * (0.12 + 0.88 * i / stations)), 0.0) ** 0.45
        for j in range(girth + 1):
            t = j / girth
            y = 9.0 * fullness * math.sin(0.5 * math.pi * t) ** 0.6 if j else 0.0
            points.append((100.0 * i / stations, y, 10.0 * t * t))

    def at(i, j):
        return i * (girth + 1) + j

    for i in range(stations):
        for j in range(girth):
            a, b, c, d = at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)
            if (i + 2 * j) % 12 == 5:
                faces += [(a, b, c), (a, c, d)]
            else:
                faces.append((a, b, c, d))
    knuckle = 6 * girth // 9
    creases += [(at(i, knuckle), at(i + 1, knuckle)) for i in range(stations // 2, stations)]
    return points, faces, creases


def make_hull(options):
    """The half hull of about so many points, with all that follows it switched on; in edit mode, or
    in object mode as a morph, or with shape fields that are previewed."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    girth = max(9, round(math.sqrt(0.65 * options.points)) - 1)
    stations = max(13, round(options.points / (girth + 1)) - 1)
    points, faces, creases = half_hull(stations, girth)
    mesh = bpy.data.meshes.new("benchmark")
    mesh.from_pydata(points, [], faces)
    part("bridge.mesh.mesh_arrays").write_tags(mesh, creases, [])
    hull = bpy.data.objects.new("benchmark", mesh)
    bpy.context.scene.collection.objects.link(hull)
    bpy.context.view_layer.objects.active = hull
    hull.select_set(True)
    bpy.ops.hull.make_hull(half=True)
    if options.drag == "weight":
        hull = _morph_of(hull)
    settings = hull.hull
    settings.samples = options.samples
    settings.length_pp, settings.draft, settings.beam = 100.0, 6.0, 18.0
    _switch_lines(settings, not options.no_lines, not options.no_combs)
    settings.plots.sectional_areas = not (options.no_lines or options.no_combs)
    if options.ghost:
        _show_ghost(settings)
    if options.drag == "fields":
        _preview_fields(hull)
    bpy.context.view_layer.update()
    if options.drag in ("one", "all"):
        bpy.ops.object.mode_set(mode="EDIT")
    return hull


def _morph_of(hull):
    """A morph of a hull and a longer, higher one, both of which are hidden then."""
    other = hull.copy()
    other.data = hull.data.copy()
    for vertex in other.data.vertices:
        vertex.co.x *= 1.2
        vertex.co.z *= 1.1
    bpy.context.scene.collection.objects.link(other)
    other.hull.length_pp = 120.0
    bpy.context.view_layer.update()
    hull.select_set(True)
    other.select_set(True)
    bpy.ops.hull.make_morph()
    for parent in (hull, other):
        parent.hide_set(True)
    return bpy.context.view_layer.objects.active


def _show_ghost(settings):
    """Of the hull as it is, behind the one that changes."""
    bpy.ops.hull.keep_variant(name="before")
    settings.variants.show_ghost = True


def _switch_lines(settings, on, with_combs):
    lines, fairness = settings.lines, settings.fairness
    lines.station_count = 20
    lines.waterlines = "0.75:9.75:0.9"
    lines.buttocks = "1:7:1"
    for name in ("stations", "waterlines", "buttocks", "design_waterline", "flats", "features"):
        setattr(lines, f"show_{name}", on)
    for name in ("stations", "waterlines", "buttocks"):
        setattr(fairness, f"comb_{name}", on and with_combs)


def _preview_fields(hull):
    """Those of native/benchmarks/fields_benchmark.cpp: a fuller shoulder, a raised sheer, and a
    line along the bottom that is protected."""
    rows = (
        ("MOVE", 18.0, (0.0, 0.4, 0.0), None),
        ("MOVE", 5.0, (0.0, 0.0, 0.5), [(60, 8.5, 10), (80, 7, 10), (99, 1, 10)]),
        ("PROTECT", 4.0, (0.0, 0.0, 0.0), [(20, 3, 0), (80, 3, 0)]),
    )
    for role, extent, shift, line in rows:
        bpy.ops.hull.add_field(role=role, base="CURVE" if line else "POINT")
        field = hull.hull.fields.fields[-1]
        field.place, field.extent, field.shift = (65.0, 8.0, 4.0), extent, shift
        if line:
            made = part("bridge.objects.curve_lines").made
            field.curve = made(field.name, np.array(line, dtype=float), False, hull)
    bpy.ops.hull.preview_fields()
