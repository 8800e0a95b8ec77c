# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fit gives, stored with a hull: parents in the family's layout, their particulars, which
features are paired, and how well each parent is met."""

import re
from dataclasses import dataclass

import numpy as np

from ...bridge.blender import units
from ...bridge.counts import counted
from . import layout_mesh, pairs, parents

_NOTHING = 1e-6  # m: below single precision of hulls


@dataclass(frozen=True, eq=False)
class Alike:
    """common: hull_native.CommonLayout; layout: the hull_native.LimitSurface that gave the layout;
    graph: its FeatureGraph; graphs: those of the parents; apart: as it was asked for."""

    common: object
    layout: object
    graph: object
    graphs: list
    apart: dict


def store(obj, alike, taken, hulls, shape, form, scale):
    """Makes hulls the parents of a hull, in the place of those it has.

    taken: making.Taken of each; hulls: their objects; shape: (Taken, object) of the layout; form:
    (layout_mesh.Layout, materials); scale: metres of Blender's unit.
    """
    morph, (layout_taken, layout_hull), (layout, materials) = obj.hull.morph, shape, form
    common = alike.common
    layout = layout_mesh.subdivided(layout, alike.layout, common.subdivisions)
    _check_numbering(layout, common)
    morph.parents.clear()
    mesh = None
    for number, (one, hull, surface) in enumerate(zip(taken, hulls, common.parents)):
        points = surface.mesh.points / scale
        name = f"{obj.name}, {one.name}"
        if mesh is None:
            mesh = own = layout_mesh.new_mesh(name, layout, points, materials)
        else:
            own = layout_mesh.with_points(mesh, name, points)
        entry = morph.parents.add()
        entry.name, entry.source, entry.mesh, entry.source_key = one.name, hull, own, one.key
        for key, value in zip(parents.PARTICULARS, one.particulars):
            setattr(entry, key, value)
        fit = common.fits[number]
        entry.fit = fit_told(fit)
        entry.shortfall = _shortfall_told(fit, layout_taken.name, one.name)
        if fit is not None:
            pairs.give_features(entry, alike.graphs[number])
            apart = alike.apart.get(number, [])
            pairs.give_pairs(entry, fit.match, alike.graph, alike.graphs[number], apart)
    morph.layout_name, morph.layout_source = layout_taken.name, layout_hull
    morph.layout_key, morph.subdivisions = layout_taken.key, common.subdivisions
    pairs.give_features(morph, alike.graph)
    morph.has_other_pairs = False


def _check_numbering(layout, common):
    faces = np.asarray(common.parents[0].mesh.face_vertices)
    if not np.array_equal(faces, layout.face_vertices):
        raise AssertionError("the layout of the family is numbered otherwise than its mesh")


def fit_told(fit):
    """How well a parent is met, in a sentence."""
    if fit is None:
        return "Its own layout"
    rms, largest = max(fit.rms, fit.rms_back), max(fit.largest, fit.largest_back)
    if largest < _NOTHING:
        return "Its own points"
    return f"Met within {units.format_mm(rms)} RMS, {units.format_mm(largest)} at most"


def told(alike, names, layout_name):
    """(what came of the fits of parents with these names in a sentence, whether it warns)."""
    common = alike.common
    count = len(common.parents[0].mesh.points)
    text = f"Parents {', '.join(names)}: layout of {layout_name}, {counted(count, 'point')}"
    if common.subdivisions:
        text += f", subdivided {common.subdivisions} ×"
    warns = False
    for name, fit in zip(names, common.fits):
        if fit is None:
            continue
        text += f". {name}: {fit_told(fit)}"
        if fit.match.remarks:
            text += f", {counted(len(fit.match.remarks), 'line')} without counterpart"
        if fit.shortfall:
            warns = True
            text += f". {_shortfall_told(fit, layout_name, name)}"
    return text, warns


def _shortfall_told(fit, layout_name, name):
    """Why a parent is not met, or members are folded, and what to do, with the hulls' names; blank
    where neither is so."""
    return with_names(fit.shortfall if fit is not None else "", layout_name, name)


def with_names(text, layout_name, name):
    """A sentence of hull_native about a first hull, the layout's, and a second one, with names."""
    names = {"first": layout_name, "second": name}
    return re.sub(r"\b[Tt]he (first|second)( hull)?\b", lambda found: f'"{names[found[1]]}"', text)
