# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell in plates, laid out and written beside Blender's own work: tasks, as those of
file_tasks are."""

from dataclasses import dataclass, replace
from math import degrees, radians
from pathlib import Path

from ....hull_io.bytes_on_disk import write_bytes
from ...bridge import limits, native
from ...bridge.background import jobs
from ..conversion import conversions
from ..exchange.endings import checked_ending
from ..hull import hull_state, plating_data
from . import plate_marks, plate_rules
from .plate_report import PlateReport

# Knuckles in the centre plane that may have been meant to be none, rad; others are keels and stems.
_SLIGHT = radians(10.0)


@dataclass(frozen=True, eq=False)
class Layout:
    """Plates of a hull laid out. key: what they were made from. surface; curves: HullCurves of it;
    seams: SurfaceCurves, without what is left out; listed: hull_native.ListedPlates; left_out: see
    PlateReport."""

    key: tuple
    surface: object
    curves: object
    seams: list
    listed: list
    left_out: tuple

    @property
    def ends(self):
        """(low, high) of x, m."""
        boxes = [one.plate.box for one in self.listed]
        return min(float(b[0][0]) for b in boxes), max(float(b[1][0]) for b in boxes)


@dataclass
class KeptPlates:
    """What a hull's state keeps of its plates."""

    report: PlateReport = None
    layout: Layout = None


def what_is_asked(obj):
    """What a hull asks for of its plates, to be compared: rules, their lines as they stand, and
    thicknesses of layers."""
    settings = obj.hull.plates
    rules = [
        (rule.kind, rule.value, rule.line and plating_data.key_of(rule.line, obj))
        for rule in settings.rules
        if rule.on
    ]
    layers = [
        (layer.material and layer.material.name, layer.thickness, layer.in_hydrostatics)
        for layer in obj.hull.layers
    ]
    return (*rules, *layers, settings.along_knuckles, settings.across_centre)


def layout_key(state, rules, settings):
    """What the plates of a state by hull_native.SeamRules and Object.hull.plates are made from."""
    lines = (None if one.line is None else one.line.tobytes() for one in rules)
    kinds = ((one.kind, one.value) for one in rules)
    key = state.ship.geometry_key, *zip(kinds, lines)
    if any(one.kind == "openings" for one in rules):
        key += (state.ship.appendages_key,)
    return *key, settings.along_knuckles, settings.across_centre


def known_layout(state, rules, settings):
    """The Layout of plates that were laid out last, None where it is of another hull or rules."""
    layout = state.of(KeptPlates).layout
    is_same = layout is not None and layout.key == layout_key(state, rules, settings)
    return layout if is_same else None


class PlateTask(jobs.JobTask):
    """Plates of a half hull's shell by the rules of Object.hull.plates, or without any by
    strakes and plate_length, m; those that were laid out last are taken where they are of the same
    hull and rules. result(): a PlateReport."""

    text = "Laying out plates"

    def __init__(self, obj, scene, *, strake, plate_length, thickness, frame_spacing):
        self.state = hull_state.up_to_date(obj, scene)
        self._source, settings = self.state.ship.source, obj.hull.plates
        if not self._source.half:
            raise ValueError(
                "Plates are laid out of a half hull: use Make Half, and each counts twice"
            )
        rules = plate_rules.seam_rules(obj, scene) or [
            native.require().SeamRule("strakes", strake),
            native.require().SeamRule("butts", plate_length),
        ]
        self._rules, self._layout = rules, known_layout(self.state, rules, settings)
        self._knuckles, self._across = settings.along_knuckles, settings.across_centre
        self._thickness = plate_marks.thickness_of(obj, scene, thickness)
        points = self.state.ship.surface.mesh.points
        self._marks = plate_marks.marks_of(obj, scene, points, frame_spacing)
        self._key = layout_key(self.state, rules, settings)
        self._asked = what_is_asked(obj)
        self._check()
        self._job = jobs.Job(self._work)
        conversions.watch(self)

    def _check(self):
        """ValueError for what need not be begun."""

    def _work(self, progress):
        if self._layout is None:
            self._layout = self._laid_out(lambda share: progress(0.9 * share))
        layout = self._layout
        plates = [one.plate for one in layout.listed]
        thicknesses, mixed = self._thickness.of(plates, layout.surface)
        listed = [replace(one, thickness=t) for one, t in zip(layout.listed, thicknesses)]
        progress(0.9)
        self._finish(replace(layout, listed=listed), lambda share: progress(0.9 + 0.1 * share))
        return PlateReport(
            native.require().plate_rows(listed),
            [one.name for one in listed if not one.flat.converged],
            sum(one.mass_t * len(one.pieces) for one in listed),
            self._key[0],
            self._asked,
            tuple(_slight_knuckles(plates)),
            mixed,
            layout.left_out,
        )

    def _laid_out(self, progress):
        hull_native, surface = native.require(), self._source.new_surface()
        curves, seams = plate_rules.seams_of(self._source, surface, self._rules, self._knuckles)
        progress(0.15)
        left_out = []
        plates = hull_native.plates(
            surface,
            seams,
            across_centre=self._across,
            left_out=left_out,
            progress=lambda share: progress(0.15 + 0.25 * share),
        )
        if len(plates) > limits.MOST_PLATES:
            raise ValueError(
                f"The shell would have {len(plates)} plates, and at most {limits.MOST_PLATES} "
                "are written; ask for larger ones"
            )
        listed = hull_native.plate_list(
            plates,
            thickness=self._thickness.of_all,
            mirrored=True,
            progress=lambda share: progress(0.4 + 0.6 * share),
        )
        # Knuckles go on, as slight ones that plates go over.
        told = tuple(one for one in left_out if one[0] != "knuckle")
        used = hull_native.used_seams(curves, seams, plates)
        return Layout(self._key, surface, curves, used, listed, told)

    def _finish(self, layout, progress):
        """What else is done with a Layout whose plates have their thickness, in the thread."""

    def result(self):
        kept = self.state.of(KeptPlates)
        try:
            kept.report = super().result()
        finally:
            # What was laid out is so whatever became of the files; else that of before stays.
            kept.layout = self._layout or kept.layout
        return kept.report


def _slight_knuckles(plates):
    for one in plates:
        angle = None if one.across else one.centre_knuckle
        if angle is not None and angle < _SLIGHT:
            yield degrees(angle)


class PlateFile(PlateTask):
    """They are written: by the name's ending as .csv the list, otherwise drawings of all plates in
    one file, or `in_sheets` of those that are named (all without a name) at true size, a file each,
    as write_shop_drawings() does."""

    def __init__(self, obj, scene, path, *, in_sheets=False, paper="A3", names="", **sizes):
        self._path, self._in_sheets, self._paper = path, in_sheets, paper
        self._names = names.split()
        drawn = (".pdf", ".svg", ".dxf") if in_sheets else (".pdf", ".dxf")
        self._is_list = checked_ending(path, (*drawn, ".csv"), "a set of plates") == ".csv"
        super().__init__(obj, scene, **sizes)

    def _finish(self, layout, progress):
        hull_native, listed = native.require(), chosen(layout.listed, self._names)
        if self._is_list:
            write_rows(self._path, hull_native.plate_rows(listed))
            return
        marks = self._marks.of(layout.curves, *layout.ends)
        marks += hull_native.opening_marks(layout.curves, self._source.appendages)
        if not self._in_sheets:
            hull_native.write_plates(listed, self._path, marks=marks, progress=progress)
            return
        drawings = []
        for k, one in enumerate(listed):
            progress(0.5 * k / len(listed))
            drawings.append(hull_native.plate_drawing(one, marks=marks))
        hull_native.write_shop_drawings(
            drawings,
            self._path,
            names=list(map(plain_name, listed)),
            paper=self._paper,
            progress=lambda share: progress(0.5 + 0.5 * share),
        )


def plain_name(listed):
    """Of a ListedPlate, without a word on sides."""
    return listed.name.split()[0]


def chosen(listed, names):
    """The ListedPlates of such names, P7 for "P7 P/S"; all without names. ValueError for one that
    there is not."""
    if not names:
        return listed
    known = {plain_name(one).upper(): one for one in listed}
    for name in names:
        if name.upper() not in known:
            raise ValueError(
                f"There is no plate {name}: they are {plain_name(listed[0])} to "
                f"{plain_name(listed[-1])}"
            )
    return [known[name] for name in dict.fromkeys(map(str.upper, names))]


def write_rows(path, rows):
    """A list as comma-separated values, all of it or nothing."""
    write_bytes(Path(path), native.require().rows_csv(rows).encode())


def last_plates(obj):
    """(the PlateReport of a hull or None, whether it is of the hull, its rules and thicknesses as
    they are)."""
    report, is_current = hull_state.last_report(obj, KeptPlates)
    return report, is_current and report.asked == what_is_asked(obj)


def plate_words(row, shown):
    """(name, what is told of it, whether its layout settled) of a plate in a list on screen, in the
    units of a units.Shown."""
    ratio = row["largest_stretch"] / row["least_stretch"] - 1.0
    area, area_symbol = shown.in_unit(row["area_m2"], "m2")
    mass, mass_symbol = shown.in_unit(row["mass_kg"] / 1000.0, "t")
    # No longer than the sidebar is broad.
    area_digits, mass_digits = int(area < 99.95), 2 - int(mass >= 9.995 or shown.is_imperial)
    plate = f"{area:.{area_digits}f} {area_symbol} {mass:.{mass_digits}f} {mass_symbol}"
    per_mille = 1000.0 * ratio
    ratio_digits = 1 - int(per_mille >= 9.95 and shown.is_imperial)
    words = f"{plate} {per_mille:.{ratio_digits}f} ‰"
    return row["plate"], words, "settled" not in row["form"]
