# SPDX-License-Identifier: GPL-3.0-or-later
"""The published surfaces that samples were fitted to, as triangles at full scale, in m.

They lie beside the project, in ../shared/hulls/reference, and are no part of it.
"""

import gzip
import tempfile
from pathlib import Path

import numpy as np
import vessels
from hull_io import read_stl
from hull_io.triangles import spread_points

FOLDER = vessels.ROOT.parent / "shared" / "hulls" / "reference"
# File and metres per unit of it.
FILES = {
    "container_ship": ("DTC-scaled.stl.gz", 59.407),
    "bulk_carrier": ("kvlcc2_lq.stl", 1.0),
}


def triangles(name):
    """(n, 3, 3): the corners of the triangles of a sample's target."""
    file_name, scale = FILES[name]
    path = FOLDER / file_name
    with tempfile.TemporaryDirectory() as folder:
        if path.suffix == ".gz":
            plain = Path(folder) / path.stem
            plain.write_bytes(gzip.decompress(path.read_bytes()))
            path = plain
        points, corners = read_stl(path)
    return scale * points[corners]


def samples(corners, count):
    """`count` points or a few less, evenly by area, with the triangles' normals (k, 3)."""
    return spread_points(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), count)


def section(corners, axis, place):
    """Segments (k, 2, 3) where the plane across an axis (0, 1, 2) meets the triangles."""
    heights = corners[:, :, axis] - place
    above = heights > 0.0
    count = above.sum(axis=1)
    met = (count == 1) | (count == 2)
    corners, heights, above = corners[met], heights[met], above[met]
    alone = np.where(count[met] == 1, above.argmax(axis=1), above.argmin(axis=1))
    row = np.arange(len(corners))
    ends = []
    for step in (1, 2):
        other = (alone + step) % 3
        h, k = heights[row, alone], heights[row, other]
        part = (h / (h - k))[:, None]
        ends.append(corners[row, alone] * (1.0 - part) + corners[row, other] * part)
    return np.stack(ends, axis=1)
