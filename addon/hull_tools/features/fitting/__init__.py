# SPDX-License-Identifier: GPL-3.0-or-later
"""Control points moved so that the surface meets a given shape."""
