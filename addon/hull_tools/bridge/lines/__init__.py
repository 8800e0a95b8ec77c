# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections and other lines of the hull, their combs, reflection lines, places of the lines plan."""
