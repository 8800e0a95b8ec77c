# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings below Object.hull, given values by chance, at their limits too."""

import bpy

from . import operators

COLOURS = ("NONE", "NONE", "GAUSSIAN", "SLOPE")
# What is left out, by reason.
_OF_THE_ADD_ON = {"format", "is_hull", "surface_object", "curves", "mesh"}
_TAKES_LONG = {"samples", "divisions"}  # at their limits: test_limits.py
_HAS_NO_RESULT_HERE = {"studio", "export", "fit", "plan", "source"}
_LEFT_OUT = _OF_THE_ADD_ON | _TAKES_LONG | _HAS_NO_RESULT_HERE
_TEXTS = ("", "1", "0 1 2", "0:3:0.5", "3:0:-1", "1/45 2/30", "1e30", "-1", "nobody knows", "½")
_AT_A_LIMIT = 0.1
_FAR = 1e30


def change(hull, random):
    """Gives one setting another value; returns which."""
    if random.random() < 0.5:
        return _change_what_is_seen(hull, random)
    group, prop = _any(hull.hull, random)
    if prop is None:
        return None
    value = _value(prop, random)
    if value is None:
        return None
    try:
        setattr(group, prop.identifier, value[0])
    except (TypeError, ValueError) as error:
        return f"{prop.identifier} refused: {error}"
    # Of settings that no panel shows, as planes of flats, Blender tells nobody what a script does.
    hull.update_tag(refresh={"DATA"})
    return f"{hull.name} {group.path_from_id()}.{prop.identifier} {value[0]}"


def _change_what_is_seen(hull, random):
    """One of those on which surface, lines and numbers depend."""
    settings, chance = hull.hull, random.random() < 0.5
    name = random.choice(
        ("half", "deck_closed", "samples", "draft", "colours", "lines", "keep_centre", "scheme")
    )
    if name == "samples":
        settings.samples = random.choice((1, 2, 3, 4))
    elif name == "draft":
        settings.draft = random.uniform(0.1, 3.0)
    elif name == "colours":
        settings.fairness.colours = random.choice(COLOURS)
    elif name == "lines":
        settings.lines.show_buttocks = chance
    elif name == "scheme":
        items = type(settings).bl_rna.properties["scheme"].enum_items
        settings.scheme = random.choice([item.identifier for item in items])
    else:
        setattr(settings, name, chance)
    return f"{hull.name} {name}"


def _any(group, random):
    """(group, property) of one below a group; the property is None where the way ended at an
    empty list."""
    while True:
        prop = random.choice([each for each in group.bl_rna.properties if _is_setting(each)])
        if prop.type == "COLLECTION":
            entries = getattr(group, prop.identifier)
            if not len(entries):
                return group, None
            group = random.choice(entries)
        elif _is_group(prop):
            group = getattr(group, prop.identifier)
        else:
            return group, prop


def _is_group(prop):
    return prop.type == "POINTER" and not issubclass(
        getattr(bpy.types, prop.fixed_type.identifier, bpy.types.PropertyGroup), bpy.types.ID
    )


def _is_setting(prop):
    is_left_out = prop.identifier in _LEFT_OUT or prop.identifier == "rna_type"
    return not (is_left_out or prop.is_hidden or prop.is_readonly and prop.type != "COLLECTION"
                and not _is_group(prop))  # fmt: skip


def _value(prop, random):
    """(value,), or None where there is none."""
    if prop.type == "POINTER":
        found = _blocks(prop.fixed_type.identifier)
        return (random.choice([None, *found]),)
    if random.random() < _AT_A_LIMIT:
        value = limit_of(prop, random)
    else:
        value = operators.value_by_chance(prop, random)
    if value is None and prop.type == "STRING":
        value = random.choice(_TEXTS)
    return None if value is None else (value,)


def _blocks(kind):
    return {
        "Object": bpy.context.view_layer.objects,
        "Material": bpy.data.materials,
    }.get(kind, ())


def limit_of(prop, random):
    """A value at a property's limit, or a name of what is there or is not; None of others."""
    if prop.type == "STRING":
        return random.choice([*_TEXTS, *bpy.context.view_layer.objects.keys()])
    if prop.type not in ("INT", "FLOAT"):
        return None
    value = random.choice((prop.hard_min, prop.hard_max))
    value = value if prop.type == "INT" else min(max(value, -_FAR), _FAR)
    return [value] * prop.array_length if getattr(prop, "is_array", False) else value
