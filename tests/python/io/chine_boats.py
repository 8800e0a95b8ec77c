# SPDX-License-Identifier: GPL-3.0-or-later
"""A small boat by its chines, as the files of three programs have it."""

import numpy as np

# Five bulkheads, stern first: keel, chine, sheer; m.
_X = np.array([0.0, 1.0, 2.0, 3.0, 4.0])


def curves():
    """Keel, chine and sheer, (5, 3) each; they meet in no point."""
    keel = np.stack([_X, 0.0 * _X, 0.02 * _X**2], axis=1)
    chine = np.stack([_X, 0.7 - 0.042 * _X**2, 0.2 + 0.03 * _X**2], axis=1)
    sheer = np.stack([_X, 0.9 - 0.05 * _X**2, 0.6 + 0.04 * _X**2], axis=1)
    chine[-1, 1] = sheer[-1, 1] = 0.0
    return [keel, chine, sheer]


def carlson(found, name="Skiff", designer="A. Builder"):
    """`.hul`: inches, x aft."""
    rows = [str(len(found))]
    for b in range(5):
        for curve in found:
            x, y, z = curve[b] / 0.0254
            rows += [f"{y:.10f}", f"{z:.10f}  some word", f"{100.0 - x:.10f}"]
    rows.append("0")
    rows += ["0.0"] * (13 * 3 * len(found) + 8 + 9)
    return "\r\n".join([*rows, designer, name]) + "\r\n"


def carene(found):
    rows = ["Skiff             and what follows"]
    for number, curve in enumerate(found, 1):
        rows += [f"LINE {number}", "what is passed over"]
        rows += ["\t".join(f"{value:.10f}" for value in point) for point in curve] + [""]
    return "\n".join(rows)


def chine_text(found, unit=0):
    scale = (1.0, 0.3048)[unit]
    blocks = ["\n".join(" ".join(f"{v / scale:.10f}" for v in p) for p in c) for c in found]
    return f"{unit}\n" + "\n\n".join(blocks) + "\nEOF\n"
