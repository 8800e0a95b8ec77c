# SPDX-License-Identifier: GPL-3.0-or-later
"""The object that shows the surface of a network: a mesh of its patches, which follows the curves.

While curves move, patches are computed anew whose borders, or the tangent planes at these, have
moved; the rest, and exact normals, at the next pause.
"""

import bpy
import numpy as np

from ...bridge import limits
from ...bridge.blender import blender_versions
from ...bridge.mesh import mesh_arrays
from ...bridge.objects import networks, shown_objects, unrecorded
from ..surface import materials

_MARK = "hull_network_surface"
# Of the network's size: what an edge may move before its patches are computed anew.
_UNSEEN = 1e-6
# Of an edge: places by which it is told whether it moved.
_EDGE_PARTS = 4


class LiveSurface:
    """What is shown: `layout` says for which regions, places and triangles; points (n, 3) m."""

    def __init__(self):
        self.forget()

    def forget(self):
        self._network, self._layout, self._points, self._normals = None, None, None, None
        self._edges, self._has_normals = None, False
        self.mesh_name = ""

    def follow(self, network, state):
        """Shows a network's surface, or hides it, as the settings have it."""
        if networks.locked(network):
            return
        shown = _tended(network)
        if shown is None or not network.hull_network.show_surface:
            return
        if state.network is None:
            if not state.curves:
                self._clear(shown)
            return
        if not state.is_joined and self._points is not None:
            return  # what was last sound stays
        if shown_objects.is_worked_on(shown):
            self.forget()
            return
        samples = int(np.clip(network.hull_network.samples, 1, limits.MOST_SAMPLES))
        self._bring(shown, state, samples)

    def _clear(self, shown):
        """Without curves there is no surface."""
        mesh = shown.data
        if len(mesh.polygons) and self._is_of(shown) and not shown_objects.is_worked_on(shown):
            mesh.clear_geometry()
            mesh.update()
        self.forget()

    @property
    def is_finished(self):
        return self._has_normals or self._layout is None

    def finish(self, network, state):
        """All patches, and exact normals, as they are."""
        shown = networks.surface_of(network)
        if self.is_finished or shown is None:
            return
        if shown_objects.is_worked_on(shown) or not self._is_of(shown):
            return
        layout = Layout(self._network, self._layout.parts)
        is_same = layout.key == self._layout.key
        self._begin(layout)
        if is_same:
            self._move(shown, state.scale)
        else:
            self._make(shown, state.scale)
        normals = self._normals[self._layout.triangles].reshape(-1, 3)
        blender_versions.set_corner_normals(shown.data, normals)
        self._has_normals = True

    def _is_of(self, shown):
        return (
            shown.data.name == self.mesh_name
            and self._points is not None
            and len(shown.data.vertices) == len(self._points)
        )

    def _bring(self, shown, state, samples):
        is_known = self._is_of(shown) and self._layout.parts == samples
        if is_known and state.network is self._network:
            return
        if is_known and self._layout.is_of(state.network) and self._follow(state.network):
            self._move(shown, state.scale)
        else:
            self._begin(Layout(state.network, samples))
            self._make(shown, state.scale)
        self._has_normals = False

    def _begin(self, layout):
        self._network, self._layout = layout.network, layout
        self._points = np.zeros((layout.count, 3))
        self._normals = np.zeros((layout.count, 3))
        self._evaluate(range(len(layout.regions)))

    def _follow(self, native_network):
        """Whether the patches that have moved were computed anew; they have the same sides."""
        changed = self._changed(self._layout, native_network)
        if not self._layout.take(native_network, changed):
            return False
        self._network = native_network
        self._evaluate(changed)
        return True

    def _evaluate(self, regions):
        for number in regions:
            run = self._layout.run(number)
            patch = self._layout.patch(number)
            self._points[run], self._normals[run] = patch.evaluate(self._layout.places(number))

    def _changed(self, layout, native_network):
        """Numbers of regions beside edges, or next but one to edges, that have moved."""
        edges = _edge_points(native_network)
        if self._edges is None or self._edges.shape != edges.shape or not len(edges):
            self._edges = edges
            return range(len(layout.regions))
        size = np.ptp(edges.reshape(-1, 3), axis=0).max()
        moved = np.abs(edges - self._edges).max(axis=(1, 2)) > _UNSEEN * size
        self._edges[moved] = edges[moved]
        near = np.zeros(len(native_network.nodes), dtype=bool)
        ends = np.asarray(native_network.edges)
        for _ in range(2):  # tangent planes are carried on to the next node
            near[ends[moved].ravel()] = True
            moved = near[ends].any(axis=1)
        return [i for i, own in enumerate(layout.edges) if near[ends[list(own)]].any()]

    def _make(self, shown, scale):
        self._edges = _edge_points(self._network)
        mesh, triangles = shown.data, self._layout.triangles
        sizes = np.full(len(triangles), 3, dtype=np.int32)
        mesh_arrays.write_faces(mesh, self._points / scale, sizes, triangles.reshape(-1))
        mesh.polygons.foreach_set("use_smooth", np.ones(len(triangles), dtype=bool))
        if not mesh.materials:
            mesh.materials.append(materials.surface_material())
        mesh.update()
        self.mesh_name = mesh.name

    def _move(self, shown, scale):
        points = (self._points / scale).astype(np.float32)
        shown.data.vertices.foreach_set("co", points.reshape(-1))
        blender_versions.rest_corner_normals(shown.data)
        shown.data.update()


class Layout:
    """Which regions of a hull_native.CurveNetwork have a patch, and how these follow one another in
    the mesh. key: equal for equal faces; edges: of each region."""

    def __init__(self, native_network, parts):
        self.network, self.parts = native_network, parts
        self.regions, self.edges, self._patches, self._sides = [], [], [], []
        for region in range(native_network.region_count):
            patch = _patch(native_network, region)
            if patch is not None:
                self.regions.append(region)
                self._patches.append(patch)
                self.edges.append(_edges_of(native_network, region))
                self._sides.append(patch.side_count)
        self._grids = {}
        for count, patch in zip(self._sides, self._patches):
            if count not in self._grids:
                self._grids[count] = patch.grid(parts)
        lengths = [len(self._grids[count][0]) for count in self._sides]
        self._starts = np.concatenate([[0], np.cumsum(lengths, dtype=np.int64)])
        self.count = int(self._starts[-1])
        self.key = (parts, tuple(self._sides))

    def is_of(self, native_network):
        """Whether another network has edges between the same nodes."""
        return np.array_equal(self.network.edges, native_network.edges)

    def take(self, native_network, numbers):
        """Takes the patches of these numbers from another network that it is_of; whether that has
        regions between the same edges, with as many sides. What number a region has there may be
        another one."""
        count = native_network.region_count
        regions = {_edges_of(native_network, region): region for region in range(count)}
        if count != self.network.region_count or not regions.keys() >= set(self.edges):
            return False
        taken = [_patch(native_network, regions[self.edges[number]]) for number in numbers]
        for number, patch in zip(numbers, taken):
            if patch is None or patch.side_count != self._sides[number]:
                return False
        for number, patch in zip(numbers, taken):
            self._patches[number] = patch
        self.network = native_network
        return True

    @property
    def triangles(self):
        """(m, 3) corners, of all patches."""
        found = [self._grids[n][1] + start for n, start in zip(self._sides, self._starts)]
        return np.concatenate([np.empty((0, 3), dtype=np.int32), *found]).astype(np.int32)

    def run(self, number):
        return slice(self._starts[number], self._starts[number + 1])

    def patch(self, number):
        return self._patches[number]

    def places(self, number):
        return self._grids[self._sides[number]][0]


def _patch(native_network, region):
    """The patch of a region; None where it has none, which is among the problems."""
    try:
        return native_network.patch(region)
    except ValueError:
        return None


def _edges_of(native_network, region):
    return frozenset(edge for side in native_network.sides(region) for edge, _ in side)


def _edge_points(native_network):
    """(edges, k, 3), m."""
    count = len(native_network.edges)
    found = [native_network.edge_points(edge, _EDGE_PARTS) for edge in range(count)]
    return np.array(found).reshape(count, _EDGE_PARTS + 1, 3)


def _tended(network):
    """The surface object of a network as its settings want it to be: made, hidden or seen; None
    where there is none. One that the user has deleted is not made again."""
    settings, shown = network.hull_network, networks.surface_of(network)
    if shown is None:
        shown = next((one for one in network.objects if one.get(_MARK)), None)
        if shown is not None:  # of a copy of the network
            settings.surface_object = shown
    pointed = settings.surface_object
    if shown is None and pointed is not None and not pointed.users_collection:
        settings.surface_object, settings.show_surface = None, False
        return None
    if shown is None and settings.show_surface:
        shown = settings.surface_object = _new(network)
    if shown is not None:
        is_hidden = not settings.show_surface
        if shown.hide_viewport != is_hidden:
            shown.hide_viewport = shown.hide_render = is_hidden
        if shown.data.users > 1:
            unrecorded.give_mesh(shown, shown.data.copy())
    return shown


def _new(network):
    mesh = bpy.data.meshes.new(f"{network.name} surface")
    shown = bpy.data.objects.new(mesh.name, mesh)
    shown[_MARK] = True
    shown.hide_select = True
    network.objects.link(shown)
    return shown
