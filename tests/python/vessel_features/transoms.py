# SPDX-License-Identifier: GPL-3.0-or-later
"""Plane ends of a ship: flat, not folded, within knuckles."""

import numpy as np

from .form import IN_PLANE


def transom(form, layer="Transom", forward=False, rake=0.0, least=20.0):
    """A plane layer of its own, square or raked by those degrees at most, within a knuckle."""
    faces = form.faces_of(layer)
    size = form.size
    cells = np.flatnonzero(np.isin(form.cell_faces(np.arange(form.surface.cell_count)), faces))
    grid = form.surface.evaluate_grid(4)[0][cells].reshape(-1, 3)
    at_end = (grid[:, 0] > 0.5 * form.given.length_pp) == forward
    points = grid[at_end]
    assert len(points), f"nothing of layer {layer} is there"
    corners = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(corners, full_matrices=False)
    normal = axes[2]
    away = np.abs(corners @ normal).max()
    assert away <= 2.0 * IN_PLANE * size, f"{away:.1e} m from a plane"
    share = _folded(form, cells, normal)
    assert share < 1e-9, f"{share:.4f} of the transom is folded over itself"
    lean = np.degrees(np.arcsin(abs(normal[2])))
    assert lean <= rake + 1e-9 and abs(normal[1]) < 1e-9, f"the transom leans by {lean:.1f}"
    rim = _rim(form, faces)
    assert rim, "the transom meets nothing"
    tagged = {tuple(sorted(edge)) for edge in form.mesh.creases.tolist()}
    assert rim <= tagged, f"no crease along {sorted(rim - tagged)}"
    for knuckle in form.knuckles:
        chain = zip(knuckle.curve.vertices, knuckle.curve.vertices[1:])
        if all(tuple(sorted(map(int, edge))) in rim for edge in chain):
            assert knuckle.angles.min() > least, f"{knuckle.angles.min():.1f} degrees at the rim"


def transom_in_water(form, layer="Transom"):
    """The lowest part of the transom is under water."""
    depth = form.given.draft - form.points_of(form.faces_of(layer))[:, 2].min()
    assert depth > 0.05 * form.given.draft, f"the transom's foot is {depth:.2f} m in the water"


def _folded(form, cells, normal):
    """The part of a plane's area whose normal is turned round; over all that face alike."""
    _, along_u, along_v = form.surface.evaluate_grid(8, 1)
    pieces = np.cross(along_u[cells], along_v[cells]) @ normal
    facing = np.where(pieces.sum(axis=(1, 2)) < 0.0, -1.0, 1.0)[:, None, None] * pieces
    return -facing[facing < 0.0].sum() / np.abs(pieces).sum()


def _rim(form, faces):
    """Edges that the faces share with others."""
    inside, outside = set(), set()
    chosen = set(faces.tolist())
    for number, face in enumerate(form.data.faces):
        edges = {tuple(sorted(edge)) for edge in zip(face, [*face[1:], face[0]])}
        if number in chosen:
            inside |= edges
        else:
            outside |= edges
    return inside & outside
