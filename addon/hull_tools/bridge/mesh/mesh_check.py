# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with a hull's control mesh, in words, with the elements to select."""

from dataclasses import dataclass

import numpy as np

from ....hull_io import sides
from .. import limits, native
from ..counts import counted, counted_are
from . import mesh_arrays
from . import slits as slits_of_mesh
from .face_sides import next_corners

# What the native check says of what Split mends.
_TO_SPLIT = ("more than two faces", "share no edge there")


@dataclass(frozen=True)
class Problem:
    """severity "error" or "warning"; kind "mesh", "vertex", "edge" or "face".

    elements are Blender's indices: vertices, faces, or for edges pairs of vertices. remedy: what
    mends it, "SPLIT", "PORT", "CENTRE", "JOIN", "POINTS" or "".
    """

    severity: str
    kind: str
    elements: tuple
    message: str
    remedy: str = ""


@dataclass(frozen=True)
class MeshCheck:
    vertex_count: int = 0
    edge_count: int = 0
    face_count: int = 0
    irregular_count: int = 0
    problems: tuple = ()

    @property
    def errors(self):
        return [problem for problem in self.problems if problem.severity == "error"]


def check_control_mesh(data, control, half, before=None):
    """(MeshCheck, hull_native.ControlMesh or None when there are errors).

    `data` is the MeshData that the ControlArrays `control` were taken from. before: a ControlMesh
    that differs by the places of its points only, of which the rest is known.
    """
    mesh, problems = None, _size_errors(control, half)
    if not problems:
        mesh, found_problems = _native_problems(control, before)
        problems = [_from_native(found, control) for found in found_problems]
    problems += _shell_errors(control) + _tag_warnings(data)
    if any(problem.severity == "error" for problem in problems):
        return MeshCheck(len(control.points), 0, len(control.face_sizes), 0, tuple(problems)), None
    if mesh is None:
        mesh = native.require().ControlMesh(*control.arguments())
    problems += _side_warnings(control, half)
    problems += _centre_line_warnings(mesh, control) if half else _slit_warnings(control)
    problems += _doubled_warnings(control, half)
    check = MeshCheck(
        mesh.vertex_count,
        mesh.edge_count,
        mesh.face_count,
        len(mesh.irregular_vertices),
        tuple(problems),
    )
    return check, mesh


def is_too_fine(control, half):
    """Whether a change of the mesh would keep the window waiting: each corner of a face is a cell
    of the surface, and of a cell there is a face to be shown at least."""
    # So few that all may be irregular: what nearly all hulls have, at each step of the mouse.
    if _work(control, half, len(control.face_vertices)) <= limits.MOST_SHOWN_FACES:
        return False
    return _work(control, half, _irregular_cells(control)) > limits.MOST_SHOWN_FACES


def _work(control, half, irregular):
    """What the surface of a mesh takes, counted in faces that are shown."""
    return _least_shown(control, half) + limits.FACES_FOR_IRREGULAR_CELL * irregular


def _least_shown(control, half):
    return len(control.face_vertices) * (1 + half)


def _irregular_cells(control):
    """How many cells are in a face without four corners, or at a point without four faces, or
    two."""
    sizes = np.repeat(control.face_sizes, control.face_sizes)
    faces = np.bincount(control.face_vertices)[control.face_vertices]
    return int(np.count_nonzero((sizes != 4) | ~np.isin(faces, (2, 4))))


def _size_errors(control, half):
    if not is_too_fine(control, half):
        return []
    message = (
        f"The mesh is too fine: its surface would have {_least_shown(control, half)} faces, "
        f"{_irregular_cells(control)} cells of it beside irregular points, which count for "
        f"{limits.FACES_FOR_IRREGULAR_CELL} more each; {limits.MOST_SHOWN_FACES} can follow its "
        "points. Use a coarser one, of faces with four corners"
    )
    return [Problem("error", "mesh", (), message)]


def _native_problems(control, before):
    """(the ControlMesh where it is that of before with other points, else None, problems)."""
    if not len(control.face_sizes):
        return None, []
    if before is not None:
        try:
            mesh = before.with_points(control.points)
            return mesh, mesh.warnings
        except ValueError:
            pass  # of these points all that is wrong is told
    return None, native.require().check_mesh(*control.arguments())


def _from_native(found, control):
    ids = control.face_ids if found.kind == "face" else control.vertex_ids
    elements = ids[np.asarray(found.elements, dtype=np.int64)].tolist()
    return Problem(
        found.severity,
        found.kind,
        tuple(tuple(e) if isinstance(e, list) else e for e in elements),
        found.message,
        "SPLIT" if any(words in found.message for words in _TO_SPLIT) else "",
    )


def _shell_errors(control):
    if len(control.face_sizes):
        return []
    message = "The shell has no faces: add some, or tick a layer as shell"
    return [Problem("error", "mesh", (), message)]


def _tag_warnings(data):
    edges, vertices = mesh_arrays.fractional_creases(data)
    problems = []
    if len(edges):
        message = (
            f"{counted_are(len(edges), 'edge')} creased between 0 and 1: make crease or smooth"
        )
        problems.append(Problem("warning", "edge", tuple(map(tuple, edges.tolist())), message))
    if len(vertices):
        message = (
            f"{counted_are(len(vertices), 'point')} creased between 0 and 1: make corner or smooth"
        )
        problems.append(Problem("warning", "vertex", tuple(vertices.tolist()), message))
    return problems


def _side_warnings(control, half):
    problems = []
    y = control.points[:, 1]
    starboard = np.flatnonzero(y < -_dust(control.points))
    if half and len(starboard) and sides.lies_to_starboard(y):
        elements = tuple(control.vertex_ids[starboard].tolist())
        message = "The half hull lies to starboard (y < 0): mirror it to port"
        problems.append(Problem("error", "vertex", elements, message, "PORT"))
    elif half and len(starboard):
        elements = tuple(control.vertex_ids[starboard].tolist())
        message = f"{counted(len(starboard), 'point')} of the half hull to starboard (y < 0)"
        problems.append(Problem("warning", "vertex", elements, message))
    if outward_flux(control) < 0.0:
        elements = tuple(control.face_ids.tolist())
        problems.append(Problem("warning", "face", elements, "The faces are turned inwards"))
    return problems


def _centre_line_warnings(mesh, control):
    """Where the two sides would not be joined, although they were probably meant to be."""
    near = mesh.near_centre_line
    if not len(near):
        return []
    furthest = np.abs(mesh.points[near, 1]).max()
    points = counted(len(near), "point")
    message = (
        f"{points} of the centre line off the centre plane, by up to {1e3 * furthest:.3g} mm: put "
        "them there (y = 0), or the two sides do not join"
    )
    elements = tuple(control.vertex_ids[near].tolist())
    return [Problem("warning", "vertex", elements, message, "CENTRE")]


def slits(control):
    """(k, 2) pairs of points of a whole hull's centre line that are to become one for its two sides
    to be joined there, as numbers of the control arrays."""
    return _slits(control, on_centre_plane(control.points))


def _slits(control, on_plane=None):
    points = control.points
    faces = control.face_sizes, control.face_vertices
    return slits_of_mesh.pairs(points, *faces, _dust(points), on_plane)


def _slit_warnings(control):
    where, apart = "of the centre line", "so that the two sides are not joined"
    return _twice_warnings(control, slits(control), where, apart, "JOIN")


def doubled(control, half):
    """The same of points of borders elsewhere: all pairs but those of slits(), of a whole hull."""
    found = _slits(control)
    if half or not len(found):
        return found
    others = set(map(tuple, slits(control).tolist()))
    return found[[tuple(pair) not in others for pair in found.tolist()]]


def _doubled_warnings(control, half):
    found = doubled(control, half)
    if not len(found):
        return []
    reach = 1e3 * _dust(control.points)
    apart = f"within {reach:.2g} mm, so that the faces on both sides are not joined"
    return _twice_warnings(control, found, "of borders", apart, "POINTS")


def _twice_warnings(control, found, where, apart, remedy):
    """Of pairs of points; where they are, and what they leave apart."""
    if not len(found):
        return []
    kept = len(np.unique(found[:, 0]))
    are = "is" if kept == 1 else "are"
    message = f"{counted(kept, 'point')} {where} {are} there twice, {apart}: join them"
    elements = tuple(control.vertex_ids[np.unique(found)].tolist())
    return [Problem("warning", "vertex", elements, message, remedy)]


def _dust(points):
    if not len(points):
        return 0.0
    size = np.linalg.norm(np.ptp(points, axis=0))
    return native.require().tolerances.ON_CENTRE_PLANE * size


def on_centre_plane(points):
    """(n,) which of these points, (n, 3), lie on the centre plane."""
    return np.abs(points[:, 1]) <= _dust(points)


def outward_flux(control):
    """The sum over the control faces of y times the y part of their area: the volume they enclose.

    An open deck and the open centre plane of a half hull add nothing to it, so that its sign tells
    which way the faces are turned even though the mesh is open.
    """
    starts = np.cumsum(control.face_sizes) - control.face_sizes
    x, y, z = control.points.T[:, control.face_vertices]
    following = next_corners(control.face_sizes)
    area_y = 0.5 * (z * x[following] - x * z[following])
    mean_y = np.add.reduceat(y, starts) / control.face_sizes
    return float(np.sum(mean_y * np.add.reduceat(area_y, starts)))
