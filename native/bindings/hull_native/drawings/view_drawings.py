# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of a hull from anywhere as drawings of lines, those that are behind it left out."""

import numpy as np

from .._core import feature_curves, section
from .._drawing import ShopDrawing
from .._production import ClosedModel, closed_model
from .hidden_lines import Eye, Sight

# Of the model's size: how far the model's triangles may be from the surface, and by how many times
# that a line is moved towards the eye before it is asked what is in front of it.
_TOLERANCE, _IN_FRONT = 1e-4, 20.0
# Points of knuckles and borders between control points.
_SAMPLES = 64
_LAYERS = {"stations": "FRAMES", "waterlines": "WATERLINES", "buttocks": "BUTTOCKS"}
_AXES = {"stations": "x", "waterlines": "z", "buttocks": "y"}


def view_drawing(
    body,
    *,
    axes,
    stations=(),
    waterlines=(),
    buttocks=(),
    knuckles=True,
    hidden=False,
    distance=None,
    tolerance=None,
    title="",
    progress=None,
):
    """The ShopDrawing of a whole HullBody, with its closings, as it is seen: outlines on the layer
    "OUTLINE", stations (x), waterlines (z) and buttocks (y) in m on "FRAMES", "WATERLINES",
    "BUTTOCKS", knuckles and borders on "SHELL"; what is hidden is left out, or, if `hidden`, on
    "HIDDEN".

    axes: view_axes(), or any rows to the right, up and towards the eye. distance: of the eye from
    the hull's middle, m; None: in parallel rays, at true size. tolerance, m: how far the triangles
    that hide lines may be from the surface (1e-4 of its size by default). Where a line passes
    behind an outline its end is off by as much as the outline, which is within tolerance of the
    surface's, and by 1e-5 of the drawing's size; where a surface turns away from the eye lines may
    end earlier than it does by that of a turn by 1/20: R / 800 of a bend of radius R. Pieces
    shorter than 1/800 of the size may be missed. progress: called with the share done. ValueError
    for axes that are none, an eye in the hull, and as closed_model(), a tolerance of 0 for one.
    """
    axes = np.asarray(axes, dtype=float)
    if axes.shape != (3, 3) or np.abs(axes @ axes.T - np.eye(3)).max() > 1e-6:
        raise ValueError("The axes of a view are three unit vectors square to one another.")
    tell = progress or (lambda share: None)
    size = body.surface.mesh.size
    tolerance = _TOLERANCE * size if tolerance is None else tolerance
    model = closed_model(body, tolerance, progress=lambda share: tell(0.3 * share))
    eye = Eye(axes, model.points, distance)
    seen = ClosedModel(eye.seen(model.points), model.triangles)
    scale = 1.0 if distance is None else eye.depth_scale
    sight = Sight(seen, np.ptp(seen.points[:, :2], axis=0).max(), _IN_FRONT * tolerance * scale)
    drawing = ShopDrawing(title or "View")
    lines = [("OUTLINE", line) for line in _outlines(seen)]
    tell(0.4)
    given = {"stations": stations, "waterlines": waterlines, "buttocks": buttocks}
    lines += [
        (layer, eye.seen(line))
        for layer, line in (
            *_sections(body, given, tolerance),
            *(_features(body) if knuckles else ()),
        )
    ]
    tell(0.5)
    for k, pieces in enumerate(sight.pieces([line for _, line in lines])):
        tell(0.8 + 0.2 * k / len(lines))
        for is_seen, piece in pieces:
            if is_seen or hidden:
                layer = lines[k][0]
                drawing.add_line(layer if is_seen else "HIDDEN", 1000.0 * eye.flat(piece))
    return drawing


def _outlines(model):
    """Polylines of the sides where a triangle that looks to +z meets one that does not."""
    a, b, c = model.points[model.triangles].transpose(1, 0, 2)
    front = np.cross(b - a, c - a)[:, 2] > 0.0
    sides = np.concatenate([model.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owners = np.tile(np.arange(len(model.triangles)), 3)
    order = np.lexsort(np.sort(sides, axis=1).T)
    first, second = order[::2], order[1::2]
    chosen = front[owners[first]] != front[owners[second]]
    # Along the triangle that is seen.
    kept = np.where(front[owners[first]], first, second)[chosen]
    return [model.points[chain] for chain in _chains(sides[kept].tolist())]


def _chains(sides):
    """Directed sides (a, b) joined to polylines of point numbers."""
    following = {}
    for a, b in sides:
        following.setdefault(a, []).append(b)
    heads = {a: len(ends) for a, ends in following.items()}
    for _, b in sides:
        heads[b] = heads.get(b, 0) - 1
    starts = [a for a, extra in heads.items() if extra > 0 for _ in range(extra)]
    chains = []
    for start in [*starts, *following]:
        while following.get(start):
            chain, at = [start], start
            while following.get(at):
                at = following[at].pop()
                chain.append(at)
                if at == start:
                    break
            chains.append(chain)
    return chains


def _both_sides(body, line):
    yield line
    if body.mirrored and np.abs(line[:, 1]).max() > 0.0:
        yield line * (1.0, -1.0, 1.0)


def _sections(body, given, tolerance):
    for kind, places in given.items():
        for place in places:
            signs = (1.0, -1.0) if kind == "buttocks" and not body.mirrored else (1.0,)
            for sign in signs:
                curves = section(body.surface, _AXES[kind], sign * float(place), tolerance)
                for curve in curves:
                    for line in _both_sides(body, curve.points):
                        yield _LAYERS[kind], line


def _features(body):
    for curve in feature_curves(body.surface, _SAMPLES):
        for line in _both_sides(body, curve.points):
            yield "SHELL", line
