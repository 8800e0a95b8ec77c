# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of programs that know hulls by control meshes or by sections alone: FREE!ship, GHS,
Archimedes, Michlet, and text. They are of the hull as it is now, upright and without trim."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from ....hull_io import HullFileError, section_files, write_freeship
from ....hull_io.bytes_on_disk import write_bytes
from ...bridge import native
from ...bridge.blender import units
from ..flotation import afloat, hydrostatics
from ..hull import hull_state, hull_to_data
from ..lines import line_places
from ..lines.lines import size_of
from ..resistance import asked

# Of the hull's size: chords of sections.
_CHORDS = 1e-5
# Of the hull's size: sides that are no farther apart are one another's mirror images; and squares
# along a cell at whose corners it is looked.
_SAME_SIDES, _LOOKED_AT = 2e-4, 2
_MICHLET_STATIONS, _MICHLET_WATERLINES, _MICHLET_SPEEDS = 81, 41, 50


def unit_of(scene):
    """The unit of length, "m" or "ft", of files that know both, as the scene has it."""
    return "ft" if units.is_imperial(scene) else "m"


def export_freeship(obj, scene, path):
    """Writes the hull as a FREE!ship file; returns sentences about what it does not hold."""
    return write_freeship(hull_to_data.hull_data(obj, scene), path, unit_of(scene))


def export_sections(obj, scene, path):
    """Writes the stations of Object.hull.lines, or for Michlet half-breadths below the water; the
    file's ending says for which program. ValueError and HullFileError with the reason."""
    path = Path(path)
    ending = path.suffix.lower()
    if ending not in _TEXTS:
        raise ValueError(
            f'"{path.name}" does not say for which program it is: give it a name that ends in '
            + ", ".join(_TEXTS)
        )
    state = hull_state.up_to_date(obj, scene)
    _refuse_one_sided(state.ship.body, path.name)
    scale = units.metres_per_unit(scene)
    write = _TEXTS[ending]
    encoding = "utf-8" if ending == ".hll" else "ascii"
    write_bytes(path, write(obj, scene, state, scale).encode(encoding))


def _refuse_one_sided(body, file_name):
    """The files have one side, which stands for both."""
    if body.mirrored:
        return
    tree = native.require().SurfaceTree(body.surface)
    images = body.surface.tessellate(_LOOKED_AT).points * (1.0, -1.0, 1.0)
    if tree.closest_points(images).distances.max() > _SAME_SIDES * size_of(body.surface):
        raise HullFileError(
            f"{file_name}: the hull's two sides differ, and this file knows one that stands for "
            "both; mirror one of them first."
        )


def _ship(obj, state, scale, lines):
    settings = obj.hull
    length, beam, draft = (
        units.as_typed(getattr(settings, name)) * scale for name in ("length_pp", "beam", "draft")
    )
    density = units.as_typed(settings.water_density)
    return section_files.Stations(obj.name, tuple(lines), length, beam, draft, density)


def _cut(obj, state, scale):
    """A function of a tolerance in m that gives the StationLine of all stations, and the usual
    tolerance."""
    surface = state.ship.surface
    stations, _, _ = line_places.line_places(obj.hull, scale).positions(surface.mesh.points)
    if not stations:
        raise ValueError("There are no stations: give Lpp and their number, or a list of them")
    planes = np.array([(1.0, 0.0, 0.0, x) for x in stations])
    size = size_of(surface)

    def cut(tolerance):
        found = native.require().sections(surface, planes, tolerance)
        return section_files.station_lines(stations, found, size)

    return cut, _CHORDS * size


def _ghs(obj, scene, state, scale):
    lines, _ = section_files.lines_for_ghs(*_cut(obj, state, scale))
    return section_files.ghs_text(_ship(obj, state, scale, lines), unit_of(scene))


def _archimedes(obj, scene, state, scale):
    cut, tolerance = _cut(obj, state, scale)
    return section_files.archimedes_text(_ship(obj, state, scale, cut(tolerance)))


def _section_text(obj, scene, state, scale):
    cut, tolerance = _cut(obj, state, scale)
    return section_files.section_text(_ship(obj, state, scale, cut(tolerance)))


def _michlet(obj, scene, state, scale):
    body = state.ship.body
    where = replace(afloat.afloat(obj.hull, scale), trim_m=0.0, heel=0.0)
    found = hydrostatics.computed(body, where)
    keel = where.draft - found.immersed_draft
    table = native.require().offset_table(
        body.surface,
        stations=np.linspace(found.waterline_aft, found.waterline_forward, _MICHLET_STATIONS),
        waterlines=np.linspace(keel, where.draft, _MICHLET_WATERLINES),
        buttocks=(),
        mirrored=body.mirrored,
    )
    return section_files.michlet_text(
        obj.name,
        np.nan_to_num(table.half_breadths),
        length=found.waterline_length,
        draft=found.immersed_draft,
        volume=found.displaced_volume,
        speeds=_michlet_speeds(obj, scale),
        water_density=where.water_density,
        viscosity=native.require().water_viscosity(where.water_density),
    )


def _michlet_speeds(obj, scale):
    """Those of the resistance, fifty at most."""
    speeds = asked.own_inputs(obj.hull, scale).speeds
    if len(speeds) < 2:
        raise ValueError("Michlet takes two speeds or more: set them in Resistance")
    count = min(len(speeds), _MICHLET_SPEEDS)
    return section_files.MichletSpeeds(speeds[0], speeds[-1], count)


_TEXTS = {".gf": _ghs, ".hll": _archimedes, ".mlt": _michlet, ".txt": _section_text}
