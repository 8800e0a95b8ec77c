# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell in plates, laid out and written beside Blender's own work: tasks, as those of
file_tasks are."""

from dataclasses import dataclass
from math import degrees, radians
from pathlib import Path

from ....hull_io.bytes_on_disk import write_bytes
from ...bridge import limits, native
from ...bridge.background import jobs
from ..conversion import conversions
from ..hull import hull_state
from . import plate_rules
from .endings import checked_ending

# Knuckles in the centre plane that may have been meant to be none, rad; others are keels and stems.
_SLIGHT = radians(10.0)


@dataclass(frozen=True)
class PlateReport:
    """rows: of hull_native.plate_rows; unsettled: names of plates whose layout did not settle;
    mass_t: of both sides; key: of the geometry that it is of; knuckles_deg: of keel plates that are
    not one with their mirror images for being slightly bent in the centre plane."""

    rows: list
    unsettled: list
    mass_t: float
    key: object = None
    knuckles_deg: tuple = ()

    @property
    def text(self):
        pieces = sum(row["pieces"] for row in self.rows)
        text = f"{len(self.rows)} plates of {pieces} pieces, {self.mass_t:.2f} t"
        if self.unsettled:
            text += f"; not settled: {', '.join(self.unsettled)}"
        if self.knuckles_deg:
            count, most = len(self.knuckles_deg), max(self.knuckles_deg)
            text += f"; apart at a centre knuckle of up to {most:.1f}°: {count} keel plates"
        return text


@dataclass
class KeptPlates:
    """What a hull's state keeps of its plates."""

    report: PlateReport = None


class PlateTask(jobs.JobTask):
    """Plates of a half hull's shell by the rules of Object.hull.plates, or without any by
    strakes and plate_length, m. result(): a PlateReport."""

    text = "Laying out plates"

    def __init__(self, obj, scene, *, strake, plate_length, thickness, frame_spacing):
        self.state = hull_state.up_to_date(obj, scene)
        self._key, source = self.state.ship.geometry_key, self.state.ship.source
        settings, hull_native = obj.hull.plates, native.require()
        if not source.half:
            raise ValueError(
                "Plates are laid out of a half hull: use Make Half, and each counts twice"
            )
        rules = plate_rules.seam_rules(obj, scene) or [
            hull_native.SeamRule("strakes", strake),
            hull_native.SeamRule("butts", plate_length),
        ]
        knuckles, across = settings.along_knuckles, settings.across_centre
        table = plate_rules.frame_table(obj, scene)

        def work(progress):
            surface = source.new_surface()
            curves, seams = hull_native.seams_by_rules(surface, rules, knuckles=knuckles)
            progress(0.15)
            plates = hull_native.plates(
                surface,
                seams,
                across_centre=across,
                progress=lambda share: progress(0.15 + 0.25 * share),
            )
            if len(plates) > limits.MOST_PLATES:
                raise ValueError(
                    f"The shell would have {len(plates)} plates, and at most {limits.MOST_PLATES} "
                    "are written; ask for larger ones"
                )
            listed = hull_native.plate_list(
                plates,
                thickness=thickness,
                mirrored=True,
                progress=lambda share: progress(0.4 + 0.5 * share),
            )
            progress(0.9)
            marks = _frames(hull_native, curves, plates, table, frame_spacing)
            marks += hull_native.opening_marks(curves, source.appendages)
            self._finish(hull_native, listed, marks, lambda share: progress(0.9 + 0.1 * share))
            return PlateReport(
                hull_native.plate_rows(listed),
                [one.name for one in listed if not one.flat.converged],
                sum(one.mass_t * (2.0 if one.is_pair else 1.0) for one in listed),
                self._key,
                tuple(
                    degrees(one.centre_knuckle)
                    for one in plates
                    if not one.across and one.centre_knuckle is not None
                    if one.centre_knuckle < _SLIGHT
                ),
            )

        self._job = jobs.Job(work)
        conversions.watch(self)

    def _finish(self, hull_native, listed, marks, progress):
        """What else is done with hull_native.ListedPlates, in the thread."""

    def result(self):
        report = super().result()
        self.state.of(KeptPlates).report = report
        return report


class PlateFile(PlateTask):
    """They are written, by the name's ending as .pdf (one page a plate), .dxf (all on one drawing
    at true size) or .csv (the list)."""

    def __init__(self, obj, scene, path, **sizes):
        checked_ending(path, (".pdf", ".dxf", ".csv"), "a set of plates")
        self._path = path
        super().__init__(obj, scene, **sizes)

    def _finish(self, hull_native, listed, marks, progress):
        if Path(self._path).suffix.lower() == ".csv":
            text = hull_native.rows_csv(hull_native.plate_rows(listed))
            write_bytes(Path(self._path), text.encode())
        else:
            hull_native.write_plates(listed, self._path, marks=marks, progress=progress)


def _frames(hull_native, curves, plates, table, spacing):
    """("FRAMES", curve) of frames that cross the plates: of a table, or else evenly spaced from
    x = 0; a spacing of 0 for none."""
    low = min(float(p.box[0][0]) for p in plates)
    high = max(float(p.box[1][0]) for p in plates)
    if table is None:
        if spacing <= 0.0:
            return []
        if high / spacing - low / spacing > limits.MOST_PLATES:
            raise ValueError("There would be too many frames; space them wider")
        ranges = [(min(int(low / spacing) - 1, 0), max(int(high / spacing) + 1, 1), spacing)]
        table = hull_native.frame_table(ranges)
    return [("FRAMES", curve) for curve in hull_native.frame_marks(curves, table, low, high)]


def last_plates(obj):
    """(the PlateReport of a hull or None, whether it is of the hull as it is)."""
    return hull_state.last_report(obj, KeptPlates)


def plate_words(row):
    """(name, what is told of it, whether its layout settled) of a plate in a list on screen."""
    ratio = row["largest_stretch"] / row["least_stretch"] - 1.0
    words = f"{row['area_m2']:.1f} m² {row['mass_kg'] / 1000.0:.2f} t {1000.0 * ratio:.1f} ‰"
    return row["plate"], words, "settled" not in row["form"]
