# SPDX-License-Identifier: GPL-3.0-or-later
"""What a studio changes of a scene, as it was before: noted with the studio's collection, and so in
the file and through undo, and put back when the studio goes."""

import json

# Of a scene; what a Blender has not, such as Cycles where it is left out, is passed over.
_SETTINGS = (
    "render.engine",
    "render.resolution_x",
    "render.resolution_y",
    "render.resolution_percentage",
    "render.pixel_aspect_x",
    "render.pixel_aspect_y",
    "render.film_transparent",
    "view_settings.view_transform",
    "view_settings.look",
    "view_settings.exposure",
    "view_settings.gamma",
    "frame_start",
    "frame_end",
    "frame_current",
    "cycles.samples",
    "cycles.use_adaptive_sampling",
    "cycles.adaptive_threshold",
    "cycles.adaptive_min_samples",
    "cycles.use_denoising",
    "cycles.max_bounces",
    "cycles.transparent_max_bounces",
    "cycles.caustics_reflective",
    "cycles.caustics_refractive",
    "cycles.sample_clamp_indirect",
    "eevee.taa_render_samples",
    "eevee.use_gtao",
    "eevee.use_soft_shadows",
    "eevee.shadow_pool_size",
    "eevee.shadow_resolution_scale",
)


def note(collection, scene):
    """Notes in a studio's collection what the scene's settings, camera and world are."""
    noted = {path: _read(scene, path) for path in _SETTINGS if _owner(scene, path) is not None}
    collection["settings"] = json.dumps(noted)
    _point_to(collection, "camera", scene.camera)
    _point_to(collection, "world", scene.world)


def give_back(collection, scene):
    """Puts back what `note` has noted."""
    for path, value in json.loads(collection["settings"]).items():
        write(scene, path, value)
    scene.camera = collection.get("camera")
    scene.world = collection.get("world")


def write(scene, path, value):
    """Sets one of a scene's settings, if this Blender has it, and has that value of it: other
    versions have other engines and views."""
    owner = _owner(scene, path)
    if owner is None:
        return
    try:
        setattr(owner, path.rpartition(".")[2], value)
    except TypeError:
        pass


def _read(scene, path):
    return getattr(_owner(scene, path), path.rpartition(".")[2])


def _owner(scene, path):
    """What has the property at a path; None where there is no such property."""
    group, _, name = path.rpartition(".")
    owner = getattr(scene, group, None) if group else scene
    return owner if owner is not None and hasattr(owner, name) else None


def _point_to(collection, name, block):
    if block is not None:
        collection[name] = block


def show_only(collection, scene, seen):
    """Leaves to pictures only those of the scene's objects that are `seen`."""
    _turn(collection, "hidden", [one for one in scene.objects if not one.hide_render], seen, True)
    _turn(collection, "shown", [one for one in scene.objects if one.hide_render], seen, False)


def _turn(collection, name, objects, seen, hide):
    changed = [obj for obj in objects if (obj in seen) != hide]
    _note_turned(collection, name, changed)
    for obj in changed:
        obj.hide_render = hide


def _note_turned(collection, name, objects):
    collection[name] = {str(index): obj for index, obj in enumerate(objects)}


def _turned(collection, name):
    return [obj for obj in collection[name].values() if obj is not None]


def show_as_before(collection, others):
    """others: as place.others gives them; what is in one of these scenes stays as it is, and is put
    back with the studio there."""
    for name, opposite in (("hidden", "shown"), ("shown", "hidden")):
        for obj in _turned(collection, name):
            keeper = next((kept for scene, kept in others if obj.name in scene.objects), None)
            if keeper is None:
                obj.hide_render = name == "shown"
            elif obj in (turned := _turned(keeper, opposite)):  # turned there to what it was before
                turned.remove(obj)
                _note_turned(keeper, opposite, turned)
            else:
                _note_turned(keeper, name, [*_turned(keeper, name), obj])
