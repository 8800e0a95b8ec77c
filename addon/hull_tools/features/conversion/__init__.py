# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as B-spline patches, and how far they are from it."""
