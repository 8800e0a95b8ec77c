# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that a vessel has what its list of features tells of.

A check is a function of a Form that asserts what makes such a feature: by the tags of the mesh, and
by the exact surface. Its limits are those without which one would not call it by that name, as
parts of the ship's length, beam and draft. table.py says which check is whose; spoils.py takes
features away.
"""
