# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of files made by older versions of the add-on.

Object.hull.format says by which of the formats below its settings are stored; hulls of before there
was a stamp have 0. A hull that is not of the present format is brought to it when its file is
opened, or when it is appended or pasted from one.

Formats: 0: which lines are drawn is kept with the hull, and more of it with the lines plan; lines
are an object. 1: all of it is in Object.hull.lines, lines are drawn over the view. 2: it is kept
whether the VCG is a guess. 3: the points of downflooding are called so. 4: layers have names of
their own, which were those of their materials. 5: a trim is called trim_m.
"""

import re

FORMAT = 5

_GUESSED_KG = 0.6  # of the depth: what a hull without VCG was given

_NUMBER, _LONGEST = re.compile(r"\.\d{3,}$"), 60  # of Blender's names, bytes

_MOVED_FROM_HULL = ("station_count", "waterline_spacing", "buttock_spacing")
_MOVED_FROM_PLAN = (
    "stations",
    "stations_in",
    "waterlines",
    "buttocks",
    "diagonals",
    "frame_spacing",
)


def bring_up_to_date(obj):
    """Gives a hull's settings the present format; returns whether anything was done."""
    settings = obj.hull
    if settings.format >= FORMAT:
        return False
    for step in _STEPS[settings.format :]:
        step(settings)
    settings.format = FORMAT
    return True


def newer(obj):
    """What to say of a hull whose file is of a newer version of the add-on; "" for others."""
    if obj.hull.format <= FORMAT:
        return ""
    return (
        f"Made by a newer version of Hull Tools (format {obj.hull.format}, this one knows "
        f"{FORMAT}): update the add-on to see all of it"
    )


def _gather_lines(settings):
    for old, names in ((settings, _MOVED_FROM_HULL), (settings.plan, _MOVED_FROM_PLAN)):
        for name in names:
            value = _taken(old, name)
            if value is not None and name not in settings.lines.keys():
                settings.lines[name] = value
    shown = _taken(settings, "lines_object")
    if shown is not None and shown.parent == settings.id_data:
        for collection in list(shown.users_collection):
            collection.objects.unlink(shown)


def _know_the_guess(settings):
    guess = _GUESSED_KG * settings.depth
    settings.loading.kg_is_guess = guess > 0.0 and abs(settings.loading.kg / guess - 1.0) < 1e-6


def _name_downflooding_points(settings):
    for group in (settings, *settings.variants.kept):
        loading = group.loading
        # What is taken away is freed: it is read before.
        for old in loading.get("flooding_points", ()):
            point = loading.downflooding_points.add()
            point.name = old.get("name", "")
            point.position = old.get("position", (0.0, 0.0, 0.0))
        _taken(loading, "flooding_points")
        active = _taken(loading, "active_flooding_point")
        if active is not None:
            loading.active_downflooding_point = active


def _name_trim_by_its_unit(settings):
    for group in (settings, *settings.variants.kept, *settings.morph.parents):
        value = _taken(group, "trim")
        if value is not None and "trim_m" not in group.keys():
            group["trim_m"] = value
    _move_animation(settings.id_data, "hull.trim", "hull.trim_m")


def _move_animation(obj, old, new):
    """Keyframes and drivers of a setting that has another name, and drivers of the object's that
    read it, go on."""
    animation = obj.animation_data
    if animation is None:
        return
    actions = [strip.action for track in animation.nla_tracks for strip in track.strips]
    for action in filter(None, {animation.action, *actions}):
        # A linked action is another file's.
        _move_curves(() if action.library else action.fcurves, old, new)
    _move_curves(animation.drivers, old, new)
    for curve in animation.drivers:
        for variable in curve.driver.variables:
            for target in variable.targets:
                if target.id == obj and target.data_path == old:
                    target.data_path = new


def _move_curves(curves, old, new):
    for curve in curves:
        if curve.data_path == old:
            curve.data_path = new


def _name_layers(settings):
    for ship in (settings, *settings.variants.kept):
        for layer in ship.layers:
            if layer.material is not None and layer.material.name != layer.name:
                _name_as_material(layer)


def _name_as_material(layer):
    """Gives a layer the name that its material was given since, without the number by which
    Blender tells it from others, and without what that cut off."""
    name = _NUMBER.sub("", layer.material.name)
    is_cut = len(layer.material.name.encode()) >= _LONGEST
    if not (is_cut and layer.name.startswith(name)):
        layer["name"] = name


def _taken(group, name):
    """A stored value that no property stands for any longer, which is removed; None for none."""
    value = group.get(name)
    if value is not None:
        del group[name]
    return value


# From each format to the next.
_STEPS = (
    _gather_lines,
    _know_the_guess,
    _name_downflooding_points,
    _name_layers,
    _name_trim_by_its_unit,
)
