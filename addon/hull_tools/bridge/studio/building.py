# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets a studio up and takes it down."""

import bpy

from ..blender import units
from ..hull import hull_state
from ..objects import shown_objects
from . import cameras, deck, ground, keeping, light, lines_on_hull, paint, rendering
from .place import MARK, Place, points_of

# Faces along each side of a cell: fine enough that a facet shows nowhere in the picture.
_SAMPLES = 12


def find(scene):
    """The collection of the scene's studio; None when it has none."""
    for collection in scene.collection.children_recursive:
        if collection.get(MARK) is not None and collection.library is None:
            return collection
    return None


def hull_of(scene):
    """The hull that the scene's studio is for; None when there is no studio, or no such hull."""
    collection = find(scene)
    return None if collection is None else collection[MARK].get("hull")


def make(hull, scene):
    """Sets up the studio that Object.hull.studio of a hull asks for, in place of one that there is;
    returns its collection. ValueError when the hull has no surface as it is."""
    state = hull_state.refresh(hull, scene)
    if state.status:
        raise ValueError(state.status)
    scale = units.metres_per_unit(scene)
    settings = hull.hull.studio
    groups = lines_on_hull.find(hull, state, settings.lines, scale)
    remove(scene)

    collection = bpy.data.collections.new(f"Studio of {hull.name}")
    collection[MARK] = {
        "hull": hull,
        "samples": hull.hull.samples,
        "in water": settings.ground == "WATER",
    }
    scene.collection.children.link(collection)
    keeping.keep(collection, scene)
    shown_objects.ensure(hull)
    hull.hull.samples = max(hull.hull.samples, _SAMPLES)
    hull_state.refresh(hull, scene)

    here = _place(hull, scene, collection)
    _furnish(here, settings, state)
    lines_on_hull.add_lines(here, state.surface, groups)
    rendering.set_renderer(scene, settings.engine)
    cameras.add_cameras(here)
    cameras.turn(here, settings.turntable_frames)
    look_from(scene, cameras.FIRST)
    keeping.show_only(collection, scene, _seen(hull, collection))
    return collection


def _furnish(here, settings, state):
    """Paint, deck, water or floor, and light."""
    surface_object = shown_objects.surface_of(here.hull)
    if settings.paint:
        _paint(here.collection, surface_object, paint.hull_paint(here, settings))
    if settings.deck:
        deck.add_deck(here, surface_object.data, paint.deck_paint(here))
    backdrop = light.backdrop_of(settings.light)
    if here.in_water:
        lines = lines_on_hull.waterlines(here.hull, state, here.metres_per_unit)
        ground.add_water(here, [line / here.metres_per_unit for line in lines], backdrop)
    elif settings.ground == "FLOOR":
        ground.add_floor(here, backdrop)
    here.scene.world = here.collection["own world"] = light.add_light(here, settings.light)


def _place(hull, scene, collection):
    points = points_of(shown_objects.surface_of(hull).data)
    draft = units.as_typed(hull.hull.draft)
    draft = draft if draft > points[:, 2].min() else 0.0
    in_water = bool(collection[MARK]["in water"]) and draft > 0.0
    scale = units.metres_per_unit(scene)
    return Place(hull, scene, collection, points, draft, scale, in_water)


def _paint(collection, surface_object, material):
    """Paints the surface object, and notes what it had; its mesh keeps its own material."""
    slot = surface_object.material_slots[0]
    was = {"link": slot.link}
    if slot.link == "OBJECT" and slot.material is not None:
        was["material"] = slot.material
    collection["painted"] = surface_object
    collection["material"] = was
    slot.link = "OBJECT"
    slot.material = material


def _unpaint(collection):
    surface_object = collection.get("painted")
    if surface_object is None or not surface_object.material_slots:
        return
    slot, was = surface_object.material_slots[0], collection["material"]
    slot.material = was.get("material")
    slot.link = was["link"]


def _seen(hull, collection):
    """What pictures show: the studio, the hull's surface, and what the user has put on the hull."""
    curves = hull.hull.lines.curves
    lines = set(curves.objects) if curves is not None else set()
    surface_object = shown_objects.surface_of(hull)
    return {surface_object, *collection.objects, *hull.children_recursive} - lines


def look_from(scene, view):
    """Has pictures be taken by the camera of one of cameras.VIEWS, framed to the hull as it is now
    and to the shape of the picture. ValueError where there is no such camera."""
    here = _studio_of(scene)
    camera = cameras.camera_of(here.collection, cameras.VIEWS[view])
    if camera is None:
        raise ValueError(f"The camera {cameras.VIEWS[view].label} is gone: set up the studio anew")
    cameras.frame(here, camera, view)
    lines_on_hull.draw_thin(here, cameras.width_at(here, camera))
    scene.camera = camera


def turn(scene, frames):
    """Has the turntable turn once in so many frames, and the film be taken from it."""
    look_from(scene, cameras.TURNTABLE)
    cameras.turn(_studio_of(scene), frames)
    # The last frame is the one before the first comes again.
    scene.frame_start, scene.frame_end = 1, frames


def _studio_of(scene):
    hull = hull_of(scene)
    if hull is None or shown_objects.surface_of(hull) is None:
        raise ValueError("There is no studio: set it up first")
    return _place(hull, scene, find(scene))


def remove(scene):
    """Takes the scene's studio down, with all that was made for it, and puts back what was changed;
    returns whether there was one."""
    collection = find(scene)
    if collection is None:
        return False
    keeping.show_as_before(collection)
    _unpaint(collection)
    keeping.give_back(collection, scene)
    hull, samples = collection[MARK].get("hull"), collection[MARK]["samples"]
    if hull is not None and hull.hull.samples != samples:
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
    """Removes the studio's objects, and lets the user's own stay; returns their data."""
    blocks = []
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
