# SPDX-License-Identifier: GPL-3.0-or-later
"""The tags of a control mesh as arrays for the graphics card, in the picture: each part of a place
is from -1 to 1, and what is large in dots stays so whatever the distance.

Edges are drawn as two rails, one on each side, and points as outlines, so that Blender's own edges
and points, and whether they are selected, are still to be seen between them.
"""

import numpy as np

_NEAREST = 1e-6  # of what clipping divides by, relative to the hull's largest


def in_clip(points, to_clip):
    """(n, 4) coordinates that the graphics card clips by, of the points (n, 3)."""
    return np.column_stack([points, np.ones(len(points))]) @ np.asarray(to_clip).T


def segments(clip, edges):
    """(k, 2, 3) places of the parts of the edges (m, 2) that are before the eye; clip as in_clip
    gives it."""
    ends = clip[np.asarray(edges, dtype=np.int64).reshape(-1, 2)]
    depths = ends[:, :, 3]
    nearest = _NEAREST * max(np.abs(clip[:, 3]).max(initial=0.0), _NEAREST)
    is_before = depths > nearest
    ends, depths, is_before = (a[is_before.any(axis=1)] for a in (ends, depths, is_before))
    if not is_before.all():
        share = (nearest - depths[:, 0]) / np.where(is_before.all(axis=1), 1.0, np.ptp(depths, 1))
        share = np.abs(share)[:, None]
        cut = (1.0 - share) * ends[:, 0] + share * ends[:, 1]
        ends = np.where(is_before[:, :, None], ends, cut[:, None])
    return ends[:, :, :3] / ends[:, :, 3:]


def rails(places, distance, viewport):
    """(2 k, 2, 3): segments beside the segments `places`, (k, 2, 3), to both sides, at a distance
    in dots; viewport (width, height) in dots."""
    half = 0.5 * np.asarray(viewport, dtype=np.float64)
    along = (places[:, 1, :2] - places[:, 0, :2]) * half
    lengths = np.linalg.norm(along, axis=1, keepdims=True)
    along = along / np.where(lengths > 0.0, lengths, 1.0)
    aside = np.zeros((len(places), 1, 3))
    aside[:, 0, 0], aside[:, 0, 1] = -along[:, 1], along[:, 0]
    aside[:, :, :2] *= distance / half
    return np.concatenate([places + aside, places - aside])


def places(clip):
    """(places (n, 3), is_seen (n,)) of points; those not seen are anywhere."""
    depths = clip[:, 3:]
    found = clip[:, :3] / np.where(depths > 0.0, depths, 1.0)
    return found, (depths[:, 0] > 0.0) & (np.abs(found) <= 1.0).all(axis=1)


def spacing(clip, viewport):
    """How far points are apart in the picture, about, in dots; infinite where the eye is among
    them. Points that are no numbers, which Blender's operators can leave, are passed over."""
    clip = clip[np.isfinite(clip).all(axis=1)]
    if not len(clip) or clip[:, 3].min() <= 0.0:
        return np.inf
    extent = np.ptp(clip[:, :2] / clip[:, 3:], axis=0) * 0.5 * np.asarray(viewport)
    return float(np.sqrt(extent.prod() / len(clip)))


def _closed(corners):
    """Segments (2 n, 2) around a polygon."""
    corners = np.array(corners, dtype=np.float64)
    return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1).reshape(-1, 2)


def _circle(count=24):
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return np.column_stack([np.cos(angles), np.sin(angles)])


def _pins():
    """From four corners towards a place."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) / np.sqrt(2.0)
    return np.stack([corners, 0.45 * corners], axis=1).reshape(-1, 2)


def _bars():
    """Of each plane that points are kept in a pair of strokes beside a place, as its lines run in
    the body plan: stations upright, waterlines level, buttocks slanted."""
    upright = np.array([(-1.0, -0.45), (-1.0, 0.45), (1.0, -0.45), (1.0, 0.45)])
    slant = np.sqrt(0.5) * np.array([(1.0, 1.0), (-1.0, 1.0)])
    return {"station": upright, "waterline": upright[:, ::-1], "buttock": upright @ slant}


# Segments (2 k, 2) of outlines around a place, for radius 1.
OUTLINES = {
    "square": _closed([(-1, -1), (1, -1), (1, 1), (-1, 1)]),
    "diamond": _closed([(0, -1.4), (1.4, 0), (0, 1.4), (-1.4, 0)]),
    "ring": _closed(_circle()),
    "pins": _pins(),
    **_bars(),
}


def outlines(name, at, radius, viewport):
    """(n k, 3) corners of the segments of one of OUTLINES around the places `at`, (n, 3)."""
    shape = OUTLINES[name] * (2.0 * radius / np.asarray(viewport, dtype=np.float64))
    return _around(at, shape)


def _around(at, shape):
    """(n k, 3) the places of a shape, (k, 2) in the picture, around each of `at`, (n, 3)."""
    corners = np.repeat(at[:, None, :], len(shape), axis=1)
    corners[:, :, :2] += shape
    return corners.reshape(-1, 3)


# Strokes of the digits in a field of 2 × 4, from its lower left.
_DIGITS = {
    "0": [[(0, 0), (2, 0), (2, 4), (0, 4), (0, 0)]],
    "1": [[(0.2, 3.2), (1, 4), (1, 0)]],
    "2": [[(0, 4), (2, 4), (2, 2.2), (0, 1.8), (0, 0), (2, 0)]],
    "3": [[(0, 4), (2, 4), (2, 0), (0, 0)], [(0.4, 2), (2, 2)]],
    "4": [[(0, 4), (0, 1.6), (2, 1.6)], [(1.5, 2.8), (1.5, 0)]],
    "5": [[(2, 4), (0, 4), (0, 2.2), (2, 2.2), (2, 0), (0, 0)]],
    "6": [[(2, 4), (0, 4), (0, 0), (2, 0), (2, 2.2), (0, 2.2)]],
    "7": [[(0, 4), (2, 4), (0.8, 0)]],
    "8": [[(0, 0), (2, 0), (2, 4), (0, 4), (0, 0)], [(0, 2), (2, 2)]],
    "9": [[(0, 0), (2, 0), (2, 4), (0, 4), (0, 1.8), (2, 1.8)]],
}
_FIELD, _DIGIT, _PITCH = 4.0, 2.0, 3.2


def _number_strokes(number):
    """Segments (2 k, 2) of a number, 1 high, from its lower left; the field of a digit is half as
    wide."""
    segments_of = []
    for place, digit in enumerate(str(number)):
        for stroke in _DIGITS[digit]:
            points = (np.array(stroke, dtype=np.float64) + (place * _PITCH, 0.0)) / _FIELD
            segments_of.append(np.repeat(points, 2, axis=0)[1:-1])
    return np.concatenate(segments_of)


def numbers(values, at, height, shift, viewport):
    """(k, 3) corners of segments that write the whole numbers `values` (n,) at the places `at`,
    (n, 3), equal ones one after another; height, and shift (x, y) from the place to the lower left,
    in dots."""
    values, dot = np.asarray(values), 2.0 / np.asarray(viewport, dtype=np.float64)
    written = [np.empty((0, 3))]
    for value in np.unique(values).tolist():
        shape = (_number_strokes(value) * height + shift) * dot
        written.append(_around(at[values == value], shape))
    return np.concatenate(written)


def number_sizes(values, height):
    """(n, 2) width and height of the whole numbers `values` (n,) as `numbers` writes them."""
    widths = [(len(str(value)) - 1) * _PITCH + _DIGIT for value in np.asarray(values).tolist()]
    return np.column_stack([np.array(widths) / _FIELD * height, np.full(len(widths), height)])


def in_dots(at, viewport):
    """(n, 2) the places `at`, (n, 3), in dots from the middle of the picture."""
    return 0.5 * np.asarray(viewport, dtype=np.float64) * at[:, :2]


def fan_triangles(faces):
    """(t, 3) indices of the triangles of faces, each the array of its vertices in order; faces of
    few corners come first."""
    triangles = [np.empty((0, 3), dtype=np.int64)]
    for same in _by_size(faces):
        inner = range(1, same.shape[1] - 1)
        fans = np.stack([same[:, [0, i, i + 1]] for i in inner], axis=1)
        triangles.append(fans.reshape(-1, 3))
    return np.concatenate(triangles)


def middles(points, faces):
    """(f, 3) the mean of the corners of each face."""
    if not len(faces):
        return np.empty((0, 3))
    return np.array([points[face].mean(axis=0) for face in faces])


def rim(faces):
    """(k, 2) the edges that one only of the faces has, each the array of its vertices in order."""
    edges = [np.empty((0, 2), dtype=np.int64)]
    for same in _by_size(faces):
        edges.append(np.stack([same, np.roll(same, -1, axis=1)], axis=2).reshape(-1, 2))
    edges = np.sort(np.concatenate(edges), axis=1)
    found, counts = np.unique(edges, axis=0, return_counts=True)
    return found[counts == 1]


def _by_size(faces):
    """Faces of one size after the other, (k, size) their vertices."""
    for size in sorted({len(face) for face in faces}):
        yield np.array([face for face in faces if len(face) == size], dtype=np.int64)
