# SPDX-License-Identifier: GPL-3.0-or-later
"""What a FREE!ship model means as a hull: metres, shell, halves, tags, faces turned outwards."""

import math

import numpy as np

from .cleanup import clean_faces, creases_of_faces, listed
from .hull_data import HullData, Layer, Particulars
from .limits import LONGEST_DIMENSION
from .mirror import mirror_faces
from .orientation import turn_outwards

FOOT = 0.3048
POUND_PER_CUBIC_FOOT = 0.45359237e-3 / FOOT**3
LONG_TON_PER_CUBIC_FOOT = 2240 * POUND_PER_CUBIC_FOOT


def water_density_in_t_per_m3(stored, imperial):
    """Density in t/m3; 0 when the stored number can't be a liquid's.

    Metric files store t/m3. The unit of imperial ones is not stated, but the usual ones are so far
    apart that the number tells: pounds per cubic foot (sea water 64), t/m3 (1.025), long tons per
    cubic foot (1/35).
    """
    units = [1.0]
    if imperial:
        units = [POUND_PER_CUBIC_FOOT, 1.0, LONG_TON_PER_CUBIC_FOOT]
    for unit in units:
        if 0.5 <= stored * unit <= 2.0:
            return stored * unit
    return 0.0


def hull_from_model(model, source):
    """The HullData of a `freeship.Model`."""
    scale = FOOT if model.imperial else 1.0
    layers = [
        Layer(_label(layer.name) or f"Layer {index}", layer.in_hydrostatics, _colour(layer.colour))
        for index, layer in enumerate(model.layers)
    ]
    faces, face_layers, notes = clean_faces(model.faces, model.face_layers, layers)
    data = HullData(
        name=_label(model.name),
        points=model.points * scale,
        faces=faces,
        creases=creases_of_faces((edge[:2] for edge in model.edges if edge[2]), faces),
        corners=model.corners,
        layers=layers,
        face_layers=face_layers,
        particulars=_particulars(model, scale, notes),
        units="ft" if model.imperial else "m",
        source=source,
        notes=notes,
    )
    _settle_symmetry(data, [layer.symmetric for layer in model.layers])
    _turn_faces(data)
    return data


def _label(text):
    """A text as a name on screen: printable, one line, of bounded length."""
    return " ".join("".join(c if c.isprintable() else " " for c in text[:200]).split())


def _as_typed(value):
    """A single-precision number as the decimal that was typed: 5.3, not 5.300000190734863."""
    return float(str(np.float32(value)))


def _colour(bgr):
    return tuple((bgr >> shift & 0xFF) / 255.0 for shift in (0, 8, 16))


def _particulars(model, scale, notes):
    """Main dimensions in metres; what can't be one is 0 (not given) and noted."""
    lengths = {}
    for name, value in (
        ("length_pp", model.length),
        ("beam", model.beam),
        ("draft", model.draft),
    ):
        sane = math.isfinite(value) and 0.0 <= value * scale <= LONGEST_DIMENSION
        lengths[name] = _as_typed(value) * scale if sane else 0.0
        if not sane:
            notes.append(f"The file's {name} of {value:g} was taken as not given.")
    density = water_density_in_t_per_m3(_as_typed(model.water_density), model.imperial)
    if density == 0.0:
        notes.append(f"The file's water density of {model.water_density:g} was taken as not given.")
    return Particulars(**lengths, water_density=density)


def _settle_symmetry(data, symmetric):
    """Set `half`. The shell's layers decide: faces of a symmetric layer are mirrored in y.

    Where only some of the shell's layers are symmetric no half can stand for the hull, so the
    other side of the symmetric ones is added as faces of its own.
    """
    in_shell = [data.layers[layer].in_hydrostatics for layer in data.face_layers]
    if not any(in_shell):
        in_shell = [True] * len(data.faces)
    shell_layers = {layer for layer, shell in zip(data.face_layers, in_shell) if shell}
    kinds = {symmetric[layer] for layer in shell_layers}
    data.half = kinds == {True}
    if kinds == {True, False}:
        lone = [data.layers[layer].name for layer in sorted(shell_layers) if not symmetric[layer]]
        mirror_faces(
            data, [index for index, layer in enumerate(data.face_layers) if symmetric[layer]]
        )
        data.notes.append(
            f"Not symmetric in the file: layer {listed(lone)}; of the others both sides were made."
        )


def _turn_faces(data):
    """Turn the shell, and the other faces by themselves: a deck must not turn the hull below."""
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
    if 0 < count < len(data.faces):
        data.notes.append(f"{count} of {len(data.faces)} faces were turned to face outwards.")
