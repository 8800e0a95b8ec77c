# SPDX-License-Identifier: GPL-3.0-or-later
"""The five figures that present a hull, after the appendices of Greshake 2021."""

from pathlib import Path

from ..folder_beside import FolderBeside
from .drawing_scales import scales
from .figure_form import FigureForm
from .hull_pictures import SeenHull, reflection_sheet, rendering_sheet
from .lines_plan import write_lines_drawing
from .mesh_figures import mesh_sheet
from .sections_plans import sections_sheet

HULL_FIGURES = ("rendering", "reflection", "control-mesh", "lines-plan", "sections-plan")
_ENDINGS = (".pdf", ".svg", ".png")
# Sheets of lines plans in mm, the smallest first; the scale is the largest that the last one takes.
_SHEETS = sorted(
    (
        (width, round(width / ratio))
        for width in range(240, 421, 20)
        for ratio in (2.0, 1.7, 2.0**0.5)
    ),
    key=lambda sheet: sheet[0] * sheet[1],
)
_SCALES = scales(-4, 5)
# About how many waterlines in the draft and buttocks in the beam, the first that a sheet takes.
_SPACINGS = ((4, 8), (3, 6), (2, 6), (2, 4), (1, 2))
# Of the work, by figure in their order, and what the surface of pictures takes before.
_SHARES, _FACETS_SHARE = (0.35, 0.15, 0.05, 0.1, 0.05), 0.3


def write_hull_figures(
    body,
    path,
    *,
    title="",
    length=0.0,
    beam=0.0,
    draft=0.0,
    depth=0.0,
    endings=None,
    figures=HULL_FIGURES,
    progress=None,
):
    """Writes figures of a HullBody, each of HULL_FIGURES that is asked for: the surface with paint,
    sections and waterlines; as a mirror of light lines; its control mesh; lines plan; sections plan
    (Greshake 2021, appendices A to F). Returns their paths: of the path "out/ship.png"
    out/ship-rendering.png and so on. The ending, .png, .pdf or .svg, is the path's; endings: others
    or several, such as (".png", ".pdf").

    length (between perpendiculars, from x = 0), beam, draft and depth, m: 0 where not known; the
    draft tells which water the paint shows. Of the body its surface and closings are drawn,
    appendages are not. progress: called with the share done; what it raises ends the work. Either
    all files are there, or none has changed. ValueError for other endings and figures, for a hull
    that encloses nothing, and where no lines plan fits a sheet; OSError if files can't be written.
    """
    path = Path(path)
    endings = (path.suffix.lower(),) if endings is None else tuple(dict.fromkeys(endings))
    figures = tuple(dict.fromkeys(figures))
    _check(path, endings, figures)
    form = FigureForm(body, title or path.stem, length, beam, draft, depth)
    stem = path.with_suffix("") if path.suffix.lower() in _ENDINGS else path
    targets = [
        stem.with_name(f"{stem.name}-{figure}{ending}") for figure in figures for ending in endings
    ]
    with FolderBeside(targets) as folder:
        for figure, write in _writers(form, figures, progress or (lambda share: None)):
            for ending in endings:
                write(str(folder / f"{figure}{ending}"))
        made = [folder / f"{figure}{ending}" for figure in figures for ending in endings]
        folder.hand_over(made)
    return targets


def _check(path, endings, figures):
    for ending in endings:
        if ending not in _ENDINGS:
            raise ValueError(
                f'Figures are written as .png, .pdf or .svg, not as "{ending or path.name}".'
            )
    for figure in figures:
        if figure not in HULL_FIGURES:
            raise ValueError(f'A figure is one of {", ".join(HULL_FIGURES)}, not "{figure}".')
    if not figures or not endings:
        raise ValueError("There is no figure to be written.")


def _writers(form, figures, tell):
    """(figure, what writes it to a path) one after the other, each made when it is asked for."""
    done = 0.0

    def part(share):
        return lambda own, done=done: tell(done + share * own)

    seen = None
    if not {"rendering", "reflection"}.isdisjoint(figures):
        seen = SeenHull(form, part(_FACETS_SHARE))
    done += _FACETS_SHARE
    for figure, share in zip(HULL_FIGURES, _SHARES):
        if figure in figures:
            yield figure, _writer(figure, form, seen, part(share))
        done += share
        tell(done)


def _writer(figure, form, seen, progress):
    if figure == "rendering":
        return rendering_sheet(seen, progress).write
    if figure == "reflection":
        return reflection_sheet(seen, progress).write
    if figure == "control-mesh":
        return mesh_sheet(form.surface.mesh, form.body.mirrored, form.title).write
    if figure == "sections-plan":
        return sections_sheet(form).write
    return _LinesPlan(form, progress).write


class _LinesPlan:
    """The lines plan on the smallest sheet that takes the scale of the largest."""

    def __init__(self, form, progress):
        self._form, self._progress = form, progress
        self._how = None

    def write(self, path):
        if self._how is None:
            self._how = self._found(path)
        self._draw(path, *self._how)

    def _found(self, path):
        largest = _SHEETS[-1]
        least = 1000.0 * self._form.lpp / largest[0]
        scales = [scale for scale in _SCALES if least <= scale < 20.0 * least]
        pairs = [(spacing, scale) for spacing in _SPACINGS for scale in scales]
        spacing, scale = self._first(pairs, lambda one: (one[0], largest, one[1]), path)
        sheet = self._first(_SHEETS, lambda one: (spacing, one, scale), path)
        return spacing, sheet, scale

    def _first(self, choices, how, path):
        reason = ""
        for one in choices:
            try:
                self._draw(path, *how(one))
            except ValueError as error:
                reason = str(error)
            else:
                return one
        raise ValueError(f"No lines plan of this hull fits a sheet: {reason}")

    def _draw(self, path, spacing, sheet, scale):
        form = self._form
        self._progress(0.0)
        step = form.lpp / 20
        starts_at_zero = form.given_length is not None
        write_lines_drawing(
            form.surface,
            path,
            mirrored=form.body.mirrored,
            stations=step if starts_at_zero else [x for _, x in form.stations()],
            waterlines=form.waterline_spacing(spacing[0]),
            buttocks=form.buttock_spacing(spacing[1]),
            draft=form.given_draft,
            length=form.given_length,
            title=form.title,
            particulars=form.particulars(),
            offsets=False,
            paper=sheet,
            scale=scale,
        )
