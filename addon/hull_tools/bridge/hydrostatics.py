# SPDX-License-Identifier: GPL-3.0-or-later
"""Upright hydrostatics of a surface, with the names and units of the panel and of the table."""

import csv
from dataclasses import astuple, dataclass

from . import native
from .files import replacing


@dataclass(frozen=True)
class Hydrostatics:
    """Metres, m², m³ and tonnes; both sides; LCB and LCF from the after perpendicular."""

    draft: float
    displaced_volume: float
    displacement_t: float
    lcb: float
    kb: float
    lcf: float
    waterplane_area: float
    wetted_surface: float
    kmt: float


TABLE_HEADER = (
    "draft [m]",
    "displaced volume [m3]",
    "displacement [t]",
    "LCB from AP [m]",
    "KB [m]",
    "LCF from AP [m]",
    "waterplane area [m2]",
    "wetted surface [m2]",
    "KMt [m]",
)


def upright(surface, draft, half, water_density):
    """Hydrostatics of a hull_native.LimitSurface at a draft in m, in water of so many t/m³.

    ValueError when the hull does not reach the water or does not rise out of it.
    """
    found = native.require().upright_hydrostatics(surface, draft=draft, mirrored=half)
    volume = found.displaced_volume
    if volume <= 0.0:
        raise ValueError(f"Nothing is under water at a draft of {draft:.3f} m")
    return Hydrostatics(
        draft,
        volume,
        volume * water_density,
        found.lcb,
        found.kb,
        found.lcf,
        found.waterplane_area,
        found.wetted_surface,
        found.km_transverse,
    )


def write_table(path, rows):
    """Hydrostatics as CSV, one row each, units in the header; `path` is replaced only when done."""
    with replacing(path) as beside, open(beside, "w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(TABLE_HEADER)
        for row in rows:
            table.writerow([f"{value:.10g}" for value in astuple(row)])
