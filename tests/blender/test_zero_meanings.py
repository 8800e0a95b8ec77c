# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a number's zero stands for another number, what draws the number says for which.

Descriptions end in "0: …" there. All settings and operators are walked; what is drawn is read.
"""

import re

import bpy
import networks
from addon_under_test import add_hull, make_active, part
from test_panels import Drawn, Notebook, context

_ZERO = re.compile(r"(?:^|[;.] )0: (.+)$")

# What a zero may say that is the number it stands for: nothing, or no deviation.
PLAIN = {
    "exact",
    "it is not counted",
    "it is solid",
    "no stations",
    "none",
    "not reckoned",
    "nothing",
    "nothing of that is told",
    "the ship has none",
}

_BELOW = "below all fields of the panel: 0: what the hull has"
_FOUR = "below the dialog's four numbers: 0: as it is, or in proportion"
EXCEPTIONS = {
    "HullExport.seam_angle": "the angle itself is shown below, As tolerance",
    "HullResistance.deadrise": _BELOW,
    "HullResistance.chine_beam": _BELOW,
    "HULL_OT_set_dimensions.length": _FOUR,
    "HULL_OT_set_dimensions.beam": _FOUR,
    "HULL_OT_set_dimensions.draft": _FOUR,
    "HULL_OT_set_dimensions.depth": _FOUR,
}


class Reading(Notebook):
    """Notes (group, property) of each field, and texts."""

    def _part(self, *unused, **more_unused):
        return Reading(self.noted)

    row = column = split = box = grid_flow = _part

    def prop(self, data, name, **unused):
        assert name in data.bl_rna.properties
        self.noted.append((data.bl_rna.identifier, name))


class OperatorDrawn(Drawn):
    """Stands for an operator whose properties are as at first."""

    def __init__(self, cls):
        super().__init__(cls)
        self.bl_rna = self.rna_type = rna_of(cls)
        self.layout = Reading()

    def __getattr__(self, name):
        found = self.bl_rna.properties.get(name)
        return super().__getattr__(name) if found is None else getattr(found, "default", None)


def registered(base):
    """Registered classes of the add-on."""
    name = part("panels").__name__.rpartition(".")[0]
    waiting, found = list(base.__subclasses__()), []
    while waiting:
        cls = waiting.pop()
        waiting += cls.__subclasses__()
        if cls.__module__.startswith(name) and cls.is_registered:
            found.append(cls)
    return found


def rna_of(cls):
    if issubclass(cls, bpy.types.Operator):
        group, name = cls.bl_idname.split(".")
        return getattr(getattr(bpy.ops, group), name).get_rna_type()
    return cls.bl_rna


def with_a_zero(base):
    """{"class.property": what its zero stands for}"""
    found = {}
    for cls in registered(base):
        for prop in rna_of(cls).properties:
            match = _ZERO.search(prop.description)
            if match and not prop.is_hidden:
                found[f"{rna_of(cls).identifier}.{prop.identifier}"] = match.group(1)
    return found


def asked(*bases):
    found = {}
    for base in bases:
        found.update(with_a_zero(base))
    return {
        key: meaning
        for key, meaning in found.items()
        if meaning not in PLAIN and key not in EXCEPTIONS
    }


def is_told(noted, place, meaning):
    """Whether a field that is noted at a place has its zero's meaning below, or its panel has."""
    after = [one for one in noted[place + 1 :] if isinstance(one, str)]
    below = noted[place + 1] if place + 1 < len(noted) else ""
    return below in after and below.startswith("0: ") or f"0: {meaning}" in after


def check(wanted, drawings):
    """That each is drawn, and told wherever it is."""
    left = set(wanted)
    for noted in drawings:
        for place, one in enumerate(noted):
            key = ".".join(one) if isinstance(one, tuple) else ""
            if key in wanted:
                assert is_told(noted, place, wanted[key]), f"{key}: {wanted[key]}"
                left.discard(key)
    assert not left, f"not drawn: {sorted(left)}"


def make_zero(settings, wanted):
    """Zero for all numbers of a property group, and of the groups in it, that are wanted."""
    for prop in settings.bl_rna.properties:
        key = f"{settings.bl_rna.identifier}.{prop.identifier}"
        if key in wanted:
            setattr(settings, prop.identifier, 0)
        elif prop.identifier != "rna_type" and prop.type in ("POINTER", "COLLECTION"):
            value = getattr(settings, prop.identifier)
            groups = value if prop.type == "COLLECTION" else [value]
            for group in groups:
                if isinstance(group, bpy.types.PropertyGroup):
                    make_zero(group, wanted)


def panels(reading=Reading, dialog_of=None):
    """What each panel that is there draws, as noted by a class of layouts; dialog_of: as
    test_panels.context() takes it."""
    now = context(dialog_of)
    for cls in part("panels")._CLASSES:
        if issubclass(cls, bpy.types.Panel) and (not hasattr(cls, "poll") or cls.poll(now)):
            drawn = Drawn(cls)
            drawn.layout = reading()
            drawn.draw(now)
            yield drawn.layout.noted


def drawings(wanted):
    """Of all panels, with hulls, appendages and networks so that all fields are there."""
    hull = add_hull()
    own = hull.hull
    for _ in range(2):
        own.layers.add().material = bpy.data.materials.new("layer")
        hull.data.materials.append(own.layers[-1].material)
    own.wind.source, own.fairness.colours, own.transform.kept_aft = "GIVEN", "GAUSSIAN", 1.0
    make_zero(own, wanted)
    bpy.context.view_layer.update()
    for method in ("HOLTROP", "SAVITSKY", "DELFT", "MICHELL"):
        own.resistance.method = method
        yield from panels()
    for kind in ("RUDDER", "SHAFT"):
        make_active(hull)
        assert bpy.ops.hull.add_appendage(kind=kind) == {"FINISHED"}
        make_zero(bpy.context.object.hull, wanted)
        yield from panels()
    make_zero(networks.grid_network().hull_network, wanted)
    yield from panels()


def test_panels_say_what_a_zero_means():
    wanted = asked(bpy.types.PropertyGroup)
    assert {"HullWind.roll_period", "HullLayer.thickness", "HullPlan.scale"} <= set(wanted)
    check(wanted, drawings(wanted))


def test_dialogs_say_what_a_zero_means():
    wanted, noted = asked(bpy.types.Operator), []
    assert {"HULL_OT_tie_curves.reach", "HULL_OT_hull_from_mesh.draft"} <= set(wanted)
    for cls in registered(bpy.types.Operator):
        if any(key.startswith(f"{cls.__name__}.") for key in wanted):
            assert hasattr(cls, "draw"), f"{cls.__name__}: Blender's own dialog says nothing"
            drawn = OperatorDrawn(cls)
            drawn.draw(context())
            noted.append(drawn.layout.noted)
    check(wanted, noted)


def test_all_exceptions_are_needed():
    found = {}
    for base in (bpy.types.PropertyGroup, bpy.types.Operator, bpy.types.AddonPreferences):
        found.update(with_a_zero(base))
    assert set(EXCEPTIONS) <= set(found) and PLAIN <= set(found.values())
    assert not asked(bpy.types.AddonPreferences)
