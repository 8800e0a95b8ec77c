# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a vessel's surface: points, sections, fairness, and moves of control points."""

import numpy as np

from .calls import SEED, attempt, native, places


def surface_results(vessel):
    mesh, surface = vessel.surface.mesh, vessel.surface
    yield "mesh", [mesh.points, mesh.face_sizes, mesh.face_vertices, mesh.creases]
    yield "kinds and valences", [mesh.vertex_kinds, mesh.vertex_valences]
    cells, uv = places(surface)
    yield "derivatives", surface.evaluate(cells, uv, 2)
    yield "normals", surface.normals(cells, uv)
    yield "curvature", surface.curvature(cells, uv)
    yield "grid", surface.evaluate_grid(2, 1)
    yield "tessellation", surface.tessellate(2)
    yield "weights", native("point_weights", surface, cells[:100], uv[:100])
    tree = native("SurfaceTree", surface)
    points = surface.positions(cells, uv)
    beside = points + 0.05 * vessel.data.particulars.beam * np.random.default_rng(SEED).normal(
        size=points.shape
    )
    yield "closest points", tree.closest_points(beside)
    yield "rays", tree.ray_hits(beside, points - beside)
    curves = native("crease_curves", surface)
    yield "crease curves", curves
    yield "points on them", [
        curve.evaluate(np.linspace(0, curve.edge_count, 4 * curve.edge_count + 1), 2)
        for curve in curves
    ]


def planes(vessel):
    """(n, 4): stations, waterlines, buttocks and diagonals, through the middle of flats too."""
    given = vessel.data.particulars
    across = [("x", x) for x in np.linspace(-0.02, 1.02, 14) * given.length_pp]
    across += [("z", z) for z in np.linspace(0.0, 1.4, 8) * given.draft]
    across += [("y", y) for y in np.linspace(0.0, 0.5, 6) * given.beam]
    diagonals = [(1.2 * given.draft, angle) for angle in np.radians([25.0, 45.0, 65.0])]
    return np.array(
        [native("plane_across", *at) for at in across]
        + [native("diagonal_plane", *at) for at in diagonals]
        + [[0.9, 0.3, 0.2, 0.45 * given.length_pp]]
    )


def section_results(vessel):
    surface, cut = vessel.surface, planes(vessel)
    yield "sections", native("sections", surface, cut)
    yield "one by one", [
        native("section", surface, axis, float(place))
        for axis, place in zip("xyz", surface.mesh.points.mean(axis=0))
    ]
    yield "splines", native("section_splines", surface, cut[::3])
    yield "features", native("feature_curves", surface)
    given = vessel.data.particulars
    yield "offsets", native(
        "offset_table",
        surface,
        stations=np.linspace(0, given.length_pp, 11),
        waterlines=np.linspace(0, 1.2 * given.draft, 7),
        buttocks=np.linspace(0, 0.45 * given.beam, 4),
    )


def fairness_results(vessel):
    surface, cut = vessel.surface, planes(vessel)
    step = vessel.data.particulars.length_pp / 200
    yield "of sections", native("section_fairness", surface, cut[::4], step=step)
    yield "of features", native("feature_fairness", surface, step=step)
    light = dict(line_direction=[1, 0, 0], light_direction=[0, 1, 1], eye_direction=[0, 1, 0.3])
    yield "reflection lines", native("reflection_lines", surface, spacing=0.1, divisions=4, **light)
    yield "isophotes", native(
        "isophotes", surface, direction=[0, 1, 0], angles=np.radians([30, 60, 90]), divisions=4
    )
    yield "silhouette", native("silhouette", surface, eye_direction=[0.2, 1, 0.4], divisions=4)
    tessellation = surface.tessellate(1)
    for kind in ("gaussian", "mean", "maximum", "minimum", "slope"):
        values = native("surface_field", surface, tessellation, kind=kind)
        yield f"{kind} field", values
        yield f"{kind} scale", native("colour_scale", values, kind=kind)
    yield "reflection field", native("reflection_field", tessellation, spacing=0.1, **light)
    yield "flat regions", native("flat_regions", surface)


def modelling_results(vessel):
    surface, given = vessel.surface, vessel.data.particulars
    cells = np.unique(np.linspace(0, surface.cell_count - 1, 5).astype(int))
    middles = np.full((len(cells), 2), 0.5)
    normals = surface.normals(cells, middles)
    targets = surface.positions(cells, middles) + 0.01 * given.beam * normals
    yield "pull", attempt(native, "pull_surface", surface, cells, middles, targets)
    yield "pull with locks", attempt(
        native,
        "pull_surface",
        surface,
        cells[:2],
        middles[:2],
        targets[:2],
        locked=[0],
        held_points=[1, 2],
        held_normals=[[0.0, 1.0, 0.0]] * 2,
    )
    wanted = surface.evaluate_grid(2)[0].reshape(-1, 3)
    wanted = wanted + 0.003 * given.beam * np.sin(wanted[:, :1] / given.beam) * [0, 1, 0]
    yield "fit", attempt(native, "fit_surface", surface, wanted, most_steps=2)
    yield "bilge", native("bilge_arc", 4, move_borders=True)
