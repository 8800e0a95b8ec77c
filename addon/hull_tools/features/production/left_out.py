# SPDX-License-Identifier: GPL-3.0-or-later
"""What models, panels and named parts do not have, or have twice, as sentences to be told."""

from ...bridge.objects import appendages
from ..flotation.ship import overlap_words


def names_of(obj):
    """Names of a hull's appendages, keels, rudders and tunnels, which only hydrostatics and closed
    solids have."""
    return tuple(body.name for body in appendages.read(obj))


def remark(names, body):
    """What is amiss with a file of the hull alone, or nothing: appendages of these names are not in
    it, and the own bodies of a hull_native.HullBody that overlap are in it twice."""
    texts = []
    if names:
        texts.append(f"Without {', '.join(names)}: appendages are in closed STEP and IGES files")
    twice = overlap_words(body.own_overlaps)
    if twice:
        texts.append(f"{twice} and are in it twice: model them as one body")
    return ". ".join(texts)
