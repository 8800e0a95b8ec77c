# SPDX-License-Identifier: GPL-3.0-or-later
"""A HullGrid's control points fitted to a network: rows keep one x, what is flat stays flat."""

import numpy as np

from .._core import crease_curves, fit_surface, tolerances
from ..polylines import foot_on, lengths_along, points_at
from .bend_terms import bend_terms
from .curve_bends import curve_bend_terms
from .even_lines import even_lines
from .grid_mesh import grid_mesh, line_named

# Places of a line between two control points of the border or crease along it.
_BETWEEN = 6
# Of the length: points nearer to a flat's plane, or beyond it, are put into it.
_NEAR_FLAT = 1e-3
# Of the half-breadth: the points that are in a flat go beyond its rim.
_AROUND_FLAT = 0.12
# A place that is missed by the tolerance over this counts for twice as much; and at most.
_HEED, _MOST_HEED = 1.5, 2.0
_STEPS_OF_BENDS = 5
_X, _Y, _Z = np.eye(3)


class GridFit:
    """Fits a grid in stages; the grid's rows get the points. flats: as extreme_flats() has them.
    rows_stay: whether rows of one x keep that. bending: what fit_surface() has as fairness; bends:
    what bend_terms() has, its fairness and that of changes. by_normals: whether the surface has to
    be turned as targets are where they count: at knuckles places of one side do not draw the other
    one. lines: CurveBends that the surface is to have, with what curve_bend_terms() has as
    fairness, or None; with them rows that stay may lean at the ends."""

    def __init__(
        self,
        grid,
        targets,
        flats,
        rows_stay=False,
        bending=0.0,
        bends=(0.0, 0.0),
        by_normals=False,
        lines=None,
    ):
        self.grid, self.targets, self.flats = grid, targets, flats
        self._normals = targets.normals if by_normals else None
        self._rows_stay, self._bending, self._bends = rows_stay, bending, bends
        self._lines, self._may_lean = lines, rows_stay and lines is not None
        self.mesh = grid_mesh(grid)
        self.points = np.array(self.mesh.points)
        self.in_flats = {}  # point -> [axes]
        self.at_centre = set()
        self._limits = self._row_limits()
        self._weights, self._distances = targets.weights, None

    @property
    def surface(self):
        return self.mesh.surface(self.points)

    def flatten(self):
        """Points near flats, or beyond them, are in them from now on; and those beyond the centre
        plane in that."""
        beyond_centre = np.flatnonzero(self.points[:, 1] < 0.0)
        self.points[beyond_centre, 1] = 0.0
        self.at_centre.update(beyond_centre.tolist())
        outline = self.grid.outline
        margin = _AROUND_FLAT * outline.high[1]
        shell = np.zeros(len(self.points), dtype=bool)
        shell[self.mesh.numbers[self.mesh.numbers >= 0]] = True
        for flat in self.flats:
            beyond = (self.points[:, flat.axis] - flat.place) * (1.0 if flat.axis == 1 else -1.0)
            near = shell & (beyond > -_NEAR_FLAT * outline.length)
            for number in np.flatnonzero(near & flat.has(self.points, margin)).tolist():
                if flat.axis not in self.in_flats.get(number, []):
                    self.in_flats.setdefault(number, []).append(flat.axis)
                    self.points[number, flat.axis] = flat.place

    def heed(self, tolerance):
        """Places that the last run missed by much of the tolerance, m, count for more now."""
        more = 1.0 + np.minimum((_HEED * self._distances / tolerance) ** 2, _MOST_HEED)
        self._weights = np.where(self.targets.on_curves, more, 1.0) * self._weights

    def flat_points(self):
        """Tuples (points, normal, offset) of the flats."""
        found = []
        for flat in self.flats:
            points = sorted(n for n, axes in self.in_flats.items() if flat.axis in axes)
            if points:
                sign = 1.0 if flat.axis == 1 else -1.0
                normal = tuple((sign * np.eye(3)[flat.axis]).tolist())
                found.append((np.array(points), normal, sign * flat.place))
        return found

    def run(self, evenness, fairness, most_steps, progress=None):
        """evenness: what a second difference of the moves along a row or column counts for, of
        what a distance does; fairness: what a third difference of the places does, or with lines
        that are to have bends what of it is along the girth."""
        # Bends are those of the surface at the start of a part.
        is_changing = max(self._bends) > 0.0 or self._lines is not None
        part = _STEPS_OF_BENDS if is_changing else most_steps
        for done in range(0, most_steps, part):
            self._run(evenness, fairness, min(part, most_steps - done), progress)

    def _run(self, evenness, fairness, most_steps, progress):
        held, tied = self._limits
        flat = [(n, np.eye(3)[axis]) for n, axes in self.in_flats.items() for axis in axes]
        held = held + flat + [(n, _Y) for n in sorted(self.at_centre)]
        surface = self.surface
        found = fit_surface(
            surface,
            self.targets.points,
            normals=self._normals,
            weights=self._weights,
            curves=self._curves(surface),
            held_points=[number for number, _ in held],
            held_normals=np.array([normal for _, normal in held]).reshape(-1, 3),
            tied=np.array([pair for pair, _ in tied]).reshape(-1, 2),
            tied_directions=np.array([way for _, way in tied]).reshape(-1, 3),
            sums=self._even_moves(evenness)
            + self._fair_lines(fairness)
            + bend_terms(surface, *self._bends)
            + ([] if self._lines is None else curve_bend_terms(surface, *self._lines)),
            fairness=self._bending,
            draw_border=True,
            most_steps=most_steps,
            progress=progress,
        )
        self.points = np.array(found.points)
        self._distances = np.nan_to_num(np.asarray(found.distances))
        for row, numbers in zip(self.grid.rows, self.mesh.numbers):
            there = numbers >= 0
            row.points[there] = self.points[numbers[there]]
            if row.x is not None and not self._may_lean:
                row.x = float(np.median(row.points[there, 0]))

    def _row_limits(self):
        """Held points with normals; tied pairs with directions. Rows are put to one x first."""
        mesh, rows = self.mesh, self.grid.rows
        held = [(n, _Y) for n in np.flatnonzero(self._is_central()).tolist()]
        for points in mesh.ends.values():
            held += self._held_in_plane(sorted(points))
        at_end = set().union(*mesh.ends.values())
        self._beside_ends = _rows_beside_ends(rows)
        tied, leaders = [], {}
        apart = at_end | mesh.feet | self._below_arch() | self._leaning()
        for number, i in enumerate(mesh.row_of):
            row = rows[i]
            if row.x is None or number in apart:
                continue
            if row.is_knuckle or self._rows_stay or i in self._beside_ends:
                held.append((number, _X))
                self.points[number, 0] = row.x
            elif i in leaders:
                tied.append(((number, leaders[i]), _X))
                self.points[number, 0] = self.points[leaders[i], 0]
            else:
                leaders[i] = number
        for number, partner in mesh.partners.items():
            if partner == number:
                continue
            held.append((number, _Y))
            tied.append(((partner, number), _Z))
            self.points[partner, [0, 2]] = self.points[number, [0, 2]]
            if not any(pair[0] == partner and way is _X for pair, way in tied):
                tied.append(((partner, number), _X))
        return held, tied

    def _is_central(self):
        return np.abs(self.points[:, 1]) < tolerances.ON_CENTRE_PLANE * self.grid.outline.size

    def _below_arch(self):
        arch = self.grid.arch_row
        if arch is None:
            return set()
        below = {int(n) for n in self.mesh.numbers[arch, : self.grid.rows[0].low] if n >= 0}
        return below | {self.mesh.partners.get(n, n) for n in below}

    def _leaning(self):
        """With a post below an arch: the points that lean with the post in the first whole row,
        those of the columns that begin there, and with the stem's foot in the last one, the lower
        half of it."""
        grid, numbers = self.grid, self.mesh.numbers
        if not self._may_lean or grid.arch_row is None or grid.rows[-1].kind != "stem":
            return set()
        whole = [i for i, row in enumerate(grid.rows) if row.kind == "station" and row.low == 0]
        aft = numbers[whole[0], 1 : grid.rows[0].low]
        forward = numbers[whole[-1], 1 : 1 + grid.columns // 2]
        return set(aft.tolist()) | set(forward.tolist())

    def _held_in_plane(self, numbers):
        """Points of an end in its plane; it may lean."""
        place = self.points[numbers].mean(axis=0)
        normal = np.linalg.svd(self.points[numbers] - place, full_matrices=False)[2][2]
        normal[np.abs(normal) < 1e-6] = 0.0
        normal /= np.linalg.norm(normal)
        self.points[numbers] -= ((self.points[numbers] - place) @ normal)[:, None] * normal
        return [(number, normal) for number in numbers]

    def _even_moves(self, evenness):
        triples = self._runs(3)
        weights = evenness / np.sqrt(len(triples)) * np.array([1.0, -2.0, 1.0])
        rests = np.einsum("k,nkd->nd", weights, self.points[triples])
        return [(triple, weights, rest) for triple, rest in zip(triples, rests)]

    def _fair_lines(self, fairness):
        """Rows and columns are to be as parabolas are, but across knuckles."""
        creases = self.mesh.creases
        sharp = {point for edge in creases for point in edge}

        def is_smooth(run):
            edges = [(min(a, b), max(a, b)) in creases for a, b in zip(run, run[1:])]
            return all(
                point not in sharp or (edges[k] and edges[k + 1])
                for k, point in enumerate(run[1:-1])
            )

        runs = [run for run in self._runs(4).tolist() if is_smooth(run)]
        if self._lines is not None:
            return even_lines(self.points, self.mesh.faces, runs, fairness)
        weights = fairness / np.sqrt(max(len(runs), 1)) * np.array([-1.0, 3.0, -3.0, 1.0])
        return [(run, weights, np.zeros(3)) for run in runs]

    def _runs(self, length):
        """(n, length) points that follow one another in a row or column."""
        numbers = self.mesh.numbers
        runs = []
        for lines in (numbers, numbers.T):
            parts = [lines[k : len(lines) - length + 1 + k] for k in range(length)]
            runs.append(np.stack(parts, axis=-1).reshape(-1, length))
        runs = np.concatenate(runs)
        return runs[(runs.min(axis=1) >= 0) & (np.diff(runs, axis=1) != 0).all(axis=1)]

    def _curves(self, surface):
        curves = []
        for number, chain in enumerate(crease_curves(surface)):
            vertices = np.asarray(chain.vertices).tolist()
            edges = [(min(e), max(e)) for e in zip(vertices, vertices[1:])]
            names = {self.mesh.lines.get(edge) for edge in edges}
            if len(names) != 1 or None in names or chain.closed:
                continue
            line = line_named(self.grid, names.pop())
            stretch = _stretch(line, self.points[vertices])
            if len(stretch) > 1:
                curves.append((stretch, number, True))
        return curves


def _rows_beside_ends(rows):
    """Rows of one x beside others: they stay, so that they do not go beyond where sections are
    whole."""
    kinds = ["", *(row.kind for row in rows), ""]
    return {
        i
        for i in range(len(rows))
        if kinds[i + 1] == "station" and {kinds[i], kinds[i + 2]} & {"stem", "post", "free", "arch"}
    }


def _stretch(line, places):
    """Places along a line from the foot of the first place to that of the last, closer where these
    are, and nowhere far from one another."""
    lengths = lengths_along(line)
    feet = [foot_on(line, lengths, place)[0] for place in places]
    rising = feet[-1] > feet[0]
    feet = np.maximum.accumulate(feet) if rising else np.minimum.accumulate(feet)
    parts = [np.linspace(a, b, _BETWEEN, endpoint=False) for a, b in zip(feet, feet[1:]) if a != b]
    even = np.linspace(feet[0], feet[-1], _BETWEEN * len(places))
    return points_at(line, lengths, np.sort(np.concatenate([*parts, even]))[:: 1 if rising else -1])
