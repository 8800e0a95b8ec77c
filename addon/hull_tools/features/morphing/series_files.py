# SPDX-License-Identifier: GPL-3.0-or-later
"""Series of members written: tables of their numbers, and a file of each. What is cancelled, or
goes wrong, leaves all files as they were."""

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np

from ....hull_io import write_hull_file
from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions, patches
from ..curves_of_form import hydrostatic_table, sectional_areas
from ..exchange import cad_files, table_units
from ..flotation import hydrostatics
from ..flotation.ship import Ship
from ..hull import hull_state, hull_to_data
from . import series

HULL = "HULL"
_ENDINGS = {HULL: ".hull.json", cad_files.STEP: ".step", cad_files.IGES: ".igs"}
_SHARE_OF_CONVERSION = 0.6  # of the time that a CAD file takes


class SeriesTables(jobs.JobTask):
    """The task of writing the numbers of a series as CSV, one row a member, and beside it their
    sectional areas, one row a station. A member that has no numbers has the reason in its row.
    result(): the paths that are written."""

    text = "Table of the series"

    def __init__(self, obj, scene, path, **asked):
        found = series.of_hull(obj, scene, **asked)
        self.state = hull_state.state_of(obj)
        conversions.clear_way(obj)
        is_imperial = units.is_imperial(scene)
        self._job = jobs.Job(
            lambda progress: _write_tables(found, Path(path), progress, is_imperial)
        )
        conversions.watch(self)


def areas_path(path):
    """Of the table of sectional areas that goes with the table of this path."""
    return path.with_name(f"{path.stem}-areas{path.suffix}")


def _write_tables(found, path, progress, is_imperial):
    rows, areas = [], []
    for number, step in enumerate(found.steps):
        progress(number / len(found.steps))
        row, own = _numbers(found, step)
        rows.append(row)
        areas += own
    targets = [path, areas_path(path)]
    with native.require().FolderBeside(targets) as aside:
        made = [aside / target.name for target in targets]
        table_units.write_shown(made[0], _header(found), rows, is_imperial)
        table_units.write_shown(made[1], ["t", "x from AP [m]", "area [m2]"], areas, is_imperial)
        aside.hand_over(made)
    return targets


def _header(found):
    weights = [f"weight of {name}" for name in found.parents]
    particulars = ["Lpp [m]", "beam [m]", "depth [m]", "KG [m]"]
    return ["t", *weights, *particulars, *hydrostatic_table.header(None), "remark"]


def _numbers(found, step):
    """(row of a member, rows of its sectional areas)."""
    begin = [step.t, *step.weights, *(step.particulars[name]
             for name in ("length_pp", "beam", "depth", "kg"))]  # fmt: skip
    try:
        source = found.member(step)
        own = Ship(source.new_body(source.new_surface()), ())
        values = hydrostatics.at(own, step.where)
    except ValueError as error:
        empty = [None] * len(hydrostatic_table.header(None))
        return [*begin, *empty, str(error)], []
    row = next(iter(hydrostatic_table.rows(SimpleNamespace(hydrostatics=[values]))))
    areas = sectional_areas.compute(own, step.where).areas
    stations = [[step.t, x, area] for x, area in zip(areas.positions, areas.areas)]
    return [*begin, *row, values.remark], stations


class SeriesFiles(jobs.JobTask):
    """The task of writing each member of a series to a file in a folder. ValueError where a member
    is folded: no file is written then. result(): the paths that are written."""

    text = "Writing the series"

    def __init__(self, obj, scene, folder, file_format, **asked):
        if not Path(folder).is_dir():
            raise ValueError(f'There is no folder "{folder}": choose one')
        found = series.of_hull(obj, scene, **asked)
        self.state = hull_state.state_of(obj)
        conversions.clear_way(obj)
        scale = units.metres_per_unit(scene)
        if file_format == HULL:
            data = hull_to_data.hull_data(obj, scene)
            write = _HullWriter(data, scale)
        else:
            choice = patches.choice_of(obj.hull.export)
            write = _CadWriter(choice, file_format, cad_files.options_of(obj, file_format))
        base, ending = bpy.path.clean_name(obj.name), _ENDINGS[file_format]
        names = [f"{base}_t{round(1000 * step.t):04d}{ending}" for step in found.steps]
        self._job = jobs.Job(
            lambda progress: _write_all(found, names, write, Path(folder), progress)
        )
        conversions.watch(self)


def _write_all(found, names, write, folder, progress):
    targets = [folder / name for name in names]
    with native.require().FolderBeside(targets) as aside:
        for number, (step, name) in enumerate(zip(found.steps, names)):

            def told(share, number=number):
                progress((number + share) / len(names))

            told(0.0)
            write(found, step, aside / name, told)
        aside.hand_over([aside / name for name in names])
    return targets


class _HullWriter:
    """Of hull files. data: the HullData of the hull; scale: metres of Blender's unit."""

    def __init__(self, data, scale):
        self._data, self._scale = data, scale

    def __call__(self, found, step, path, progress):
        stored = (found.points(step) / self._scale).astype(np.float32)
        own, data = step.particulars, self._data
        member = replace(
            data,
            name=f"{data.name}, t = {step.t:g}",
            points=units.all_as_stored(stored) * self._scale,
            particulars=replace(
                data.particulars,
                **{name: own[name] for name in ("length_pp", "beam", "draft", "depth")},
            ),
            afloat=replace(data.afloat, trim_m=own["trim_m"]),
            load=replace(data.load, kg=own["kg"]),
        )
        write_hull_file(member, path)


class _CadWriter:
    """Of STEP and IGES files. choice: patches.Choice; options: of hull_native.write_step …"""

    def __init__(self, choice, file_format, options):
        self._choice, self._options = choice, options
        self._write = getattr(native.require(), f"write_{file_format.lower()}")

    def __call__(self, found, step, path, progress):
        surface = found.member(step).new_surface()
        converted = patches.convert(
            surface, self._choice, lambda share: progress(_SHARE_OF_CONVERSION * share)
        )
        rest = 1.0 - _SHARE_OF_CONVERSION
        self._write(
            converted.patches,
            str(path),
            curves=[],
            progress=lambda share: progress(_SHARE_OF_CONVERSION + rest * share),
            **{**self._options, "name": f"{found.name}, t = {step.t:g}"},
        )
