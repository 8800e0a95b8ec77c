# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender's own tools did to hulls is made good; see bridge.objects.surface_upkeep.

These come after the handlers of `follow`: what they change is brought up to date here.
"""

import bpy
from bpy.app.handlers import persistent

from ..bridge.objects import hull_objects, shown_objects, surface_upkeep, unrecorded
from ..features.hull import hull_state
from . import follow

# What a handler moves is told in turn while it is at work.
_is_following = False


def _refresh(hulls):
    for scene in bpy.data.scenes:
        for hull in hulls:
            if hull.name in scene.objects:
                hull_state.refresh(hull, scene)
                follow.later_subjects(hull, scene)


def _follow(changed, view_layer):
    """Brings the hulls up to date that were looked after, and those that hang on their surface
    objects: what handlers move, Blender moves along without telling."""
    global _is_following
    if not changed or _is_following:
        return
    _is_following = True
    try:
        _refresh(changed)
        view_layer.update()
        _refresh(hull_state.with_other_refusal(view_layer))
    finally:
        _is_following = False


@persistent
def after_update(scene, depsgraph):
    if unrecorded.is_undoing():
        return  # after_undo() looks after all
    # Blender says that a scene has changed when objects come, go, or change collections, and when
    # units change; not while points move.
    if depsgraph.id_type_updated("SCENE") or depsgraph.id_type_updated("COLLECTION"):
        changed = surface_upkeep.look_after(depsgraph.view_layer)
        _refresh(surface_upkeep.with_new_scale(bpy.data.scenes))
        _follow(changed, depsgraph.view_layer)
        surface_upkeep.follow_local_views(depsgraph)
    _follow(
        [obj for obj in _moved(depsgraph) if shown_objects.put_in_place(obj)], depsgraph.view_layer
    )


def _moved(depsgraph):
    """The hulls of this file that an update has moved."""
    moved = [
        update.id.original
        for update in depsgraph.updates
        if update.is_updated_transform and isinstance(update.id, bpy.types.Object)
    ]
    return [obj for obj in moved if hull_objects.is_hull(obj) and not hull_objects.locked(obj)]


@persistent
def after_undo(*unused):
    view_layer = bpy.context.view_layer
    _follow(surface_upkeep.look_after(view_layer), view_layer)


@persistent
def before_load(*unused):
    surface_upkeep.forget_all()


@persistent
def after_load(*unused):
    surface_upkeep.forget_all()
    view_layer = bpy.context.view_layer
    _follow(surface_upkeep.look_after(view_layer, is_new_file=True), view_layer)
    surface_upkeep.with_new_scale(bpy.data.scenes)
