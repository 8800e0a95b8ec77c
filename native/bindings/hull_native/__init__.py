# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact hull surfaces from crease-tagged control meshes, their analysis and exchange.

Lengths are in metres, angles in radians; x points forward, y to port, z up. Arrays of points have
shape (n, 3). What a caller can get wrong raises ValueError saying what and where.
"""

import importlib

from ._core import *  # noqa: F401,F403

# What modelling does not need: the most of it takes large libraries.
_LATER = {
    "PlaceError": "._exchange",
    "write_step": "._exchange",
    "write_iges": "._exchange",
    "read_cad_report": "._exchange",
    "read_cad_geometry": "._exchange",
    "ComparedHull": ".comparison",
    "compare_areas": ".comparison",
    "compare_hulls": ".comparison",
    "difference": ".comparison",
    "DistanceField": ".distances",
    "surface_distances": ".distances",
    "CommonLayout": ".layouts",
    "common_layout": ".layouts",
    "half_breadth": ".breadth",
    "reach_within_breadth": ".breadth",
    "kept_ranges": ".kept_parts",
    "bilge_of": ".kept_parts",
    "map_surface": ".mapped_surface",
    "surface_ends": ".mapped_surface",
    "write_lines_drawing": ".lines_plan",
    "DiscMap": "._morphing",
    "MergedDiscs": "._morphing",
    "PlaceSearch": "._morphing",
    "TriangleDisc": "._morphing",
    "polygon_on_circle": "._morphing",
    "FeatureGraph": "._morphing",
    "FeatureMatch": "._morphing",
    "HullFamily": "._morphing",
    "HullFeature": "._morphing",
    "LayoutFit": "._morphing",
    "WholeVolume": "._morphing",
    "family_differences": "._morphing",
    "feature_graph": "._morphing",
    "fit_layout": "._morphing",
    "match_features": "._morphing",
    "renumbering": "._morphing",
    "CurveEnd": "._network",
    "CurveNetwork": "._network",
    "NetworkCurve": "._network",
    "NetworkPatches": "._network",
    "NetworkProblem": "._network",
    "TransfinitePatch": "._network",
    "network_check": "._network",
    "CurveDistance": ".network_targets",
    "NetworkHull": ".network_hull",
    "hull_from_network": ".network_hull",
    "NetworkReport": ".network_quality",
    "immersion_lines": ".network_quality",
    "network_immersion": ".network_quality",
    "network_meetings": "._network",
    "network_patches": "._network",
    "network_report": ".network_quality",
    "network_curves": ".sampled_network",
    "ClosedModel": "._production",
    "DevelopableStrip": "._production",
    "LargestWarp": "._production",
    "ModelLayers": "._production",
    "ModelSlice": "._production",
    "PanelMesh": "._production",
    "closed_model": "._production",
    "largest_warp": "._production",
    "ruled_warp": "._production",
    "wetted_panels": "._production",
    "GRAVITY": "._resistance",
    "MichellIntegral": "._resistance",
    "WaveResistance": "._resistance",
    "ittc_1957": "._resistance",
    "SurfaceAreas": ".surface_areas",
    "surface_areas": ".surface_areas",
    "HoltropResult": ".holtrop_resistance",
    "HoltropShip": ".holtrop_form",
    "Propeller": ".propulsion",
    "SEA_WATER_VISCOSITY": ".holtrop_resistance",
    "holtrop": ".holtrop_resistance",
    "holtrop_ship": ".holtrop_form",
    "PlaningBoat": ".planing",
    "PlaningResult": ".planing",
    "attc_1947": ".planing",
    "planing_at_trims": ".planing",
    "planing_boat": ".planing",
    "savitsky": ".planing",
    "resistance_plot": ".resistance_plots",
    "wave_heights": ".wave_pattern",
    "holtrop_table": ".resistance_table",
    "michell_table": ".resistance_table",
    "savitsky_table": ".resistance_table",
    "resistance_csv": ".resistance_table",
    "Plot": "._drawing",
    "PlotSheet": "._drawing",
    "lay_out_plot": "._drawing",
    "write_plot": "._drawing",
    "sectional_area_plot": ".plots",
    "hydrostatic_curves_plot": ".plots",
    "bonjean_plot": ".plots",
    "righting_lever_plot": ".plots",
    "cross_curves_plot": ".plots",
}


def __getattr__(name):
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(_LATER[name], __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return sorted({*globals(), *_LATER})
