# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's own tools did to hulls is made good; see bridge.objects.surface_upkeep.

These come after the handlers of `follow`: what they change is brought up to date here.
"""

import bpy
from bpy.app.handlers import persistent

from ..bridge.objects import hull_objects, shown_objects, surface_upkeep, unrecorded
from ..features.hull import hull_state


def _refresh(hulls):
    for scene in bpy.data.scenes:
        for hull in hulls:
            if hull.name in scene.objects:
                hull_state.refresh(hull, scene)


@persistent
def after_update(scene, depsgraph):
    if unrecorded.is_undoing():
        return  # after_undo() looks after all
    # Blender says that a scene has changed when objects come, go, or change collections, and when
    # units change; not while points move.
    if depsgraph.id_type_updated("SCENE") or depsgraph.id_type_updated("COLLECTION"):
        changed = surface_upkeep.look_after(depsgraph.view_layer)
        _refresh({*changed, *surface_upkeep.with_new_scale(bpy.data.scenes)})
        surface_upkeep.follow_local_views(depsgraph)
    for update in depsgraph.updates:
        if update.is_updated_transform and isinstance(update.id, bpy.types.Object):
            obj = update.id.original
            if hull_objects.is_hull(obj) and not hull_objects.locked(obj):
                shown_objects.put_in_place(obj)


@persistent
def after_undo(*unused):
    _refresh(surface_upkeep.look_after(bpy.context.view_layer))


@persistent
def before_load(*unused):
    surface_upkeep.forget_all()


@persistent
def after_load(*unused):
    surface_upkeep.forget_all()
    _refresh(surface_upkeep.look_after(bpy.context.view_layer, is_new_file=True))
    surface_upkeep.with_new_scale(bpy.data.scenes)
