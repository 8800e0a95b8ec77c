# SPDX-License-Identifier: GPL-3.0-or-later
"""Why no hull can be laid over a network, as a sentence with a remedy."""

import numpy as np

# Problems by how much of the surface they take: the first of these that there is, is the reason.
_WORST = ("shape", "off_plane", "wrong_order", "overlap", "halt", "gap")
# Of the length: what misses one another within it of the reason's place is told with it, and so far
# from the centre plane a network is beside it.
_NEAR, _BESIDE = 0.02, 1e-3


def no_regions(network):
    """Why a CurveNetwork has no regions."""
    text = "The network has no regions, so that no hull can be laid onto it. "
    if not network.curves:
        return text + "Give curves that cross one another."
    points = np.concatenate([np.asarray(curve.points) for curve in network.curves])
    low, high = points.min(axis=0), points.max(axis=0)
    if reason := beside_centre_plane(low, high):
        return text + reason
    faults = [problem for problem in network.problems if not problem.is_note]
    if not faults:
        return text + "Give curves that cross one another."
    faults.sort(key=lambda one: _WORST.index(one.kind) if one.kind in _WORST else len(_WORST))
    worst = faults[0]
    text += worst.what
    if worst.kind == "wrong_order" and (gap := _gap_near(faults, worst, high[0] - low[0])):
        text += f" Near by, {gap.what[0].lower()}{gap.what[1:]}"
    if any(fault.kind == "apart" for fault in faults):
        text += (
            " There are parts that nothing connects with the rest: give the curves of one body, "
            "its appendages apart."
        )
    return text


def no_shell(kinds):
    """Why a network whose sheets are flat ends, "aft" and "forward", and a "bar" is no hull."""
    names = {"aft": "a flat end", "forward": "a flat end", "bar": "a bar along the centre plane"}
    told = " and ".join(dict.fromkeys(names[kind] for kind in kinds))
    return (
        f"No part of the network is a shell: all of it is {told}. Give the curves of the shell "
        "between keel, deck edge and ends, too."
    )


def beside_centre_plane(low, high):
    """Why a network within low and high (3,), m, that has no border in the centre plane is no half
    hull; None where it comes to that plane."""
    if low[1] < _BESIDE * (high[0] - low[0]):
        return None
    return (
        f"The network lies beside the centre plane, from y = {low[1]:.3f} m on, as a demihull of a "
        "catamaran does. Give the curves of its outer half, moved so that its own centre plane is "
        "y = 0."
    )


def _gap_near(faults, worst, length):
    """The gap nearest to a fault's place; None where none is near."""
    gaps = [fault for fault in faults if fault.kind == "gap" and len(fault.places)]
    if not (gaps and len(worst.places)):
        return None
    place = np.asarray(worst.places)[0]
    away = [np.linalg.norm(np.asarray(gap.places) - place, axis=1).min() for gap in gaps]
    return gaps[int(np.argmin(away))] if min(away) < _NEAR * length else None
