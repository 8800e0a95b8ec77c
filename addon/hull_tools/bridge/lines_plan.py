# SPDX-License-Identifier: GPL-3.0-or-later
"""What an Object.hull wants of its lines plan and table of offsets."""

from dataclasses import dataclass
from math import radians

import numpy as np

from .analyses.ranges import numbers
from .lines import multiples
from .units import as_typed

_OWN_PAPER = "OWN"


@dataclass(frozen=True)
class PlanLines:
    """The lines that are asked for, in m; positions given one by one count before spacings."""

    length: float
    station_spacing: float
    waterline_spacing: float
    buttock_spacing: float
    stations: tuple
    waterlines: tuple
    buttocks: tuple
    diagonals: tuple  # pairs of height in m and angle in rad
    frame_spacing: float
    in_frames: bool

    def positions(self, points):
        """(stations, waterlines, buttocks) in m, as far as control points (n, 3) in m reach."""
        low, high = points.min(axis=0), points.max(axis=0)
        aft, fore = min(low[0], 0.0), max(high[0], self.length)
        half_beam = max(abs(low[1]), abs(high[1]))
        return (
            self.stations or multiples(self.station_spacing, aft, fore, "stations", with_ends=True),
            self.waterlines or multiples(self.waterline_spacing, low[2], high[2], "waterlines"),
            self.buttocks or multiples(self.buttock_spacing, 0.0, half_beam, "buttocks"),
        )


def plan_lines(settings, metres_per_unit):
    """PlanLines of an Object.hull; ValueError for lists that can't be understood."""
    plan = settings.plan
    length = as_typed(settings.length_pp) * metres_per_unit
    frame_spacing = as_typed(plan.frame_spacing) * metres_per_unit
    stations = numbers(plan.stations, "Stations")
    in_frames = plan.stations_in == "FRAMES" and bool(stations)
    if in_frames:
        if not frame_spacing:
            raise ValueError("Give the frame spacing first: the stations are in frames")
        stations = tuple(number * frame_spacing for number in stations)
    return PlanLines(
        length,
        length / settings.station_count if settings.station_count else 0.0,
        as_typed(settings.waterline_spacing) * metres_per_unit,
        as_typed(settings.buttock_spacing) * metres_per_unit,
        stations,
        numbers(plan.waterlines, "Waterlines"),
        numbers(plan.buttocks, "Buttocks"),
        diagonals_from(plan.diagonals),
        frame_spacing,
        in_frames,
    )


def diagonals_from(text):
    """Pairs (height in m, angle in rad) of a text such as "5.2/35 4/50", the angle in degrees."""
    pairs = []
    for word in text.replace(";", " ").replace(",", ".").split():
        height, _, angle_deg = word.partition("/")
        try:
            pairs.append((float(height), radians(float(angle_deg))))
        except ValueError:
            raise ValueError(
                f'Diagonals: "{word}" should be a height in m, a slash, and an angle in degrees '
                "below the horizontal, such as 5.2/35"
            ) from None
    return tuple(pairs)


def drawing_options(settings, surface, metres_per_unit):
    """Keyword arguments of hull_native.write_lines_drawing that an Object.hull decides."""
    plan = settings.plan
    wanted = plan_lines(settings, metres_per_unit)
    stations, waterlines, buttocks = wanted.positions(surface.mesh.points)
    texts = (("Drawn", plan.drawn), ("Date", plan.date), ("Drawing no.", plan.number))
    return {
        "stations": np.array(stations),
        "waterlines": np.array(waterlines),
        "buttocks": np.array(buttocks),
        "diagonals": wanted.diagonals,
        "mirrored": settings.half,
        "draft": as_typed(settings.draft) * metres_per_unit or None,
        "length": wanted.length or None,
        "station_spacing": wanted.frame_spacing if wanted.in_frames else None,
        "frame_spacing": wanted.frame_spacing or None,
        "offsets": plan.offsets,
        "title_block": [(name, text) for name, text in texts if text],
        "paper": (plan.width, plan.height) if plan.paper == _OWN_PAPER else plan.paper,
        "scale": as_typed(plan.scale) or None,
        "dxf_unit": plan.dxf_unit,
    }
