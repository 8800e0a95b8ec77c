# SPDX-License-Identifier: GPL-3.0-or-later
"""The variants that no other one surpasses in two numbers at once, and their picture."""

import hull_native as hn
import numpy as np

from .evaluation import MISSED

SENSES = ("least", "most")
_GREY, _RED, _SAND = (0.55, 0.62, 0.70), (0.78, 0.16, 0.12), (0.85, 0.78, 0.62)


def pareto_front(x, y, senses=("least", "least"), among=None):
    """Indices (k,) of the points that no point surpasses, by rising x: none is as good in both and
    better in one. x, y: (n,), NaN of what does not count; senses: whether the "least" or the "most"
    is best; among (n,): which points count. ValueError for other senses and lengths."""
    x, y = np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)
    if x.ndim != 1 or x.shape != y.shape:
        raise ValueError(f"x and y must have one shape (n,), not {x.shape} and {y.shape}.")
    for sense in senses:
        if sense not in SENSES:
            raise ValueError(f'A sense is "least" or "most", not "{sense}".')
    counts = np.isfinite(x) & np.isfinite(y)
    if among is not None:
        counts &= np.asarray(among, dtype=bool)
    signs = [1.0 if sense == "least" else -1.0 for sense in senses]
    index = np.flatnonzero(counts)
    a, b = signs[0] * x[index], signs[1] * y[index]
    order = np.lexsort((b, a))
    found, best, at = [], np.inf, np.nan
    for k in order:
        if b[k] < best or (b[k] == best and a[k] == at):
            found.append(index[k])
            best, at = b[k], a[k]
    found = np.array(found, dtype=np.int64)
    return found[np.argsort(x[found], kind="stable")]


def front_plot(table, x, y, senses=("least", "least"), *, labels=None, title="", marks=()):
    """(hull_native.Plot for write_plot, the front's indices (k,)) of a Table's variants by two of
    its columns. labels: ((label, unit), (label, unit)) of the axes, else the columns' names. marks:
    tuples (x, y, text) of places of their own, such as the hull that all began with."""
    across, up = table.column(x), table.column(y)
    front = pareto_front(across, up, senses, among=table.made)
    labels = labels or ((x, ""), (y, ""))
    counts = table.counts()
    told = ", ".join(f"{count} {status}" for status, count in counts.items() if count)
    plot = hn.Plot(title or table.study.name, [f"{len(table.rows)} variants: {told}"])
    plot.add_x_axis(*labels[0])
    plot.set_y_axis(*labels[1])
    made = table.made
    _add_dots(plot, f"made: {made.sum()}", across[made], up[made], _GREY)
    missed = np.array([row.status == MISSED for row in table.rows], dtype=bool)
    if missed.any():
        _add_dots(plot, f"missed: {missed.sum()}", across[missed], up[missed], _SAND)
    if len(front):
        plot.add_curve(f"front: {len(front)}", across[front], up[front], colour=_RED)
        number = _add_dots(plot, "", across[front], up[front], _RED)
        for end in sorted({int(front[0]), int(front[-1])}):
            plot.add_marker(across[end], up[end], f"variant {end + 1}", curve=number)
    for place in marks:
        plot.add_marker(*place)
    return plot, front


def _add_dots(plot, name, x, y, colour):
    """Points without neighbours are drawn as dots."""
    apart = np.full(2 * len(x), np.nan)
    apart[::2] = x
    values = np.full(2 * len(y), np.nan)
    values[::2] = y
    return plot.add_curve(name, apart, values, colour=colour)
