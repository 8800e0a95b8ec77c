# SPDX-License-Identifier: GPL-3.0-or-later
"""A sectional area curve that is wanted: where it comes from, drawn beside the hull's own, dragged
by its handles, and the hull brought to it."""
