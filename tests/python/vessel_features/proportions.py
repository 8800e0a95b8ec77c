# SPDX-License-Identifier: GPL-3.0-or-later
"""What is told by numbers: block, centre of buoyancy, points of the mesh."""

import numpy as np


def buoyancy_aft(form):
    """The centre of buoyancy is abaft of amidships."""
    lcb = form.afloat.lcb_percent
    assert lcb < 0.0, f"the centre of buoyancy is {lcb:.2f} % forward"


def block(form, least, most):
    """Block coefficient on length between perpendiculars, beam and draft."""
    found = form.afloat.project.block
    assert least <= found <= most, f"block coefficient {found:.3f}"


def sections_at_shoulder(form, first, last, least):
    """So many points of the keel between two x."""
    lines = [line for line in form.lines if line.kind == "border"]
    vertices = np.unique(np.concatenate([line.vertices for line in lines]))
    x, y, z = form.mesh.points[vertices].T
    count = ((y == 0.0) & (z < form.given.draft) & (x >= first) & (x <= last)).sum()
    assert count >= least, f"{count} sections between x = {first} and {last} m"
