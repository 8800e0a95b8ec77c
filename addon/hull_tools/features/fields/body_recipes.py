# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of shape fields that change the body of a ship: sheer, bilge, tunnels."""

import numpy as np

from ...bridge import native
from .recipe_form import ALONG, deck_near, protected_centre


def sheer(form):
    return [
        {
            "name": "Sheer",
            "base": "CREASE",
            "place": deck_near(form, 0.8),
            "extent": max(form.depth - form.draft, 0.3 * form.depth),
            "extent_end": max(form.depth - form.draft, 0.3 * form.depth),
            "varies": True,
            "shift_end": (0.0, 0.0, 0.08 * form.depth),
            "axes": "z",
        }
    ]


def bilge(form):
    middle = form.section("X", form.x(0.5), (form.x(0.5), form.half_breadth, form.low[2])).curve
    points = middle.points_at(np.linspace(0.0, middle.length, 200))
    size = np.array([1.0, form.half_breadth, form.draft])
    corner = np.array([form.x(0.5), form.half_breadth, form.low[2]])
    bilge = points[np.linalg.norm((points - corner) / size, axis=1).argmin()]
    x = np.linspace(form.x(0.3), form.x(0.7), ALONG)
    return [
        {
            "name": "Bilge",
            "base": "CURVE",
            "curve": [(at, bilge[1], bilge[2]) for at in x],
            "extent": 0.7 * form.draft,
            "shift": (0.0, 0.02 * form.half_breadth, -0.02 * form.draft),
            "axes": "yz",
        }
    ]


def tunnel(form):
    y = 0.35 * form.half_breadth
    x = np.linspace(form.x(0.02), form.x(0.16), ALONG)
    up = np.tile((0.0, 0.0, 1.0), (ALONG, 1))
    tree = native.require().SurfaceTree(form.surface)
    below = np.column_stack([x, np.full(ALONG, y), np.full(ALONG, form.low[2] - form.depth)])
    found = np.asarray(tree.ray_hits(below, up).points)
    found = found[np.isfinite(found).all(axis=1)]
    found = found[found[:, 2] < form.low[2] + form.draft] if len(found) else found
    if len(found) < 2:
        raise ValueError(
            "There is no bottom over the propellers, at a third of the breadth: place a field "
            "there by hand"
        )
    return [
        {
            "name": "Tunnel",
            "base": "CURVE",
            "curve": found,
            "extent": 0.3 * abs(form.half_breadth),
            "extent_end": 0.3 * abs(form.half_breadth),
            "varies": True,
            "shift": (0.0, 0.0, 0.08 * form.draft),
            "axes": "z",
        },
        {**protected_centre(form, 0.2), "axes": "z"},
    ]
