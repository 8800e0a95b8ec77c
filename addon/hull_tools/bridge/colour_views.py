# SPDX-License-Identifier: GPL-3.0-or-later
"""Solid 3D views show the colours of a mesh only when they are told to."""

import bpy

_before = {}  # by a view's address: (colours, light) that it had


def follow(any_colours):
    """Has all solid views show the meshes' colours, in flat light so that they are those of the
    legend; or has them show what they did before."""
    for space in _views():
        shading, address = space.shading, space.as_pointer()
        if any_colours and address not in _before:
            _before[address] = shading.color_type, shading.light
            shading.color_type, shading.light = "VERTEX", "FLAT"
        elif not any_colours and address in _before:
            shading.color_type, shading.light = _before.pop(address)


def _views():
    for screen in bpy.data.screens:
        for area in screen.areas:
            if area.type == "VIEW_3D":
                yield area.spaces.active
