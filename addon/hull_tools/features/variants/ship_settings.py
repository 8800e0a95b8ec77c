# SPDX-License-Identifier: GPL-3.0-or-later
"""What a variant keeps of a hull's settings: those that decide on results, from group to group."""

# Of Object.hull, and of its variants.
SHARED = (
    "half",
    "keep_centre",
    "source",
    "length_pp",
    "beam",
    "draft",
    "depth",
    "water_density",
    "trim_m",
    "heel",
    "deck_closed",
    "scheme",
    "layers",
    "flats",
    "developables",
    "lines",
    "loading",
    "weights",
    "wind",
    "resistance",
)

# Of the lines, what is the view's alone.
_OF_THE_VIEW = {
    "lines": frozenset(
        {
            "show_stations",
            "show_waterlines",
            "show_buttocks",
            "show_diagonals",
            "show_planes",
            "show_design_waterline",
            "show_flats",
            "show_features",
            "in_front",
            "width",
            "curves",
        }
    )
}


def copy_ship(source, target):
    """Gives a variant, or an Object.hull, the settings of another; what is the view's own stays."""
    _copy(source, target, SHARED)


def copy_view(source, target):
    """Gives an Object.hull what is the view's own of another one's lines, but for curves."""
    _copy(source.lines, target.lines, sorted(_OF_THE_VIEW["lines"] - {"curves"}))


def copy_named(source, target, names):
    """Gives a variant, or an Object.hull, these settings of another."""
    _copy(source, target, names)


def _copy(source, target, names):
    for name in names:
        prop = source.bl_rna.properties[name]
        value = getattr(source, name)
        if prop.type == "COLLECTION":
            entries = getattr(target, name)
            entries.clear()
            for entry in value:
                _copy(entry, entries.add(), _names_of(entry))
        elif _is_group(prop):
            left_out = _OF_THE_VIEW.get(name, frozenset())
            _copy(value, getattr(target, name), [n for n in _names_of(value) if n not in left_out])
        elif source.is_property_set(name):
            setattr(target, name, value)
        else:
            target.property_unset(name)


def _names_of(group):
    return [prop.identifier for prop in group.bl_rna.properties if prop.identifier != "rna_type"]


def _is_group(prop):
    if prop.type != "POINTER":
        return False
    base = prop.fixed_type.base
    return base is not None and base.identifier == "PropertyGroup"
