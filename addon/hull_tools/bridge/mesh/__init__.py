# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's meshes as arrays and back: points, faces, creases, marks on edges, what is selected."""
