# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wanted of a hull, targets and area curve: from hull_io's HullData to Object.hull, and
back."""

from ....hull_io.wanted import DIMENSIONS, AreaPoint, AreaTarget, FreeDimension, Target, Targets
from ...bridge.blender.units import as_stored

# By the names of hull files, those in Object.hull.targets.
_STAYING = {"profile": "keep_profile", "deck_edge": "keep_deck", "greatest_beam": "keep_side"}


def give_wanted(settings, hull, scale):
    """To an Object.hull without targets; scale: metres of Blender's unit."""
    _give_targets(settings.targets, hull.targets, scale)
    if hull.area_target is not None:
        target = settings.area_target
        target.source = hull.area_target.source
        _give_points(target.base, hull.area_target.base, scale)
        _give_points(target.area_points, hull.area_target.points, scale)


def _give_targets(settings, targets, scale):
    for row in targets.rows:
        entry = settings.rows.add()
        entry.quantity, entry.sense, entry.use = row.quantity.upper(), row.sense, row.on
        if row.speed_kn:
            entry.speed_kn = row.speed_kn
        # After what gives a row its present value.
        entry.value, entry.tolerance, entry.station = row.value, row.tolerance, row.station / scale
    settings.moving = targets.moving.upper()
    for name, own in _STAYING.items():
        setattr(settings, own, name in targets.staying)
    for name in DIMENSIONS:
        dimension = getattr(targets, name)
        setattr(settings, f"free_{name}", dimension.free)
        setattr(settings, f"{name}_change", dimension.percent)
    settings.stiffness = targets.fairness


def _give_points(entries, points, scale):
    for point in points:
        entry = entries.add()
        entry.x, entry.area = point.x / scale, point.area


def take_wanted(settings, scale):
    """The values for a HullData, by name, of an Object.hull."""
    area_target = settings.area_target
    is_there = len(area_target.area_points) > 0
    return {
        "targets": _taken_targets(settings.targets, scale),
        "area_target": _taken_curve(area_target, scale) if is_there else None,
    }


def _taken_targets(settings, scale):
    return Targets(
        rows=[
            Target(
                row.quantity.lower(),
                as_stored(row.value),
                row.sense,
                as_stored(row.tolerance),
                as_stored(row.station) * scale,
                row.use,
                as_stored(row.speed_kn) if row.quantity == "WAVE_RESISTANCE" else 0.0,
            )
            for row in settings.rows
        ],
        moving=settings.moving.lower(),
        staying=tuple(name for name, own in _STAYING.items() if getattr(settings, own)),
        fairness=as_stored(settings.stiffness),
        **{name: _taken_dimension(settings, name) for name in DIMENSIONS},
    )


def _taken_dimension(settings, name):
    change = as_stored(getattr(settings, f"{name}_change"))
    return FreeDimension(getattr(settings, f"free_{name}"), change)


def _taken_curve(settings, scale):
    return AreaTarget(
        _taken_points(settings.base, scale),
        _taken_points(settings.area_points, scale),
        settings.source,
    )


def _taken_points(entries, scale):
    return [AreaPoint(as_stored(entry.x) * scale, as_stored(entry.area)) for entry in entries]
