# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the wetted hull for programs that compute waves and motions: WAMIT, Nemoh, and OBJ.

Points (n, 3) in metres, in the water's axes, panels (m, 4) counter-clockwise seen from the water,
the last corner of a triangle twice, as `hull_native.PanelMesh` has them. All raise HullFileError
where the file can't be written, leaving what was there, and ValueError for what are no panels.
"""

from pathlib import Path

import numpy as np

from .bytes_on_disk import write_bytes
from .face_arrays import checked_faces, lines_of
from .limits import GRAVITY
from .real_points import real_points

# WAMIT's own (manual, 6.1): a header's letters, the least ULEN, and, of ULEN and its square, what
# are one point and no area.
_LONGEST_HEADER = 72
_LEAST_ULEN = 1e-5
_SAME_POINT = 1e-6
_NO_AREA = 1e-10


def gdf_title(name):
    """The name as a header of write_gdf: letters that are not ASCII as "?", cut to 72."""
    text = " ".join(name.split()).encode("ascii", "replace").decode("ascii")
    return "".join(letter if letter.isprintable() else "?" for letter in text)[:_LONGEST_HEADER]


def panel_areas(points, panels):
    """(m,) of panels, by half the cross product of the diagonals."""
    a, b, c, d = real_points(points)[np.asarray(panels)].transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)


def write_gdf(path, points, panels, *, half, ulen=1.0, gravity=GRAVITY, title="Hull Tools"):
    """A WAMIT .gdf file of the low-order method. half: the panels are the port half, and y = 0 is
    a plane of symmetry (ISY). ulen: the length by which WAMIT makes its results dimensionless;
    panels must have an area of at least 1e-10 ulen². title: at most 72 letters of ASCII."""
    points, panels = checked_faces(points, panels, 4)
    if not (ulen > _LEAST_ULEN and np.isfinite(ulen) and gravity > 0.0 and np.isfinite(gravity)):
        raise ValueError(
            f"ULEN must be above {_LEAST_ULEN:g} and gravity positive, not {ulen:g}, {gravity:g}."
        )
    if len(title) > _LONGEST_HEADER or not (title.isascii() and title.isprintable()):
        raise ValueError(f"A header has at most {_LONGEST_HEADER} letters of ASCII on one line.")
    panels = _with_triangles(points, panels, _SAME_POINT * ulen)
    small = np.flatnonzero(panel_areas(points, panels) < _NO_AREA * ulen**2)
    if len(small):
        raise ValueError(
            f"Panel {small[0]} has less area than WAMIT takes, {_NO_AREA:g} ULEN²: choose another "
            "size of panels, or a smaller ULEN."
        )
    head = f"{title}\n{ulen:.9g} {gravity:.9g} ULEN GRAV\n0 {int(half)} ISX ISY\n{len(panels)}\n"
    numbers = " ".join(["%.10g"] * 12)
    write_bytes(
        Path(path), head.encode("ascii") + lines_of(points[panels].reshape(-1, 12), numbers)
    )


def write_nemoh(path, points, panels, *, half):
    """A mesh file of Nemoh. half: as for write_gdf, told in the first line."""
    points, panels = checked_faces(points, panels, 4)
    number = np.arange(1, len(points) + 1)[:, None]
    write_bytes(
        Path(path),
        f"2 {int(half)}\n".encode("ascii")
        + lines_of(np.hstack([number, points]), "%d %.10g %.10g %.10g")
        + b"0 0.0 0.0 0.0\n"
        + lines_of(panels + 1, "%d %d %d %d")
        + b"0 0 0 0\n",
    )


def write_obj(path, points, faces):
    """An OBJ file of faces (m, 4), triangles among them, or (m, 3)."""
    write_bytes(Path(path), bytes_of_obj(points, faces))


def bytes_of_obj(points, faces):
    """The bytes of such a file."""
    points, faces = checked_faces(points, faces, np.asarray(faces).shape[-1])
    if faces.shape[1] not in (3, 4):
        raise ValueError("Faces of OBJ files here have three or four corners.")
    corners = [face[face != np.roll(face, 1)] + 1 for face in faces]
    text = b"".join(
        b"f " + " ".join(map(str, face)).encode("ascii") + b"\n"
        for face in corners
        if len(face) > 2
    )
    return b"# Hull Tools\n" + lines_of(points, "v %.10g %.10g %.10g") + text


def _with_triangles(points, panels, same):
    """Panels of which two neighbouring corners are one point, as triangles with the last twice."""
    panels = panels.copy()
    corners = points[panels]
    short = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2) < same
    for panel in np.flatnonzero(short[:, :3].any(axis=1) & (short.sum(axis=1) == 1)):
        side = int(np.flatnonzero(short[panel])[0])
        kept = np.delete(panels[panel], side)
        panels[panel] = [*kept, kept[-1]]
    return panels
