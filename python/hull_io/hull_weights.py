# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of the ship's weights: m, t and t/m³.

    "weights": {"thickness": m of the shell's plating, "density": t/m3 of it,
                "items": [{"name": "...", "mass_t": t, "lcg": m, "tcg": m, "vcg": m}, ...]}

All may be left out; a shell without thickness has no weight. "layers" may have a thickness and a
density of their own.
"""

from .limits import DENSEST, HEAVIEST_LOAD, LONGEST_DIMENSION, MAX_LOADING_ENTRIES, THICKEST
from .ship_data import Weight, Weights

KEY = "weights"
_CENTRE = ("lcg", "tcg", "vcg")


def parsed(check, content):
    """The Weights of a hull file's content; raises HullFileError."""
    entries = check.object(content.get(KEY, {}), KEY, ("thickness", "density", "items"))
    items = check.list(entries.get("items", []), f"{KEY}.items")
    if len(items) > MAX_LOADING_ENTRIES:
        raise check.error(
            f"{KEY}.items", f"it has {len(items)} entries", f"write at most {MAX_LOADING_ENTRIES}"
        )
    return Weights(
        thickness=thickness(check, entries, KEY),
        density=density(check, entries, KEY, Weights.density),
        items=[_item(check, item, f"{KEY}.items[{index}]") for index, item in enumerate(items)],
    )


def thickness(check, entries, where):
    """m, 0 where it is not told."""
    return check.number(entries.get("thickness", 0), f"{where}.thickness", 0.0, THICKEST)


def density(check, entries, where, usual=0.0):
    """t/m³."""
    return check.number(entries.get("density", usual), f"{where}.density", 0.0, DENSEST)


def _item(check, value, where):
    entries = check.object(value, where, ("name", "mass_t", *_CENTRE))
    if "mass_t" not in entries:
        raise check.error(f"{where}.mass_t", "it is missing", "add the mass in t")
    centre = {
        key: check.number(
            entries.get(key, 0), f"{where}.{key}", -LONGEST_DIMENSION, LONGEST_DIMENSION
        )
        for key in _CENTRE
    }
    return Weight(
        name=check.text(entries.get("name", "Weight"), f"{where}.name"),
        mass_t=check.number(entries["mass_t"], f"{where}.mass_t", 0.0, HEAVIEST_LOAD),
        **centre,
    )


def entries(data):
    """What a hull file says of a HullData's weights, by its key; nothing where there are none."""
    own = data.weights
    if own == Weights():
        return {}
    items = [
        {
            "name": item.name,
            "mass_t": float(item.mass_t),
            **{key: float(getattr(item, key)) for key in _CENTRE},
        }
        for item in own.items
    ]
    return {KEY: {"thickness": float(own.thickness), "density": float(own.density), "items": items}}
