# SPDX-License-Identifier: GPL-3.0-or-later
"""The other surface that the surface object's colours are distances from."""

from dataclasses import dataclass


@dataclass(frozen=True, eq=False)
class OtherSurface:
    """key: equal for equal surfaces. field: its hull_native.DistanceField, None where there is none
    as `status` says."""

    key: tuple
    field: object
    status: str = ""
