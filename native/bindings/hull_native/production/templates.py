# SPDX-License-Identifier: GPL-3.0-or-later
"""Templates to which plates are rolled: sections normal to the plate, from one base plane."""

from dataclasses import dataclass

import numpy as np

from .._drawing import ShopDrawing

_SHORTEST = 0.05  # m


@dataclass(frozen=True)
class Template:
    """name: that of the mark. line: (k, 2), m, the plate along the template, x from the base line's
    mark outward and y from the base plane. on_hull: the same points (k, 3)."""

    name: str
    line: np.ndarray
    on_hull: np.ndarray


def plate_templates(listed, curves, marks, *, height=0.15):
    """Templates of a ListedPlate at marks (SurfaceCurve), made by HullCurves: each in the plane
    through the mark's ends that holds the plate's mean normal, so that all stand upright on one
    base plane, `height` (m) inward of the plate's nearest point. x is counted from the plane
    through the plate's centre along its length.

    Marks that do not cross the plate are left out. ValueError where none does, and for a height
    that is not above 0.
    """
    if not (np.isfinite(height) and height > 0.0):
        raise ValueError(f"The height of templates must be above 0 m, not {height:g}.")
    normal, centre = mean_normal(listed.plate)
    cuts = []
    for mark, begin, end in _crossings(listed, marks):
        along = end - begin
        along -= (along @ normal) * normal
        along /= np.linalg.norm(along)
        across = np.cross(normal, along)
        try:
            found = curves.in_plane(np.append(across, across @ begin), mark.name)
        except ValueError:
            found = [mark]  # along the hull's border, which the plane misses by rounding
        for curve in found:
            for _, hull in listed.flat.marks(curve):
                # Of the plane's branches the one at the mark.
                if min(np.linalg.norm(hull - begin, axis=1)) < 0.3 * np.linalg.norm(end - begin):
                    cuts.append((mark.name, hull, along))
    if not cuts:
        raise ValueError(
            f"No mark crosses plate {listed.name}: there is nothing to make templates at."
        )
    plane = min(float(((hull - centre) @ normal).min()) for _, hull, _ in cuts) - height
    made = []
    for name, hull, along in cuts:
        line = np.stack([(hull - centre) @ along, (hull - centre) @ normal - plane], axis=1)
        if line[0, 0] > line[-1, 0]:
            line, hull = line[::-1], hull[::-1]
        made.append(Template(name, line, hull))
    return made


def _crossings(listed, marks):
    """(mark, begin, end) of the parts of marks on a ListedPlate that are longer than 0.05 m, their
    ends (3,) on the hull: where templates can stand."""
    return [
        (curve, hull[0], hull[-1])
        for curve in marks
        for _, hull in listed.flat.marks(curve)
        if np.linalg.norm(hull[-1] - hull[0]) > _SHORTEST
    ]


def mean_normal(plate):
    """(unit normal of the closed border by its area vector, centre) of a Plate."""
    loop = np.concatenate([line[:-1] for _, line in plate.loops[0]])
    centre = np.asarray(plate.centre)
    vector = np.cross(loop - centre, np.roll(loop, -1, axis=0) - centre).sum(axis=0)
    return vector / np.linalg.norm(vector), centre


def template_drawing(listed, templates):
    """The ShopDrawing of templates, one above the other on their base lines, with the sight line
    (x = 0) and heights at the ends."""
    drawing = ShopDrawing(f"Templates of plate {listed.name}", [("Templates", str(len(templates)))])
    level = 0.0
    for template in templates:
        line = template.line + [0.0, level]
        low, high = line[0, 0], line[-1, 0]
        outline = np.concatenate([[[low, level]], line, [[high, level], [low, level]]])
        drawing.add_line("OUTLINE", 1000.0 * outline)
        top = float(template.line[:, 1].max())
        if low < 0.0 < high:
            drawing.add_line("BASE", 1000.0 * np.array([[0.0, level], [0.0, level + top]]))
        middle = 500.0 * (low + high)
        drawing.add_text(template.name, (middle, 1000.0 * level + 40.0), size=10.0)
        for x, y in (template.line[0], template.line[-1]):
            drawing.add_text(
                f"{1000.0 * y:.1f}",
                (1000.0 * x, 1000.0 * (level + 0.5 * y)),
                size=6.0,
                angle=np.pi / 2,
            )
        level += top + 0.1
    return drawing
