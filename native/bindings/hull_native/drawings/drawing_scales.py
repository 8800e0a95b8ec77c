# SPDX-License-Identifier: GPL-3.0-or-later
"""Scales of drawings, 1 to a round number."""

_ROUND = (1, 1.25, 1.5, 2, 2.5, 3, 4, 5, 7.5)


def scales(first, end):
    """The denominators from 10^first to below 10^end, rising."""
    return [f * 10.0**n for n in range(first, end) for f in _ROUND]
