# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever the mouse rests on says what it is: operators, their properties, settings, preferences,
panels without a title that says it all."""

import bpy
from addon_under_test import module_name, part


def operators():
    return [
        cls
        for cls in bpy.types.Operator.__subclasses__()
        if cls.__module__.startswith(f"{module_name()}.")
    ]


def groups():
    """All groups of settings, found from where they hang."""
    found, waiting = [], [bpy.types.Object.bl_rna.properties["hull"].fixed_type]
    while waiting:
        group = waiting.pop()
        if group in found:
            continue
        found.append(group)
        for prop in group.properties:
            if prop.type in ("POINTER", "COLLECTION") and prop.identifier != "rna_type":
                if is_group(prop.fixed_type):
                    waiting.append(prop.fixed_type)
    return found


def is_group(rna):
    return rna.base is not None and rna.base.identifier == "PropertyGroup"


def own_properties(rna):
    known = {*bpy.types.Operator.bl_rna.properties.keys(), "name"}
    for prop in rna.properties:
        is_of_helper = prop.identifier in ("filepath", "check_existing", "filter_glob")
        if prop.identifier not in known and not is_of_helper:
            if not (prop.type in ("POINTER", "COLLECTION") and is_group(prop.fixed_type)):
                yield prop


def faults_of(prop, where):
    """What is wrong with the texts of a property, as sentences."""
    text = prop.description
    if not prop.name:
        yield f"{where}: no name"
    if not text:
        yield f"{where}: no description"
    elif text.strip() == prop.name.strip():
        yield f"{where}: the description only repeats the name"
    if text.endswith("."):
        yield f"{where}: Blender adds the full stop itself"
    if prop.type == "ENUM":
        for item in prop.enum_items:
            if not item.description:
                yield f"{where}, {item.identifier}: no description"


def test_operators_say_what_they_do():
    found = operators()
    assert len(found) > 20
    faults = []
    for cls in found:
        rna = getattr(bpy.ops.hull, cls.bl_idname.split(".")[1]).get_rna_type()
        text = rna.description
        if not rna.name or not text or text == rna.name:
            faults.append(f"{cls.bl_idname}: no description")
        if text.endswith("."):
            faults.append(f"{cls.bl_idname}: Blender adds the full stop itself")
        if "\n" in text or "  " in text:
            faults.append(f"{cls.bl_idname}: the text has line breaks of the source")
        for prop in own_properties(rna):
            faults += faults_of(prop, f"{cls.bl_idname}.{prop.identifier}")
    assert not faults, "\n".join(faults)


def test_settings_say_what_they_are():
    found = groups()
    assert len(found) > 8
    faults = []
    for rna in found:
        for prop in own_properties(rna):
            faults += faults_of(prop, f"{rna.identifier}.{prop.identifier}")
    assert not faults, "\n".join(faults)


def test_preferences_say_what_they_are():
    rna = type(bpy.context.preferences.addons[module_name()].preferences).bl_rna
    inherited = bpy.types.AddonPreferences.bl_rna.properties.keys()
    faults = []
    for prop in rna.properties:
        if prop.identifier not in inherited:
            faults += faults_of(prop, f"preferences.{prop.identifier}")
    assert not faults, "\n".join(faults)


def test_every_preference_has_its_property():
    rna = type(bpy.context.preferences.addons[module_name()].preferences).bl_rna
    assert set(part("bridge.blender.preferences").DEFAULTS) <= set(rna.properties.keys())
