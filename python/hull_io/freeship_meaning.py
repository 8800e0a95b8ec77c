# SPDX-License-Identifier: GPL-3.0-or-later
"""What a FREE!ship model means as a hull: metres, shell, halves, tags, faces turned outwards."""

import math
from dataclasses import replace

import numpy as np

from .cleanup import clean_faces, creases_of_faces, listed
from .freeship_curves import row_edges
from .freeship_plating import as_typed, give_plating
from .freeship_units import FOOT, POUND_PER_CUBIC_FOOT
from .hull_data import HullData, Layer, Particulars
from .hull_developables import between_knuckles
from .limits import LONGEST_DIMENSION
from .mending import mend
from .mirror import mirror_faces, put_on_centre_plane
from .shell import shell_face_indices
from .subdivision import subdivided

LONG_TON_PER_CUBIC_FOOT = 2240 * 0.45359237e-3 / FOOT**3

# A keel nearer to the base line than this part of the hull's size is on it.
ON_BASE = 1e-5


def water_density_in_t_per_m3(stored, imperial):
    """Density in t/m3; 0 when the stored number can't be a liquid's.

    Metric files store t/m3. The unit of imperial ones is not stated, but the usual ones are so far
    apart that the number tells: FREE!ship's pounds per cubic foot (sea water 65), t/m3 (1.025),
    long tons per cubic foot (1/35).
    """
    units = [1.0]
    if imperial:
        units = [POUND_PER_CUBIC_FOOT, 1.0, LONG_TON_PER_CUBIC_FOOT]
    for unit in units:
        if 0.5 <= stored * unit <= 2.0:
            return stored * unit
    return 0.0


def hull_from_model(model, source):
    """The HullData of a `freeship_model.Model`."""
    scale = FOOT if model.imperial else 1.0
    layers = [
        Layer(_label(layer.name) or f"Layer {index}", layer.in_hydrostatics, _colour(layer.colour))
        for index, layer in enumerate(model.layers)
    ]
    faces, face_layers, notes = clean_faces(model.faces, model.face_layers, layers)
    give_plating(layers, model, notes)
    data = HullData(
        name=_label(model.name),
        points=model.points * scale,
        faces=faces,
        creases=creases_of_faces((edge[:2] for edge in model.edges if edge[2]), faces),
        corners=model.corners,
        locked=model.locked,
        shown_rows=row_edges(model.curves, faces, notes),
        layers=layers,
        face_layers=face_layers,
        particulars=_particulars(model, scale, notes),
        units="ft" if model.imperial else "m",
        source=source,
        notes=notes,
    )
    _settle_symmetry(data, [layer.symmetric for layer in model.layers])
    mend(data)
    flagged = {index for index, layer in enumerate(model.layers) if layer.developable}
    of_layers = [face for face, layer in enumerate(data.face_layers) if layer in flagged]
    data.developables = between_knuckles(data, of_layers)
    _settle_draft(data, model.levels)
    return data


def _label(text):
    """A text as a name on screen: printable, one line, of bounded length."""
    return " ".join("".join(c if c.isprintable() else " " for c in text[:200]).split())


def _colour(bgr):
    return tuple((bgr >> shift & 0xFF) / 255.0 for shift in (0, 8, 16))


def _particulars(model, scale, notes):
    """Main dimensions in metres; what can't be one is 0 (not given) and noted."""
    lengths = {}
    if not model.dimensions_set:
        notes.append(
            f"Nobody set the file's main dimensions ({model.length:g}, {model.beam:g}, "
            f"{model.draft:g}): they were taken as not given."
        )
        model = replace(model, length=0.0, beam=0.0, draft=0.0)
    for name, value in (
        ("length_pp", model.length),
        ("beam", model.beam),
        ("draft", model.draft),
    ):
        sane = math.isfinite(value) and 0.0 <= value * scale <= LONGEST_DIMENSION
        lengths[name] = as_typed(value) * scale if sane else 0.0
        if not sane:
            notes.append(f"The file's {name} of {value:g} was taken as not given.")
    density = water_density_in_t_per_m3(as_typed(model.water_density), model.imperial)
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
    if data.half and (moved := put_on_centre_plane(data)):
        data.notes.append(f"Put on the centre plane, off by rounding in the file: {moved} points.")
    if kinds == {True, False}:
        lone = [data.layers[layer].name for layer in sorted(shell_layers) if not symmetric[layer]]
        mirror_faces(
            data, [index for index, layer in enumerate(data.face_layers) if symmetric[layer]]
        )
        data.notes.append(
            f"Not symmetric in the file: layer {listed(lone)}; of the others both sides were made."
        )


def _settle_draft(data, levels):
    """FREE!ship's draft is from the lowest point of the shell, as subdivided there, ours from
    z = 0. Where the water would lie below that the hull is moved up."""
    shell = [data.faces[index] for index in shell_face_indices(data)] or data.faces
    stored = data.particulars.draft
    if not shell or stored == 0.0:
        return
    edges = creases_of_faces(data.creases, shell)
    lowest = float(subdivided(data.points, shell, edges, data.corners, levels)[:, 2].min())
    size = float(np.ptp(data.points, axis=0).max())
    if abs(lowest) <= ON_BASE * size:
        return
    where = f"The file's draft of {stored:.4g} m is from the lowest point, at z = {lowest:.4g} m"
    if stored + lowest > ON_BASE * size:
        data.particulars.draft = stored + lowest
        data.notes.append(f"{where}: the water lies at z = {stored + lowest:.4g} m.")
    else:
        data.points[:, 2] -= lowest
        data.notes.append(f"{where}: the hull was moved up, to stand on z = 0.")
