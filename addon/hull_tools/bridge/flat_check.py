# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the surface of faces that are selected is flat, and the control points that keep it from
being so."""

from dataclasses import dataclass

import bmesh
import numpy as np

from . import hull_state, lines, native, units


@dataclass(frozen=True)
class FlatCheck:
    """distance: the largest of the surface from the plane that fits it best, in m. at_fault:
    Blender's indices of the control points too far from it."""

    distance: float
    at_fault: tuple
    message: str


def check_selected(obj, scene, tolerance):
    """The FlatCheck of the faces that are selected in edit mode; tolerance in Blender's units, 0:
    what single precision tells apart. ValueError without faces of the shell."""
    state = hull_state.refresh(obj, scene)
    if state.status:
        raise ValueError(state.status)
    control = state.source.control
    bm = bmesh.from_edit_mesh(obj.data)
    bm.faces.index_update()
    selected = [face.index for face in bm.faces if face.select]
    faces = np.flatnonzero(np.isin(control.face_ids, selected))
    if not len(faces):
        raise ValueError("Select the faces of the hull that should be flat")
    scale = units.metres_per_unit(scene)
    allowed = tolerance * scale or lines.flat_tolerance(state.surface)
    found = native.require().flatness(state.surface, faces=faces, tolerance=allowed)
    at_fault = tuple(control.vertex_ids[found.at_fault].tolist())
    return FlatCheck(
        found.surface_distance, at_fault, _message(scene, found, len(at_fault), allowed)
    )


def _message(scene, found, count, allowed):
    furthest = units.format_value(scene, found.surface_distance, "m")
    control = units.format_value(scene, found.control_distance, "m")
    if not count:
        return f"Flat: the surface is at most {1e3 * found.surface_distance:.3g} mm from its plane"
    return (
        f"The surface is up to {furthest} from its plane, control points up to {control}: "
        f"{count} selected"
    )


def select_points(obj, indices):
    """Selects exactly these points of a hull in edit mode."""
    bm = bmesh.from_edit_mesh(obj.data)
    bm.verts.ensure_lookup_table()
    for sequence in (bm.faces, bm.edges, bm.verts):
        for element in sequence:
            element.select_set(False)
    for index in indices:
        bm.verts[index].hide_set(False)
        bm.verts[index].select_set(True)
    bm.select_mode = {"VERT"}
    bm.select_flush_mode()
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
