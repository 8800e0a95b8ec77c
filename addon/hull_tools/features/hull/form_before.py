# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface that a hull had before its form was last changed as a whole: by that it is told which
marks the change made."""

from dataclasses import dataclass

from ...bridge.objects import hull_mesh
from . import hull_state


@dataclass
class FormBefore:
    """surface: a hull_native.LimitSurface of its own, or None; topology_key: as hull_mesh's
    HullMesh has it."""

    surface: object = None
    topology_key: object = None


def keep(obj, surface):
    """The form of a hull is about to be changed from a surface of its own."""
    kept = hull_state.state_of(obj).of(FormBefore)
    kept.surface, kept.topology_key = surface, hull_mesh.read(obj).topology_key


def is_known(obj):
    state = hull_state.state_of(obj)
    return state is not None and state.of(FormBefore).surface is not None


def of_hull(obj):
    """The surface before; ValueError where there is none by which the hull as it is can be
    judged."""
    if not is_known(obj):
        raise ValueError("Nothing is known of the hull's form before: transform it first")
    kept = hull_state.state_of(obj).of(FormBefore)
    if kept.topology_key != hull_mesh.read(obj).topology_key:
        raise ValueError(
            "The mesh itself was changed since the transformation, not its points alone: count "
            "marks without comparing"
        )
    return kept.surface
