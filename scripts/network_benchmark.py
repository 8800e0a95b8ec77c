# SPDX-License-Identifier: GPL-3.0-or-later
"""A sample's lines to the patches of their network, one of its curves moved, and the network to a
control mesh, in processor time, against limits; part of ./hull bench.

PYTHONPATH=build/release/python:samples python3 scripts/network_benchmark.py
"""

import time

import hull_native as hn
import numpy as np
import vessels

NAME, STATIONS, WATERLINES = "container_ship", 19, 9
CURVE_TOLERANCE, JOIN_TOLERANCE = 1e-5, 2e-5  # of the length
REPEATS = 5
MOST_MS, MOST_MOVED_MS, MOST_HULL_MS = 2000.0, 50.0, 20000.0
MOVE = 0.05  # of a station, m
BUDGET, SHOWN_PARTS = 176, 8


def length_of(surface):
    return float(np.ptp(np.asarray(surface.mesh.points)[:, 0]))


def lines_of(surface):
    """Curves, and the tolerance that they are joined within, m."""
    beam = np.asarray(surface.mesh.points)[:, 1].max()
    curves = vessels.curves_of(
        surface, STATIONS, WATERLINES, CURVE_TOLERANCE,
        flat_buttocks=vessels.even(0.0, beam, WATERLINES), fading=True,
    )  # fmt: skip
    return curves, JOIN_TOLERANCE * length_of(surface)


def edited_lines(surface):
    """About 40 curves of stations, waterlines, knuckles and borders."""
    curves = vessels.curves_of(surface, STATIONS, WATERLINES, CURVE_TOLERANCE)
    return hn.CurveNetwork(curves, 1.5 * JOIN_TOLERANCE * length_of(surface))


def moved_station(surface, network):
    """The middle one of a network's stations, farther forward, and its number."""
    stations = [i for i, curve in enumerate(network.curves) if curve.kind == "station"]
    number = stations[len(stations) // 2]
    x = np.asarray(network.curves[number].points)[0, 0] + MOVE
    tolerance = CURVE_TOLERANCE * surface.mesh.size
    found = hn.network_curves(surface, stations=[x], tolerance=tolerance)
    return next(curve for curve in found if curve.kind == "station"), number


def followed(network, moved, number):
    """The network with a curve moved, and the patches beside it as they are shown."""
    anew = network.with_curve(moved, number)
    ends, curves = np.asarray(anew.edges), np.asarray(anew.edge_curves)
    near = np.zeros(len(anew.nodes), dtype=bool)
    near[ends[curves == number].ravel()] = True
    # Tangent planes are carried on to the next node.
    near[ends[near[ends].any(axis=1)].ravel()] = True
    count = 0
    for region in range(anew.region_count):
        edges = [edge for side in anew.sides(region) for edge, _ in side]
        if near[ends[edges]].any():
            patch = anew.patch(region)
            patch.evaluate(patch.grid(SHOWN_PARTS)[0])
            count += 1
    return count


def median_ms(work, repeats=REPEATS):
    """Of so many times, and what came of the last."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        made = work()
        times.append(1e3 * (time.process_time() - start))
    return float(np.median(times)), made


def tell(what, milliseconds, most):
    missed = "  MISSED" if milliseconds > most else ""
    print(f"{what:<50} {milliseconds:9.3f} ms   (at most {most:g} ms){missed}")


def main():
    surface = vessels.vessel(NAME).surface
    curves, tolerance = lines_of(surface)
    median, made = median_ms(lambda: hn.network_patches(hn.CurveNetwork(curves, tolerance)))
    tell(f"{len(curves)} curves joined, {made.patches.patch_count} patches", median, MOST_MS)
    network = edited_lines(surface)
    moved, number = moved_station(surface, network)
    median, count = median_ms(lambda: followed(network, moved, number))
    tell(f"one of {len(network.curves)} curves moved, {count} patches", median, MOST_MOVED_MS)
    median, hull = median_ms(lambda: hn.hull_from_network(network, budget=BUDGET), 1)
    count = len(hull.surface.mesh.points)
    tell(f"the network to a mesh of {count} points", median, MOST_HULL_MS)


if __name__ == "__main__":
    main()
