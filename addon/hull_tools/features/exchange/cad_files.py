# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP and IGES files of a hull, made beside Blender's own work."""

from dataclasses import dataclass

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.mesh import mesh_check
from ..conversion import conversions
from ..hull import hull_state
from . import cad_curves, step_size

STEP, IGES = "STEP", "IGES"

# Of the time that conversion and writing take together, and of that which curves and file take.
_SHARE_OF_CONVERSION = 0.4
_SHARE_OF_CURVES = 0.1

_SOLIDS = ("SOLID", "HALF_SOLID")


@dataclass(frozen=True, eq=False)
class Written:
    """converted: patches.Converted; report: what was found in the file, as hull_native tells it.
    without_appendages: the hull has some, which this file, as no closed solid, does not hold."""

    converted: object
    report: dict
    without_appendages: bool = False


@dataclass
class LastProblem:
    """(key of the surface, mesh_check.Problem) because of which the last file of a hull was not
    written, or None."""

    found: tuple = None


class Export(jobs.JobTask):
    """The task (see conversions) of writing a hull, as it is when this is made, to a file.

    The patches are those of the last conversion, if that is of the hull and its settings as they
    are. ValueError when the hull has no surface, or a file of it is being written.
    """

    def __init__(self, obj, scene, path, file_format):
        self.text = f"Writing {file_format}"
        known = conversions.current(obj, scene)
        if known is not None:
            conversions.clear_way(obj)
        self._conversion = None if known else conversions.begin(obj, scene)
        self.state = hull_state.state_of(obj)
        source = self.state.ship.source
        self._geometry, self._control = self.state.ship.geometry_key, source.control
        wanted = cad_curves.wanted(obj, scene, self.state.ship.surface)
        options = options_of(obj, file_format)
        without = leaves_appendages_out(obj) and bool(source.appendages)
        if not without:
            options["appendages"] = list(source.appendages)

        # Jobs run one after the other: the conversion is over when this begins.
        def work(progress):
            converted = known or self._conversion.converted()
            curves = []
            if wanted is not None:
                curves = cad_curves.curves(
                    source.new_surface(), wanted, lambda share: progress(_SHARE_OF_CURVES * share)
                )
            rest = 1.0 - _SHARE_OF_CURVES
            write = getattr(native.require(), f"write_{file_format.lower()}")
            report = write(
                converted.patches,
                path,
                curves=curves,
                progress=lambda share: progress(_SHARE_OF_CURVES + rest * share),
                **options,
            )
            return Written(converted, report, without)

        self._job = jobs.Job(work)
        conversions.watch(self)

    @property
    def share(self):
        if self._conversion is None:
            return super().share
        rest = 1.0 - _SHARE_OF_CONVERSION
        return _SHARE_OF_CONVERSION * self._conversion.share + rest * super().share

    def cancel(self):
        """The file of this name, if there is one, stays as it is."""
        if self._conversion is not None:
            self._conversion.cancel()
        super().cancel()

    def result(self):
        """The Written, which is waited for. ValueError and OSError with the reason when nothing
        was written, jobs.Cancelled when it was cancelled."""
        if self._conversion is not None:
            self._conversion.result()
        last = self.state.of(LastProblem)
        last.found = None
        try:
            return self._job.result()
        except ValueError as error:
            last.found = self._problem(error)
            raise

    def _problem(self, error):
        """What a hull_native.PlaceError says of a place, None of another error."""
        if not getattr(error, "elements", ()):
            return None
        ids = self._control.face_ids if error.kind == "face" else self._control.vertex_ids
        elements = tuple(ids[list(error.elements)].tolist())
        # The points that are named are those beside the centre plane.
        remedy = "CENTRE" if error.kind == "vertex" else ""
        found = mesh_check.Problem("error", error.kind, elements, str(error), remedy)
        return self._geometry, found


def problem_of(obj):
    """The mesh_check.Problem because of which the last STEP or IGES file of a hull, as it still is,
    was not written; None when there is none, or nothing to select."""
    state = hull_state.state_of(obj)
    found = None if state is None else state.of(LastProblem).found
    if found is None:
        return None
    geometry, problem = found
    return problem if state.ship.geometry_key == geometry else None


def leaves_appendages_out(obj):
    """Whether the extent of a hull's STEP and IGES files is one that appendages are no part of."""
    return obj.hull.export.extent != "SOLID"


def options_of(obj, file_format):
    """Keyword arguments of hull_native.write_step or write_iges that an Object.hull decides."""
    settings = obj.hull.export
    options = {
        "name": obj.name,
        "unit": settings.unit,
        "mirrored": step_size.is_mirrored(obj),
        "solid": settings.extent in _SOLIDS,
    }
    return {**options, "schema": settings.schema} if file_format == STEP else options


def export(obj, scene, path, file_format=STEP):
    """Writes a hull to a file; returns the Written."""
    return Export(obj, scene, path, file_format).result()
