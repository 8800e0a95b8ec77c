# SPDX-License-Identifier: GPL-3.0-or-later
"""Zip files that are the same bytes for the same contents: names sorted, dates fixed."""

import os
import zipfile

_OLDEST_DATE = (1980, 1, 1, 0, 0, 0)
_REGULAR_FILE = 0o100000


def write_zip(target, contents):
    """Writes pairs of names and bytes; the zip is there whole or not at all."""
    target.parent.mkdir(parents=True, exist_ok=True)
    unfinished = target.with_suffix(".part")
    with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as file:
        for name, data in sorted(contents):
            entry = zipfile.ZipInfo(name, _OLDEST_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            mode = 0o755 if name.endswith(".so") else 0o644
            entry.external_attr = (_REGULAR_FILE | mode) << 16
            file.writestr(entry, data)
    os.replace(unfinished, target)
