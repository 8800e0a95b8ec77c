# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of a control mesh: a material slot each, whose entry in Object.hull.layers says whether
its faces belong to the shell, and what plating they have."""

import bmesh
import numpy as np

from ...bridge.objects import hull_objects
from ..hull import hull_state
from ..surface import materials

_SHELL, _GREY = "Shell", (0.75, 0.75, 0.75)


def make_layer(obj, scene, name):
    """Puts the faces that are selected in edit mode into a new layer of the shell; returns how
    many. ValueError when none is."""
    bm = bmesh.from_edit_mesh(obj.data)
    chosen = [face for face in bm.faces if face.select]
    if not chosen:
        raise ValueError("Select the faces of the layer first")
    slot = add_layer(obj, _free_name(obj, name))
    for face in chosen:
        face.material_index = slot
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
    hull_state.follow_edit(obj, scene)
    return len(chosen)


def add_layer(obj, name, in_hydrostatics=True):
    """Index of the slot of a new layer without faces: in a mesh without slots not the first one,
    which its faces are in."""
    if not obj.material_slots:
        _add_slot(obj, _SHELL, True)
    return _add_slot(obj, name, in_hydrostatics)


def _free_name(obj, name):
    """A name that no layer of a hull has: this one, or with the least number after it."""
    taken = set(hull_objects.slot_names(obj))
    number, free = 2, name
    while free in taken:
        number, free = number + 1, f"{name} {number}"
    return free


def _add_slot(obj, name, in_hydrostatics):
    material = materials.layer_material(name, _GREY)
    obj.data.materials.append(material)
    layer = obj.hull.layers.add()
    layer.name, layer.material, layer.in_hydrostatics = name, material, in_hydrostatics
    return len(obj.data.materials) - 1


def remove_empty(obj, scene):
    """Removes the layers without faces of a hull that is not in edit mode; returns how many.
    ValueError where there are none."""
    slots = np.empty(len(obj.data.polygons), dtype=np.int32)
    obj.data.polygons.foreach_get("material_index", slots)
    count = len(obj.material_slots)
    # Faces of a slot that is not there show, and count as, the last one.
    empty = sorted(set(range(count)) - set(np.minimum(slots, count - 1).tolist()))
    if not empty:
        raise ValueError("Every layer has faces")
    for slot in reversed(empty):
        obj.data.materials.pop(index=slot)
    _forget_layers(obj)
    hull_state.follow_edit(obj, scene)
    return len(empty)


def _forget_layers(obj):
    """Removes the entries of layers that the mesh has no longer."""
    layers = obj.hull.layers
    left = {slot.material for slot in obj.material_slots}
    for index in reversed(range(len(layers))):
        if layers[index].material not in left:
            layers.remove(index)
