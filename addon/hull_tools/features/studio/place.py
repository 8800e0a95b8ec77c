# SPDX-License-Identifier: GPL-3.0-or-later
"""What the parts of a studio have in common: the hull in numbers, and what is made for it."""

from dataclasses import dataclass

import bpy
import numpy as np

from ...bridge.blender import units
from ...bridge.objects import shown_objects

# On all that a studio has made, so that what a user adds to its collection can be told from it.
MARK = "hull_studio"


@dataclass(frozen=True)
class Place:
    """A hull and its studio's collection. points: the surface's, both sides, in the hull's
    coordinates and Blender's units, as `draft` and `length`, the greatest extent. draft: 0 for a
    hull that the water does not reach. in_water: whether it floats, as it was set up."""

    hull: object
    scene: object
    collection: object
    points: np.ndarray
    draft: float
    metres_per_unit: float
    in_water: bool

    @property
    def surface(self):
        """The mesh that shows the hull's surface, both sides."""
        return self.hull.hull.surface_object.data

    @property
    def low(self):
        return self.points.min(axis=0)

    @property
    def high(self):
        return self.points.max(axis=0)

    @property
    def length(self):
        return float((self.high - self.low).max())

    @property
    def centre(self):
        return 0.5 * (self.low + self.high)

    def add(self, name, data, location=(0.0, 0.0, 0.0)):
        """A new object of the studio, which goes with the hull."""
        obj = bpy.data.objects.new(name, data)
        obj[MARK] = name
        obj.parent = self.hull
        obj.location = location
        self.collection.objects.link(obj)
        return obj

    def find(self, name):
        """The object that was added by this name, whatever it is called now; None if it is gone."""
        return next((obj for obj in self.collection.objects if obj.get(MARK) == name), None)

    def add_scenery(self, name, data, location=(0.0, 0.0, 0.0)):
        """The same of one that is there to be seen and lit, and not to be picked."""
        obj = self.add(name, data, location)
        obj.hide_select = True
        return obj


def find(scene):
    """The collection of the scene's studio; None when it has none."""
    for collection in scene.collection.children_recursive:
        if collection.get(MARK) is not None and collection.library is None:
            return collection
    return None


def others(scene):
    """Pairs (scene, its studio's collection) of all other scenes that have one."""
    own, found = find(scene), ((other, find(other)) for other in bpy.data.scenes)
    return [pair for pair in found if pair[1] not in (None, own)]


def hull_of(scene):
    """The hull that the scene's studio is for; None when there is no studio, or no such hull."""
    collection = find(scene)
    return None if collection is None else collection[MARK].get("hull")


def place_of(hull, scene):
    """The Place of a hull and its studio, as the hull is shown now."""
    collection = find(scene)
    points = points_of(shown_objects.surface_of(hull).data)
    draft = units.as_typed(hull.hull.draft)
    draft = draft if draft > points[:, 2].min() else 0.0
    in_water = bool(collection[MARK]["in water"]) and draft > 0.0
    scale = units.metres_per_unit(scene)
    return Place(hull, scene, collection, points, draft, scale, in_water)


def points_of(mesh):
    """(n, 3) of a mesh, in its coordinates."""
    points = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", points.reshape(-1))
    return points.astype(np.float64)


def new_material(name, colour, see_through=False):
    """A material of a studio; `colour` as the solid view shows it."""
    material = bpy.data.materials.new(name)
    material[MARK] = True
    material.diffuse_color = colour if len(colour) == 4 else (*colour, 1.0)
    return material
