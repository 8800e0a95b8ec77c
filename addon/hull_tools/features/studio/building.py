# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets a studio up and takes it down."""

import bpy

from ...bridge.objects import shown_objects
from ..hull import hull_state
from . import (
    cameras,
    deck,
    following,
    light,
    lines_on_hull,
    paint,
    renderer_settings,
    scene_settings,
    views,
    water_or_floor,
)
from .place import MARK, find, hull_of, others, place_of

# Faces along each side of a cell: fine enough that a facet shows nowhere in the picture.
_SAMPLES = 12


def make(hull, scene):
    """Sets up the studio that Object.hull.studio of a hull asks for, in place of one that there is;
    returns its collection. ValueError when the hull has no surface as it is."""
    state = hull_state.up_to_date(hull, scene)
    settings = hull.hull.studio
    plan = following.Plan.of(hull, state, scene, settings.lines)
    remove(scene)

    collection = bpy.data.collections.new(f"Studio of {hull.name}")
    collection[MARK] = {
        "hull": hull,
        "samples": _samples_before(hull, scene),
        "in water": settings.ground == "WATER",
        "lines": settings.lines,
    }
    scene.collection.children.link(collection)
    scene_settings.note(collection, scene)
    shown_objects.ensure(hull)
    hull.hull.samples = max(hull.hull.samples, _SAMPLES)
    hull_state.refresh(hull, scene)

    here = place_of(hull, scene)
    _furnish(here, settings)
    lines_on_hull.add_lines(here, plan.cuts)
    renderer_settings.set_renderer(scene, settings.engine)
    cameras.add_cameras(here)
    following.follow(scene)
    cameras.turn(here, settings.turntable_frames)
    look_from(scene, views.FIRST)
    scene_settings.show_only(collection, scene, _seen(hull, collection))
    return collection


def _furnish(here, settings):
    """Paint, deck, water or floor, and light."""
    surface_object = shown_objects.surface_of(here.hull)
    if settings.paint:
        _paint(here, surface_object, paint.hull_paint(here, settings))
    if settings.deck:
        deck.add_deck(here, paint.deck_paint(here))
    backdrop = light.backdrop_of(settings.light)
    if here.in_water:
        water_or_floor.add_water(here, backdrop)
    elif settings.ground == "FLOOR":
        water_or_floor.add_floor(here, backdrop)
    here.scene.world = here.collection["own world"] = light.add_light(here, settings.light)


def _samples_before(hull, scene):
    """Those of a hull that no studio has changed."""
    known = (own[MARK]["samples"] for _, own in others(scene) if own[MARK].get("hull") == hull)
    return next(known, hull.hull.samples)


def _painted_in(studios, surface_object):
    """The studio among place.others that has painted a surface object, too; None without."""
    return next((own for _, own in studios if own.get("painted") == surface_object), None)


def _paint(here, surface_object, material):
    """Paints the surface object, and notes what it had before any studio; its mesh keeps its own
    material."""
    if not surface_object.material_slots:
        surface_object.data.materials.append(None)
    slot = surface_object.material_slots[0]
    was = {"link": slot.link}
    if slot.link == "OBJECT" and slot.material is not None:
        was["material"] = slot.material
    other = _painted_in(others(here.scene), surface_object)
    here.collection["material"] = was if other is None else dict(other["material"].items())
    here.collection["painted"], here.collection["paint"] = surface_object, material
    slot.link = "OBJECT"
    slot.material = material


def _unpaint(collection, studios):
    surface_object = collection.get("painted")
    if surface_object is None or not surface_object.material_slots:
        return
    slot, was = surface_object.material_slots[0], collection["material"]
    other = _painted_in(studios, surface_object)
    if other is not None and other.get("paint") is not None:
        slot.material = other["paint"]
        return
    slot.material = was.get("material")
    slot.link = was["link"]


def _seen(hull, collection):
    """What pictures show: the studio, the hull's surface, and what the user has put on the hull."""
    curves = hull.hull.lines.curves
    lines = set(curves.objects) if curves is not None else set()
    surface_object = shown_objects.surface_of(hull)
    return {surface_object, *collection.objects, *hull.children_recursive} - lines


def look_from(scene, view):
    """Has pictures be taken by the camera of one of views.VIEWS, framed to the hull as it is now
    and to the shape of the picture. ValueError where there is no such camera."""
    here = _studio_of(scene)
    camera = cameras.camera_of(here.collection, views.VIEWS[view])
    if camera is None:
        raise ValueError(f"The camera {views.VIEWS[view].label} is gone: set up the studio anew")
    cameras.frame(here, camera, view)
    lines_on_hull.draw_thin(here, cameras.width_at(here, camera))
    scene.camera = camera


def turn(scene, frames):
    """Has the turntable turn once in so many frames, and the film be taken from it."""
    look_from(scene, views.TURNTABLE)
    cameras.turn(_studio_of(scene), frames)
    # The last frame is the one before the first comes again.
    scene.frame_start, scene.frame_end = 1, frames


def _studio_of(scene):
    hull = hull_of(scene)
    if hull is None or shown_objects.surface_of(hull) is None:
        raise ValueError("There is no studio: set it up first")
    following.follow(scene)
    return place_of(hull, scene)


def remove(scene):
    """Takes the scene's studio down, with all that was made for it, and puts back what was changed;
    returns whether there was one."""
    collection = find(scene)
    if collection is None:
        return False
    studios = others(scene)
    scene_settings.show_as_before(collection, studios)
    _unpaint(collection, studios)
    scene_settings.give_back(collection, scene)
    hull, samples = collection[MARK].get("hull"), collection[MARK]["samples"]
    is_elsewhere = any(own[MARK].get("hull") == hull for _, own in studios)
    if hull is not None and hull.hull.samples != samples and not is_elsewhere:
        hull.hull.samples = samples
    blocks = _remove_objects(collection, scene)
    blocks.append(collection.get("own world"))
    bpy.data.collections.remove(collection)
    for block in blocks:
        if block is not None and not block.users:
            _blocks_like(block).remove(block)
    for material in [one for one in bpy.data.materials if one.get(MARK) and not one.users]:
        bpy.data.materials.remove(material)
    return True


def _remove_objects(collection, scene):
    """Removes the studio's objects, and lets the user's own, and his collections, stay; returns
    their data."""
    blocks = []
    for child in collection.children:
        if child.name not in scene.collection.children:
            scene.collection.children.link(child)
    for obj in list(collection.objects):
        if obj.get(MARK) is None:
            if len(obj.users_collection) == 1:
                scene.collection.objects.link(obj)
            continue
        blocks.append(obj.data)
        if obj.animation_data is not None:
            blocks.append(obj.animation_data.action)
        bpy.data.objects.remove(obj)
    return blocks


def _blocks_like(block):
    """Where Blender has data of this kind."""
    kinds = {
        bpy.types.Mesh: bpy.data.meshes,
        bpy.types.Curve: bpy.data.curves,
        bpy.types.Camera: bpy.data.cameras,
        bpy.types.Light: bpy.data.lights,
        bpy.types.Action: bpy.data.actions,
        bpy.types.World: bpy.data.worlds,
    }
    return next(blocks for kind, blocks in kinds.items() if isinstance(block, kind))
