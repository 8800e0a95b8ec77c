# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender itself: its versions, units of the scene, what the user prefers."""
