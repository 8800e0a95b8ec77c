# SPDX-License-Identifier: GPL-3.0-or-later
"""The diagram of a ship's resistance over speeds, as `Plot` for `write_plot` and the screen."""

import numpy as np

from ._drawing import Plot

# Parts in the order in which they are drawn, by the columns of a table.
_PARTS = (
    ("Friction with form", ("friction_kN", "form_kN")),
    ("Pressure", ("pressure_kN",)),
    ("Waves", ("wave_kN",)),
    ("Residuary", ("residuary_kN",)),
    ("Keel", ("keel_kN",)),
    ("Rudder", ("rudder_kN",)),
    ("Heel", ("heel_kN",)),
    ("Appendages", ("appendages_kN",)),
    ("Bulb and transom", ("bulb_kN", "transom_kN")),
    ("Correlation", ("correlation_kN",)),
)


def resistance_plot(rows, *, title="Resistance", subtitles=(), others=()):
    """Total resistance and its parts over the speed in knots.

    rows: of michell_table(), holtrop_table(), savitsky_table() or delft_table(), one at least.
    others: pairs (name, rows) whose totals are drawn dashed beside it, such as another hull's or
    method's. ValueError for no rows.
    """
    rows = list(rows)
    if not rows:
        raise ValueError("A diagram of resistance needs a row of the table at least.")
    speeds = _column(rows, "speed_kn")
    plot = Plot(title, list(subtitles))
    plot.add_x_axis("Speed", "kn")
    plot.set_y_axis("Resistance", "kN", from_zero=True)
    plot.add_curve("Total", speeds, _column(rows, "total_kN"), symbol="RT")
    for name, columns in _PARTS:
        values = sum(_column(rows, column) for column in columns if column in rows[0])
        if np.any(values):
            plot.add_curve(name, speeds, values)
    for name, other in others:
        plot.add_curve(name, _column(other, "speed_kn"), _column(other, "total_kN"), style="dashed")
    return plot


def _column(rows, name):
    return np.array([row[name] for row in rows], dtype=float)
