# SPDX-License-Identifier: GPL-3.0-or-later
"""What rows of Object.hull.fields say together: settings that count with others only."""

# Bases that are curves.
CURVES = frozenset(("CREASE", "CURVE", "SECTION"))


def becomes_another(field):
    """Whether the shift of a row is that to another curve."""
    return field.base in CURVES and field.role == "MOVE" and field.becomes is not None


def varies(field):
    """Whether what a row wants varies along its base."""
    return field.varies and field.base in CURVES


def goes_along_surface(field):
    """Whether distances of a row are measured along the hull's surface."""
    return field.along_surface and field.base != "PLANE"
