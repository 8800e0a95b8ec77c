# SPDX-License-Identifier: GPL-3.0-or-later
"""What this package uses of the native module and of hull_io, which lie beside it: on the Python
path, or in the same packaged add-on; there the native module may come from a wheel, which is on the
path."""

import importlib

_above = __package__.rpartition(".")[0]


def _beside(name, *wanted):
    try:
        module = importlib.import_module(f"{_above}.{name}" if _above else name)
    except ModuleNotFoundError:
        module = importlib.import_module(name)
    return [getattr(module, one) for one in wanted] if wanted else module


hull_native = _beside("hull_native")
smooth_curve = hull_native.smooth_curve
GirthLines, *_ = _beside("hull_native.networks.girth_lines", "GirthLines")
extreme_flats, *_ = _beside("hull_native.networks.extreme_flats", "extreme_flats")
GridFit, *_ = _beside("hull_native.networks.grid_fit", "GridFit")
RowsAndColumns, *_ = _beside("hull_native.networks.grid_refinement", "RowsAndColumns")
keel_range, laid_grid = _beside("hull_native.networks.hull_grid", "keel_range", "laid_grid")
HullOutline, find_ends = _beside("hull_native.networks.hull_outline", "HullOutline", "find_ends")
NetworkTargets, *_ = _beside("hull_native.networks.network_targets", "NetworkTargets")
bend_shares, end_to_end, foot_on, lengths_along, points_at, where_x_is = _beside(
    "hull_native.polylines",
    *("bend_shares", "end_to_end", "foot_on", "lengths_along", "points_at", "where_x_is"),
)

guess_hull, oriented, placed_views = _beside(
    "hull_io.geometry", "guess_hull", "oriented", "placed_views"
)
Flat, HullData, Kept, Particulars, edge_key, shell_and_transom = _beside(
    "hull_io.hull_data",
    *("Flat", "HullData", "Kept", "Particulars", "edge_key", "shell_and_transom"),
)
normals_of, spread_points = _beside("hull_io.triangles", "normals_of", "spread_points")
