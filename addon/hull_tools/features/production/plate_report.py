# SPDX-License-Identifier: GPL-3.0-or-later
"""What came of plates that were laid out."""

from dataclasses import dataclass

_MOST_TOLD = 3


@dataclass(frozen=True)
class PlateReport:
    """rows: of hull_native.plate_rows; unsettled: names of plates whose layout did not settle;
    mass_t: of both sides; key: of the geometry that it is of, asked: what_is_asked() then;
    knuckles_deg: of keel plates that are not one with their mirror images for being slightly bent
    in the centre plane. mixed: how many plates lie on layers of different thickness. left_out:
    (name of a seam, m, place) of seams that end within a plate."""

    rows: list
    unsettled: list
    mass_t: float
    key: object = None
    asked: tuple = ()
    knuckles_deg: tuple = ()
    mixed: int = 0
    left_out: tuple = ()

    @property
    def text(self):
        pieces = sum(row["pieces"] for row in self.rows)
        text = f"{len(self.rows)} plates of {pieces} pieces, {self.mass_t:.2f} t"
        if self.unsettled:
            text += f"; not settled: {', '.join(self.unsettled)}"
        if self.knuckles_deg:
            count, most = len(self.knuckles_deg), max(self.knuckles_deg)
            text += f"; apart at a centre knuckle of up to {most:.1f}°: {count} keel plates"
        if self.mixed:
            text += f"; over layers of different thickness, with that of most: {self.mixed}"
        if self.left_out:
            ends = [f"{length:.2f} m of {name}" for name, length in self._left_out_lengths()]
            more = f" and {len(ends) - _MOST_TOLD} more" if len(ends) > _MOST_TOLD else ""
            text += f"; left out for ending within a plate: {', '.join(ends[:_MOST_TOLD])}{more}"
        return text

    def _left_out_lengths(self):
        """(name, m) of seams, the longest first."""
        lengths = {}
        for name, length, _ in self.left_out:
            lengths[name] = lengths.get(name, 0.0) + length
        return sorted(lengths.items(), key=lambda item: -item[1])
