# SPDX-License-Identifier: GPL-3.0-or-later
"""The Hull tab of the 3D view's sidebar."""

import bpy

from . import export, fairness, hull, lines_plan, results, sections, shape, shown, stability, tags

_CLASSES = (
    *hull.CLASSES,
    *tags.CLASSES,
    *shape.CLASSES,
    *shown.CLASSES,
    *sections.CLASSES,
    *fairness.CLASSES,
    *results.CLASSES,
    *stability.CLASSES,
    *lines_plan.CLASSES,
    *export.CLASSES,
)


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
