# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that tasks were begun of: what came of a task is written only to a hull that is as it was
then."""

from ...bridge.blender import units
from ...bridge.objects import hull_mesh, hull_objects
from . import hull_state


class AsItWas:
    """A hull as it is now in a scene, of which a task begins; again: what to do where it is another
    later, as "fit it again"."""

    def __init__(self, obj, scene, again):
        self.state = hull_state.state_of(obj)
        self._key, self._again = _key_of(obj, scene), again

    def checked(self, scene):
        """The hull; ValueError where it is not there any more, or its surface is another."""
        obj = hull_state.hull_with(self.state, scene)
        if not hull_objects.is_hull(obj) or _key_of(obj, scene) != self._key:
            raise ValueError(f"The hull was changed meanwhile, and stays as it is: {self._again}")
        return obj


def _key_of(obj, scene):
    found = hull_mesh.read(obj)
    return found.topology_key, found.points_digest, units.metres_per_unit(scene)
