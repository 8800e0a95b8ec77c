# SPDX-License-Identifier: GPL-3.0-or-later
"""Stability: righting levers, cross curves, load cases, criteria."""
