# SPDX-License-Identifier: GPL-3.0-or-later
"""Files made from a hull as it is now: STEP, lines plan, table of hydrostatics."""

from . import hull_state, hydrostatics, lines, native, units

_TABLE_ROWS = 10


def _up_to_date(obj, scene):
    """The hull's surface; ValueError with the reason when the mesh has none as it is."""
    state = hull_state.refresh(obj, scene)
    if state.status:
        raise ValueError(state.status)
    return state.surface


def export_step(obj, scene, path, progress=lambda part: None):
    """Writes the hull as one shell; returns the PatchSet with its report of the distance.

    `progress` is called with the part done, 0 to 1.
    """
    hull_native = native.require()
    progress(0.0)
    surface = _up_to_date(obj, scene)
    progress(0.1)
    patches = hull_native.fit_per_cell(surface)
    progress(0.5)
    hull_native.write_step(patches, path, name=obj.name, mirrored=obj.hull.half)
    progress(1.0)
    return patches


def export_lines_drawing(obj, scene, path):
    """Draws body plan, profile and half-breadth plan; SVG, PDF or PNG by the name's ending."""
    surface = _up_to_date(obj, scene)
    scale = units.metres_per_unit(scene)
    where = lines.planes(obj.hull, surface.mesh.points, scale)
    native.require().write_lines_drawing(
        surface,
        path,
        stations=where.stations,
        waterlines=where.waterlines,
        buttocks=where.buttocks,
        mirrored=obj.hull.half,
        draft=units.as_typed(obj.hull.draft) * scale or None,
        title=obj.name,
    )


def export_hydrostatics(obj, scene, path):
    """Writes hydrostatics at ten equal steps of draft up to the hull's draft as CSV."""
    surface = _up_to_date(obj, scene)
    draft = units.as_typed(obj.hull.draft) * units.metres_per_unit(scene)
    water_density = units.as_typed(obj.hull.water_density)
    rows = []
    for step in range(1, _TABLE_ROWS + 1):
        at = draft * step / _TABLE_ROWS
        try:
            rows.append(hydrostatics.upright(surface, at, obj.hull.half, water_density))
        except ValueError:
            if step == _TABLE_ROWS:
                raise
    hydrostatics.write_table(path, rows)
