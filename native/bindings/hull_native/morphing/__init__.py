# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls of different layouts made parents of one family."""
