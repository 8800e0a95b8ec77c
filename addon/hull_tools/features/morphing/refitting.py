# SPDX-License-Identifier: GPL-3.0-or-later
"""Parents of a hull fitted again as they are now, with pairs of lines as they were corrected."""

from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_objects
from ..hull import hull_state
from . import making, pairs, parents


class Refitting(making.Morphing):
    """The task of fitting the parents of a hull of a family again."""

    def __init__(self, obj, scene):
        morph = obj.hull.morph
        _check_all_there(morph)
        hulls = [entry.source for entry in morph.parents]
        super().__init__(obj, hulls, morph.layout_source, scene, *pairs.corrections(morph))

    def write(self, scene):
        """Gives the hull its new parents; its weights stay. ValueError where it, or a parent, was
        deleted meanwhile."""
        obj = hull_state.hull_with(self.state, scene)
        if not hull_objects.is_hull(obj):
            raise ValueError("The hull was changed meanwhile, and stays as it is: pair again")
        if obj.data.is_editmode:
            raise ValueError("Leave edit mode first (Tab), and pair again")
        check_single_user(obj.data)
        return self.rewrite(obj, scene)


def _check_all_there(morph):
    for name, source in [
        *((entry.name, entry.source) for entry in morph.parents),
        (morph.layout_name, morph.layout_source),
    ]:
        if not parents.is_there(source):
            raise ValueError(
                f'"{name}" was deleted and cannot be fitted again: the family stays as it is'
            )
