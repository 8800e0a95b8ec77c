# SPDX-License-Identifier: GPL-3.0-or-later
"""What the groups of properties have in common, and how one is drawn whose zero has a meaning."""

from bpy.props import BoolProperty, FloatProperty


def changed(settings, context):
    """Blender tells handlers of changes made in the window by itself, but not of a script's."""
    settings.id_data.update_tag(refresh={"DATA"})


def switch(name, description, default=False):
    return BoolProperty(name=name, description=description, default=default, update=changed)


def length(name, description, default=0.0, minimum=0.0, update=changed, **more):
    """A length in the scene's units; `minimum` None for one that may be negative."""
    bounds = {} if minimum is None else {"min": minimum}
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        unit="LENGTH",
        subtype="DISTANCE",
        precision=5,
        update=update,
        **bounds,
        **more,
    )


def mass(name, description, precision=3):
    return FloatProperty(
        name=name, description=description, min=0.0, precision=precision, step=100, update=changed
    )


def angle(name, description, default, minimum, maximum, update=changed):
    """Radians, shown in degrees."""
    return FloatProperty(
        name=name,
        description=description,
        default=default,
        min=minimum,
        max=maximum,
        unit="ROTATION",
        subtype="ANGLE",
        precision=3,
        step=100,
        update=update,
    )


def field_or(layout, settings, name, meaning):
    """A number, and below it what counts where it is zero."""
    column = layout.column(align=True)
    column.prop(settings, name)
    if not getattr(settings, name):
        row = column.row()
        row.active = False
        row.alignment = "RIGHT"
        row.label(text=f"0: {meaning}")
