# SPDX-License-Identifier: GPL-3.0-or-later
"""The shells of sample hulls with their seams and butts."""

import hull_native as hn
from production_hulls import body_of


def coaster_shell(tolerance=1e-3):
    """(surface, curves): strakes of 2.4 m, plates of 12 m, the transom."""
    _, body = body_of("coaster")
    _, seams = hn.shell_seams(body.surface, strake=2.4, plate_length=12.0, tolerance=tolerance)
    return body.surface, seams


def planing_boat_shell(tolerance=1e-4):
    """(surface, curves): the knuckles, and two butts."""
    _, body = body_of("planing_boat")
    surface = body.surface
    curves = hn.HullCurves(surface, tolerance)
    seams = curves.knuckles()
    for x in (4.0, 8.0):
        seams += curves.in_plane(hn.plane_across("x", x), f"Butt {x:g}")
    return surface, seams
