# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to other main dimensions, with all that belongs to them."""
