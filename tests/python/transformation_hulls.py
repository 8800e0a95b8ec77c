# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls for tests of transformation: one whose sectional area curve is known, and the samples."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np

SAMPLE_FILES = sorted((Path(__file__).resolve().parents[2] / "samples").glob("*.hull.json"))
SAMPLES = [path.name.split(".")[0] for path in SAMPLE_FILES]

# Sections of wigley_areas(): half-breadths and depths of the control points, from the keel up.
_BREADTHS = np.array([0.0, 0.35, 0.7, 0.92, 1.0, 1.05, 1.1])
_DEPTHS = np.array([1.0, 0.97, 0.8, 0.5, 0.2, -0.1, -0.4])


def grid_mesh(points, is_round=False):
    """The hn.ControlMesh of points (rows, columns, 3), normals along columns x rows; is_round: the
    last column has the first one beside it."""
    rows, columns = points.shape[:2]
    corners = np.arange(rows * columns).reshape(rows, columns)
    if is_round:
        corners = np.concatenate([corners, corners[:, :1]], axis=1)
    faces = np.stack(
        [corners[:-1, :-1], corners[:-1, 1:], corners[1:, 1:], corners[1:, :-1]], axis=-1
    ).reshape(-1, 4)
    return hn.ControlMesh(points.reshape(-1, 3), np.full(len(faces), 4), faces.ravel())


def wigley_areas(stations):
    """(LimitSurface of a half hull from x = 0 to 2 that floats at z = 2, its largest area).

    Its sectional area curve is 1 - (x - 1)² exactly, as that of Wigley's parabolic hull: sections
    are one outline, as broad as 2 - x and as deep as x, so that control points lie on straight
    lines. (A hull with parabolic waterlines cannot be exact: where a surface ends its second
    derivative across the border vanishes.)
    """
    x = np.linspace(0.0, 2.0, stations)[:, None]
    points = np.stack([x + 0.0 * _BREADTHS, (2.0 - x) * _BREADTHS, 2.0 - x * _DEPTHS], axis=-1)
    surface = hn.LimitSurface(grid_mesh(points))
    body = hn.HullBody(surface, mirrored=True)
    return surface, hn.section_areas(body, [1.0], draft=2.0).areas[0]


def tube(stations, length=40.0, radius=5.0, around=48):
    """LimitSurface of a round tube, open at both ends, whose axis is at z = radius: as round as
    `around` control points can make it."""
    step = 2.0 * np.pi / around
    angles = step * np.arange(around)
    # So that the cubic B-spline goes through the circle at its knots.
    control = radius * 6.0 / (4.0 + 2.0 * np.cos(step))
    ring = np.stack([control * np.sin(angles), radius - control * np.cos(angles)], axis=-1)
    x = np.linspace(0.0, length, stations)
    points = np.concatenate(
        [np.repeat(x[:, None], around, 1)[..., None], np.tile(ring, (stations, 1, 1))], axis=-1
    )
    return hn.LimitSurface(grid_mesh(points, is_round=True))


class Sample:
    """A sample hull's surface and body with all limits that keep it as it should be."""

    def __init__(self, name):
        data = hull_io.read_hull(SAMPLE_FILES[SAMPLES.index(name)])
        self.data, shell = data, hull_io.shell_arrays(data)
        self.ship = data.particulars
        self.mesh = hn.ControlMesh(*shell.arguments())
        self.surface = hn.LimitSurface(self.mesh)
        self.half = data.half
        self.body = hn.HullBody(self.surface, mirrored=self.half)
        new_index = {old: new for new, old in enumerate(shell.point_indices.tolist())}
        self.flats = []  # (control points, unit normal)
        for flat in data.flats:
            points = {new_index[p] for face in flat.faces for p in data.faces[face]}
            self.flats.append((np.array(sorted(points)), np.array(flat.normal)))

    def where(self):
        """How it floats, as arguments of hydrostatics."""
        return {"draft": self.ship.draft, "length_pp": self.ship.length_pp, "beam": self.ship.beam}

    def limits(self, **more):
        points = self.mesh.points
        centre = np.flatnonzero(
            np.abs(points[:, 1]) <= hn.tolerances.ON_CENTRE_PLANE * self.mesh.size
        )
        # Flats along the ship keep their planes, the others go with the hull.
        held = [(centre, (0.0, 1.0, 0.0))] + [flat for flat in self.flats if flat[1][0] == 0.0]
        across = [flat[0] for flat in self.flats if flat[1][0] != 0.0]
        tied, directions = hn.square_ties(self.surface)
        return hn.TransformLimits(
            held_points=np.concatenate([points for points, _ in held]),
            held_normals=np.concatenate([np.tile(n, (len(points), 1)) for points, n in held]),
            tied=tied,
            tied_directions=directions,
            rigid=[*hn.plane_ends(self.surface), *across],
            **more,
        )

    def least_change(self, **wanted):
        """Moves that bring the hull to values of hull_native.FORM_NUMBERS, with __ for a dot, by
        the least change, with the limits that the add-on begins with; ValueError where there are
        none."""
        held = self._held_for_least_change()
        tied, directions = hn.square_ties(self.surface)
        reached, _ = hn.reach_within_breadth(
            self.surface,
            [hn.FormTarget(name.replace("__", "."), value) for name, value in wanted.items()],
            mirrored=self.half,
            openings=self.body.openings,
            stiffness=1.0,
            locked=self._parallel_points(),
            held_points=np.concatenate([points for points, _ in held]),
            held_normals=np.concatenate([np.tile(n, (len(points), 1)) for points, n in held]),
            tied=tied,
            tied_directions=directions,
            kept=hn.square_sums(self.surface),
            **self.where(),
        )
        if reached.status != "met":
            raise ValueError(f"{reached.status}: {reached.reached}")
        return reached.moves

    def _held_for_least_change(self):
        """[(control points, normal)]: flats and plane ends in their planes, the centre plane with
        its heights, the length, the greatest breadth."""
        points = self.mesh.points
        x, out = points[:, 0], np.abs(points[:, 1])
        centre = np.flatnonzero(out <= hn.tolerances.ON_CENTRE_PLANE * self.mesh.size)
        margin = 0.02 * np.ptp(x)
        ends = np.flatnonzero((x <= x.min() + margin) | (x >= x.max() - margin))
        held = [flat for flat in self.flats if flat[1][0] == 0.0]
        across = [flat[0] for flat in self.flats if flat[1][0] != 0.0]
        for part in [*across, *hn.plane_ends(self.surface)]:
            offsets = points[part] - points[part].mean(axis=0)
            held.append((np.asarray(part), np.linalg.svd(offsets)[2][2]))
        held += [(centre, axis) for axis in np.eye(3)[1 if self.half else 2 :]]
        widest = np.flatnonzero(out >= (1.0 - 1e-3) * out.max())
        return [*held, (ends, (1.0, 0.0, 0.0)), (widest, (0.0, 1.0, 0.0))]

    def _parallel_points(self):
        """Control points of the parallel middle body."""
        aft, forward = hn.parallel_body(self.body, draft=self.ship.draft)
        x = self.mesh.points[:, 0]
        is_long = forward - aft > 1e-3 * self.ship.length_pp
        return np.flatnonzero((x >= aft) & (x <= forward) & is_long)

    def moved(self, moves):
        """(surface, body) with the moves in them."""
        surface = hn.LimitSurface(self.mesh.with_points(self.mesh.points + moves))
        return surface, hn.HullBody(surface, mirrored=self.half)
