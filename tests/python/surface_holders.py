# SPDX-License-Identifier: GPL-3.0-or-later
"""All classes that are made of a surface or a body, how one of each is made, and what it is asked:
those that refuse after set_points(), those that keep to what they were made of, and those that keep
what depends on topology alone."""

from dataclasses import dataclass, field

import hull_native as hn
import numpy as np

AFLOAT = {"draft": 0.5}


def box_surface():
    """A box of 8 m by 2 m by 1 m whose edges are creases, not quite square."""
    points = [(x, y, z) for z in (0.0, 1.0) for y in (-1.0, 1.0) for x in (0.0, 8.0)]
    faces = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
    edges = [(0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7)]
    edges += [(0, 4), (1, 5), (2, 6), (3, 7)]
    points = np.array(points) + 0.05 * np.sin(np.arange(24.0).reshape(8, 3))
    return hn.LimitSurface(hn.ControlMesh(points, [4] * 6, faces, creases=edges))


def move(surface):
    points = surface.mesh.points * [1.0, 1.1, 1.05]
    surface.set_points(points + 0.05 * np.cos(np.arange(24.0).reshape(8, 3)))


@dataclass
class Holder:
    """make(surface, body); asks: what is asked of it besides its properties."""

    make: object
    asks: dict = field(default_factory=dict)


def family(surface, body):
    mesh = surface.mesh
    return hn.HullFamily([surface, hn.LimitSurface(mesh.with_points(mesh.points * 1.1))])


def form_numbers(surface, body):
    return hn.FormNumbers(hn.BodyDerivatives(body), **AFLOAT, length_pp=8.0, beam=2.0)


LINE = [(2.0, -0.5, 3.0), (6.0, 0.5, 3.0)]
TOWARDS = {"towards": (1.0, 0.0, 0.0), "across": (0.0, 1.0, 0.0)}
PLACES = np.random.default_rng(7).uniform((-1.0, -2.0, -1.0), (9.0, 2.0, 2.0), (50, 3))
BASE = {}  # a curve for those who take one


def across(curves, x):
    return curves.in_plane(hn.plane_across("x", x))


def based(curves):
    """A curve of a HullCurves from before a move."""
    if "curve" not in BASE:
        (BASE["curve"],) = across(curves, 3.0)
    return BASE["curve"]


REFUSE = {
    "HullBody": Holder(
        lambda surface, body: hn.HullBody(surface, mirrored=False),
        {
            "immersion": lambda own: own.immersion((0.0, 0.0, 1.0), 0.5),
            "shell_area": lambda own: own.shell_area,
            "shell_flux_forms": lambda own: own.shell_flux_forms,
            "join": lambda own: own.join([]),
        },
    ),
    "MoveWatch": Holder(
        lambda surface, body: hn.MoveWatch(surface),
        {
            "cells": lambda own: own.cells,
            "comes_near": lambda own: own.comes_near([(1.0, 0.0, 0.0, 2.0)], margin=0.0),
        },
    ),
    "KeptStations": Holder(
        lambda surface, body: hn.KeptStations(body),
        {"areas": lambda own: own.section_areas([4.0, 5.0], **AFLOAT).areas},
    ),
    "FormNumbers": Holder(
        form_numbers,
        {
            **{f"value {n}": lambda own, n=n: own.value(n) for n in hn.FORM_NUMBERS},
            **{f"gradient {n}": lambda own, n=n: own.gradient(n) for n in hn.FORM_NUMBERS},
            "section_area": lambda own: own.section_area(4.0),
            "section_area_gradient": lambda own: own.section_area_gradient(4.0),
        },
    ),
    "MichellIntegral": Holder(
        lambda surface, body: hn.MichellIntegral(body, **AFLOAT),
        {
            "length": lambda own: own.length,
            "resistance": lambda own: own.resistance([4.0]),
            "resistance of none": lambda own: own.resistance([]),
            "resistance_to": lambda own: own.resistance_to(4.0, 2.0),
            "amplitudes": lambda own: own.amplitudes(4.0, [0.1]),
        },
    ),
    "HullCurves": Holder(
        lambda surface, body: hn.HullCurves(surface, 1e-3),
        {
            "in_plane": lambda own: across(own, 3.0),
            "on_cylinder": lambda own: own.on_cylinder(
                (4.0, 0.0, 0.0), direction=(0.0, 0.0, 1.0), radius=0.5
            ),
            "at_girth": lambda own: own.at_girth(based(own), 0.5, **TOWARDS),
            "projected": lambda own: own.projected(LINE, direction=(0.0, 0.0, -1.0)),
            "projected_from": lambda own: own.projected_from(LINE, centre=(4.0, 0.0, 9.0)),
            "borders": lambda own: own.borders(),
            "knuckles": lambda own: own.knuckles(),
            "pieces": lambda own: own.pieces(based(own), []),
        },
    ),
    "ComparedHull": Holder(
        lambda surface, body: hn.ComparedHull(body, 0.5),
        {
            "hydrostatics": lambda own: own.hydrostatics(),
            "areas": lambda own: own.areas([4.0]),
        },
    ),
}

KEEP = {
    "SurfaceTree": Holder(
        lambda surface, body: hn.SurfaceTree(surface),
        {
            "closest_points": lambda own: own.closest_points(PLACES),
            "ray_hits": lambda own: own.ray_hits(PLACES, [(0.0, 0.0, -1.0)] * len(PLACES)),
            "all_ray_hits": lambda own: own.all_ray_hits((4.0, 0.1, 5.0), (0.0, 0.0, -1.0)),
        },
    ),
    "ShownPoints": Holder(lambda surface, body: hn.ShownPoints(surface, 3, mirrored=False)),
    "SurfacePlaces": Holder(
        lambda surface, body: hn.SurfacePlaces(surface),
        {"points_beyond": lambda own: own.points_beyond(np.ones((len(own.positions), 3)))},
    ),
    "Reshape": Holder(
        lambda surface, body: hn.Reshape(surface),
        {"solve": lambda own: own.solve(0.01 * own.positions[:, ::-1])},
    ),
    "FairRegion": Holder(
        lambda surface, body: hn.FairRegion(
            surface, range(8), energy="thin_plate", keep_creases=False
        ),
        {"solve": lambda own: own.solve(0.01)},
    ),
    "SectionShift": Holder(
        lambda surface, body: hn.SectionShift(body, **AFLOAT, length_pp=8.0),
        {
            "shift": lambda own: own.shift(0, 3.0),
            "shifted": lambda own: own.shifted([0.02, 0.01]),
        },
    ),
    "GeodesicNet": Holder(
        lambda surface, body: hn.GeodesicNet(surface),
        {
            "along_surface": lambda own: hn.ShapeFields(
                [hn.ShapeField.at_point((4.0, 1.0, 1.0), (0.0, 0.1, 0.0), extent=3.0)
                 .along_surface(own)]
            ).at(PLACES)
        },
    ),  # fmt: skip
    "HullFamily": Holder(
        family,
        {
            "points": lambda own: own.points([0.4, 0.6]),
            "first_fold": lambda own: own.first_fold(own.points([1.0, 0.0]) * [1.0, -1.0, 1.0]),
        },
    ),
    "RuledRow": Holder(
        lambda surface, body: hn.RuledRow(surface, [0]),
        {
            "warps": lambda own: own.warps(),
            "rulings": lambda own: own.rulings(),
            "develop": lambda own: own.develop(0.5, 0.5),
        },
    ),
    "DistanceField": Holder(
        lambda surface, body: hn.DistanceField(surface, mirrored=False),
        # Off the edges, in the planes of faces, normals tell the side.
        {"distances": lambda own: own.distances([*PLACES, *(1.1 * own_edges())])},
    ),
}


def judged(surface, kept):
    planes = [(1.0, 0.0, 0.0, 3.0)]
    return kept.section_fairness(planes, hn.sections(surface, planes))


# What depends on topology alone: the same of the surface as it is.
FOLLOW = {
    "KeptSections": Holder(
        lambda surface, body: hn.KeptSections(surface),
        {"sections": lambda own: own.sections([(1.0, 0.0, 0.0, 3.0)], 1e-3)},
    ),
    "KeptFairness": Holder(
        lambda surface, body: (surface, hn.KeptFairness(surface)),
        {"section_fairness": lambda own: judged(*own)},
    ),
    "BodyDerivatives": Holder(
        lambda surface, body: hn.BodyDerivatives(body),
        {"gradient": lambda own: hn.FormNumbers(own, **AFLOAT).gradient("kb")},
    ),
    "BendSums": Holder(
        lambda surface, body: hn.BendSums(surface),
        {
            "sum": lambda own: own.sum(
                box_surface().mesh.points, [3], [(0.3, 0.4)], [(1.0, 0.0, 0.0)], [(0.0, 0.0, 1.0)]
            )
        },
    ),
}
ALL = REFUSE | KEEP | FOLLOW


def own_edges():
    return np.array([(x, y, z) for x in (0.0, 8.0) for y in (-1.0, 1.0) for z in (0.0, 1.0)])
