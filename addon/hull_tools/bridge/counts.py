# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts in sentences."""


def counted(count, noun):
    """ "1 point", "2 points": the noun, or the words that end with it, has a plural with s."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def counted_are(count, noun):
    """ "1 point is", "2 points are"."""
    return f"{counted(count, noun)} {'is' if count == 1 else 'are'}"
