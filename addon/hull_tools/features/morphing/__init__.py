# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that are members of a family between parents: made, moved by weights, taken out of it."""
