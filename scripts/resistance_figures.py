# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/resistance.md: the coaster beside one of less beam, her waves and their
spectrum.

PYTHONPATH=build/dev/python python3 scripts/resistance_figures.py FOLDER
"""

import sys
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np

ROOT = Path(__file__).resolve().parents[1]
SPEED = 13.0 * 1852.0 / 3600.0  # m/s, of the waves
NARROWER = 0.92


def body_of(data):
    mesh = hn.ControlMesh(*hull_io.shell_arrays(data).arguments())
    return hn.HullBody(hn.LimitSurface(mesh, data.scheme), mirrored=data.half)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    data = hull_io.read_hull(ROOT / "samples" / "coaster.hull.json")
    draft, body = data.particulars.draft, body_of(data)
    speeds = np.linspace(8.0, 16.0, 33) * 1852.0 / 3600.0
    narrow = body_of(hull_io.scaled(data, (1.0, NARROWER, 1.0)))
    rows, others = (hn.holtrop_table(one, speeds, draft=draft) for one in (body, narrow))
    subtitle = f"coaster, Holtrop and Mennen 1984, draft {draft:.2f} m"
    plot = hn.resistance_plot(rows, subtitles=[subtitle], others=[(f"beam × {NARROWER}", others)])
    hn.write_plot(plot, folder / "beside.svg")
    integral, subtitle = hn.MichellIntegral(body, draft=draft), "coaster, 13 kn, by Michell"
    stern = hn.hydrostatics(body, draft=draft).waterline_aft
    found = hn.waves_behind(integral, SPEED, stern=stern, gravity=hn.GRAVITY)
    plot = hn.wave_pattern_plot(found.x, found.y, found.heights, subtitles=[subtitle])
    hn.write_plot(plot, folder / "wave-pattern.svg")
    degrees = np.linspace(0.0, 85.0, 681)
    power = np.radians(
        hn.resistance_by_direction(
            integral.amplitudes(SPEED, np.radians(degrees)),
            np.radians(degrees),
            speed=SPEED,
            water_density=hn.SEA_WATER_DENSITY,
        )
    )
    plot = hn.wave_spectrum_plot(degrees, power, subtitles=[subtitle])
    hn.write_plot(plot, folder / "wave-spectrum.svg")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
