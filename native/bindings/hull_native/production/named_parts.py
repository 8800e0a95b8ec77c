# SPDX-License-Identifier: GPL-3.0-or-later
"""The closed hull in named parts, as programs of flow take them: hull, transom, deck, and what else
has a name."""

import numpy as np

# Cosine of how far a transom may lean, of the mean of a cell's or a closing's normals; how flat a
# cell is: the length of the sum of its triangles' areas as vectors over their sum; of the hull's
# length, how far from its after end a transom is at most.
_LEANING, _FLAT, _NEAR_AFT = 0.5, 0.995, 0.25


def surface_parts(model, names=None):
    """The triangles (m, 3) of a ClosedModel of closed_model() by part, {name: triangles}: each
    triangle is in one.

    names: {name: numbers of the surface's cells}, what the shell's parts are called; cells that are
    in none are "transom" where they are flat and look aft in the after quarter, else "hull". What
    closes the hull is "deck", "bottom", "transom", "front" or "side" by where it looks, each
    connected closing as one. ValueError for a model whose cells are not known, and for cells that
    it has not.
    """
    cells, triangles = model.cells, model.triangles
    if not len(cells):
        raise ValueError("Of this model it is not known what its triangles are of.")
    areas = _area_vectors(model)
    of = np.full(len(triangles), "hull", dtype=object)
    shell = np.flatnonzero(cells >= 0)
    of[shell[_is_transom(model, areas, shell)]] = "transom"
    for name, own in (names or {}).items():
        own = np.asarray(own)
        if own.size and not (0 <= own.min() and own.max() <= cells.max()):
            raise ValueError(f'The part "{name}" has cells that the model has not.')
        of[np.isin(cells, own) & (cells >= 0)] = name
    for closing in _closings(triangles, np.flatnonzero(cells < 0)):
        of[closing] = _looks(areas[closing].sum(axis=0))
    found = {
        name: triangles[of == name]
        for name in dict.fromkeys(of[np.argsort(cells < 0, kind="stable")])
    }
    return {"hull": found.pop("hull"), **found} if "hull" in found else found


def _area_vectors(model):
    a, b, c = model.points[model.triangles].transpose(1, 0, 2)
    return 0.5 * np.cross(b - a, c - a)


def _is_transom(model, areas, shell):
    """Of each triangle of the shell, whether its cell is flat and looks aft, near the after end."""
    cells = model.cells[shell]
    count = cells.max() + 1
    sums = np.stack([np.bincount(cells, areas[shell, k], count) for k in range(3)], axis=1)
    # Both sides of a half hull are of one cell: the athwartships part of one alone.
    sums[:, 1] = np.bincount(cells, np.abs(areas[shell, 1]), count)
    whole = np.bincount(cells, np.linalg.norm(areas[shell], axis=1), count)
    length = np.linalg.norm(sums, axis=1)
    x = model.points[:, 0]
    middles = model.points[model.triangles[shell]].mean(axis=1)[:, 0]
    reach = np.full(count, -np.inf)
    np.maximum.at(reach, cells, middles)
    with np.errstate(invalid="ignore", divide="ignore"):
        is_one = (length > _FLAT * whole) & (-sums[:, 0] > _LEANING * length)
    return (is_one & (reach < x.min() + _NEAR_AFT * np.ptp(x)))[cells]


def _closings(triangles, numbers):
    """The connected groups of triangles, by their common points."""
    root = {}

    def find(p):
        while root.setdefault(p, p) != p:
            root[p] = root[root[p]]
            p = root[p]
        return p

    for a, b, c in triangles[numbers].tolist():
        root[find(b)] = find(a)
        root[find(c)] = find(a)
    groups = {}
    for number in numbers:
        groups.setdefault(find(int(triangles[number, 0])), []).append(number)
    return [np.array(group) for group in groups.values()]


def _looks(way):
    axis = int(np.abs(way).argmax())
    return (("transom", "front"), ("side", "side"), ("bottom", "deck"))[axis][int(way[axis] > 0.0)]
