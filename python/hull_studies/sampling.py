# SPDX-License-Identifier: GPL-3.0-or-later
"""Which values the variables of a study take, variant by variant.

Kinds of sampling: "list" (rows as given), "grid" (all combinations of evenly spaced values),
"random" (independent and uniform) and "latin" (a Latin hypercube, McKay, Beckman & Conover 1979:
of n variants each has another n-th of every variable's range). The same description gives the same
values to the last bit.
"""

from itertools import product

import numpy as np

KINDS = ("list", "grid", "random", "latin")
MOST_VARIANTS = 1_000_000
MOST_STEPS = 10_000
_LARGEST_SEED = 2**63 - 1

_KEYS = {
    "list": {"kind", "rows"},
    "grid": {"kind", "steps"},
    "random": {"kind", "count", "seed"},
    "latin": {"kind", "count", "seed"},
}


def checked_sampling(check, value, variables):
    """The description of a sampling with all of its keys. check: the CheckedJson of the study;
    variables: {name: (low, high)}. HullFileError for what is none."""
    value = check.object(value, "sampling")
    kind = check.choice(value.get("kind"), "sampling.kind", KINDS)
    check.object(value, "sampling", _KEYS[kind])
    if kind == "list":
        return {"kind": kind, "rows": _checked_rows(check, value.get("rows"), variables)}
    if kind == "grid":
        return {"kind": kind, "steps": _checked_steps(check, value.get("steps"), variables)}
    count = _whole(check, value.get("count"), "sampling.count", 1, MOST_VARIANTS)
    seed = _whole(check, value.get("seed", 0), "sampling.seed", 0, _LARGEST_SEED)
    return {"kind": kind, "count": count, "seed": seed}


def _whole(check, value, where, lowest, highest):
    if isinstance(value, float) and value.is_integer():
        value = int(value)
    if isinstance(value, bool) or not isinstance(value, int) or not lowest <= value <= highest:
        raise check.error(where, "it is no whole number in reach", f"write {lowest} to {highest}")
    return value


def _checked_rows(check, rows, variables):
    rows = check.list(rows, "sampling.rows", most=MOST_VARIANTS)
    if not rows:
        raise check.error("sampling.rows", "it has no rows", "write one for each variant")
    found = []
    for number, row in enumerate(rows):
        where = f"sampling.rows[{number}]"
        row = check.list(row, where, len(variables))
        found.append([check.number(one, where, -1e300, 1e300) for one in row])
    return found


def _checked_steps(check, steps, variables):
    """One number for all variables, or {name: steps}."""
    if not isinstance(steps, dict):
        steps = dict.fromkeys(variables, steps)
    check.object(steps, "sampling.steps", variables)
    found = {
        name: _whole(check, steps.get(name), f"sampling.steps.{name}", 1, MOST_STEPS)
        for name in variables
    }
    count = 1
    for one in found.values():
        count *= one
    if count > MOST_VARIANTS:
        raise check.error(
            "sampling.steps", f"they make {count} variants", f"{MOST_VARIANTS} are the most"
        )
    return found


def variants(sampling, variables):
    """[tuple of floats, in the order of the variables] of a checked sampling: a variant each. Of a
    grid the last variable changes first."""
    bounds = list(variables.values())
    kind = sampling["kind"]
    if kind == "list":
        return [tuple(map(float, row)) for row in sampling["rows"]]
    if kind == "grid":
        return list(product(*map(_spaced, bounds, sampling["steps"].values())))
    random = np.random.default_rng(sampling["seed"])
    count = sampling["count"]
    shares = random.random((count, len(bounds)))
    if kind == "latin":
        for column in range(len(bounds)):
            shares[:, column] = (shares[:, column] + random.permutation(count)) / count
    low, high = np.array(bounds, dtype=np.float64).reshape(-1, 2).T
    return [tuple(row) for row in (low + (high - low) * shares).tolist()]


def _spaced(bounds, steps):
    """Evenly from bound to bound, ends included; one step: the middle."""
    low, high = bounds
    if steps == 1:
        return [0.5 * (low + high)]
    return [low + (high - low) * (k / (steps - 1)) for k in range(steps - 1)] + [high]
