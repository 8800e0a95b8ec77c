# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that were kept under a name, and one hull beside another: ghost, differences, distances."""
