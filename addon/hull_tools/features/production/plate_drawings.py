# SPDX-License-Identifier: GPL-3.0-or-later
"""What the yard gets of plates beside their drawings: nesting on plates of the mill, templates,
maps of stretch; tasks, as those of plate_files are."""

from ...bridge import native
from ..exchange.endings import checked_ending
from .plate_files import PlateTask, chosen, plain_name, write_rows


class NestingFile(PlateTask):
    """All pieces of both sides on plates of the mill of (length, breadth) m, with a margin, m,
    around each; by the name's ending .pdf, a page each, .dxf or .csv, the list."""

    def __init__(self, obj, scene, path, *, stock, margin, **sizes):
        self._ending = checked_ending(path, (".pdf", ".dxf", ".csv"), "a nesting")
        self._path, self._stock, self._margin = path, stock, margin
        super().__init__(obj, scene, **sizes)

    def _finish(self, layout, progress):
        hull_native = native.require()
        pieces = [piece for one in layout.listed for piece in one.pieces]
        self.used = hull_native.nesting(pieces, [self._stock], margin=self._margin)
        if self._ending == ".csv":
            write_rows(self._path, hull_native.nesting_rows(self.used))
            return
        drawings = [
            hull_native.nesting_drawing(stock, f"S{k}") for k, stock in enumerate(self.used, 1)
        ]
        progress(0.5)
        hull_native.write_shop_drawings(drawings, self._path)


class TemplateFile(PlateTask):
    """Templates at the frames of plates that are named, of all that frames cross without a name,
    `height` (m) high at least: one file, .pdf with a page a plate or .dxf, or, in_sheets, a file a
    plate at true size."""

    def __init__(self, obj, scene, path, *, names, height, in_sheets, paper, **sizes):
        native.require().shop_ending(path, apart=in_sheets)
        self._path, self._names, self._height = path, names.split(), height
        self._in_sheets, self._paper = in_sheets, paper
        super().__init__(obj, scene, **sizes)

    def _check(self):
        if self._marks.table is None and self._marks.spacing <= 0.0:
            raise ValueError("Templates stand at frames: add a range under Frames")

    def _finish(self, layout, progress):
        hull_native, names, drawings = native.require(), [], []
        low, high = layout.ends
        frames = hull_native.frame_marks(layout.curves, self._marks.frames(low, high), low, high)
        listed = chosen(layout.listed, self._names)
        for k, one in enumerate(listed):
            progress(0.7 * k / len(listed))
            try:
                made = hull_native.plate_templates(one, layout.curves, frames, height=self._height)
            except ValueError:
                if self._names:
                    raise
                continue  # no frame crosses it
            drawings.append(hull_native.template_drawing(one, made))
            names.append(plain_name(one))
        if not drawings:
            raise ValueError("No frame crosses a plate: change the ranges under Frames")
        hull_native.write_shop_drawings(
            drawings,
            self._path,
            names=names if self._in_sheets else None,
            paper=self._paper,
            progress=lambda share: progress(0.7 + 0.3 * share),
        )


class StretchFile(PlateTask):
    """Maps of stretch of plates that are named, of all that are doubly curved without a name: .pdf
    with a page each, or .dxf."""

    def __init__(self, obj, scene, path, *, names, **sizes):
        native.require().shop_ending(path)
        self._path, self._names = path, names.split()
        super().__init__(obj, scene, **sizes)

    def _finish(self, layout, progress):
        hull_native, listed = native.require(), chosen(layout.listed, self._names)
        if not self._names:
            listed = [one for one in listed if not one.flat.developed]
            if not listed:
                raise ValueError("All plates were developed: none has a stretch to be drawn")
        drawings = []
        for k, one in enumerate(listed):
            progress(0.8 * k / len(listed))
            drawings.append(hull_native.stretch_drawing(one))
        hull_native.write_shop_drawings(drawings, self._path)
