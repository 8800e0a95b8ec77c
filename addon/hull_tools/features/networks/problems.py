# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with a network, and where."""

from dataclasses import dataclass, field

import numpy as np

from ...bridge.objects import networks


@dataclass(frozen=True, eq=False)
class Problem:
    """text: a sentence with place and remedy; curves: names of the objects concerned; places
    (k, 3) in the world, Blender's units. is_note: nothing has to be done about it. is_fatal: while
    it lasts nothing is joined."""

    text: str
    curves: tuple = ()
    places: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))
    is_note: bool = False
    is_fatal: bool = False


def select(view_layer, network, problem):
    """Selects the curves of a problem, and no others; returns its place (3,), None without one.
    ValueError where none of the curves is seen."""
    objects = [network.objects.get(name) for name in problem.curves]
    objects = [one for one in objects if one is not None and one.name in view_layer.objects]
    if problem.curves and not any(one.visible_get(view_layer=view_layer) for one in objects):
        raise ValueError("The curves concerned are hidden: show them first (Alt H)")
    for obj in view_layer.objects:
        obj.select_set(obj in objects, view_layer=view_layer)
    if objects:
        view_layer.objects.active = objects[0]
    if len(problem.places):
        return np.asarray(problem.places[0])
    return _middle(objects)


def _middle(objects):
    if not objects:
        return None
    corners = [obj.matrix_world.translation for obj in objects]
    return np.mean([np.array(one) for one in corners], axis=0)


def numbered(network, state, number):
    """A Problem by its number in the list; ValueError where there is none."""
    if state is None or not 0 <= number < len(state.problems):
        raise ValueError("This problem is there no longer")
    if not networks.is_network(network):
        raise ValueError("Select a curve of a network first")
    return state.problems[number]
