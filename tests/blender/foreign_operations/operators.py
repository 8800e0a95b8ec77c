# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own operators on meshes and objects, called with arguments by chance."""

import functools

import bpy
import numpy as np

FAMILIES = {
    "EDIT": ("mesh", "transform", "object", "geometry"),
    "OBJECT": ("object", "transform", "geometry"),
    "SCULPT": ("sculpt", "paint", "object"),
    "PAINT": ("paint", "geometry", "object"),
}

# What is left out, by reason; test_foreign_operations.py holds the names against Blender's own.
_NEEDS_THE_MOUSE = {
    "mesh.knife_tool",
    "object.voxel_size_edit",
    "object.transform_to_mouse",
    "object.transfer_mode",
    "sculpt.brush_stroke",
    "sculpt.dyntopo_detail_size_edit",
    "sculpt.expand",
    "sculpt.sample_detail_size",
    "transform.from_gizmo",
    "transform.seq_slide",
}
_TAKES_FILES_OR_TIME = {
    "object.bake",
    "object.bake_image",
    "object.lineart_bake_strokes",
    "object.lineart_bake_strokes_all",
    "object.multires_external_save",
    "object.ocean_bake",
    "object.paths_calculate",
    "object.quick_explode",
    "object.quick_fur",
    "object.quick_liquid",
    "object.quick_smoke",
    "object.volume_import",
    "paint.image_from_view",
}
# These are done by the session itself, which has to know of them.
_ACTIONS_OF_THE_SESSION = {
    "object.editmode_toggle",
    "object.mode_set",
    "object.mode_set_with_submode",
    "object.posemode_toggle",
    "paint.texture_paint_toggle",
    "paint.vertex_paint_toggle",
    "paint.weight_paint_toggle",
    "sculpt.sculptmode_toggle",
}
# Objects that are no meshes: Blender's own operators come down with some of them.
_NO_MESHES = {
    "object.add",
    "object.armature_add",
    "object.camera_add",
    "object.collection_instance_add",
    "object.curves_empty_hair_add",
    "object.curves_random_add",
    "object.data_instance_add",
    "object.drop_named_image",
    "object.effector_add",
    "object.gpencil_add",
    "object.light_add",
    "object.lightprobe_add",
    "object.metaball_add",
    "object.pointcloud_add",
    "object.speaker_add",
    "object.text_add",
    "object.volume_add",
}
_BRINGS_BLENDER_DOWN = {
    "sculpt.set_persistent_base": "it brings Blender down",
    "sculpt.face_sets_create": "without a window it writes where other things are",
    "object.lightprobe_cache_bake": "without a window it wants a GPU, and brings Blender down",
}
# These change a mesh that is edited and forget to say so to anybody, Blender's own view included.
TELL_NOBODY = {"mesh.bridge_edge_loops"}
# {name: why it is left out}.
LEFT_OUT = {
    **dict.fromkeys(_NEEDS_THE_MOUSE, "it needs the mouse"),
    **dict.fromkeys(_TAKES_FILES_OR_TIME, "it takes files, or much time"),
    **dict.fromkeys(_ACTIONS_OF_THE_SESSION, "the session itself does it"),
    **dict.fromkeys(_NO_MESHES, "it makes an object that is no mesh"),
    **_BRINGS_BLENDER_DOWN,
}
# Of those names the ones that Blender did not always have: its version from which on it has them.
# All others it had in 3.4, and some no longer.
SINCE = {"object.lightprobe_cache_bake": (4, 1)}
# Simulations, and what reads files.
MODIFIERS_LEFT_OUT = {
    "CLOTH",
    "COLLISION",
    "DYNAMIC_PAINT",
    "EXPLODE",
    "FLUID",
    "MESH_CACHE",
    "MESH_SEQUENCE_CACHE",
    "MESH_TO_VOLUME",
    "OCEAN",
    "PARTICLE_INSTANCE",
    "PARTICLE_SYSTEM",
    "SOFT_BODY",
    "VOLUME_TO_MESH",
}
_MOST = 3  # of what an operator repeats or divides by
_FARTHEST = 4.0
_VOXELS = 12  # along a mesh


def by_chance(mode, random):
    """Names as "mesh.delete" of the operators of a mode, in an order by chance."""
    family = "PAINT" if mode.endswith("PAINT") else mode
    return in_an_order_by_chance(FAMILIES[family], LEFT_OUT, random)


def in_an_order_by_chance(modules, left_out, random):
    names = [f"{module}.{name}" for module in modules for name in names_of(module)]
    names = [name for name in names if name not in left_out]
    return random.sample(names, len(names))


@functools.cache  # asking Blender for them takes longer than most of them
def names_of(module):
    return sorted(dir(getattr(bpy.ops, module)))


def _operator(name):
    module, own = name.split(".")
    return getattr(getattr(bpy.ops, module), own)


def can_be_called(name):
    try:
        return _operator(name).poll()
    except (AttributeError, KeyError, RuntimeError, TypeError):  # those of scripts may read much
        return False


def call(name, arguments):
    """What the operator returned, or what it refused with; the add-on's own refuse with a sentence,
    not with a traceback."""
    if name == "object.voxel_remesh":
        _take_large_voxels(bpy.context.view_layer.objects.active.data)
    try:
        return sorted(_operator(name)("EXEC_DEFAULT", **arguments))
    except (RuntimeError, TypeError, ValueError) as error:
        assert "Traceback" not in str(error) or "hull_tools" not in str(error), error
        return str(error).strip().splitlines()[-1][:80]


def _take_large_voxels(mesh):
    """Of the mesh's own size: modifiers may hide all that the object's dimensions are of, and
    voxels of a millimetre in a ship take gigabytes."""
    points = np.array([vertex.co for vertex in mesh.vertices]).reshape(-1, 3)
    size = np.ptp(points, axis=0).max() if len(points) else 0.0
    mesh.remesh_voxel_size = max(size / _VOXELS, 1e-3)


def properties_of(name):
    properties = _operator(name).get_rna_type().properties
    return [prop for prop in properties if prop.identifier != "rna_type"]


def arguments_by_chance(name, random):
    """Arguments for about half of what the operator takes."""
    found = {}
    for prop in properties_of(name):
        if random.random() < 0.5:
            continue
        value = value_by_chance(prop, random)
        if value is not None:
            found[prop.identifier] = value
    return found


def value_by_chance(prop, random):
    """Of a property's kind, not far from zero; None of some kinds."""
    if prop.type == "POINTER":
        return _macro_step(prop, random)
    if prop.type == "ENUM":
        return _choice(prop, random)
    if prop.type == "STRING":
        return _modifier(random) if prop.identifier == "modifier" else None
    if prop.type not in ("BOOLEAN", "INT", "FLOAT") or prop.identifier == "wait_for_input":
        return None
    if getattr(prop, "is_array", False):
        return [_number(prop, random) for _ in range(prop.array_length)]
    return _number(prop, random)


def _macro_step(prop, random):
    """Arguments of a part of an operator that is made of others."""
    if "translate" in prop.identifier:
        return {"value": [random.uniform(-1.0, 1.0) for _ in range(3)]}
    return {"value": random.uniform(-1.0, 1.0)} if "shrink_fatten" in prop.identifier else None


def _choice(prop, random):
    items = [item.identifier for item in prop.enum_items]
    items = [item for item in items if item not in MODIFIERS_LEFT_OUT]
    if not items:
        return None
    return {random.choice(items)} if prop.is_enum_flag else random.choice(items)


def _modifier(random):
    active = bpy.context.view_layer.objects.active
    names = [modifier.name for modifier in active.modifiers] if active is not None else []
    return random.choice(names) if names else None


def _number(prop, random):
    if prop.type == "BOOLEAN":
        return random.random() < 0.5
    if prop.type == "INT":
        low = max(prop.hard_min, -_MOST)
        return random.randint(low, max(min(prop.hard_max, _MOST), low))
    low, high = max(prop.soft_min, -_FARTHEST), min(prop.soft_max, _FARTHEST)
    value = random.choice([0.0, 1.0, random.uniform(low, high), random.uniform(low, high)])
    return min(max(value, prop.hard_min), prop.hard_max)
