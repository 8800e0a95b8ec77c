# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields that are often wanted, in sizes that suit the hull: where to begin from."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...bridge import limits, native
from ...bridge.blender import units
from ...bridge.objects import curve_lines, field_faces, hull_mesh
from ..flotation import ship
from . import base_curves, field_list

# Points of a curve that is laid along the hull.
_ALONG = 9
# Of the half breadth: what is narrower is a stem.
_NARROW = 0.04


@dataclass(frozen=True, eq=False)
class _Form:
    """A hull in metres. surface: hull_native.LimitSurface; low, high (3,): the ends of it;
    half_breadth: with the sign of the side where it is widest; draft, depth: above the lowest
    point; control: mesh_arrays.ControlArrays."""

    surface: object
    low: np.ndarray
    high: np.ndarray
    half_breadth: float
    draft: float
    depth: float
    control: object

    @property
    def points(self):
        return self.control.points

    @cached_property
    def faces(self):
        """The points of each control face."""
        ends = np.cumsum(self.control.face_sizes)[:-1]
        return np.split(np.asarray(self.control.face_vertices), ends)

    @property
    def face_ids(self):
        return self.control.face_ids

    @property
    def length(self):
        return self.high[0] - self.low[0]

    def x(self, part):
        """From its aft end, 0, to its fore end, 1."""
        return self.low[0] + part * self.length

    def section(self, axis, position, near):
        """The base_curves.BaseCurve in which a plane cuts it, nearest to a place (3,)."""
        return base_curves.section_near(self.surface, axis, position, near)


def add(obj, scene, name):
    """Adds the fields of a recipe, one of RECIPES, to a hull. ValueError where the hull has no part
    that it is about: nothing is added then."""
    form = _form_of(obj, scene)
    rows = RECIPES[name](form)
    count = len(rows) + len(obj.hull.fields.fields)
    limits.at_most(count, "fields", limits.MOST_FIELDS)
    scale = units.metres_per_unit(scene)
    for row in rows:
        _add_row(obj, scene, row, scale)
    obj.hull.fields.active_field = count - len(rows)


def _form_of(obj, scene):
    scale, found = units.metres_per_unit(scene), hull_mesh.read(obj)
    control = found.control(scale)
    surface = ship.source_of(found, control).new_surface()
    points = surface.evaluate_grid(4)[0].reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    depth = float(high[2] - low[2])
    draft = units.as_typed(obj.hull.draft) * scale - low[2]
    widest = high[1] if high[1] >= -low[1] else low[1]
    if not (widest and depth > 0.0):
        raise ValueError("The hull is flat: give it a breadth and a depth first")
    draft = draft if 0 < draft < depth else 0.6 * depth
    return _Form(surface, low, high, widest, draft, depth, control)


def _add_row(obj, scene, row, scale):
    field = field_list.add(obj, scene, row.pop("role", "MOVE"), row.pop("base"))
    field.name = row.pop("name")
    field.axes = [axis in row.get("axes", "xyz") for axis in "xyz"]
    row.pop("axes", None)
    for name in ("curve", "becomes"):
        if name in row:
            title = field.name if name == "curve" else f"{field.name}: becomes"
            points = np.asarray(row.pop(name)) / scale
            setattr(field, name, curve_lines.made(title, points, False, obj))
    for name in ("extent", "extent_end", "place", "shift", "shift_end"):
        if name in row:
            setattr(field, name, np.asarray(row.pop(name)) / scale)
    field_faces.give(obj, field, row.pop("faces", ()))
    for name, value in row.items():
        setattr(field, name, value)


def _protected_centre(form, extent):
    """What is at the centre plane keeps its breadth."""
    return {
        "name": "Centre plane kept",
        "role": "PROTECT",
        "base": "PLANE",
        "axis": "Y",
        "place": (form.x(0.5), 0.0, form.low[2] + form.draft),
        "extent": extent * abs(form.half_breadth),
        "axes": "y",
    }


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


def _deck_near(form, part):
    """A place from which the nearest crease or border is the deck's edge."""
    deck = form.section("X", form.x(part), (form.x(part), form.half_breadth, form.high[2]))
    ends = deck.ends
    return ends[ends[:, 2].argmax()]


def _fore_waterline(form, part):
    """(_ALONG, 3) points of the waterline, from a part of the length to its fore end."""
    height = form.low[2] + form.draft
    line = form.section("Z", height, (form.x(0.8), form.half_breadth, height)).curve
    points = line.points_at(np.linspace(0.0, line.length, 400))
    fore = points[points[:, 0] > form.x(part)]
    if len(fore) < _ALONG:
        raise ValueError("The hull has no waterline in its fore ship: look at its draft")
    fore = fore[np.argsort(fore[:, 0], kind="stable")]
    return fore[np.linspace(0, len(fore) - 1, _ALONG).round().astype(int)]


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
        _protected_centre(form, 0.4),
        *_stem_kept(form),
        {
            "name": "Knuckle kept",
            "role": "PROTECT",
            "base": "CREASE",
            "place": _deck_near(form, 0.85),
            "extent": 0.25 * form.depth,
        },
    ]


def _sharpen(form):
    return _fore_ship(form, -0.12, "Sharper fore ship")


def _fatten(form):
    return _fore_ship(form, 0.12, "Fuller fore ship")


def _sheer(form):
    return [
        {
            "name": "Sheer",
            "base": "CREASE",
            "place": _deck_near(form, 0.8),
            "extent": max(form.depth - form.draft, 0.3 * form.depth),
            "extent_end": max(form.depth - form.draft, 0.3 * form.depth),
            "varies": True,
            "shift_end": (0.0, 0.0, 0.08 * form.depth),
            "axes": "z",
        }
    ]


def _bilge(form):
    middle = form.section("X", form.x(0.5), (form.x(0.5), form.half_breadth, form.low[2])).curve
    points = middle.points_at(np.linspace(0.0, middle.length, 200))
    size = np.array([1.0, form.half_breadth, form.draft])
    corner = np.array([form.x(0.5), form.half_breadth, form.low[2]])
    bilge = points[np.linalg.norm((points - corner) / size, axis=1).argmin()]
    x = np.linspace(form.x(0.3), form.x(0.7), _ALONG)
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


def _tunnel(form):
    y = 0.35 * form.half_breadth
    x = np.linspace(form.x(0.02), form.x(0.16), _ALONG)
    up = np.tile((0.0, 0.0, 1.0), (_ALONG, 1))
    tree = native.require().SurfaceTree(form.surface)
    below = np.column_stack([x, np.full(_ALONG, y), np.full(_ALONG, form.low[2] - form.depth)])
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
        _protected_centre(form, 0.2),
    ]


def _flare(form):
    return [
        {
            "name": "Flare",
            "base": "CREASE",
            "place": _deck_near(form, 0.85),
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
        _protected_centre(form, 0.3),
        *_stem_kept(form),
    ]


def _bulb(form):
    """The stem is drawn out below the waterline around an upright line: fields around the stem
    itself, which bends sharply at its foot, fold the bow."""
    low, draft = form.low[2], form.draft
    x = _stem_at(form, low + 0.4 * draft)
    heights = np.linspace(low + 0.25 * draft, low + 0.5 * draft, _ALONG)
    return [
        {
            "name": "Bulb",
            "base": "CURVE",
            "curve": [(x, 0.0, height) for height in heights],
            "extent": 0.7 * draft,
            "shift": (0.25 * draft, 0.0, 0.0),
        },
        {
            "name": "Width of the bulb",
            "base": "POINT",
            "place": (x - 0.1 * draft, 0.1 * draft, low + 0.35 * draft),
            "extent": 0.4 * draft,
            "shift": (0.0, 0.05 * draft, 0.0),
            "axes": "y",
        },
    ]


def _stem_at(form, height):
    """Where a ray from ahead meets the hull beside the centre plane."""
    tree = native.require().SurfaceTree(form.surface)
    ahead = (form.high[0] + form.length, 1e-3 * form.half_breadth, height)
    hits = tree.ray_hits([ahead], [(-1.0, 0.0, 0.0)])
    if not np.isfinite(hits.points).all():
        raise ValueError("The hull has no stem in its centre plane: place fields by hand")
    return float(hits.points[0, 0])


# By what properties.field_settings.RECIPES names them.
RECIPES = {
    "SHARPEN": _sharpen,
    "FATTEN": _fatten,
    "SHEER": _sheer,
    "BILGE": _bilge,
    "TUNNEL": _tunnel,
    "FLARE": _flare,
    "BULB": _bulb,
}
