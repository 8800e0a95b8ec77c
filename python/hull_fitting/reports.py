# SPDX-License-Identifier: GPL-3.0-or-later
"""How near a fitted hull is to what it was fitted to, in numbers."""

import numpy as np

from .beside import hull_native as hn
from .beside import spread_points
from .hull_files import station_points
from .immersion import immersed

# Places at which distances are measured.
_MEASURED = 20_000


def fit_report(shell, fitted, draft, tolerance, places=None):
    """A dict of numbers in m, m² and m³: points, distances of the source's surface, or of places
    (n, 3) that are given, from the hull (in all and below the draft), ∇ and wetted surface of both,
    what was found."""
    mesh, outline = shell.mesh, fitted.outline
    if places is None:
        places, _ = spread_points(mesh.points, mesh.triangles, _MEASURED)
    distances = np.asarray(hn.SurfaceTree(fitted.surface).closest_points(places).distances)
    low = places[:, 2] <= draft
    volume, area = immersed(mesh.points, mesh.triangles, outline, draft)
    found = hn.upright_hydrostatics(fitted.surface, draft=draft, mirrored=True)
    count = len(fitted.fit.points)
    return {
        "points": count,
        "points_in_rows_of_one_x": len(station_points(fitted)),
        "rows": len(fitted.fit.grid.rows),
        "columns": fitted.fit.grid.columns + 1,
        "length": outline.length,
        "draft": draft,
        "tolerance": tolerance,
        "within_tolerance": bool(distances.max() <= tolerance),
        "distances": _told(places, distances),
        "distances_below_draft": _told(places[low], distances[low]) if low.any() else None,
        "displaced_volume": {"source": volume, "hull": found.displaced_volume},
        "wetted_surface": {"source": area, "hull": found.wetted_surface},
        "features": _features(shell, fitted),
    }


def _told(places, distances):
    most = int(np.argmax(distances))
    return {
        "rms": float(np.sqrt(np.mean(distances**2))),
        "largest": float(distances[most]),
        "place": [round(float(c), 4) for c in places[most]],
    }


def _features(shell, fitted):
    outline = fitted.outline
    keel = outline.on_contour
    return {
        "profile": _ends(outline.contour),
        "deck_edge": _ends(outline.deck),
        "deck_left_out": round(shell.deck_area, 4),
        "transom": None if outline.aft is None else _ends(outline.aft),
        "transom_has_faces": "aft" in outline.ends,
        "flat_bow": None if outline.forward is None else _ends(outline.forward),
        "stem_begins": None if outline.stem is None else _place(keel(outline.stem)),
        "stern_post_ends": None if outline.post is None else _place(keel(outline.post)),
        "arch_above_post": None if outline.arch is None else _place(keel(outline.arch)),
        "knuckles": [_ends(line) for line in outline.knuckles],
        "flats": [
            {"normal": list(normal), "offset": float(offset), "points": len(points)}
            for points, normal, offset in fitted.flats
        ],
    }


def _ends(line):
    return [_place(line[0]), _place(line[-1])]


def _place(point):
    return [round(float(c), 4) for c in point]
