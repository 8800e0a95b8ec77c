# SPDX-License-Identifier: GPL-3.0-or-later
"""The list of a shell's plates: sizes, weights, stretch; and how they lie on stock plates."""

from dataclasses import dataclass, field, replace
from math import degrees, isfinite

from ..csv_rows import csv_text

# t/m³
STEEL = 7.85
# Of names of plates of which there is one on each side.
PAIR = " P/S"


@dataclass(frozen=True)
class ListedPlate:
    """A Plate with its name, thickness (m) and FlatPlate. is_turned: it is the other side's, the
    mirror image of these. is_pair: it stands for a plate of each side."""

    name: str
    plate: object
    thickness: float
    flat: object
    density: float = STEEL
    is_turned: bool = False
    is_pair: bool = False

    @property
    def mass_t(self):
        """Of the plate as it is on the hull, t: its exact area times the thickness."""
        return self.plate.area * self.thickness * self.density

    @property
    def extents(self):
        """(length, breadth) of the least rectangle around the flat plate, m."""
        return tuple(float(e) for e in self.flat.points.max(axis=0))

    @property
    def outline(self):
        """Lines (k, 2) of the flat plate's sides and its holes', m, seen from the water."""
        return [self.as_laid(line) for _, line in all_sides(self.flat)]

    def as_laid(self, places):
        """Places (…, 2) of the flat plate, m, as they are on this piece."""
        return places * [-1.0, 1.0] + [self.extents[0], 0.0] if self.is_turned else places

    @property
    def pieces(self):
        """ListedPlates of single pieces: itself, or one a side, "… P" and "… S"."""
        if not self.is_pair:
            return [self]
        name = self.name.removesuffix(PAIR)
        port = replace(self, name=f"{name} P", is_pair=False)
        return [port, replace(port, name=f"{name} S", is_turned=True)]


def plate_list(
    plates, *, thickness, names=None, density=STEEL, mirrored=False, poisson=0.3, progress=None
):
    """ListedPlates of plates, laid out: those of plates(), with one thickness (m) or one each.

    names: one each; by default P1, P2 … from aft. mirrored: the plates are the port half's, and
    names say so, but of those across the centre plane. density: t/m³. progress: called with the
    share done; what it raises ends the work. ValueError for a thickness or a density that is not
    above 0, and where counts differ.
    """
    plates = list(plates)
    thicknesses = list(thickness) if hasattr(thickness, "__len__") else [thickness] * len(plates)
    if names is None:
        names = [f"P{k + 1}" for k in range(len(plates))]
    if not len(names) == len(thicknesses) == len(plates):
        raise ValueError(
            f"There are {len(plates)} plates, {len(names)} names and {len(thicknesses)} "
            "thicknesses: give one for each."
        )
    for name, value in [("density", density)] + [("thickness", t) for t in thicknesses]:
        if not (isfinite(value) and value > 0.0):
            raise ValueError(f"The {name} of plates must be above 0, not {value:g}.")
    listed = []
    for k, plate in enumerate(plates):
        if progress:
            progress(k / len(plates))
        is_pair = mirrored and not plate.across
        name = names[k] + PAIR if is_pair else names[k]
        flat = plate.flat(poisson)
        listed.append(ListedPlate(name, plate, thicknesses[k], flat, density, is_pair=is_pair))
    return listed


def all_sides(flat):
    """The sides of a FlatPlate's outline, and those of its holes."""
    return [*flat.sides, *(side for hole in flat.holes for side in hole)]


def form_of(flat):
    """How a FlatPlate was laid out, in words for lists and drawings."""
    if flat.developed:
        return "developed"
    return "doubly curved" if flat.converged else "doubly curved, not settled"


def plate_rows(listed):
    """Rows of ListedPlates for a list. Stretches are lengths on the hull over those on the flat
    plate; areas are the exact surface's and the flat plate's."""
    rows = []
    for one in listed:
        flat, (length, breadth) = one.flat, one.extents
        least, largest = flat.stretch
        low, high = one.plate.box
        rows.append(
            {
                "plate": one.name,
                "thickness_mm": 1000.0 * one.thickness,
                "area_m2": one.plate.area,
                "flat_area_m2": flat.area,
                "mass_kg": 1000.0 * one.mass_t,
                "pieces": 2 if one.is_pair else 1,
                "length_m": length,
                "breadth_m": breadth,
                "of_rectangle": flat.area / (length * breadth),
                "form": form_of(flat),
                "least_stretch": least,
                "largest_stretch": largest,
                "stretch_error": flat.stretch_error,
                "rolling_radius_m": flat.rolling_radius,
                "roll_from_length_deg": degrees(flat.rolling_angle),
                "x_from_m": float(low[0]),
                "x_to_m": float(high[0]),
                "centre_x_m": float(one.plate.centre[0]),
                "centre_y_m": float(one.plate.centre[1]),
                "centre_z_m": float(one.plate.centre[2]),
            }
        )
    return rows


def rows_csv(rows):
    """Rows as comma-separated values, numbers with seven digits. ValueError for none."""
    if not rows:
        raise ValueError("There is nothing to list.")
    return csv_text(rows, 7)


@dataclass
class StockPlate:
    """A plate of the mill, length and breadth in m, with what lies on it: (plate, x, y), the lower
    left corner of the plate's rectangle."""

    length: float
    breadth: float
    thickness: float
    laid: list = field(default_factory=list)
    shelves: list = field(default_factory=list)  # [y, height, taken length]

    @property
    def used(self):
        """The share of its area that becomes plates of the hull."""
        area = sum(one.flat.area for one, _, _ in self.laid)
        return area / (self.length * self.breadth)


def nesting(listed, stock, *, margin=0.02):
    """The pieces of ListedPlates laid on plates of the mill by their rectangles, in rows, the
    broadest first: a list of StockPlate, those of one thickness together.

    stock: (length, breadth) in m of what can be had. margin (m) is left around each plate. Plates
    are laid along the stock's length. ValueError, naming it, for a plate that none of these holds.
    """
    if not (isfinite(margin) and margin >= 0.0):
        raise ValueError("The margin around plates must be 0 m or more.")
    stock = sorted((tuple(float(e) for e in s) for s in stock), key=lambda s: s[0] * s[1])
    if not stock or not all(isfinite(a) and isfinite(b) and a > 0 and b > 0 for a, b in stock):
        raise ValueError("Stock plates need a length and a breadth above 0 m.")
    used = []
    pieces = [piece for one in listed for piece in one.pieces]
    for one in sorted(pieces, key=lambda p: (-p.thickness, -p.extents[1], -p.extents[0])):
        length, breadth = (e + 2.0 * margin for e in one.extents)
        fits = [s for s in stock if length <= s[0] and breadth <= s[1]]
        if not fits:
            raise ValueError(
                f"Plate {one.name} takes {length:.2f} m by {breadth:.2f} m with its margin, and no "
                "stock plate is so large: put another seam or butt there, or order a larger one."
            )
        of_thickness = [s for s in used if s.thickness == one.thickness]
        if not any(_lay(plate, one, length, breadth, margin) for plate in of_thickness):
            used.append(StockPlate(*fits[0], one.thickness))
            _lay(used[-1], one, length, breadth, margin)
    return used


def _lay(stock, one, length, breadth, margin):
    """Whether the plate found room: in a row that is there, or in a new one."""
    for shelf in stock.shelves:
        if breadth <= shelf[1] and shelf[2] + length <= stock.length:
            stock.laid.append((one, shelf[2] + margin, shelf[0] + margin))
            shelf[2] += length
            return True
    y = sum(shelf[1] for shelf in stock.shelves)
    if y + breadth > stock.breadth or length > stock.length:
        return False
    stock.shelves.append([y, breadth, length])
    stock.laid.append((one, margin, y + margin))
    return True


def nesting_rows(used):
    """Rows of a nesting for a list: of each plate its stock plate and place, m."""
    return [
        {
            "stock": f"S{k + 1}",
            "stock_length_m": stock.length,
            "stock_breadth_m": stock.breadth,
            "thickness_mm": 1000.0 * stock.thickness,
            "used": stock.used,
            "plate": one.name,
            "at_x_m": x,
            "at_y_m": y,
        }
        for k, stock in enumerate(used)
        for one, x, y in stock.laid
    ]
