# SPDX-License-Identifier: GPL-3.0-or-later
"""In an imperial scene every field that stays metric says beside itself what it is in feet or their
like: all settings, dialogs and preferences are walked, what is drawn is read, and its numbers are
turned over by a list of the test's own. In a metric scene nothing is said.
"""

import re

import bpy
import networks
import pytest
from addon_under_test import module_name, sample
from test_panels import Notebook, context, texts
from test_zero_meanings import panels, registered, rna_of

FOOT = 0.3048
# By a plain list, so that a slip in the add-on's shows.
SIZES = {
    "m": (FOOT, "ft"), "m²": (FOOT**2, "ft²"), "m³": (FOOT**3, "ft³"),
    "t": (1.0160469088, "LT"), "t/m³": (0.45359237 / FOOT**3 / 1e3, "lb/ft³"),
    "kN": (0.0044482216152605, "lbf"), "mm": (25.4, "in"), "µm": (25.4, "mil"),
    "Pa": (4.4482216152605 / FOOT**2, "lb/ft²"), "°/m": (1.0 / FOOT, "°/ft"),
    "1/m": (1.0 / FOOT, "1/ft"), "1/m²": (1.0 / FOOT**2, "1/ft²"),
}  # fmt: skip
_WORDS = {"Metres": "m", "metres": "m", "tonnes": "t", "m/°": "m"}
_SYMBOLS = "|".join(sorted((*SIZES, *_WORDS), key=len, reverse=True))
# At the end of a name, and where a description says what the number is in.
_NAMED = re.compile(rf"(?:^|[ (])({_SYMBOLS})\)?$")
_DESCRIBED = re.compile(rf"\b[Ii]n ({_SYMBOLS})(?![\w/²³])")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")

# As people type them, and in feet.
_LISTS = {"HullLines.diagonals": ("1.524/35 3.048/50", "5/35 10/50"),
          "": ("0:9.144:1.524", "0:30:5")}  # fmt: skip

EXCEPTIONS = {
    "HullVariant.water_density": "kept with a variant, and drawn nowhere",
    "HULL_OT_network_from_hull.stations": "blank takes the list of Sections, which tells feet",
    "HULL_OT_network_from_hull.waterlines": "blank takes the list of Sections, which tells feet",
    "HULL_OT_network_from_hull.buttocks": "blank takes the list of Sections, which tells feet",
    "HULL_OT_drag_area_curve.points": "what was dragged, for scripts; the header tells areas",
}


def unit_of(prop, label=None):
    """The metric symbol that a property's name or description has, or the label that is drawn;
    None for what Blender itself shows in the scene's units, and for what has none."""
    if prop.type not in ("FLOAT", "STRING") or getattr(prop, "unit", "NONE") != "NONE":
        return None
    for pattern, text in (
        (_NAMED, label or ""),
        (_NAMED, prop.name),
        (_DESCRIBED, prop.description),
    ):
        found = pattern.search(text)
        if found:
            return _WORDS.get(found[1], found[1])
    return None


class Reading(Notebook):
    """Notes (key, metric symbol, value) of each metric field, and texts."""

    def _part(self, *unused, **more_unused):
        return Reading(self.noted)

    row = column = split = box = grid_flow = _part

    def prop(self, data, name, text=None, **unused):
        prop = data.rna_type.properties[name]
        key = f"{data.rna_type.identifier}.{name}"
        symbol = unit_of(prop, text)
        if symbol and key not in EXCEPTIONS:
            self.noted.append((key, symbol, getattr(data, name)))


class Dialog:
    """What stands for an operator has of it: properties as at first."""

    def __getattr__(self, name):
        found = self.rna_type.properties.get(name)
        if found is None:
            raise AttributeError(name)
        return getattr(found, "default", None)


def dialog(cls, **given):
    """Stands for an operator or for preferences, with properties that are given."""
    bases = (base for base in cls.__bases__ if not issubclass(base, bpy.types.bpy_struct))
    own = {name: each for name, each in vars(cls).items() if not name.startswith(("__", "bl_rna"))}
    made = type(cls.__name__, (Dialog, *bases), own)()
    made.__dict__.update(rna_type=rna_of(cls), layout=Reading(), **given)
    return made


def is_said(symbol, value, texts):
    """Whether texts beside a field have its number in feet or their like, and the unit."""
    if isinstance(value, str):
        return any(_listed(value) in text and "ft" in text for text in texts)
    size, imperial = SIZES[symbol]
    numbers = [float(number) for text in texts for number in NUMBER.findall(text)]
    is_there = any(number == pytest.approx(value / size, rel=6e-4, abs=6e-4) for number in numbers)
    return is_there and any(re.search(rf"(?:^|[\s]){imperial}(?:$|[\s/])", text) for text in texts)


def _listed(text):
    return next(feet for metric, feet in _LISTS.values() if metric == text)


def faults(noted):
    """Of one drawing: the metric fields beside which nothing is said. What is said stands below
    the field, or below the last of some."""
    for place, one in enumerate(noted):
        if isinstance(one, tuple):
            texts = [text for text in noted[place + 1 : place + 9] if isinstance(text, str)]
            if not is_said(*one[1:], texts):
                yield f"{one[0]}, {one[2]} {one[1]}: {texts}"


def metric_properties(*bases):
    return {
        f"{rna_of(cls).identifier}.{prop.identifier}"
        for base in bases
        for cls in registered(base)
        for prop in rna_of(cls).properties
        if unit_of(prop) and not prop.is_hidden
    }


def number_for(prop, place):
    """One that no other field has, within a property's bounds."""
    low, high = max(prop.hard_min, 0.0), prop.hard_max
    wanted = (prop.default or 1.0) * (1.0 + 0.017 * (place % 40 + 1))
    return wanted if low <= wanted <= high else 0.5 * (low + min(high, 1e3))


def fill(settings):
    """Numbers for all metric fields of a property group, and of the groups in it."""
    for place, prop in enumerate(settings.bl_rna.properties):
        key = f"{settings.bl_rna.identifier}.{prop.identifier}"
        if unit_of(prop) and key not in EXCEPTIONS:
            text = _LISTS.get(key, _LISTS[""])[0]
            value = text if prop.type == "STRING" else number_for(prop, place)
            setattr(settings, prop.identifier, value)
        elif prop.identifier != "rna_type" and prop.type in ("POINTER", "COLLECTION"):
            value = getattr(settings, prop.identifier)
            for group in value if prop.type == "COLLECTION" else [value]:
                if isinstance(group, bpy.types.PropertyGroup):
                    fill(group)


def ship():
    """Of which there is one of everything that has fields."""
    hull = sample("coaster")
    own = hull.hull
    for _ in range(2):
        own.layers.add().material = bpy.data.materials.new("layer")
        hull.data.materials.append(own.layers[-1].material)
    for name in ("weight", "load_case", "wind_area", "target"):
        assert getattr(bpy.ops.hull, f"add_{name}")() == {"FINISHED"}
    bpy.ops.hull.suggest_seams()
    bpy.ops.hull.change_plate_list(action="ADD_RANGE")
    bpy.ops.hull.take_area_curve()
    own.wind.source, own.plan.paper, own.model.in_segments = "GIVEN", "OWN", True
    own.loading.use_displacement = False
    fill(own)
    return hull


def drawings():
    """Of all panels, with hulls and networks so that all fields are there."""
    own = ship().hull
    bpy.context.view_layer.update()
    for method in ("HOLTROP", "SAVITSKY", "DELFT", "MICHELL"):
        own.resistance.method = method
        yield from panels(Reading)
    own.model.in_segments = False
    yield from panels(Reading)
    yield from panels(Reading, "HULL_OT_export_step")
    network = networks.grid_network()
    fill(network.hull_network)
    yield from panels(Reading)


@pytest.fixture
def imperial():
    bpy.context.scene.unit_settings.system = "IMPERIAL"


def test_the_check_itself():
    noted = [("HullWind.keel_area", "m²", 2.0)]
    assert len(list(faults([*noted, "Keels"]))) == 1
    assert len(list(faults([*noted, "= 21.528"]))) == 1
    assert len(list(faults([*noted, "= 2.000 ft²"]))) == 1
    assert len(list(faults([*noted, "= 21.528 ft"]))) == 1
    assert not list(faults([*noted, "= 21.528 ft²"]))


def test_panels(imperial):
    wanted = metric_properties(bpy.types.PropertyGroup) - set(EXCEPTIONS)
    assert {"HullWind.keel_area", "HullLines.waterlines", "HullTarget.value"} <= wanted
    found = []
    for noted in drawings():
        found += faults(noted)
        wanted -= {one[0] for one in noted if isinstance(one, tuple)}
    assert not found, "\n".join(found)
    assert not wanted, f"not drawn: {sorted(wanted)}"


def test_dialogs(imperial):
    sample("coaster")
    checked = 0
    for cls in registered(bpy.types.Operator):
        rna = rna_of(cls)
        metric = [
            prop for prop in rna.properties
            if unit_of(prop) and f"{rna.identifier}.{prop.identifier}" not in EXCEPTIONS
        ]  # fmt: skip
        if not metric:
            continue
        assert hasattr(cls, "draw"), f"{cls.__name__}: Blender's own dialog says nothing"
        given = {prop.identifier: number_for(prop, place) for place, prop in enumerate(metric)}
        left = set(given)
        for choice in choices(rna):
            drawn = dialog(cls, **given, **choice)
            drawn.draw(context())
            found = list(faults(drawn.layout.noted))
            assert not found, "\n".join(found)
            left -= {one[0].split(".")[1] for one in drawn.layout.noted if isinstance(one, tuple)}
        assert not left, f"{cls.__name__}: not drawn: {left}"
        checked += 1
    assert checked >= 15


def choices(rna):
    """Settings with which dialogs show other fields."""
    yield {"in_segments": True}
    for name in ("measure", "format", "area_as"):
        prop = rna.properties.get(name)
        for item in prop.enum_items if prop else ():
            yield {name: item.identifier}


def test_preferences(imperial):
    cls = type(bpy.context.preferences.addons[module_name()].preferences)
    assert metric_properties(bpy.types.AddonPreferences) == {"HullToolsPreferences.water_density"}
    drawn = dialog(cls, page="HULLS", water_density=1.01)
    drawn.draw(context())
    assert [one[0] for one in drawn.layout.noted if isinstance(one, tuple)]
    assert not list(faults(drawn.layout.noted))


def test_all_exceptions_are_needed():
    groups = (bpy.types.PropertyGroup, bpy.types.Operator, bpy.types.AddonPreferences)
    assert set(EXCEPTIONS) <= metric_properties(*groups)


def test_nothing_of_it_in_a_metric_scene():
    ship()
    for noted in drawings_of_texts():
        assert not [text for text in noted if text.startswith("= ")]


def drawings_of_texts():
    own = bpy.context.object.hull
    for method in ("HOLTROP", "SAVITSKY", "DELFT", "MICHELL"):
        own.resistance.method = method
        yield from texts().values()
