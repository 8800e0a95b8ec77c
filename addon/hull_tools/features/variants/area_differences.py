# SPDX-License-Identifier: GPL-3.0-or-later
"""The sectional areas of a hull and of the other hull at the stations of the lines plan."""

from . import differences

IS_LIVE = False

inputs = differences.inputs
compute = differences.compute


def header(result):
    names = [
        f"{what}, {how} draft [m2]"
        for how in ("own", "same")
        for what in ("other hull", "difference")
    ]
    return ["x from AP [m]", "this hull [m2]", *names]


def rows(result):
    own, same = result.by["OWN"].areas, result.by["SAME"].areas
    known = own or same
    if known is None:
        return
    for place, x in enumerate(known.stations):
        cells = [
            cell
            for one in (own, same)
            for cell in (
                (None, None) if one is None else (one.other_areas[place], one.differences[place])
            )
        ]
        yield [x, known.areas[place], *cells]
