# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps what shows a hull in step with what Blender's own tools do to the hull.

A hull that was duplicated, separated or pasted gets a surface object of its own; one that was
deleted or joined to another takes its surface object along; a surface object stays with its hull
when this is scaled, hidden, moved to other collections or looked at in local view. A surface object
that the user deletes is not made again. Hulls of older files are brought to the present format.

Objects are unlinked, never removed: what else listens to the same change may still hold them, and
what no scene has is not saved.
"""

from dataclasses import dataclass

import bpy

from ..blender import units
from . import hull_objects, migration, shown_objects, unrecorded


@dataclass(frozen=True)
class _Seen:
    """What a hull was like when it was last looked after."""

    name: str
    surface: str
    collections: tuple
    is_hidden: dict  # by view layer


_seen = {}  # by the hull's address
_scales = {}  # metres per unit by the name of the scene


def forget_all():
    _seen.clear()
    _scales.clear()


def look_after(view_layer, is_new_file=False):
    """Looks after all hulls of the file; returns those that changed by it."""
    changed, found = [], {}
    for obj in hull_objects.hulls(bpy.data.objects):
        seen = _seen.get(obj.as_pointer())
        if hull_objects.locked(obj):
            _show_linked(obj, seen, is_new_file)
        else:
            if seen is None and is_new_file:
                seen = _as_it_is(obj, view_layer, None)
            if migration.bring_up_to_date(obj) | _tend(obj, seen, view_layer):
                changed.append(obj)
        found[obj.as_pointer()] = _as_it_is(obj, view_layer, seen)
    for address in _seen.keys() - found.keys():
        _take_along(_seen[address])
    _seen.clear()
    _seen.update(found)
    return changed


def with_new_scale(scenes):
    """The hulls of those scenes whose unit scale is not what it was."""
    hulls = []
    for scene in scenes:
        scale = units.metres_per_unit(scene)
        if _scales.setdefault(scene.name, scale) != scale:
            _scales[scene.name] = scale
            hulls += hull_objects.hulls(scene.objects)
    return hulls


def _as_it_is(obj, view_layer, before):
    """before: the _Seen that was, or None; of other view layers it is as that has it."""
    shown = shown_objects.surface_of(obj)
    known = {} if before is None else before.is_hidden
    return _Seen(
        obj.name,
        shown.name if shown is not None else "",
        _collections(obj),
        {**known, _key(view_layer): _is_hidden(obj, view_layer)},
    )


def _key(view_layer):
    return view_layer.id_data.name_full, view_layer.name


def _collections(obj):
    return tuple(sorted(collection.name_full for collection in obj.users_collection))


def _is_hidden(obj, view_layer):
    if obj.name not in view_layer.objects:
        return False
    return obj.hide_viewport or obj.hide_get(view_layer=view_layer)


def _tend(obj, seen, view_layer):
    """Brings the surface object of a hull to where it belongs; whether it is a new one, or stood
    elsewhere."""
    pointed = obj.hull.surface_object
    if pointed is None or not obj.users_collection:
        return False
    if shown_objects.surface_of(obj) is None:
        shown_objects.ensure(obj)
        unrecorded.has_new_surface(obj, pointed)
        return True
    if not pointed.users_collection and seen is not None:
        obj.hull.surface_object = None  # the user has deleted it
        return False
    is_elsewhere = seen is not None and seen.collections != _collections(obj)
    if not pointed.users_collection or (is_elsewhere and _collections(pointed) == seen.collections):
        _move(pointed, obj.users_collection)
    is_hidden = _is_hidden(obj, view_layer)
    was_hidden = is_hidden if seen is None else seen.is_hidden.get(_key(view_layer), is_hidden)
    if was_hidden != is_hidden and pointed.name in view_layer.objects:
        pointed.hide_set(is_hidden, view_layer=view_layer)
    if seen is None:
        _be_no_choice(pointed, view_layer)
    return shown_objects.put_in_place(obj)


def _be_no_choice(shown, view_layer):
    """Pasting selects a surface too, and lets it be selected: joined with its hull it would be part
    of the control mesh."""
    shown.hide_select = True
    if shown.name in view_layer.objects:
        shown.select_set(False, view_layer=view_layer)


def _move(shown, collections):
    for old in shown.users_collection:
        if old not in collections:
            old.objects.unlink(shown)
    for new in collections:
        if shown.name not in new.objects:
            new.objects.link(shown)


def _show_linked(obj, seen, is_new_file):
    """The surface of a hull that was linked alone is not in the scene yet."""
    pointed = obj.hull.surface_object
    if pointed is None or pointed.users_collection or seen is not None or is_new_file:
        return
    for collection in obj.users_collection:
        if collection.library is None:
            collection.objects.link(pointed)


def _take_along(seen):
    """The surface object of a hull that is no more goes too, unless the user made it his own."""
    shown = bpy.data.objects.get(seen.surface) if seen.surface else None
    if shown is None or shown.parent is not None or not shown.hide_select:
        return
    if shown.library is not None or shown.type != "MESH":
        return
    for collection in list(shown.users_collection):
        collection.objects.unlink(shown)


def follow_local_views(depsgraph):
    """Shows the surface too where a hull is looked at in local view."""
    objects = depsgraph.view_layer.objects
    for space in _local_views():
        for obj in hull_objects.hulls(objects):
            shown = obj.hull.surface_object
            if shown is None or shown.name not in objects:
                continue
            if _is_in(space, obj, depsgraph) and not _is_in(space, shown, depsgraph):
                shown.local_view_set(space, True)


def _is_in(space, obj, depsgraph):
    # Of objects themselves Blender does not keep it.
    return obj.evaluated_get(depsgraph).local_view_get(space)


def _local_views():
    for window_manager in bpy.data.window_managers:
        for window in window_manager.windows:
            for area in window.screen.areas:
                if area.type == "VIEW_3D" and area.spaces.active.local_view is not None:
                    yield area.spaces.active
