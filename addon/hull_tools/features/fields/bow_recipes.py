# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of shape fields that change the fore ship."""

import numpy as np

from ...bridge import native
from .recipe_form import ALONG, deck_near, protected_centre

# Of the half breadth: what is narrower is a stem.
_NARROW = 0.04


def _stem_kept(form):
    """A field, or none: narrow faces along the stem keep as they are, which is rounded so tightly
    that control points beside it cannot follow without folds."""
    narrow = np.array([np.abs(form.points[face, 1]).max() for face in form.faces])
    foremost = np.array([form.points[face, 0].min() for face in form.faces])
    is_narrow = narrow < _NARROW * abs(form.half_breadth)
    own = np.flatnonzero(is_narrow & (foremost > form.x(0.7)))
    if not len(own):
        return []
    return [
        {
            "name": "Stem kept",
            "role": "PROTECT",
            "base": "FACES",
            "faces": form.face_ids[own],
            "extent": 0.02 * form.length,
        }
    ]


def _fore_waterline(form, part):
    """(ALONG, 3) points of the waterline, from a part of the length to its fore end."""
    height = form.low[2] + form.draft
    line = form.section("Z", height, (form.x(0.8), form.half_breadth, height)).curve
    points = line.points_at(np.linspace(0.0, line.length, 400))
    fore = points[points[:, 0] > form.x(part)]
    if len(fore) < ALONG:
        raise ValueError("The hull has no waterline in its fore ship: look at its draft")
    fore = fore[np.argsort(fore[:, 0], kind="stable")]
    return fore[np.linspace(0, len(fore) - 1, ALONG).round().astype(int)]


def _fore_ship(form, share, name):
    """The waterlines of the fore ship in or out, its deck edge or knuckle kept."""
    line = _fore_waterline(form, 0.65)
    return [
        {
            "name": name,
            "base": "CURVE",
            "curve": line,
            "extent": 0.8 * form.depth,
            "extent_end": 0.8 * form.depth,
            "varies": True,
            "shift": (0.0, 0.0, 0.0),
            "shift_end": (0.0, share * form.half_breadth, 0.0),
            "axes": "y",
        },
        protected_centre(form, 0.4),
        *_stem_kept(form),
        {
            "name": "Knuckle kept",
            "role": "PROTECT",
            "base": "CREASE",
            "place": deck_near(form, 0.85),
            "extent": 0.25 * form.depth,
        },
    ]


def sharpen(form):
    return _fore_ship(form, -0.12, "Sharper fore ship")


def fatten(form):
    return _fore_ship(form, 0.12, "Fuller fore ship")


def flare(form):
    return [
        {
            "name": "Flare",
            "base": "CREASE",
            "place": deck_near(form, 0.85),
            "extent": form.depth,
            "extent_end": form.depth,
            "varies": True,
            "shift_end": (0.0, 0.06 * form.half_breadth, 0.0),
            "axes": "y",
        },
        {
            "name": "Waterline kept",
            "role": "PROTECT",
            "base": "PLANE",
            "axis": "Z",
            "place": (form.x(0.8), 0.0, form.low[2] + form.draft),
            "extent": max(form.depth - form.draft, 0.3 * form.depth),
            "axes": "y",
        },
        protected_centre(form, 0.3),
        *_stem_kept(form),
    ]


def bulb(form):
    """A plain bow to a bulb by three curves (Veelo 2004, 6.2): the stem, a waterline that ends at
    the bulb's tip, the lowest waterline; each becomes another one, a curve object that can be
    changed.

    The first base is an upright line beside the stem: fields around the stem itself, which bends
    sharply at its foot, fold the bow. Each of the three has its own axes, so that they may overlap.
    """
    low, draft = form.low[2], form.draft
    x = _stem_at(form, low + 0.4 * draft)
    stem = np.zeros((ALONG, 3))
    stem[:, 0], stem[:, 2] = x, np.linspace(low + 0.2 * draft, low + 0.55 * draft, ALONG)
    drawn_out = stem.copy()
    drawn_out[:, 0] += 0.25 * draft * (0.8 + 0.2 * np.sin(np.linspace(0.0, np.pi, ALONG)))
    return [
        {
            "name": "Bulb: stem",
            "base": "CURVE",
            "curve": stem,
            "becomes": drawn_out,
            "extent": 0.7 * draft,
            "axes": "xz",
        },
        _fuller_waterline(form, "Bulb: waterline", 0.37, 0.06),
        _fuller_waterline(form, "Bulb: lowest waterline", 0.18, 0.025),
    ]


def _fuller_waterline(form, name, height, fuller):
    """A row: the waterline at a part of the draft becomes fuller by a part of it, from the stem as
    far aft as most of the draft."""
    line = _waterline_from_stem(form, form.low[2] + height * form.draft, 0.8 * form.draft)
    outward = np.zeros_like(line)
    part = np.linspace(0.0, 1.0, len(line))
    outward[:, 1] = (
        np.sign(form.half_breadth) * fuller * form.draft * np.sin(np.pi * part**0.6) ** 2
    )
    return {
        "name": name,
        "base": "CURVE",
        "curve": line,
        "becomes": line + outward,
        "extent": 0.55 * form.draft,
        "axes": "y",
    }


def _waterline_from_stem(form, height, length):
    """(2 ALONG, 3) points of the waterline at a height, evenly from its fore end aft."""
    near = (form.high[0], 1e-3 * form.half_breadth, height)
    line = form.section("Z", height, near).curve
    points = line.points_at(np.linspace(0.0, line.length, 2000))
    # Of a whole hull the line goes around the stem.
    side = points[points[:, 1] * form.half_breadth >= 0.0]
    fore = side[side[:, 0] > side[:, 0].max() - length]
    fore = fore[np.argsort(-fore[:, 0], kind="stable")]
    if len(fore) < 2 * ALONG:
        raise ValueError("The hull has no waterline at the bulb's height: place fields by hand")
    return fore[np.linspace(0, len(fore) - 1, 2 * ALONG).round().astype(int)]


def _stem_at(form, height):
    """Where a ray from ahead meets the hull beside the centre plane."""
    tree = native.require().SurfaceTree(form.surface)
    ahead = (form.high[0] + form.length, 1e-3 * form.half_breadth, height)
    hits = tree.ray_hits([ahead], [(-1.0, 0.0, 0.0)])
    if not np.isfinite(hits.points).all():
        raise ValueError("The hull has no stem in its centre plane: place fields by hand")
    return float(hits.points[0, 0])
