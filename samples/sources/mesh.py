# SPDX-License-Identifier: GPL-3.0-or-later
"""Control meshes laid out by hand: rows of points, strips of faces between them, tags by point.

Faces run counter-clockwise seen from the water. Between two rows that run upwards, `strip(aft,
forward)` does so on the port side.
"""

import numpy as np

SHELL = ("Shell", (0.55, 0.17, 0.14))
TRANSOM = ("Transom", (0.7, 0.7, 0.68))
# How far a point may be from a plane and yet be meant to lie in it, in m.
_IN_PLANE = 1e-9


class Mesh:
    """Points by number, faces by layer, creases, corners, deck edge and flats as they are added."""

    def __init__(self, layers=(SHELL, TRANSOM)):
        self.layers = list(layers)
        self.points = []
        self.faces = []
        self.face_layers = []
        self.creases = set()
        self.corners = set()
        self.deck_edge = set()
        self.flats = []

    def point(self, place):
        """The number of a point: a new one at (x, y, z), or the number that is given."""
        if isinstance(place, (int, np.integer)):
            return int(place)
        x, y, z = place
        self.points.append((float(x), float(y), float(z)))
        return len(self.points) - 1

    def row(self, places):
        """Numbers of a row of points, each a new one or one that is there already."""
        return [self.point(place) for place in places]

    def face(self, *corners, layer=0):
        """A face; a point repeated one after another counts once, so that a face of four corners
        may be given with two of them alike. Nothing comes of less than three points."""
        face = [a for a, b in zip(corners, corners[1:] + corners[:1]) if a != b]
        if len(face) > 2:
            self.faces.append(face)
            self.face_layers.append(layer)

    def strip(self, aft, forward, layer=0):
        """Faces between two rows of as many points."""
        if len(aft) != len(forward):
            raise ValueError(
                f"a strip between rows of {len(aft)} and {len(forward)} points: give rows alike"
            )
        for a, b, c, d in zip(aft, aft[1:], forward[1:], forward):
            self.face(a, b, c, d, layer=layer)

    def strips(self, rows, layer=0):
        """Strips between each row and the next."""
        for aft, forward in zip(rows, rows[1:]):
            self.strip(aft, forward, layer)

    def round_stem_body(self, sections, stem, is_fan=False):
        """Strips from the transom over sections to the stem, and the transom; the rows of points.

        Keel and stem are one line: the lowest point of the last section is its foot, which stands
        for the stem's two lowest points, too; `stem` has those above."""
        rows = [self.row(section) for section in sections]
        foot = rows[-1][0]
        rows.append([foot, foot, *self.row(stem)])
        self.strips(rows)
        self.transom(rows[0], is_fan=is_fan)
        return rows

    def transom(self, rim, layer=1, is_fan=False):
        """A plane transom within its rim, which runs up from the centre plane: the rim a knuckle,
        strips across, a further point in the centre plane at the height of the rim's end.

        is_fan: triangles from the further point instead, which do not fold about a rim that has
        corners and straight parts."""
        self.crease(rim)
        x, _, z = self.points[rim[-1]]
        ring = [*rim, self.point((x, 0.0, z))]
        if is_fan:
            self.corner(ring[-1])
            for above, below in zip(rim[1:], rim):
                self.face(ring[-1], above, below, layer=layer)
            return
        low, high = 0, len(ring) - 1
        while high - low >= 5:
            self.face(ring[high], ring[high - 1], ring[low + 1], ring[low], layer=layer)
            low, high = low + 1, high - 1
        self.face(*ring[high : low - 1 if low else None : -1], layer=layer)

    def crease(self, chain):
        """A knuckle along a chain of points."""
        self.creases.update(_edges(chain))

    def corner(self, *points):
        self.corners.update(points)

    def deck(self, chain):
        """The deck edge along a chain of points."""
        self.deck_edge.update(_edges(chain))

    def flat(self, normal, offset, layer=0):
        """Keeps the layer's faces flat that lie in the plane normal · point = offset."""
        normal = np.asarray(normal, dtype=float) / np.linalg.norm(normal)
        near = np.abs(np.array(self.points) @ normal - offset) < _IN_PLANE
        faces = [
            index
            for index, face in enumerate(self.faces)
            if self.face_layers[index] == layer and all(near[face])
        ]
        if not faces:
            raise ValueError(f"no face lies in the plane {normal} at {offset} m")
        self.flats.append((faces, tuple(normal.tolist()), float(offset)))

    def hull(self, hull_io, name, source, **particulars):
        """The HullData of the port half; particulars as in hull_io.Particulars."""
        return hull_io.HullData(
            name=name,
            points=np.array(self.points),
            faces=self.faces,
            creases=sorted(self.creases),
            corners=sorted(self.corners),
            half=True,
            layers=[hull_io.Layer(label, True, colour) for label, colour in self.layers],
            face_layers=self.face_layers,
            particulars=hull_io.Particulars(**particulars),
            deck_edge=sorted(self.deck_edge),
            flats=[hull_io.hull_data.Flat(*flat) for flat in self.flats],
            source=source,
        )


def _edges(chain):
    return {(min(a, b), max(a, b)) for a, b in zip(chain, chain[1:]) if a != b}


def by_station(values, stations):
    """A dictionary's values by x, at the stations: the same shape for each."""
    table = np.array(list(values.values()))
    shape = (len(stations), *table.shape[1:])
    return spline(list(values), table.reshape(len(table), -1))(stations).reshape(shape)


def spline(places, values, start=None, end=None):
    """A function of one number through values at rising places, curved as little as may be.

    values: (n,) or (n, d). start, end: the slope at the ends, free (no curvature) when not given.
    Beyond its ends it goes straight on.
    """
    x, y = np.asarray(places, dtype=float), np.asarray(values, dtype=float)
    slopes = _slopes(x, y, start, end)

    def at(place):
        place = np.asarray(place, dtype=float)
        inside = np.clip(place, x[0], x[-1])
        k = np.clip(np.searchsorted(x, inside, side="right") - 1, 0, len(x) - 2)
        h = x[k + 1] - x[k]
        t = (inside - x[k]) / h
        beyond = place - inside
        if y.ndim > 1:
            h, t, beyond = h[..., None], t[..., None], beyond[..., None]
        found = (1 + 2 * t) * (1 - t) ** 2 * y[k] + t * t * (3 - 2 * t) * y[k + 1]
        found = found + h * t * (1 - t) * ((1 - t) * slopes[k] - t * slopes[k + 1])
        return found + beyond * np.where(beyond < 0.0, slopes[0], slopes[-1])

    return at


def _slopes(x, y, start, end):
    """Slopes at the places of a spline of continuous curvature."""
    n = len(x)
    h = np.diff(x)
    secants = np.diff(y, axis=0) / (h if y.ndim == 1 else h[:, None])
    matrix, right = np.zeros((n, n)), np.zeros(y.shape)
    for k in range(1, n - 1):
        matrix[k, k - 1 : k + 2] = h[k], 2 * (h[k - 1] + h[k]), h[k - 1]
        right[k] = 3 * (h[k] * secants[k - 1] + h[k - 1] * secants[k])
    for k, near, slope, secant in ((0, 1, start, secants[0]), (-1, -2, end, secants[-1])):
        matrix[k, k] = 1.0 if slope is not None else 2.0
        matrix[k, near] = 0.0 if slope is not None else 1.0
        right[k] = slope if slope is not None else 3.0 * secant
    return np.linalg.solve(matrix, right)


def through(places):
    """Control points (n, d) of the crease or border that goes through given places (n, d).

    Such a line is a uniform cubic B-spline that begins and ends at its outermost control points.
    """
    places = np.asarray(places, dtype=float)
    matrix = np.eye(len(places))
    for k in range(1, len(places) - 1):
        matrix[k, k - 1 : k + 2] = 1 / 6, 4 / 6, 1 / 6
    return np.linalg.solve(matrix, places)


def faired(values, stiffness, held=(0, -1)):
    """Coordinates (n,) along a row, moved so that their third differences are small.

    stiffness: how much that counts against staying where they are. Those that are held stay.
    """
    values = np.asarray(values, dtype=float)
    # The surface goes on beyond the ends of a row as if it were reflected there.
    unit = np.eye(len(values))
    extended = np.vstack([2 * unit[0] - unit[1], unit, 2 * unit[-1] - unit[-2]])
    third = np.diff(extended, 3, axis=0)
    matrix = unit + stiffness * third.T @ third
    free = np.setdiff1d(np.arange(len(values)), np.arange(len(values))[list(held)])
    moves = np.zeros(len(values))
    right = -stiffness * (third.T @ (third @ values))
    moves[free] = np.linalg.solve(matrix[np.ix_(free, free)], right[free])
    return values + moves


def faired_patch(values, sections, rows, along, across):
    """Coordinates (sections, rows) of a grid, those of a patch moved so that third differences over
    sections and over rows are small.

    sections, rows: slices, the patch. along, across: how much that counts against staying.
    """
    values = np.asarray(values, dtype=float)
    count, width = values.shape
    over_sections = np.kron(np.diff(np.eye(count), 3, axis=0), np.eye(width))
    over_rows = np.kron(np.eye(count), np.diff(np.eye(width), 3, axis=0))
    uneven = along * over_sections.T @ over_sections + across * over_rows.T @ over_rows
    free = np.arange(values.size).reshape(values.shape)[sections, rows].reshape(-1)
    moves = np.zeros(values.size)
    matrix = np.eye(len(free)) + uneven[np.ix_(free, free)]
    moves[free] = np.linalg.solve(matrix, -(uneven @ values.reshape(-1))[free])
    return values + moves.reshape(values.shape)


def largest(values):
    """The largest coordinate of the crease or border of control points with these (n,)."""
    values = np.asarray(values, dtype=float)
    line = np.concatenate([2 * values[:1] - values[1:2], values, 2 * values[-1:] - values[-2:-1]])
    t = np.linspace(0.0, 1.0, 65)
    basis = (
        (1 - t) ** 3,
        3 * t**3 - 6 * t**2 + 4,
        -3 * t**3 + 3 * t**2 + 3 * t + 1,
        t**3,
    )
    spans = np.stack([line[k : len(line) - 3 + k] for k in range(4)], axis=1)
    return float((spans @ np.array(basis)).max() / 6)
