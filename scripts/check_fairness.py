# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts what is not fair on hulls' lines and reflection lines, and tells what no design calls for.

PYTHONPATH=build/release/python:samples python3 scripts/check_fairness.py [--all] [HULL ...]

HULL is a sample's name or a hull file; without any: every sample. What the design calls for is
WANTED in samples/sources/NAME.py; hull_fairness/lines.py tells its form, inflections.py and
kinks.py what is seen. Ends with 1 where something is unwanted. --all shows lines that are as
wanted, too.
"""

import argparse
import sys

import vessels
from hull_fairness.lines import LEAST_DEPTH, judged


def counts(found):
    """Such as "2 inflections, 1 dip"."""
    names = [mark.mark for mark in found]
    kinds = [(kind, names.count(kind)) for kind in sorted(set(names), reverse=True)]
    return ", ".join(f"{n} {kind}{'s' * (n > 1)}" for kind, n in kinds) or "nothing"


def tell(line, is_all):
    if not (line.unwanted or (is_all and line.found)):
        return
    wanted = [mark for mark in line.found if mark.reason is not None]
    print(f"  {line.name}: found {counts(line.found)}; wanted {counts(wanted)}")
    for mark in line.found:
        place = "({:.2f}, {:.2f}, {:.2f})".format(*mark.point)
        why = f"wanted: {mark.reason}" if mark.reason is not None else "UNWANTED"
        if mark.reason is None or is_all:
            print(f"    {mark.mark} at {place}, {mark.size}, {why}")


def check(name, is_all):
    """How many marks of a hull are unwanted."""
    vessel = vessels.vessel(name)
    beam = vessel.data.particulars.beam
    lines = judged(vessel.surface, beam, vessel.wanted)
    unwanted = sum(len(line.unwanted) for line in lines)
    print(
        f"{vessel.name}: {len(lines)} lines; seen from {1e3 * LEAST_DEPTH * beam:.1f} mm"
        f" depth on: {counts([mark for line in lines for mark in line.found])}; {unwanted} unwanted"
    )
    for line in lines:
        tell(line, is_all)
    used = {(line.kind, mark.mark, mark.reason) for line in lines for mark in line.found}
    for kind, mark, _, _, why in vessel.wanted:
        if (kind, mark, why) not in used:
            print(f"  wanted but nowhere found: {kind}, {mark}: {why}")
    return unwanted


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("hulls", nargs="*", metavar="HULL")
    parser.add_argument("--all", action="store_true")
    given = parser.parse_args()
    unwanted = [check(name, given.all) for name in given.hulls or vessels.names()]
    sys.exit(1 if any(unwanted) else 0)


if __name__ == "__main__":
    main()
