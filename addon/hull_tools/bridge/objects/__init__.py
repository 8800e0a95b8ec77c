# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's objects: which is the hull, which shows its surface, what became of copies."""
