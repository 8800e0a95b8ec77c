# SPDX-License-Identifier: GPL-3.0-or-later
"""The part of a FREE!ship file that makes a hull, as it stands there."""

from dataclasses import dataclass

import numpy as np


@dataclass
class StoredLayer:
    """A layer as the file has it; colour is 0xBBGGRR. Of its plating density in t/m3 and thickness
    in mm, where the model is imperial in lb/ft3 and inches."""

    name: str
    colour: int
    symmetric: bool
    in_hydrostatics: bool
    developable: bool = False
    density: float = 0.0
    thickness: float = 0.0


@dataclass
class Model:
    """The part of a file that makes a hull, in the file's own units, checked but not interpreted.

    levels: how often FREE!ship subdivides the mesh. dimensions_set: whether somebody gave length,
    beam and draft; the draft is from the lowest point of the layers in hydrostatics. points: (n, 3)
    float64. corners, locked: indices of points that are tagged so. edges: (a, b, crease). curves:
    the control curves, lists of points that follow one another.
    """

    name: str
    levels: int
    length: float
    beam: float
    draft: float
    dimensions_set: bool
    water_density: float
    imperial: bool
    layers: list
    points: np.ndarray
    corners: list
    locked: list
    edges: list
    curves: list
    faces: list
    face_layers: list
