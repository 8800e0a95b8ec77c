# SPDX-License-Identifier: GPL-3.0-or-later
"""Views of a hull from anywhere as drawings of lines, those that are behind it left out."""

import numpy as np

from .._core import SurfaceTree, crease_curves, section, tolerances
from .._drawing import ShopDrawing
from .._production import ClosedModel, closed_model
from .hidden_lines import Eye, Sight

# Of the model's size: how far the model's triangles may be from the surface, and the chords of
# lines on it; by how many times that these are outside of it before it is asked what hides them.
_TOLERANCE, _OUTSIDE = 1e-4, 3.0
# Points of knuckles and borders between control points.
_SAMPLES = 64
# Of a chord: how far from a knuckle a line's normal there is taken.
_BESIDE = 1e-3
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
    behind an outline its end is off by three tolerances at most, and by 1e-5 of the drawing's
    size. Pieces shorter than 1/800 of the size may be missed. progress: called with the share
    done. ValueError for axes that are none, an eye in the hull, and as closed_model(), a tolerance
    of 0 for one.
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
    sight = Sight(seen, np.ptp(seen.points[:, :2], axis=0).max())
    off = _OUTSIDE * tolerance
    drawing = ShopDrawing(title or "View")
    lines = [("OUTLINE", _asked(eye, *line, off)) for line in _outlines(model, seen)]
    tell(0.4)
    given = {"stations": stations, "waterlines": waterlines, "buttocks": buttocks}
    lines += [
        (layer, _asked(eye, *line, off))
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


def _asked(eye, points, normals, is_closed, off):
    """A line for Sight.pieces(): of points with the normals of both of its sides (n, 3) each, from
    `off` outside of them. What looks away from the eye is not seen, but where the closing beside it
    may be."""
    columns = [eye.seen(points)]
    for own in normals:
        facing = np.ones(len(points)) if is_closed else eye.facing(points, own)
        columns += [eye.seen(points + off * own), facing[:, None]]
    return np.hstack(columns)


def _outlines(model, seen):
    """(points, normals of both sides, True) of the sides where a triangle that looks to the eye, +z
    of the model as it is seen, meets one that does not; their normals are the mean of these two."""
    a, b, c = seen.points[seen.triangles].transpose(1, 0, 2)
    front = np.cross(b - a, c - a)[:, 2] > 0.0
    sides = np.concatenate([model.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owners = np.tile(np.arange(len(model.triangles)), 3)
    order = np.lexsort(np.sort(sides, axis=1).T)
    first, second = order[::2], order[1::2]
    chosen = front[owners[first]] != front[owners[second]]
    # Along the triangle that is seen.
    kept = np.where(front[owners[first]], first, second)[chosen]
    a, b, c = model.points[model.triangles].transpose(1, 0, 2)
    units = _unit(np.cross(b - a, c - a))
    normals = np.zeros_like(model.points)
    for beside in (first[chosen], second[chosen]):
        for k in range(2):
            np.add.at(normals, sides[kept, k], units[owners[beside]])
    normals = _unit(normals)
    for chain in _chains(sides[kept].tolist()):
        yield model.points[chain], (normals[chain],) * 2, True


def _unit(vectors):
    lengths = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)


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


def _both_sides(body, points, normals, is_closed):
    yield points, normals, is_closed
    if body.mirrored and np.abs(points[:, 1]).max() > 0.0:
        other = (1.0, -1.0, 1.0)
        yield points * other, [own * other for own in normals], is_closed


def _sections(body, given, tolerance):
    """(layer, (points, normals of both sides, False)), from knuckle to knuckle."""
    tree = SurfaceTree(body.surface)
    for kind, places in given.items():
        for place in places:
            signs = (1.0, -1.0) if kind == "buttocks" and not body.mirrored else (1.0,)
            for sign in signs:
                curves = section(body.surface, _AXES[kind], sign * float(place), tolerance)
                for stretch in (one for curve in curves for one in curve.stretches):
                    normals = _normals_along(body.surface, tree, stretch.points)
                    for line in _both_sides(body, stretch.points, (normals,) * 2, False):
                        yield _LAYERS[kind], line


def _normals_along(surface, tree, points):
    """(n, 3) of the surface, at the ends of a line from within it, as they may be on knuckles."""
    places = points.copy()
    places[0] += _BESIDE * (points[1] - points[0])
    places[-1] += _BESIDE * (points[-2] - points[-1])
    found = tree.closest_points(places)
    return surface.normals(found.cells, found.uv)


def _features(body):
    """The same of knuckles, which have another normal on each side, and of borders, which have one,
    and that of the mirror image in the centre plane."""
    surface = body.surface
    on_centre = tolerances.ON_CENTRE_PLANE * surface.mesh.size
    for curve in crease_curves(surface):
        t = np.linspace(0.0, curve.edge_count, _SAMPLES * curve.edge_count + 1)
        points, normals = curve.evaluate(t)[0], []
        for cells, uv in (curve.left(t), curve.right(t)):
            if (cells >= 0).all():
                normals.append(surface.normals(cells, uv))
        is_border = len(normals) == 1
        is_central = is_border and body.mirrored and np.abs(points[:, 1]).max() < on_centre
        if is_border:
            normals.append(normals[0] * (1.0, -1.0, 1.0) if is_central else normals[0])
        for line in _both_sides(body, points, normals, is_border and not is_central):
            yield "SHELL", line
