# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls fitted to a shape: the task that moves the control points, and its report."""

from dataclasses import dataclass

import bpy
import numpy as np
from mathutils import Vector

from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import letters, units, view_target
from ...bridge.mesh import mesh_arrays, mesh_points
from ...bridge.objects import hull_mesh
from ..constraints import move_limits
from ..conversion import conversions
from ..hull import hull_state
from ..hull.as_it_was import AsItWas
from ..lines import lines
from . import coverage, fit_targets, run_out

_USUAL_REACH = 0.05  # of the length
_VIEW_DISTANCE = 0.3  # of the length
_MOST_LEFT_OUT = 1.0 / 3.0
_MOST_RUN_OUT = 0.01  # of the length


@dataclass(frozen=True, eq=False)
class Report:
    """What came of a fit, in m. key: the geometry of the hull it gave; place (3,): where it is
    farthest from the target; target_rms, target_largest: of all of the target from the hull, that
    which was left out too; faces_alone: how many faces have no target, and were left alone.
    run_out: how much farther from the target borders came to lie; length: of the hull before."""

    key: object
    counted: int
    left_out: int
    rms: float
    largest: float
    place: np.ndarray
    line_rms: float
    settled: bool
    target_rms: float
    target_largest: float
    faces_alone: int
    run_out: float
    length: float

    @property
    def has_run_out(self):
        """Whether borders came to lie so far beyond the target that the hull is no use."""
        return self.run_out > _MOST_RUN_OUT * self.length

    @property
    def is_mostly_beside(self):
        """Whether so much of the target was left out that the fit says little of it."""
        return self.left_out > _MOST_LEFT_OUT * (self.counted + self.left_out)


@dataclass
class LastFit:
    """The Report of the last fit of a hull, or None."""

    report: object = None


class Fitting(jobs.JobTask):
    """The task of fitting a hull as it is now; see features.conversion.conversions. result(): the
    hull_native.Fit."""

    text = "Fitting"

    def __init__(self, obj, scene):
        self.state = hull_state.up_to_date(obj, scene)
        conversions.clear_way(obj)
        self.scale = units.metres_per_unit(scene)
        self._before = AsItWas(obj, scene, "fit it again")
        found = hull_mesh.read(obj)
        control = found.control(self.scale)
        self._ids = control.vertex_ids
        hull_native = native.require()
        surface = hull_native.LimitSurface(
            hull_native.ControlMesh(*control.arguments()), found.scheme
        )
        self._targets, options, self._alone = _arguments(obj, surface, control, self.scale)
        targets = self._targets[~self._alone.is_beside]
        self._run_out = run_out.RunOut(surface, control, self._targets)
        self._length = lines.size_of(surface)
        self._job = jobs.Job(
            lambda progress: hull_native.fit_surface(surface, targets, progress=progress, **options)
        )
        conversions.watch(self)

    def write(self, scene):
        """Moves the hull's control points to where they fit; returns the Report. ValueError when
        the hull is no longer what was fitted."""
        fit = self.result()
        obj = self._before.checked(scene)
        mesh_points.write(obj.data, self._ids, fit.points / self.scale)
        state = hull_state.follow_edit(obj, scene, is_by_hand=False)
        apart = coverage.distances(state.ship.surface, self._targets)
        report = state.of(LastFit).report = Report(
            state.ship.geometry_key,
            fit.counted,
            len(self._targets) - fit.counted,
            fit.rms,
            fit.largest,
            np.array(fit.largest_place),
            fit.curve_rms,
            fit.settled,
            float(np.sqrt((apart**2).mean())),
            float(apart.max()),
            self._alone.face_count,
            self._run_out.by(state.ship.surface),
            self._length,
        )
        return report


def _arguments(obj, surface, control, scale):
    """(all targets, the arguments of hull_native.fit_surface beside them, the coverage.Uncovered
    that is left alone for want of a target): targets beside that do not count."""
    hull_native, settings = native.require(), obj.hull.fit
    limits.within(settings.samples, "Points", *limits.FIT_POINTS)
    limits.within(settings.fairness, "Fairness", 0.0, limits.GREATEST_FAIRNESS)
    limits.within(settings.stiffness, "Stiffness", 0.0, limits.GREATEST_STIFFNESS)
    size = lines.size_of(surface)
    target = fit_targets.of_hull(obj, scale, size)
    reach = scale * settings.reach or _USUAL_REACH * size
    limits.within(reach, "Reach in m", 0.0, limits.LONGEST)
    curves = [(line, None, False) for line in target.lines]
    curves += fit_targets.centre_curves(target, hull_native.crease_curves(surface), reach)
    moves = move_limits.of_hull(obj, control.vertex_ids, control.points)
    turned = _turned_as(surface, target, reach)
    alone = coverage.uncovered(control, surface, target.points, turned, reach)
    moves = moves.with_locked(alone.points)
    limits_of_moves = (
        moves.reshape_arguments(surface) if settings.stay_square else moves.arguments()
    )
    options = {
        **limits_of_moves,
        "normals": None if turned is None else turned[~alone.is_beside],
        "curves": curves,
        "fairness": settings.fairness,
        "stiffness": settings.stiffness,
        "reach": reach,
        "draw_border": settings.draw_border,
    }
    return target.points, options, alone


def _turned_as(surface, target, reach):
    """The target's normals, all turned round if most of them look inwards."""
    if target.normals is None:
        return None
    near = native.require().SurfaceTree(surface).closest_points(target.points, reach)
    found = near.cells >= 0
    own = surface.normals(near.cells[found], near.uv[found])
    agreement = (own * target.normals[found]).sum()
    return target.normals if agreement >= 0.0 else -target.normals


def last_report(obj):
    """(the Report of a hull's last fit or None, whether the hull is as that made it)."""
    return hull_state.last_report(obj, LastFit)


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    found = [
        ("Points", str(report.counted)),
        ("Left out", str(report.left_out)),
        ("RMS", units.format_mm(report.rms)),
        ("Largest", units.format_mm(report.largest)),
        ("All of target, RMS", units.format_mm(report.target_rms)),
        ("All of target, largest", units.format_mm(report.target_largest)),
    ]
    if report.has_run_out:
        found.append(("Borders beyond", units.format_mm(report.run_out)))
    if report.faces_alone:
        found.append(("Faces without target", str(report.faces_alone)))
    if report.line_rms:
        found.append(("Creases RMS", units.format_mm(report.line_rms)))
    return found


def summary(report):
    """A Report as a sentence."""
    text = (
        f"{report.counted} points, {report.left_out} left out: RMS {units.format_mm(report.rms)}, "
        f"largest {units.format_mm(report.largest)}"
    )
    if warning(report):
        text = f"{warning(report)}. {text}"
    return text if report.settled else f"{text}. It may come nearer still: fit again"


def warning(report):
    """What is to be said of a Report first, a sentence, or ""."""
    if report.has_run_out:
        return (
            f"Borders ran out beyond the target, by {report.run_out:.3g} m: undo, and switch "
            "Creases to edges on, or Draw borders off"
        )
    if not report.is_mostly_beside:
        return ""
    share = 100.0 * report.left_out / (report.counted + report.left_out)
    return (
        f"{share:.0f} % of the target was left out, being beyond Reach, beyond the borders or "
        "turned otherwise: the RMS says nothing of it"
    )


def mark_worst(obj, scene, view):
    """Sets the 3D cursor where a hull is farthest from its target; brings that into a RegionView3D
    unless it is None. ValueError without a report."""
    report, is_current = last_report(obj)
    if not is_current or not report.counted:
        raise ValueError("There is no fit of the hull as it is: press Fit first")
    scale = units.metres_per_unit(scene)
    scene.cursor.location = obj.matrix_world @ (Vector(report.place) / scale)
    view_target.look_at(view, scene.cursor.location)
    if view is not None:
        view.view_distance = _VIEW_DISTANCE * max(obj.dimensions)


def shape_object(name, points, triangles, collection):
    """A new mesh object of triangles (m, 3) between points (n, 3) in Blender's units."""
    name = letters.taken(name)
    mesh = bpy.data.meshes.new(name)
    sizes = np.full(len(triangles), 3, dtype=np.int32)
    mesh_arrays.write_faces(mesh, points, sizes, np.asarray(triangles).reshape(-1))
    obj = bpy.data.objects.new(name, mesh)
    collection.objects.link(obj)
    return obj
