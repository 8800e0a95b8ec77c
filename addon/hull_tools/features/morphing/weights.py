# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights of parents, which sum to 1: where one is moved, the others share what it leaves."""

from contextlib import contextmanager

from ...bridge import limits
from ...bridge.blender import units

# A sum of weights that is none: the others have no proportions then.
_NOTHING = 1e-6
# By how much weights that somebody gives may miss the sum of 1.
_SUM_TOLERANCE = 1e-5

_is_writing = False


def read(morph):
    """[w] of the parents, which sum to 1 but for the last bits of doubles."""
    return normalised([units.as_typed(entry.weight) for entry in morph.parents])


def shown(morph):
    """The same of the member that is shown."""
    return normalised([units.as_typed(entry.shown_weight) for entry in morph.parents])


def normalised(found):
    """Weights of single precision as ones that sum to 1; a 1 beside zeros stays so."""
    total = sum(found)
    if abs(total) <= _NOTHING:
        raise ValueError("All weights are 0: give one of the parents some")
    return [weight / total for weight in found]


def checked(wanted, count):
    """Weights that somebody gives; ValueError unless there is one a parent and they sum to 1."""
    found = [float(weight) for weight in wanted]
    if len(found) != count:
        raise ValueError(f"There are {count} parents: give a weight for each of them")
    for weight in found:
        limits.within(weight, "A weight", *limits.MORPH_WEIGHTS)
    if abs(sum(found) - 1.0) > _SUM_TOLERANCE:
        raise ValueError(f"The weights sum to {sum(found):g}: they must sum to 1")
    return found


def numbers(text):
    """[weight] that a text has, between blanks or commas."""
    try:
        return [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        raise ValueError(f'"{text}" are no weights: give numbers such as 0.3 0.7') from None


@contextmanager
def writing():
    """While weights are set together, none of them moves the others."""
    global _is_writing
    before, _is_writing = _is_writing, True
    try:
        yield
    finally:
        _is_writing = before


def is_writing():
    return _is_writing


def write(morph, values):
    with writing():
        for entry, value in zip(morph.parents, values):
            entry.weight = value


def follow_one(morph, moved):
    """After the weight of one parent, by its number, was moved: the others are scaled so that all
    sum to 1. Where they are all 0 they share as they did before."""
    found = [units.as_typed(entry.weight) for entry in morph.parents]
    shares = [entry.share for entry in morph.parents]
    values = others_scaled(found, moved, shares)
    write(morph, values)
    remember_shares(morph)


def remember_shares(morph):
    """What each parent has of all, where that is something, for the time when it has nothing."""
    for entry in morph.parents:
        if abs(entry.weight) > _NOTHING:
            entry.share = abs(entry.weight)


def others_scaled(found, moved, shares):
    """Weights that sum to 1 with the one numbered `moved` as it is in `found`, unless the others
    cannot leave their limits for it. shares: how others without weight share what is left."""
    if len(found) == 1:
        return [1.0]
    least, most = limits.MORPH_WEIGHTS
    others = [k for k in range(len(found)) if k != moved]
    rest, total = 1.0 - found[moved], sum(found[k] for k in others)
    if abs(total) > _NOTHING:
        values = {k: found[k] * (rest / total) for k in others}
    else:
        own = {k: max(shares[k], 0.0) for k in others}
        whole = sum(own.values())
        parts = {k: own[k] / whole if whole > _NOTHING else 1.0 / len(others) for k in others}
        values = {k: found[k] + (rest - total) * parts[k] for k in others}
    values = {k: min(max(value, least), most) for k, value in values.items()}
    values[moved] = 1.0 - sum(values.values())
    return [values[k] for k in range(len(found))]
