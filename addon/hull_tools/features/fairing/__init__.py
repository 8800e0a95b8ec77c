# SPDX-License-Identifier: GPL-3.0-or-later
"""Chosen control points moved so that the surface is fair, within a deviation."""
