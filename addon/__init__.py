# SPDX-License-Identifier: GPL-3.0-or-later
"""Hull Tools: ship hulls as one control mesh, from Blender's mesh editor to lines and STEP."""

import gc

bl_info = {
    "name": "Hull Tools",
    "description": "Model a ship's hull as one control mesh: surface, lines, hydrostatics, STEP",
    "author": "The Hull Tools authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Hull",
    "category": "Mesh",
}


def register():
    # Nearly all that is made now stays: looking for garbage meanwhile takes a fifth of the time.
    collects = gc.isenabled()
    gc.disable()
    try:
        from . import hull_tools

        hull_tools.register()
    finally:
        if collects:
            gc.enable()


def unregister():
    from . import hull_tools

    hull_tools.unregister()
