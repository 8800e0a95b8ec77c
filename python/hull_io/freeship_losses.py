# SPDX-License-Identifier: GPL-3.0-or-later
"""What a FREE!ship file does not hold of a hull, and what FREE!ship takes otherwise: sentences."""

import numpy as np

from .freeship_points import irregular_knuckles
from .hull_data import Kept
from .ship_data import Afloat, Resistance
from .wanted import Targets

# Rounding of control points, in m, that is worth a word.
_SEEN_ROUNDING = 1e-5


def losses(data, scale, lowest, replaced_letters):
    """Sentences for the user. data: a HullData with points in the file's unit of `scale` m; lowest:
    z of the shell's lowest point, m; replaced_letters: of texts, that the file's code page lacks.
    """
    return [
        *_of_the_surface(data),
        *_of_numbers(data, scale, lowest),
        *_not_kept(data),
        *_of_texts(replaced_letters),
    ]


def _of_the_surface(data):
    triangles = sum(1 for face in data.faces if len(face) == 3)
    if triangles:
        yield (
            f"FREE!ship subdivides triangles by other rules, so its surface beside {triangles} of "
            "them is not the same."
        )
    knuckles = irregular_knuckles(data) if data.scheme == "biermann" else []
    if knuckles:
        yield (
            f"FREE!ship does not know Biermann's rules, so its surface beside {len(knuckles)} "
            "irregular points of knuckles and borders is not the same."
        )
    if not data.half:
        yield (
            "Both sides are in layers that are not symmetric; FREE!ship's tools expect the port "
            "half alone."
        )


def _of_numbers(data, scale, lowest):
    rounded = data.points.astype(np.float32).astype(np.float64)
    off = scale * float(np.abs(rounded - data.points).max())
    if off > _SEEN_ROUNDING:
        yield f"Points are rounded to single precision, by up to {1e3 * off:.3g} mm."
    given = data.particulars
    missing = [
        word
        for word, value in (
            ("length", given.length_pp),
            ("beam", given.beam),
            ("draft", given.draft),
        )
        if not value
    ]
    if missing:
        yield (
            f"The {' and the '.join(missing)} of the project is not given, so FREE!ship takes its "
            "main dimensions as not set and computes no hydrostatics."
        )
    elif given.draft <= lowest:
        yield "The draft is below the lowest point, so FREE!ship takes it as not set."
    elif abs(lowest) > 1e-6 * scale * float(np.ptp(data.points, axis=0).max()):
        yield (
            f"FREE!ship counts the draft from the lowest point, at z = {lowest:.4g} m: it is "
            f"{given.draft - lowest:.4g} m there."
        )


def _not_kept(data):
    parts = (
        ("the depth", data.particulars.depth),
        ("the marked deck edge", data.deck_edge),
        ("flats", data.flats),
        ("developable regions", data.developables),
        ("points kept in planes", data.kept != Kept()),
        ("tied points", data.ties),
        ("groups of points", data.groups),
        ("names of control curves", data.curves),
        ("load cases", data.load_cases),
        ("the load", _is_given(data.load)),
        ("trim and heel", data.afloat != Afloat()),
        ("weights beside the plating", data.weights.items),
        ("openings", data.downflooding_points),
        ("wind areas", data.wind),
        ("settings of the resistance", data.resistance != Resistance()),
        ("targets", data.targets != Targets()),
        ("the wanted area curve", data.area_target),
        ("fields", data.fields),
        ("appendages", data.appendages),
        ("seams of plates", data.plating),
        ("diagonals", data.lines and data.lines.diagonals.strip()),
        ("planes that the hull is cut by", data.lines and data.lines.planes),
        ("variants", data.variants),
    )
    names = [name for name, is_there in parts if is_there]
    if names:
        yield f"Not in FREE!ship's files: {', '.join(names)}. Keep a hull file beside it."


def _is_given(load):
    """Whether somebody gave it."""
    return load.mass_t is not None or load.lcg is not None or (load.kg and not load.kg_is_guess)


def _of_texts(replaced):
    if replaced:
        yield (
            f"{replaced} letters of names are not in the code page of FREE!ship's files; there are "
            "question marks for them."
        )
