# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a 3D view looks."""


def look_at(view, place):
    """Brings a place into the middle of a RegionView3D, which leaves a camera's view for that; None
    of it where there is no view."""
    if view is None:
        return
    if view.view_perspective == "CAMERA":
        view.view_perspective = "PERSP"
    view.view_location = place
