# SPDX-License-Identifier: GPL-3.0-or-later
"""What the groups of properties have in common, and how one is drawn whose zero has a meaning, or
whose unit is metric whatever the scene's are."""

import bpy
from bpy.props import BoolProperty, FloatProperty

from ..bridge.blender import units


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


def field_or(layout, settings, name, meaning, unit=None, **shown):
    """A number, and below it what counts where it is zero; of others as metric_field."""
    column = layout.column(align=True)
    if getattr(settings, name):
        metric_field(column, settings, name, unit, **shown)
    else:
        column.prop(settings, name, **shown)
        _label_below(column, f"0: {meaning}")


def metric_field(layout, settings, name, unit=None, **shown):
    """A number, and where it is metric and the scene is imperial, below it what that is in feet or
    their like. unit: of tables; None: what its name ends in. shown: as of UILayout.prop()."""
    label = shown.get("text", settings.rna_type.properties[name].name)
    unit = unit or units.unit_of_label(label)
    column = layout.column(align=True) if _is_turned(unit) else layout
    column.prop(settings, name, **shown)
    show_imperial(column, settings, [name], unit)


def metric_fields(layout, settings, names, unit=None):
    """Numbers of one unit, and below them all what they are in feet or their like."""
    for name in names:
        layout.prop(settings, name)
    label = settings.rna_type.properties[names[0]].name
    show_imperial(layout, settings, names, unit or units.unit_of_label(label))


def show_imperial(layout, settings, names, unit):
    """What numbers in a unit of tables are in the imperial one, where the scene's units are those
    and not all are 0."""
    values = [getattr(settings, name) for name in names]
    if _is_turned(unit) and any(values):
        _label_below(layout, f"= {units.imperial_texts(values, unit)}")


def _is_turned(unit):
    return unit is not None and units.is_imperial(bpy.context.scene)


def _label_below(layout, text):
    row = layout.row()
    row.active = False
    row.alignment = "RIGHT"
    row.label(text=text)
