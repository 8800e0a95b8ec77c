# SPDX-License-Identifier: GPL-3.0-or-later
"""Solid 3D views show the colours of a mesh only when they are told to."""

import bpy

from . import hull_objects

_COLOURED = ("VERTEX", "FLAT")
_USUAL = ("MATERIAL", "STUDIO")

_before = {}  # by a view's address: (colours, light) that it had


def follow():
    """Has all solid views show the meshes' colours while any hull has some, in flat light so that
    they are those of the legend; then has them show what they did before."""
    hulls = hull_objects.hulls(bpy.data.objects)
    any_colours = any(hull.hull.fairness.colours != "NONE" for hull in hulls)
    for space in _views():
        shading, address = space.shading, space.as_pointer()
        shown = shading.color_type, shading.light
        if any_colours and address not in _before:
            _before[address] = _USUAL if shown == _COLOURED else shown
            shading.color_type, shading.light = _COLOURED
        elif not any_colours and address in _before:
            before = _before.pop(address)
            if shown == _COLOURED:  # else the user has chosen meanwhile
                shading.color_type, shading.light = before


def forget():
    """Forgets the views of a file that goes."""
    _before.clear()


def _views():
    for screen in bpy.data.screens:
        for area in screen.areas:
            if area.type == "VIEW_3D":
                yield area.spaces.active
