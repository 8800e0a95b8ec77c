# SPDX-License-Identifier: GPL-3.0-or-later
"""What an Object.hull wants of its lines plan."""

import numpy as np

from ...bridge.blender.units import as_typed
from . import frames
from .line_places import line_places

_OWN_PAPER = "OWN"
_VIEWS = ("profile", "half_breadth", "body_plan")


def drawing_options(settings, surface, metres_per_unit):
    """Keyword arguments of hull_native.write_lines_drawing that an Object.hull decides."""
    plan = settings.plan
    wanted = line_places(settings, metres_per_unit)
    stations, waterlines, buttocks = wanted.positions(surface.mesh.points)
    by_table = wanted.in_frames and wanted.frames is not None
    texts = (("Drawn", plan.drawn), ("Date", plan.date), ("Drawing no.", plan.number))
    return {
        "stations": np.array(wanted.frame_numbers if by_table else stations),
        "stations_in": "frames" if by_table else "m",
        "waterlines": np.array(waterlines),
        "buttocks": np.array(buttocks),
        "diagonals": wanted.diagonals,
        "mirrored": settings.half,
        "draft": as_typed(settings.draft) * metres_per_unit or None,
        "length": wanted.length or None,
        "station_spacing": wanted.frame_spacing if wanted.in_frames and not by_table else None,
        "frame_spacing": wanted.frame_spacing or None,
        "frames": frames.frame_table(settings, metres_per_unit),
        "offsets": plan.offsets,
        "views": [name for name in _VIEWS if getattr(plan, name)],
        "title_block": [(name, text) for name, text in texts if text],
        "paper": (plan.width, plan.height) if plan.paper == _OWN_PAPER else plan.paper,
        "scale": as_typed(plan.scale) or None,
        "dxf_unit": plan.dxf_unit,
    }
