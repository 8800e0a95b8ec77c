# SPDX-License-Identifier: GPL-3.0-or-later
"""A control mesh laid over a network's curves and fitted to them, as a new hull; and how far the
curves are from it."""

from dataclasses import dataclass

import numpy as np
from mathutils import Vector

from ....hull_io.hull_data import Flat, HullData
from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.counts import counted
from ...bridge.objects import hull_objects, networks
from ..hull import hull_creation, hull_state
from . import network_state

# Of the length: the tolerance where the network has none.
_TOLERANCE = 3e-4
_CORNER = 3  # of hull_native.ControlMesh.vertex_kinds


@dataclass(frozen=True, eq=False)
class Report:
    """How far the curves of a network are from the hull laid over it, m. key: the geometry of that
    hull; laid: _laid_of the network; curves: hull_native.CurveDistances, the farthest first;
    in_rows: the share of its control points in rows of one x; tolerance: what was asked for."""

    key: object
    laid: tuple
    points: int
    rms: float
    largest: float
    place: tuple
    curves: tuple
    in_rows: float
    tolerance: float

    @property
    def is_within(self):
        return self.largest <= self.tolerance


@dataclass
class LaidOver:
    """The Report of a hull that was laid over a network, or None."""

    report: object = None


class Laying(jobs.JobTask):
    """Lays a control mesh over a network in a thread; `write` makes a hull of it. text: what is
    done. result(): the hull_native.NetworkHull."""

    text = "Network to hull"

    def __init__(self, network, scene):
        self._scale, settings = units.metres_per_unit(scene), network.hull_network
        limits.within(settings.hull_points, "Points at Most", *limits.NETWORK_HULL_POINTS)
        limits.within(settings.hull_tolerance, "Hull Tolerance", 0.0, limits.LONGEST)
        self._network = network.name
        state = network_state.up_to_date(network, scene)
        self._laid = _laid_of(state)
        asked = units.as_typed(settings.hull_tolerance) * self._scale
        self._tolerance = asked or _TOLERANCE * _length_of(state.network)
        layout = _layout(settings.layout_hull, scene)
        options = {"tolerance": self._tolerance, "budget": settings.hull_points}
        curves = state.network
        self._job = jobs.Job(lambda progress: _laid(curves, layout, options, progress))

    def write(self, scene, collection):
        """(the new hull, in a collection that is no network, or else the scene's; its Report).
        ValueError where the network was deleted meanwhile."""
        laid = self.result()
        if networks.is_network(collection):
            collection = scene.collection
        network = networks.named(self._network)
        if network is None:
            raise ValueError(f'"{self._network}" was deleted meanwhile: no hull is made')
        data = _hull_data(laid, f"{self._network} hull")
        obj = hull_creation.hull_object(data, scene, collection)
        network.hull_network.hull = obj
        state = hull_state.up_to_date(obj, scene)
        curves = tuple(sorted(laid.curves, key=lambda curve: -curve.largest))
        report = state.of(LaidOver).report = Report(
            state.ship.geometry_key, self._laid, len(data.points), laid.rms, laid.largest,
            laid.place, curves, laid.in_rows, self._tolerance,
        )  # fmt: skip
        return obj, report


def _laid_of(state):
    """What a hull is laid over, of a NetworkState, to be compared: its curves in m."""
    return tuple(state.curves[name].key for name in state.joined if name in state.curves)


def _length_of(native_network):
    nodes = np.asarray(native_network.nodes)
    return float(np.ptp(nodes[:, 0])) if len(nodes) else 1.0


def _layout(hull, scene):
    """A flotation.ship.ShipSource whose control mesh is taken as it is; None without a hull."""
    if not hull_objects.is_hull(hull) or scene.objects.get(hull.name) != hull:
        return None
    if not hull.hull.half:
        raise ValueError(f'The layout "{hull.name}" is a whole hull: Make Half (panel Hull)')
    if hull.matrix_world.translation.length > 0.0:
        raise ValueError(
            f'The layout "{hull.name}" is not at the origin: clear its location (Alt G)'
        )
    source = hull_state.up_to_date(hull, scene).ship.source
    if source is None:
        raise ValueError(f'The layout "{hull.name}" has no surface')
    return source


def _laid(curves, layout, options, progress):
    surface = None if layout is None else layout.new_surface()
    return native.require().hull_from_network(curves, layout=surface, progress=progress, **options)


def _hull_data(laid, name):
    mesh = laid.surface.mesh
    ends = np.cumsum(mesh.face_sizes)
    corners = np.asarray(mesh.face_vertices)
    faces = [
        corners[end - size : end].tolist() for end, size in zip(ends.tolist(), mesh.face_sizes)
    ]
    border = {tuple(sorted(edge)) for edge in np.asarray(mesh.border_edges).tolist()}
    creases = {tuple(sorted(edge)) for edge in np.asarray(mesh.creases).tolist()}
    return HullData(
        name=name,
        points=mesh.points,
        faces=faces,
        creases=sorted(creases - border),
        corners=np.flatnonzero(np.asarray(mesh.vertex_kinds) == _CORNER).tolist(),
        half=True,
        scheme=laid.surface.scheme,
        flats=_flats(laid.flats, faces),
        source=f"Laid over {name}",
    )


def _flats(found, faces):
    """Flats of the faces all of whose points are in a plane; no face is of two."""
    flats, taken = [], set()
    for points, normal, offset in found:
        inside = set(points.tolist())
        own = [i for i, face in enumerate(faces) if i not in taken and inside.issuperset(face)]
        taken.update(own)
        if own:
            flats.append(Flat(own, tuple(normal), float(offset)))
    return flats


def last_report(network):
    """(the Report of the hull that was laid over a network last or None, as for one that was
    deleted, whether hull and network are still as they were then)."""
    hull = None if network is None else network.hull_network.hull
    if hull is None or not hull.users_scene:  # the network keeps what was deleted
        return None, False
    report, is_current = hull_state.last_report(hull, LaidOver)
    state = network_state.state_of(network)
    return report, is_current and state is not None and report.laid == _laid_of(state)


def summary(report):
    """A Report as a sentence."""
    text = (
        f"{counted(report.points, 'control point')}: curves are off by "
        f"{units.format_mm(report.rms)} RMS, {units.format_mm(report.largest)} at most"
    )
    if report.curves:
        text += f', of "{report.curves[0].name}"'
    if not report.is_within:
        text += (
            f". That is more than the tolerance of {units.format_mm(report.tolerance)}: allow more "
            "points, or add curves there"
        )
    return text


def rows(report):
    """Pairs (name, value) of what a panel shows of a Report."""
    return [
        ("Control points", str(report.points)),
        ("In rows of one x", f"{100.0 * report.in_rows:.0f} %"),
        ("RMS", units.format_mm(report.rms)),
        ("Largest", units.format_mm(report.largest)),
    ]


def of_curve(network, name):
    """The hull_native.CurveDistance of a curve by its name; None where it is not known."""
    report, is_current = last_report(network)
    if report is None or not is_current:
        return None
    return next((curve for curve in report.curves if curve.name == name), None)


def place_of(network, scene, number):
    """Where (3,), Blender's units, a curve by its number in the Report is farthest off. ValueError
    where there is none."""
    report, is_current = last_report(network)
    if report is None or not is_current or not 0 <= number < len(report.curves):
        raise ValueError("There is no hull laid over the network as it is: press To Hull first")
    hull = network.hull_network.hull
    place = Vector(report.curves[number].place) / units.metres_per_unit(scene)
    return hull.matrix_world @ place
