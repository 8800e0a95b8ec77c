# SPDX-License-Identifier: GPL-3.0-or-later
"""The colours of what is drawn over the 3D view, as they are until the user chooses others in the
add-on's preferences.

A new entry has its place in the preferences by itself; `preferences.colours` reads what is chosen.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Ink:
    """label: what it is the colour of. on_light, on_dark: sRGB, each part 0 to 1, on light and on
    dark grounds; on_dark is None for one that stands out from both."""

    label: str
    on_light: tuple
    on_dark: tuple = None


# Of what is printed over the view as on paper: plots, legends, notes; the same on any ground.
PAPER, INK = (0.97, 0.97, 0.96, 0.96), (0.12, 0.12, 0.12, 1.0)

# By the kinds of features.lines.lines and features.fairness.level_lines.
_LINES = {
    "station": Ink("Stations", (0.05, 0.05, 0.07), (0.96, 0.96, 0.96)),
    "waterline": Ink("Waterlines", (0.07, 0.25, 0.80), (0.50, 0.72, 1.00)),
    "buttock": Ink("Buttocks", (0.05, 0.42, 0.14), (0.49, 0.87, 0.53)),
    "diagonal": Ink("Diagonals", (0.50, 0.12, 0.60), (0.88, 0.62, 0.96)),
    "plane": Ink("Planes", (0.80, 0.05, 0.28), (1.00, 0.48, 0.65)),
    "draft": Ink("Design waterline", (0.00, 0.45, 0.75), (0.30, 0.84, 1.00)),
    "flat": Ink("Flats", (0.42, 0.38, 0.00), (0.86, 0.84, 0.40)),
    "feature": Ink("Knuckles, borders", (0.78, 0.31, 0.00), (1.00, 0.68, 0.34)),
    "isophote": Ink("Isophotes", (0.45, 0.10, 0.10), (1.00, 0.72, 0.66)),
    "reflection": Ink("Reflection lines", (0.08, 0.08, 0.30), (0.92, 0.95, 1.00)),
    "silhouette": Ink("Silhouette", (0.00, 0.00, 0.00), (1.00, 1.00, 0.80)),
}
# Of the hull that a hull is compared with: all of its lines.
_GHOST = {"ghost": Ink("Ghost", (1.00, 0.10, 1.00))}
_PLATES = {"seam": Ink("Seams, butts", (0.55, 0.00, 0.42), (1.00, 0.62, 0.90))}
# Where it is not selected: it recedes behind what is of the surface.
_NET = {"net": Ink("Control net", (0.58, 0.50, 0.68), (0.66, 0.62, 0.72))}
# Combs stand out from the hull: these can be told from light and dark alike.
_COMBS = {
    "station": Ink("Stations", (0.85, 0.20, 0.58)),
    "waterline": Ink("Waterlines", (0.12, 0.50, 0.95)),
    "buttock": Ink("Buttocks", (0.08, 0.62, 0.25)),
    "diagonal": Ink("Diagonals", (0.62, 0.36, 0.92)),
    "plane": Ink("Planes", (0.95, 0.25, 0.30)),
    "feature": Ink("Knuckles, borders", (0.95, 0.50, 0.05)),
    "row": Ink("Rows of points", (0.00, 0.62, 0.62)),
}
# Of combs; told apart by their shapes too.
_MARKS = {
    "inflection": Ink("Inflections", (0.80, 0.15, 0.00), (1.00, 0.75, 0.20)),
    "maximum": Ink("Most bent", (0.00, 0.20, 0.45), (0.35, 0.95, 0.95)),
    "minimum": Ink("Least bent", (0.40, 0.05, 0.45), (0.96, 0.66, 1.00)),
}
# Of the control mesh in edit mode; away from the orange of what is selected.
_TAGS = {
    "knuckle": Ink("Knuckles", (0.86, 0.08, 0.62)),
    "border": Ink("Borders", (0.00, 0.66, 0.70)),
    "deck_edge": Ink("Deck edge", (0.48, 0.72, 0.00)),
    "corner": Ink("Corners, darts", (0.86, 0.08, 0.62)),
    "irregular": Ink("Irregular points", (0.48, 0.30, 0.95)),
    "odd_face": Ink("Not quads", (0.80, 0.58, 0.00)),
    "locked": Ink("Locked", (0.10, 0.10, 0.14)),
    "kept": Ink("Kept in planes", (0.05, 0.36, 0.86)),
    "flat": Ink("Kept flat", (0.10, 0.65, 0.45)),
    "problem": Ink("Problems", (0.92, 0.06, 0.06)),
}

# By name: (title in the preferences, {kind: Ink}).
GROUPS = {
    "lines": ("Lines", _LINES),
    "ghost": ("Other hull", _GHOST),
    "plates": ("Plates", _PLATES),
    "net": ("Control net", _NET),
    "combs": ("Combs", _COMBS),
    "marks": ("Marks of combs", _MARKS),
    "tags": ("Tags in edit mode", _TAGS),
}


def property_names(group, kind):
    """Names in the add-on's preferences of a colour: on light and on dark grounds, or one for
    both."""
    name = f"{group}_{kind}"
    if GROUPS[group][1][kind].on_dark is None:
        return (name,)
    return (f"{name}_on_light", f"{name}_on_dark")
