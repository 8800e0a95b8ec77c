# SPDX-License-Identifier: GPL-3.0-or-later
"""Hull Tools: ship hulls as one control mesh, from Blender's mesh editor to lines and STEP."""

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
    from . import hull_tools

    hull_tools.register()


def unregister():
    from . import hull_tools

    hull_tools.unregister()
