# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user chose in the add-on's preferences, for all files.

Choices of hulls (`OF_NEW_HULLS`) are given to a hull when it is made and are the hull's own from
then on: a file looks the same on every machine.
"""

import bpy

from ....hull_io.limits import SEA_WATER_DENSITY
from . import palette

# The add-on's name in Blender: a legacy one or an extension.
ADDON = __package__.rsplit(".", 3)[0]

# By property: the value until the user chooses another.
DEFAULTS = {
    "samples": 4,
    "line_width": 1.5,
    "station_count": 20,
    "waterline_count": 10,
    "buttock_count": 5,
    "water_density": SEA_WATER_DENSITY,
    "mark_size": 5.0,
    "tag_width": 3.0,
    "plot_size": 1.0,
    "use_pie_key": True,
}


def of_addon():
    """The add-on's AddonPreferences; None when it was enabled without any."""
    addon = bpy.context.preferences.addons.get(ADDON)
    return addon.preferences if addon is not None else None


def value(name):
    """A choice, by its name in DEFAULTS."""
    chosen = of_addon()
    return DEFAULTS[name] if chosen is None else getattr(chosen, name)


def colour(group, kind, is_on_light=True):
    """The sRGB colour of an entry of palette.GROUPS, three parts from 0 to 1."""
    ink = palette.GROUPS[group][1][kind]
    chosen = of_addon()
    if chosen is None:
        return ink.on_light if is_on_light or ink.on_dark is None else ink.on_dark
    names = palette.property_names(group, kind)
    return tuple(getattr(chosen, names[0] if is_on_light else names[-1]))


def colours(group, is_on_light=True):
    """All colours of a group, by kind."""
    return {kind: colour(group, kind, is_on_light) for kind in palette.GROUPS[group][1]}
