# SPDX-License-Identifier: GPL-3.0-or-later
"""Solid 3D views show the colours of a mesh only when they are told to."""

from contextlib import contextmanager

import bpy

from ...bridge.objects import hull_objects

_COLOURED = ("VERTEX", "FLAT")
_USUAL = ("MATERIAL", "STUDIO")

_before = {}  # by a view's address: (colours, light) that it had


def follow():
    """Has all solid views show the meshes' colours while any hull has some, in flat light so that
    they are those of the legend; then has them show what they did before."""
    hulls = hull_objects.hulls(bpy.data.objects)
    any_colours = any(hull.hull.fairness.colours != "NONE" for hull in hulls)
    for space in _views():
        if any_colours != (space.as_pointer() in _before):
            with _as_solid(space.shading) as shading:
                _follow(shading, space.as_pointer(), any_colours)


def _follow(shading, address, any_colours):
    shown = shading.color_type, shading.light
    if any_colours:
        _before[address] = _USUAL if shown == _COLOURED else shown
        shading.color_type, shading.light = _COLOURED
        return
    before = _before.pop(address)
    if shown == _COLOURED:  # else the user has chosen meanwhile
        shading.color_type, shading.light = before


@contextmanager
def _as_solid(shading):
    """A view that shows wires does not tell its colours of solids, nor takes any."""
    is_wire = shading.type == "WIREFRAME"
    if is_wire:
        shading.type = "SOLID"
    yield shading
    if is_wire:
        shading.type = "WIREFRAME"


def forget():
    """Forgets the views of a file that goes."""
    _before.clear()


def _views():
    for screen in bpy.data.screens:
        for area in screen.areas:
            if area.type == "VIEW_3D":
                yield area.spaces.active
