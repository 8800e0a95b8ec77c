# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.appendage: the body that an appendage's object shows; of other objects it is
unused."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty

from ..features.hull import appendage_kinds, appendage_meshes
from .shared import length


def _changed(settings, context):
    """The mesh shows the body anew, and the hull follows."""
    obj = settings.id_data
    if settings.shape != "NONE":
        appendage_meshes.show(obj)
    obj.update_tag(refresh={"DATA"})


def _length(name, description, minimum=0.0):
    return length(name, description, minimum=minimum, update=_changed)


def _ratio(name):
    return FloatProperty(
        name=name,
        description="Of the chord; 0: that of the section's name",
        min=0.0,
        max=1.0,
        precision=4,
        step=1,
        update=_changed,
    )


class HullAppendage(bpy.types.PropertyGroup):
    """Lengths in Blender's units; what they mean: bridge.objects.appendages."""

    shape: EnumProperty(
        name="Shape",
        description="What the body is",
        items=(
            ("NONE", "None", "No appendage"),
            ("CYLINDER", "Cylinder", "A circular cylinder or cone along its own z"),
            ("FOIL", "Foil", "Straight lines between two sections, root and tip"),
            ("BULB", "Bulb", "A body of revolution with a section's outline"),
        ),
        default="NONE",
        options={"HIDDEN"},
    )
    counts: BoolProperty(
        name="Counts",
        description="The body counts in hydrostatics and stability, and is in STEP and IGES files",
        default=True,
        update=_changed,
    )
    is_cut: BoolProperty(
        name="Cut out",
        description="The body is cut out of the hull, as a tunnel; else it is added to it",
        update=_changed,
    )
    is_mirrored: BoolProperty(
        name="Both sides",
        description="Its mirror image in the centre plane is there too",
        update=_changed,
    )
    section: StringProperty(
        name="Section",
        description=appendage_kinds.SECTIONS,
        default="0012",
        update=_changed,
    )
    length: _length("Length", "Of the cylinder or bulb along its axis")
    radius: _length("Radius", "Of the cylinder at its start, or the bulb's largest")
    end_radius: _length("End radius", "Of the cylinder at its end; 0: as at the start")
    span: _length("Span", "From root down to tip, square to the sections", None)
    sweep: _length("Sweep", "How far the tip's leading edge is abaft the root's", None)
    lean: _length("Lean", "How far the tip is to port of the root", None)
    chord: _length("Root chord", "Length of the section at the root")
    tip_chord: _length("Tip chord", "Length of the section at the tip; 0: as at the root")
    thickness: _ratio("Root t/c")
    tip_thickness: _ratio("Tip t/c")


CLASSES = (HullAppendage,)
