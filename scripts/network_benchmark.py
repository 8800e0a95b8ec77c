# SPDX-License-Identifier: GPL-3.0-or-later
"""A sample's lines to the patches of their network, in processor time, against a limit; part of
./hull bench.

PYTHONPATH=build/release/python:samples python3 scripts/network_benchmark.py
"""

import time

import hull_native as hn
import numpy as np
import vessels

NAME, STATIONS, WATERLINES = "container_ship", 19, 9
CURVE_TOLERANCE, JOIN_TOLERANCE = 1e-5, 2e-5  # of the length
REPEATS, MOST_MS = 5, 2000.0


def lines_of(surface):
    points = np.asarray(surface.mesh.points)
    low, high = points.min(axis=0), points.max(axis=0)
    length = high[0] - low[0]
    curves = hn.network_curves(
        surface,
        stations=np.linspace(low[0], high[0], STATIONS + 2)[1:-1],
        waterlines=np.linspace(low[2], high[2], WATERLINES + 2)[1:-1],
        flat_buttocks=np.linspace(0.0, high[1], WATERLINES + 2)[1:-1],
        fading=True,
        tolerance=CURVE_TOLERANCE * length,
    )
    return curves, JOIN_TOLERANCE * length


def main():
    curves, tolerance = lines_of(vessels.vessel(NAME).surface)
    times = []
    for _ in range(REPEATS):
        start = time.process_time()
        made = hn.network_patches(hn.CurveNetwork(curves, tolerance))
        times.append(1e3 * (time.process_time() - start))
    median = float(np.median(times))
    what = f"{len(curves)} curves joined, {made.patches.patch_count} patches"
    missed = "  MISSED" if median > MOST_MS else ""
    print(f"{what:<50} {median:9.3f} ms   (at most {MOST_MS:g} ms){missed}")


if __name__ == "__main__":
    main()
