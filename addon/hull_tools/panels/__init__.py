# SPDX-License-Identifier: GPL-3.0-or-later
"""The Hull tab of the 3D view's sidebar, menus, and the key of the pie."""

import bpy

from ..bridge.blender import pie_key, preferences
from . import (
    add_menu,
    appendage,
    area_curve,
    criteria,
    export,
    fairing,
    fairness,
    fields,
    fit,
    geometry,
    hull,
    hydrostatics,
    lines_plan,
    load_cases,
    morph,
    networks,
    plates,
    production,
    pull,
    resistance,
    sections,
    shape,
    shown,
    stability,
    studio,
    tag_menus,
    tags,
    targets,
    transformation,
    variants,
    weights,
)

# Panels stand in the sidebar in this order, which is that of the work: hull, surface, lines, shape,
# variants, fairness, hydrostatics, stability, resistance, output.
_CLASSES = (
    *add_menu.CLASSES,
    *hull.CLASSES,
    *geometry.CLASSES,
    *shown.CLASSES,
    *sections.CLASSES,
    *tags.CLASSES,
    *tag_menus.CLASSES,
    *shape.CLASSES,
    *pull.CLASSES,
    *fit.CLASSES,
    *transformation.CLASSES,
    *fields.CLASSES,
    *networks.CLASSES,
    *appendage.CLASSES,
    *area_curve.CLASSES,
    *targets.CLASSES,
    *morph.CLASSES,
    *variants.CLASSES,
    *fairing.CLASSES,
    *fairness.CLASSES,
    *hydrostatics.CLASSES,
    *stability.CLASSES,
    *load_cases.CLASSES,
    *criteria.CLASSES,
    *weights.CLASSES,
    *resistance.CLASSES,
    *lines_plan.CLASSES,
    *production.CLASSES,
    *export.CLASSES,
    *plates.CLASSES,
    *studio.CLASSES,
)

_DRAWN_IN = [  # by the names of menus and panels
    *add_menu.DRAWN_IN.items(),
    *hull.DRAWN_IN.items(),
    *tag_menus.DRAWN_IN.items(),
    *pull.DRAWN_IN.items(),
]


def register():
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    for name, draw in _DRAWN_IN:
        getattr(bpy.types, name).append(draw)
    pie_key.follow(preferences.value("use_pie_key"))


def unregister():
    pie_key.follow(False)
    for name, draw in _DRAWN_IN:
        getattr(bpy.types, name).remove(draw)
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
