# SPDX-License-Identifier: GPL-3.0-or-later
"""How results call hull_native: by the names that it had before some were changed, too."""

import re

import hull_native
import numpy as np

# Functions, arguments and results that have got another name: the present one of each earlier one,
# so that modules before and after the change can be compared. Reports tell the earlier names.
RENAMED = {
    "immersed_draught": "immersed_draft",
    "flooding_heel": "downflooding_heel",
    "has_openings": "can_flood",
}

SEED = 20261122
PLACES = 500


def native(name, *arguments, **named):
    """hull_native's function of that name, or of the name that it has now; so its arguments."""
    function = getattr(hull_native, name, None) or getattr(hull_native, RENAMED[name])
    known = function.__doc__ or ""
    named = {
        key if re.search(rf"\b{key}\b", known) else RENAMED.get(key, key): value
        for key, value in named.items()
    }
    return function(*arguments, **named)


def attempt(function, *arguments, **named):
    """What a function gives, or the words with which it refuses."""
    try:
        return function(*arguments, **named)
    except ValueError as refusal:
        return f"ValueError: {refusal}"


def places(surface):
    """(cells, uv): places at random, then the corners, sides and middles of some cells."""
    random = np.random.default_rng(SEED)
    ends = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0], [0, 0.5], [0.5, 0.5], [2**-9] * 2])
    some = np.unique(np.linspace(0, surface.cell_count - 1, 60).astype(int))
    cells = random.integers(0, surface.cell_count, PLACES)
    return (
        np.concatenate([cells, np.repeat(some, len(ends))]),
        np.concatenate([random.random((PLACES, 2)), np.tile(ends, (len(some), 1))]),
    )


def body_of(vessel):
    """The vessel's HullBody."""
    return native("HullBody", vessel.surface, mirrored=vessel.data.half)
