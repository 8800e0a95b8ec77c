# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections and other lines of the hull, places of the lines plan, the table of offsets."""
