# SPDX-License-Identifier: GPL-3.0-or-later
"""The published surfaces that samples were fitted to, as triangles at full scale, in m.

They lie beside the project, in ../shared/hulls/reference, and are no part of it.
"""

import gzip
import tempfile
from pathlib import Path

import numpy as np
import vessels

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
        points, corners = vessels.hull_io.read_stl(path)
    return scale * points[corners]


def samples(corners, count, seed=1):
    """Points (count, 3) evenly by area, with the triangles' normals (count, 3)."""
    rng = np.random.default_rng(seed)
    crosses = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(crosses, axis=1)
    chosen = rng.choice(len(corners), count, p=areas / areas.sum())
    a, b = rng.random((2, count))
    a, b = np.where(a + b > 1.0, 1.0 - a, a), np.where(a + b > 1.0, 1.0 - b, b)
    first, second, third = np.moveaxis(corners[chosen], 1, 0)
    points = first + a[:, None] * (second - first) + b[:, None] * (third - first)
    return points, crosses[chosen] / areas[chosen, None]


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
