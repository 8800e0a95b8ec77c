# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the surface of faces that are selected is flat, and the control points that keep it from
being so."""

from dataclasses import dataclass

import bmesh
import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ..hull import hull_state
from ..lines import lines


@dataclass(frozen=True)
class FlatCheck:
    """distance: the largest of the surface from the plane that fits it best, in m. at_fault:
    Blender's indices of the control points of the faces that are too far from it, or else of those
    around the faces that bend their rim."""

    distance: float
    at_fault: tuple
    message: str


def check_selected(obj, scene, tolerance):
    """The FlatCheck of the faces that are selected in edit mode; tolerance in Blender's units, 0:
    what single precision tells apart. ValueError without faces of the shell."""
    state = hull_state.up_to_date(obj, scene)
    control = state.ship.source.control
    bm = bmesh.from_edit_mesh(obj.data)
    bm.faces.index_update()
    selected = [face.index for face in bm.faces if face.select]
    faces = np.flatnonzero(np.isin(control.face_ids, selected))
    if not len(faces):
        raise ValueError("Select the faces of the hull that should be flat")
    scale = units.metres_per_unit(scene)
    allowed = tolerance * scale or lines.flat_tolerance(state.ship.surface)
    found = native.require().flatness(state.ship.surface, faces=faces, tolerance=allowed)
    own, around = found.at_fault, found.neighbours_at_fault
    furthest = units.format_value(scene, found.surface_distance, "m")
    if len(own):
        at_fault = own
        furthest_point = units.format_value(scene, found.control_distance, "m")
        reason = f"control points up to {furthest_point}: {len(own)} selected"
    elif found.surface_distance > allowed:
        at_fault = around
        reason = (
            f"though its control points are in it: {len(around)} around, which bend it, selected"
        )
    else:
        most = units.format_mm(found.surface_distance)
        message = f"Flat: the surface is at most {most} from its plane"
        return FlatCheck(found.surface_distance, (), message)
    message = f"The surface is up to {furthest} from its plane, {reason}"
    return FlatCheck(
        found.surface_distance,
        tuple(state.ship.source.control.vertex_ids[at_fault].tolist()),
        message,
    )
