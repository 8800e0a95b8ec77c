# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull of geometry that was read: everything from a file to a HullData with its report."""

from dataclasses import dataclass
from pathlib import PurePath

from .beside import guess_hull, oriented, placed_views
from .fitting import TOLERANCE, fit_shell
from .half_meshes import half_mesh
from .hull_files import hull_data, particulars_of
from .keel_strips import closed_to_centre
from .lofting import lofted
from .reports import fit_report
from .shells import hull_shell

# Of the depth: the draft where nobody tells one.
_DRAFT = 0.6


@dataclass(frozen=True)
class MadeHull:
    """data: the HullData; report: a dict as fit_report() has it, with the guesses; shell, fitted:
    the HullShell and its FittedHull; guess: the Guess by which the geometry was taken."""

    data: object
    report: dict
    shell: object
    fitted: object
    guess: object


def hull_from_geometry(
    geometry, *, budget=None, tolerance=None, draft=None, stern_post=True, knuckles=True, name=None,
    progress=None, **known
):  # fmt: skip
    """The MadeHull of a Geometry. budget: control points at most; tolerance and draft: m;
    stern_post, knuckles: whether such as are found are laid out; name: of the hull, instead of the
    geometry's; progress: called with the share that is done, what it raises ends the work; known:
    what guess_hull() takes. ValueError in one sentence for what no hull can be laid onto."""
    geometry = placed_views(geometry)
    guess = guess_hull(geometry, **known)
    placed = oriented(geometry, guess)
    loft, beside = None, 0.0
    if placed.curves and not placed.meshes:
        loft = lofted(placed)
        shell = loft.shell
    else:
        mesh, beside = closed_to_centre(half_mesh(placed))
        shell = hull_shell(mesh)
    used = shell.mesh.points[shell.mesh.triangles].reshape(-1, 3)
    low, high = float(used[:, 2].min()), float(used[:, 2].max())
    is_told = draft is not None
    draft = low + _DRAFT * (high - low) if draft is None else float(draft)
    if not low < draft < high:
        raise ValueError(
            f"The draft of {draft:g} m is not within the hull, which is from {low:.3f} to "
            f"{high:.3f} m above the base line: give another one."
        )
    fitted = fit_shell(
        shell, tolerance=tolerance, budget=budget, stern_post=stern_post, knuckles=knuckles,
        progress=progress, loft=loft,
    )  # fmt: skip
    tolerance = TOLERANCE * fitted.outline.length if tolerance is None else float(tolerance)
    report = {
        "source": geometry.name,
        "guesses": guess.reasons,
        "doubts": list(guess.doubts),
        "draft_is_told": is_told,
        **fit_report(shell, fitted, draft, tolerance, None if loft is None else loft.told),
        "left_out": [*geometry.left_out, *_told_of_strip(beside), *shell.left_out],
    }
    data = hull_data(
        fitted,
        name or _name_of(geometry.name),
        f"fitted to {geometry.name}",
        particulars_of(guess.length_pp, fitted.surface, draft),
    )
    return MadeHull(data, report, shell, fitted, guess)


def _told_of_strip(beside):
    if beside == 0.0:
        return []
    return [
        f"The shell ends up to {beside:.3f} m beside the centre plane: it was closed to that by a "
        "strip."
    ]


def _name_of(file):
    """A file's name without its ending."""
    return PurePath(file).stem.strip(".") or "hull"
