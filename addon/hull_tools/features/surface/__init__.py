# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface as an object to look at: its mesh, exact normals, colours, materials."""
