# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that other programs made, mended to what a surface can be made of.

Each function changes a HullData in place, and adds a sentence to its notes where it changed
anything: nothing is done unseen.
"""

from dataclasses import fields

import numpy as np

from . import scaling, sides
from .cleanup import listed
from .hull_data import KEPT_IN
from .hull_ties import renumbered
from .moving import OtherSide
from .orientation import turn_outwards
from .shell import shell_face_indices
from .splitting import split, standing_parts


def mend(data):
    """Parts the shell where it is no one surface, brings a half hull to port, turns the faces."""
    part_shell(data)
    bring_to_port(data)
    turn_faces(data)


def part_shell(data):
    """Splits the points and edges where faces of the shell join without making one surface."""
    shell = shell_face_indices(data)
    made = split(data.points, data.faces, data.face_layers, shell)
    if len(made.origins) == len(data.points):
        return
    standing = standing_parts(data.points, data.faces, data.face_layers, shell)
    data.notes.append(_parted(data, made, standing))
    data.points = data.points[made.origins]
    data.faces = made.faces
    data.creases = made.carried_edges(data.creases)
    data.deck_edge = made.carried_edges(data.deck_edge)
    data.shown_rows = made.carried_edges(data.shown_rows)
    for curve in data.curves:
        curve.edges = made.carried_edges(curve.edges)
    data.corners = made.carried_points(data.corners)
    data.locked = made.carried_points(data.locked)
    for name in KEPT_IN:
        setattr(data.kept, name, made.carried_points(getattr(data.kept, name)))
    for group in data.groups:
        group.points = made.carried_points(group.points)
    first = {}
    for index, origin in enumerate(np.asarray(made.origins).tolist()):
        first.setdefault(origin, index)
    data.ties = renumbered(data.ties, first)


def _parted(data, made, standing):
    places = [f"point {listed(made.points)}"] if made.points else []
    if made.edges:
        places.append(f"edge {listed(['–'.join(map(str, edge)) for edge in made.edges])}")
    note = (
        f"Faces that joined without making one surface were split, at {' and '.join(places)} of "
        "the file"
    )
    if standing:
        layers = sorted(
            {data.layers[data.face_layers[index]].name for p in standing for index in p}
        )
        note += (
            f"; {sum(map(len, standing))} faces stand on others (layer {listed(layers)}): Set "
            "Aside takes them out of the shell"
        )
    return note + "."


def bring_to_port(data):
    """Mirrors a half hull whose shell lies to starboard (y < 0), and all that lies in space with
    it; variants stay, which are hulls of their own."""
    if not lies_to_starboard(data):
        return
    moved = scaling.follow(data, OtherSide())
    for name in (field.name for field in fields(data)):
        setattr(data, name, getattr(moved, name))
    data.faces = [face[::-1] for face in data.faces]
    data.notes.append("The half hull lay to starboard (y < 0): it was mirrored to port.")


def lies_to_starboard(data):
    """Whether the shell of a half hull is on the wrong side of the centre plane."""
    used = sorted({point for index in shell_face_indices(data) for point in data.faces[index]})
    if not data.half or not used:
        return False
    return sides.lies_to_starboard(data.points[used, 1])


def turn_faces(data):
    """Turns the shell, and the other faces by themselves: a deck must not turn the hull below."""
    count = 0
    for part in (True, False):
        indices = [
            index
            for index, layer in enumerate(data.face_layers)
            if data.layers[layer].in_hydrostatics is part
        ]
        turned, turned_count = turn_outwards(
            data.points, [data.faces[index] for index in indices], data.half
        )
        for index, face in zip(indices, turned):
            data.faces[index] = face
        count += turned_count
    if count:
        which = "All" if count == len(data.faces) else f"{count} of"
        data.notes.append(f"{which} {len(data.faces)} faces were turned to face outwards.")
