# SPDX-License-Identifier: GPL-3.0-or-later
"""What the user can do, from panels, menus, the operator search and scripts."""

import bpy

from . import (
    add_appendage,
    add_hull,
    area_curve,
    area_curve_drag,
    bilge,
    check_mesh,
    control_curves,
    convert,
    coordinates,
    deck_edge,
    developable,
    dimensions,
    displacement,
    export_cad,
    export_hull,
    export_models,
    export_plates,
    export_views,
    fairing,
    fairness,
    field_drag,
    fields,
    fit,
    geometry,
    import_hull,
    keep_points,
    knuckles,
    layers,
    lines,
    loading_lists,
    lock_points,
    make_hull,
    mend,
    morph,
    morph_series,
    network_curves,
    network_hull,
    network_surface,
    networks,
    new_marks,
    plates,
    pull,
    rows,
    select_tags,
    shape,
    sides,
    studio,
    tag_mesh,
    targets,
    tie_points,
    transformation,
    variants,
)

_CLASSES = (
    *add_hull.CLASSES,
    *add_appendage.CLASSES,
    *make_hull.CLASSES,
    *tag_mesh.CLASSES,
    *select_tags.CLASSES,
    *deck_edge.CLASSES,
    *shape.CLASSES,
    *plates.CLASSES,
    *developable.CLASSES,
    *sides.CLASSES,
    *coordinates.CLASSES,
    *pull.CLASSES,
    *rows.CLASSES,
    *bilge.CLASSES,
    *knuckles.CLASSES,
    *fit.CLASSES,
    *displacement.CLASSES,
    *new_marks.CLASSES,
    *transformation.CLASSES,
    *fields.CLASSES,
    *field_drag.CLASSES,
    *area_curve.CLASSES,
    *area_curve_drag.CLASSES,
    *control_curves.CLASSES,
    *fairing.CLASSES,
    *targets.CLASSES,
    *morph.CLASSES,
    *morph_series.CLASSES,
    *networks.CLASSES,
    *network_curves.CLASSES,
    *network_hull.CLASSES,
    *network_surface.CLASSES,
    *lock_points.CLASSES,
    *keep_points.CLASSES,
    *tie_points.CLASSES,
    *dimensions.CLASSES,
    *check_mesh.CLASSES,
    *mend.CLASSES,
    *layers.CLASSES,
    *import_hull.CLASSES,
    *geometry.CLASSES,
    *export_hull.CLASSES,
    *convert.CLASSES,
    *export_cad.CLASSES,
    *export_models.CLASSES,
    *export_plates.CLASSES,
    *export_views.CLASSES,
    *loading_lists.CLASSES,
    *lines.CLASSES,
    *fairness.CLASSES,
    *variants.CLASSES,
    *studio.CLASSES,
)


def register():
    for cls in _CLASSES:
        # Blender breaks the lines of a tooltip where the text does, and indents them alike.
        cls.bl_description = " ".join((cls.__doc__ or "").split())
        bpy.utils.register_class(cls)
    bpy.types.TOPBAR_MT_file_import.append(import_hull.draw_import_menu)
    bpy.types.TOPBAR_MT_file_export.append(export_hull.draw_export_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(export_hull.draw_export_menu)
    bpy.types.TOPBAR_MT_file_import.remove(import_hull.draw_import_menu)
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
