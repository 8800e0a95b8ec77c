# SPDX-License-Identifier: GPL-3.0-or-later
"""The lights that a hull mirrors in its reflection pictures, and where they are seen from."""

from .native import hull_native as hn

# Pairs of a light and a dark band all around the ship, along its length.
BANDS = hn.LIGHT_BANDS
# Degrees: where the eye is, from the bow to port, and above the hull.
VIEWS = hn.LIGHT_VIEWS
