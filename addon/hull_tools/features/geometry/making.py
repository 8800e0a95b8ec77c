# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls made of geometry: the task that lays and fits the control mesh, and its report."""

from dataclasses import dataclass, field

import numpy as np
from mathutils import Vector

from .... import hull_fitting
from ...bridge import limits
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.counts import counted
from ..fitting import fitting
from ..hull import hull_creation, hull_state
from . import sources

_SHARE_OF_READING = 0.1  # of the work
# What is guessed of nearly every hull, and told in the panel only.
_USUAL_DOUBTS = {"perpendiculars"}


@dataclass(frozen=True)
class Asked:
    """points: control points at most; tolerance, draft: m, None: 3e-4 of the length, 60 % of the
    depth; known: what hull_io.geometry.guess_hull takes; keeps_source: whether the surface that
    was fitted to becomes an object, where it is none; stern_post, knuckles: whether such as are
    found are laid out."""

    points: int
    tolerance: object = None
    draft: object = None
    known: dict = field(default_factory=dict)
    keeps_source: bool = True
    stern_post: bool = True
    knuckles: bool = True


@dataclass(frozen=True, eq=False)
class Report:
    """How near a hull is to what it was made of. key: its geometry as it was made; told: what
    hull_fitting's MadeHull has as report."""

    key: object
    told: dict

    @property
    def is_within(self):
        return self.told["within_tolerance"]

    @property
    def doubts(self):
        """Sentences."""
        return [sources.sentence(self.told["guesses"], doubt) for doubt in self.told["doubts"]]


@dataclass
class MadeOf:
    """The Report of a hull that was made of geometry, or None."""

    report: object = None


class Making(jobs.JobTask):
    """Makes a hull of a sources.Source in a thread, as is Asked; `write` makes the object. text:
    what is done. result(): the hull_fitting.MadeHull."""

    text = "Hull from geometry"

    def __init__(self, source, asked):
        limits.within(asked.points, "Points at Most", *limits.NETWORK_HULL_POINTS)
        for value, name in ((asked.tolerance, "Tolerance"), (asked.draft, "Draft")):
            if value is not None:
                limits.within(value, f"{name} in m", 0.0, limits.LONGEST)
        self._source, self._asked = source, asked
        self._job = jobs.Job(lambda progress: _made(source, asked, progress))

    def write(self, scene, collection):
        """(the new hull, its Report). It stands upon a mesh object that has the same axes, else at
        the origin."""
        made, scale = self.result(), units.metres_per_unit(scene)
        obj = hull_creation.hull_object(made.data, scene, collection)
        source = self._source.object_in(scene)
        if source is not None and _has_ship_axes(made.guess):
            obj.location = np.array(made.guess.origin) / scale
        elif self._asked.keeps_source:
            source = _shell_object(made, scale, collection)
        obj.hull.fit.target = source
        state = hull_state.up_to_date(obj, scene)
        report = state.of(MadeOf).report = Report(state.ship.geometry_key, made.report)
        return obj, report


def _made(source, asked, progress):
    def of_reading(share):
        progress(_SHARE_OF_READING * share)

    def of_fitting(share):
        progress(_SHARE_OF_READING + (1.0 - _SHARE_OF_READING) * share)

    return hull_fitting.hull_from_geometry(
        source.read(of_reading),
        budget=asked.points,
        tolerance=asked.tolerance,
        draft=asked.draft,
        stern_post=asked.stern_post,
        knuckles=asked.knuckles,
        name=source.name,
        progress=of_fitting,
        **asked.known,
    )


def _has_ship_axes(guess):
    return (guess.forward, guess.port, guess.up) == ("+x", "+y", "+z")


def _shell_object(made, scale, collection):
    """An object of what was fitted to; hidden, for it lies in the hull's surface."""
    mesh = made.shell.mesh
    used, triangles = np.unique(mesh.triangles, return_inverse=True)
    triangles = triangles.reshape(-1, 3)
    name = f"{made.data.name} source"
    obj = fitting.shape_object(name, mesh.points[used] / scale, triangles, collection)
    obj.hide_render = True
    obj.hide_set(True)
    return obj


def last_report(obj):
    """(the Report of a hull that was made of geometry or None, whether the hull is still as it was
    then)."""
    return hull_state.last_report(obj, MadeOf)


def summary(report):
    """(a Report as a sentence, whether it is a warning)."""
    told = report.told
    distances = told["distances"]
    text = (
        f"{counted(told['points'], 'control point')}: the surface is off by "
        f"{units.format_mm(distances['rms'])} RMS, {units.format_mm(distances['largest'])} at most"
    )
    if not report.is_within:
        tolerance = units.format_mm(told["tolerance"])
        text += f". That is more than the tolerance of {tolerance}: allow more points"
    odd = [told["guesses"][doubt] for doubt in told["doubts"] if doubt not in _USUAL_DOUBTS]
    for sentence in (*odd, *told["left_out"]):
        text += f". {sentence.rstrip('.')}"
    return text, bool(odd or told["left_out"]) or not report.is_within


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    told = report.told
    below = told["distances_below_draft"] or told["distances"]
    in_rows = 100.0 * told["points_in_rows_of_one_x"] / told["points"]
    return [
        ("Control points", str(told["points"])),
        ("In rows of one x", f"{in_rows:.0f} %"),
        ("RMS", units.format_mm(told["distances"]["rms"])),
        ("Largest", units.format_mm(told["distances"]["largest"])),
        ("RMS below the draft", units.format_mm(below["rms"])),
        ("Largest below the draft", units.format_mm(below["largest"])),
        ("∇ off by", _more(told["displaced_volume"])),
        ("Surface off by", _more(told["wetted_surface"])),
    ]


def _more(told):
    if not told["source"]:
        return "–"
    return f"{100.0 * (told['hull'] / told['source'] - 1.0):+.3f} %"


def place_of(obj, scene):
    """Where (3,), Blender's units, the source is farthest from a hull. ValueError where that is
    not known."""
    report, is_current = last_report(obj)
    if report is None or not is_current:
        raise ValueError(
            "There is no report of the hull as it is: it was changed since it was made"
        )
    place = Vector(report.told["distances"]["place"]) / units.metres_per_unit(scene)
    return obj.matrix_world @ place
