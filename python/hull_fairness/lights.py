# SPDX-License-Identifier: GPL-3.0-or-later
"""The lights that a hull mirrors in its reflection pictures, and where they are seen from."""

# Pairs of a light and a dark band all around the ship, along its length.
BANDS = 32
# Degrees: where the eye is, from the bow to starboard, and above the hull.
VIEWS = {"bow": (-42.0, -14.0), "stern": (-138.0, -14.0)}
