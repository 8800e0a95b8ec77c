# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls brought to other dimensions and numbers: parts that keep their shape, surfaces mapped to
where they belong, breadths that are held."""
