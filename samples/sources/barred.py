# SPDX-License-Identifier: GPL-3.0-or-later
"""Ships with a flat bar round the whole centre plane and a stern bulb above an aperture."""

from dataclasses import dataclass, field

from .mesh import Mesh


@dataclass
class BarredShip:
    """What the bar and the sections are made of.

    contour: x and z along the bar, from the transom round boss, keel and bulb to the stem's head;
    bar: its half width. sections: rows of points from beside the bar to the deck edge, four of the
    counter and then those from the boss forward. counter, aperture, keel, stem: which of the
    bar's points begin the rows of the counter, the aperture, the keel and the stem. flat_bottom,
    flat_side: sections between which the border of the flat is a knuckle line.
    """

    contour: list
    sections: list
    bar: float
    half_beam: float
    counter: slice
    aperture: slice
    keel: slice
    stem: slice
    flat_bottom: slice
    flat_side: slice = field(default_factory=lambda: slice(None))

    def mesh(self):
        """The mesh; the points in the centre plane; the rows from the boss forward."""
        mesh = Mesh()
        bar = mesh.row([(x, self.bar, z) for x, z in self.contour[:-1]])
        x, z = self.contour[-1]
        head = mesh.point((x, 0.0, z))  # the bar ends in one point
        bar.append(head)
        middle = mesh.row([(x, 0.0, z) for x, z in self.contour[:-1]]) + [head]
        rows = [mesh.row(section) for section in self.sections]
        counter = [[start, *row] for start, row in zip(bar[self.counter], rows[:4])]
        mesh.strips(counter)
        aperture = [*bar[self.aperture], *rows[3]]
        after = [[start, *row] for start, row in zip(bar[self.keel][1:], rows[4:])]
        mesh.strips([aperture, *after, bar[self.stem]])
        mesh.strip(bar, middle)
        mesh.crease(bar)
        mesh.transom([middle[0], *counter[0]])
        mesh.crease([row[1] for row in after][self.flat_bottom])
        mesh.crease([row[-2] for row in rows[self.flat_side]])
        mesh.deck([row[-1] for row in rows] + [head])
        mesh.flat((0, 1, 0), self.half_beam)
        mesh.flat((0, 0, 1), 0.0)
        mesh.flat((-1, 0, 0), -self.contour[0][0], layer=1)
        return mesh, middle, after
