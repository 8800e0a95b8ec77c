# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of a vessel in water: hydrostatics and stability."""

import numpy as np

from .calls import attempt, body_of, native

HEELS = np.radians(np.arange(0.0, 91.0, 10.0))


def hydrostatic_results(vessel):
    body, given = body_of(vessel), vessel.data.particulars
    project = dict(length_pp=given.length_pp, beam=given.beam, design_draft=given.draft)
    for name, (draft, trim, heel) in {
        "design": (1.0, 0.0, 0.0),
        "light": (0.55, 0.01, 0.0),
        "deep": (1.15, -0.008, 0.0),
        "heeled": (1.0, 0.0, 0.2),
        "trimmed and heeled": (0.9, 0.02, -0.35),
    }.items():
        yield f"particulars {name}", attempt(
            native,
            "hydrostatics",
            body,
            draft=draft * given.draft,
            trim=trim,
            heel=heel,
            **project,
        )
    yield "table", native(
        "hydrostatic_table",
        body,
        drafts=list(np.linspace(0.3, 1.2, 4) * given.draft),
        trims=[0.0, 0.01],
        **project,
    )
    yield "upright", native(
        "upright_hydrostatics", vessel.surface, draft=given.draft, mirrored=vessel.data.half
    )
    stations = list(np.linspace(0, 1, 21) * given.length_pp)
    yield "sectional areas", native("section_areas", body, stations, draft=given.draft)
    yield "heeled sectional areas", native(
        "section_areas", body, stations, draft=given.draft, trim=0.01, heel=0.15
    )
    drafts = list(np.linspace(0.2, 1.2, 6) * given.draft)
    yield "bonjean", native("bonjean", body, stations=stations, drafts=drafts)
    yield "immersion", body.immersion([0.1, -0.3, 1.0], 0.9 * given.draft)
    yield "shell", [body.shell_area, body.shell_flux_forms]


def stability_results(vessel):
    body, given = body_of(vessel), vessel.data.particulars
    upright = native("hydrostatics", body, draft=given.draft, length_pp=given.length_pp)
    centre = [upright.lcb, 0.0, upright.km_transverse - 0.06 * given.beam]
    case = dict(mass_t=upright.displacement_t, centre_of_gravity=centre)
    opening = [[0.4 * given.length_pp, sign * 0.3 * given.beam, given.depth] for sign in (-1, 1)]
    yield "levers", attempt(
        native,
        "righting_levers",
        body,
        heels=HEELS,
        downflooding_points=opening,
        area_intervals=[(0.0, 0.5), (0.5, 0.7)],
        **case,
    )
    yield "levers at fixed trim", attempt(
        native, "righting_levers", body, heels=HEELS[:6], free_trim=False, trim=0.005, **case
    )
    yield "cross curves", attempt(
        native,
        "cross_curves",
        body,
        displacements_t=[share * upright.displacement_t for share in (0.6, 1.0)],
        heels=HEELS[1:7],
    )
    yield "criteria", attempt(
        native, "stability_criteria", body, downflooding_points=opening, **case
    )
    moved = [centre[0] - 0.01 * given.length_pp, 0.004 * given.beam, centre[2]]
    yield "equilibrium", attempt(
        native, "equilibrium", body, mass_t=0.9 * upright.displacement_t, centre_of_gravity=moved
    )
    high = [centre[0], 0.0, upright.km_transverse + 0.02 * given.beam]
    yield "angle of loll", attempt(
        native, "equilibrium", body, mass_t=upright.displacement_t, centre_of_gravity=high
    )
