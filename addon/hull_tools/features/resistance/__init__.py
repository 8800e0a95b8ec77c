# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and power of an upright hull over speeds."""
