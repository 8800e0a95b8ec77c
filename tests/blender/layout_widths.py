# SPDX-License-Identifier: GPL-3.0-or-later
"""How wide a panel's texts are, without a window: a layout that measures what it is told.

Sizes are those of Blender's interface at a scale of 1, taken from pictures of it.
"""

import blf
import bpy

# Of the sidebar as Blender opens it, what is left between the margins of a panel. It is 220 wide in
# 3.4, and 280 in 4.3.
SIDEBAR = (280.0 if bpy.app.version >= (4, 0, 0) else 220.0) - 55.0

_TEXT = 11  # points
_FONT = 0
_NUMBER, _CHECKBOX, _BUTTON, _DROPDOWN, _LABEL = 33.0, 17.0, 6.0, 26.0, 4.0
_ICON = 20.0
_SPLIT_PART = 0.4  # what names get where they are split from their fields
_NAME_PART = 0.25  # what the names of texts and of choices get of a field's width


_ICONS = set(bpy.types.UILayout.bl_rna.functions["prop"].parameters["icon"].enum_items.keys())


def _icon_width(icon):
    assert icon in _ICONS, f"Blender has no icon {icon}"
    return _ICON if icon != "NONE" else 0.0


def text_width(text):
    blf.size(_FONT, _TEXT)
    return blf.dimensions(_FONT, text)[0]


class Measuring:
    """Stands for a layout. `faults(width)` are the texts that are cut off at a width."""

    scale_x, alignment, use_property_split = 1.0, "EXPAND", False

    def __init__(self, parts="COLUMN", factor=0.0):
        self._parts, self._factor = parts, factor
        self._items = []  # pairs (width that is needed, what it is), or Measuring

    def _child(self, parts, factor=0.0):
        child = Measuring(parts, factor)
        child.use_property_split = self.use_property_split
        self._items.append(child)
        return child

    def column(self, **unused):
        return self._child("COLUMN")

    box = column

    def grid_flow(self, columns=0, **unused):
        return self._child("ROW" if columns != 1 else "COLUMN")

    def row(self, **unused):
        return self._child("ROW")

    def split(self, factor=0.0, **unused):
        return self._child("SPLIT", factor)

    def menu_pie(self):
        return self._child("COLUMN")

    def separator(self, **unused):
        pass

    def template_list(self, *unused, **more_unused):
        pass

    def _add(self, width, what):
        self._items.append((width, what))

    def label(self, text="", icon="NONE", **unused):
        self._add(text_width(text) + _LABEL + _icon_width(icon), text)

    def _button(self, text, icon):
        if text:
            self._add(text_width(text) + _BUTTON + _icon_width(icon), text)
        else:
            _icon_width(icon)
            self._add(_ICON, "")

    def prop_enum(self, data, name, value, text=None, icon="NONE", **unused):
        item = data.bl_rna.properties[name].enum_items[value]
        self._button(item.name if text is None else text, icon)

    def operator(self, idname, text=None, icon="NONE", **unused):
        group, name = idname.split(".")
        rna = getattr(getattr(bpy.ops, group), name).get_rna_type()
        self._button(rna.name if text is None else text, icon)
        return _Anything()

    def operator_menu_enum(self, idname, prop, text=None, icon="NONE", **unused):
        return self.operator(idname, text, icon)

    def operator_enum(self, idname, prop, **unused):
        group, name = idname.split(".")
        rna = getattr(getattr(bpy.ops, group), name).get_rna_type()
        for item in rna.properties[prop].enum_items:
            self._button(item.name, item.icon)

    def menu(self, idname, text=None, icon="NONE", **unused):
        self._button(getattr(bpy.types, idname).bl_label if text is None else text, icon)

    def popover(self, panel, text=None, icon="NONE", **unused):
        self.menu(panel, text, icon)

    def prop(self, data, name, text=None, icon="NONE", icon_only=False, toggle=False, **unused):
        prop = data.bl_rna.properties[name]
        shown = prop.name if text is None else text
        _icon_width(icon)
        if self.use_property_split and shown and prop.type != "BOOLEAN":
            beside = self.split(factor=_SPLIT_PART)
            beside.use_property_split = False
            beside.label(text=shown)
            beside.prop(data, name, text="")
            return
        if icon_only or (not shown and prop.type == "BOOLEAN"):
            self._add(_ICON, "")
        elif prop.type == "BOOLEAN":
            self._add(text_width(shown) + _CHECKBOX, shown)
        elif prop.type in ("INT", "FLOAT") and not prop.is_array:
            value = _value_text(data, prop)
            self._add(text_width(shown) + text_width(value) + _NUMBER, f"{shown} {value}")
        elif prop.type in ("INT", "FLOAT"):
            self._add(text_width(shown) + _LABEL, shown)
        elif prop.type == "ENUM":
            widest = max(text_width(item.name) for item in prop.enum_items) + _DROPDOWN
            self._named(shown, widest)
        elif prop.type == "STRING":
            self._named(shown, 0.0)
        else:
            self._add(0.0, shown)

    def prop_search(self, data, name, *where, **more):
        self.prop(data, name, **more)

    def _named(self, name, field_width):
        """A name before a field, which each have their part."""
        if not name:
            self._add(field_width, "choice")
            return
        self._add((text_width(f"{name}:") + _LABEL) / _NAME_PART, f"{name}:")
        self._add(field_width / (1.0 - _NAME_PART), f"{name}: choice") if field_width else None

    def needed(self):
        needs = [item.needed() if isinstance(item, Measuring) else item[0] for item in self._items]
        return sum(needs) if self._parts in ("ROW", "SPLIT") else max(needs, default=0.0)

    def natural(self):
        """The width that Blender shares a row out by."""
        sizes = self._natural_sizes()
        whole = sum(sizes) if self._parts in ("ROW", "SPLIT") else max(sizes, default=0.0)
        return self.scale_x * whole

    def _natural_sizes(self):
        """A panel's texts have ten units whatever they are, unless they are put to one side."""
        return [_natural(item, self.alignment != "EXPAND") for item in self._items]

    def texts(self):
        for item in self._items:
            yield from item.texts() if isinstance(item, Measuring) else (item[1],)

    def faults(self, width):
        natural = self._natural_sizes()
        fixed = sum(one for one in natural if one <= _ICON)
        for index, item in enumerate(self._items):
            room = width
            if self._parts == "ROW" and natural[index] > _ICON:
                room = (width - fixed) * natural[index] / (sum(natural) - fixed)
            if self._parts == "SPLIT" and len(self._items) > 1:
                rest = (1.0 - self._factor) / (len(self._items) - 1)
                room = width * (rest if index else self._factor)
            if isinstance(item, Measuring):
                yield from item.faults(room)
            elif item[0] > room:
                yield f"{item[0]:.0f} of {room:.0f}: {item[1]}"


def _natural(item, is_as_needed):
    if isinstance(item, Measuring):
        return item.natural()
    width, text = item
    if is_as_needed:
        return width
    return 10.0 * _ICON if text else _ICON


class _Anything:
    """Takes any attribute: the properties of a button's operator."""


def _value_text(data, prop):
    """A number as its field shows it."""
    value = getattr(data, prop.identifier)
    if prop.type == "INT":
        return str(value)
    if prop.unit == "LENGTH":
        system = bpy.context.scene.unit_settings.system
        return bpy.utils.units.to_string(system, "LENGTH", value, precision=6)
    if prop.unit == "ROTATION":
        return f"{value * 57.29578:.2f}°"
    return f"{value:.{min(prop.precision, 6)}f}"
