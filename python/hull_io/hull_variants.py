# SPDX-License-Identifier: GPL-3.0-or-later
"""What a hull file tells of a hull's variants: hulls that were kept under a name.

    "variants": [{"name": "...", "note": "...", "half": true, "points": [...], "faces": [...],
                  ...}, ...]

Each has the keys of a hull file's own hull, from "name" to "wind", and a note.
"""

from . import hull_content
from .hull_data import Variant
from .limits import MAX_VARIANTS

KEY = "variants"
_KNOWN = ("note", *hull_content.REQUIRED, *hull_content.OPTIONAL)


def parsed(check, content):
    """The list of Variant in the content of a hull file; raises HullFileError."""
    listed = check.list(content.get(KEY, []), KEY, most=MAX_VARIANTS)
    return [_variant(check, value, index) for index, value in enumerate(listed)]


def _variant(check, value, index):
    where = f"{KEY}[{index}]"
    own = check.object(value, where, _KNOWN)
    hull = hull_content.parsed(check.within(f"{where}."), own, f"Variant {index + 1}")
    return Variant(hull, check.text(own.get("note", ""), f"{where}.note"))


def entries(data):
    """What a hull file says of a HullData's variants, by its key; nothing where there are none."""
    found = [{**hull_content.entries(one.hull), "note": one.note} for one in data.variants]
    return {KEY: found} if found else {}
