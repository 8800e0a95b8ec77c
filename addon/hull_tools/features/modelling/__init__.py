# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools on points and faces: pulling, bilges, flats, halves, irregular points."""
