# SPDX-License-Identifier: GPL-3.0-or-later
"""Ships with a flat bar round the whole centre plane and a stern bulb above an aperture."""

from dataclasses import dataclass, field

from .mesh import Mesh


@dataclass
class BarredShip:
    """What the bar and the sections are made of.

    contour: x and z along the bar, from the transom round boss, keel and bulb to the stem's head;
    bar: its half width. sections: rows of points from beside the bar to the deck edge, those of the
    counter and then those from the boss forward. ring: points between the last section and as many
    of the stem, from the second on. counter, aperture, keel, stem: which of the
    bar's points begin the rows of the counter, the aperture, the keel and the stem; the keel's may
    be given one by one, and repeated where sections share one. flat_bottom, flat_side: sections
    between which the border of the flat is a knuckle line. short: the numbers of sections that end
    there, at the border of the flat side, and of those whose points of the deck edge they share.
    """

    contour: list
    sections: list
    bar: float
    half_beam: float
    counter: slice
    aperture: slice
    keel: object
    stem: slice
    flat_bottom: slice
    flat_side: slice = field(default_factory=lambda: slice(None))
    short: dict = field(default_factory=dict)
    ring: list = field(default_factory=list)

    def mesh(self):
        """The mesh; the points in the centre plane; the rows from the boss forward."""
        mesh = Mesh()
        bar = mesh.row([(x, self.bar, z) for x, z in self.contour[:-1]])
        x, z = self.contour[-1]
        head = mesh.point((x, 0.0, z))  # the bar ends in one point
        bar.append(head)
        middle = mesh.row([(x, 0.0, z) for x, z in self.contour[:-1]]) + [head]
        rows = [mesh.row(section) for section in self.sections]
        for section, whole in self.short.items():
            rows[section].append(rows[whole][-1])
        starts = bar[self.counter]
        counter = [[start, *row] for start, row in zip(starts, rows)]
        mesh.strips(counter)
        aperture = [*bar[self.aperture], *counter[-1][1:]]
        keel = bar[self.keel] if isinstance(self.keel, slice) else [bar[i] for i in self.keel]
        after = [[start, *row] for start, row in zip(keel[1:], rows[len(starts) :])]
        stem = bar[self.stem]
        # Where the ring has no points of its own it is the stem.
        ring = [stem[0], *mesh.row(self.ring), *stem[len(self.ring) + 1 :]]
        mesh.strips([aperture, *after, ring, stem])
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
