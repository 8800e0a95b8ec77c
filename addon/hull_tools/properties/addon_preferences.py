# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit > Preferences > Add-ons > Hull Tools: what holds for all files."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty

from ..bridge.blender import palette, pie_key, preferences, redraw
from .shared import metric_field

_GROUNDS = ("on light grounds", "on dark grounds")


def _changed(chosen, context):
    redraw.redraw()


def _pie_key_changed(chosen, context):
    pie_key.follow(chosen.use_pie_key)


def _whole_number(prop, name, description, minimum, maximum):
    return IntProperty(
        name=name,
        description=description,
        default=preferences.DEFAULTS[prop],
        min=minimum,
        max=maximum,
        update=_changed,
    )


def _number(prop, name, description, minimum, maximum, precision=1, step=50):
    return FloatProperty(
        name=name,
        description=description,
        default=preferences.DEFAULTS[prop],
        min=minimum,
        max=maximum,
        precision=precision,
        step=step,
        update=_changed,
    )


def _colour(ink, group, ground, default):
    return FloatVectorProperty(
        name=ink.label,
        description=f"{group}: {ink.label.lower()}, {ground}",
        default=default,
        subtype="COLOR_GAMMA",
        size=3,
        min=0.0,
        max=1.0,
        update=_changed,
    )


def _colours():
    """A property for each colour of the palette, by name."""
    found = {}
    for group, (title, inks) in palette.GROUPS.items():
        for kind, ink in inks.items():
            names = palette.property_names(group, kind)
            grounds = _GROUNDS if len(names) == 2 else ("on any ground",)
            for name, ground, default in zip(names, grounds, (ink.on_light, ink.on_dark)):
                found[name] = _colour(ink, title, ground, default)
    return found


class HullToolsPreferences(bpy.types.AddonPreferences):
    bl_idname = preferences.ADDON

    page: EnumProperty(
        name="Page",
        description="What is shown of the preferences",
        items=(
            ("HULLS", "New Hulls", "What a mesh gets when it becomes a hull"),
            ("VIEW", "3D View", "Sizes of what is drawn over the 3D view, and keys"),
            ("COLOURS", "Colours", "Colours of what is drawn over the 3D view"),
        ),
    )

    samples: _whole_number(
        "samples", "Samples", "Faces along each side of a cell in the surface of a new hull", 1, 32
    )
    line_width: _number(
        "line_width", "Line width", "Of the lines of a new hull in the 3D view, in dots", 0.5, 10.0
    )
    station_count: _whole_number(
        "station_count", "Spaces of stations",
        "Into how many Lpp of a new hull is divided; 0: no stations", 0, 200,
    )  # fmt: skip
    waterline_count: _whole_number(
        "waterline_count", "Waterlines",
        "About how many a new hull has; their spacing is a handy number; 0: none", 0, 100,
    )  # fmt: skip
    buttock_count: _whole_number(
        "buttock_count", "Buttocks",
        "About how many a new hull has on each side; their spacing is a handy number; 0: none",
        0, 100,
    )  # fmt: skip
    water_density: _number(
        "water_density", "Density t/m³",
        "Density of the water of a new hull: 1.025 in the sea, 1.000 in a river",
        0.5, 2.0, precision=4, step=0.1,
    )  # fmt: skip

    mark_size: _number(
        "mark_size", "Size of marks", "Radius of marks on lines and points, in dots", 2.0, 20.0
    )
    tag_width: _number(
        "tag_width", "Width of tags", "Of tagged edges in edit mode, in dots", 1.0, 10.0
    )
    plot_size: _number(
        "plot_size", "Size of plots", "Of plots over the 3D view; 1 is 125 × 88 mm on paper",
        0.4, 3.0, precision=2, step=10,
    )  # fmt: skip
    use_pie_key: BoolProperty(
        name="Key of the pie menu",
        description="The pie menu of hulls has a key in the 3D view",
        default=preferences.DEFAULTS["use_pie_key"],
        update=_pie_key_changed,
    )

    __annotations__.update(_colours())

    def draw(self, context):
        layout = self.layout
        layout.row().prop(self, "page", expand=True)
        getattr(self, f"_draw_{self.page.lower()}")(layout)

    def _draw_hulls(self, layout):
        layout.use_property_split = True
        layout.label(text="Hulls that there are keep what they have")
        column = layout.column()
        for name in ("station_count", "waterline_count", "buttock_count", "samples",
                     "line_width"):  # fmt: skip
            column.prop(self, name)
        metric_field(column, self, "water_density")

    def _draw_view(self, layout):
        layout.use_property_split = True
        column = layout.column()
        for name in ("mark_size", "tag_width", "plot_size", "use_pie_key"):
            column.prop(self, name)

    def _draw_colours(self, layout):
        flow = layout.grid_flow(columns=2, even_columns=True)
        for group, (title, inks) in palette.GROUPS.items():
            box = flow.box().column(align=True)
            row = box.split(factor=0.5)
            row.label(text=title)
            if any(ink.on_dark for ink in inks.values()):
                row.label(text="On light")
                row.label(text="On dark")
            for kind, ink in inks.items():
                row = box.split(factor=0.5)
                row.label(text=ink.label)
                for name in palette.property_names(group, kind):
                    row.prop(self, name, text="")


CLASSES = (HullToolsPreferences,)
