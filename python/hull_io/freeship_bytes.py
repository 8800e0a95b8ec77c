# SPDX-License-Identifier: GPL-3.0-or-later
"""The values of a FREE!ship file as bytes: little-endian, packed, texts in the legacy code page."""

import struct

from .cursors import CODE_PAGE


class FreeshipBytes:
    """Values in the order of the file. replaced: how many letters of texts the code page lacks."""

    def __init__(self):
        self._parts = []
        self.replaced = 0

    def record(self, layout, *values):
        """layout: of struct, as BinaryCursor.record reads it."""
        self._parts.append(struct.pack("<" + layout, *values))

    def text(self, text):
        """Its length, then its bytes; "?" for a letter that the code page lacks."""
        found = text.encode(CODE_PAGE, errors="replace")
        self.replaced += sum(1 for a, b in zip(text, found.decode(CODE_PAGE)) if a != b)
        self.record("i", len(found))
        self._parts.append(found)

    def content(self):
        return b"".join(self._parts)
