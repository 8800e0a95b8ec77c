# SPDX-License-Identifier: GPL-3.0-or-later
"""Many drawings for the shop in one file, or at true size in a file each."""

from pathlib import Path

import numpy as np

from .._drawing import ShopDrawing, write_shop_booklet
from ..folder_beside import FolderBeside

_TOGETHER, _APART = (".pdf", ".dxf"), (".pdf", ".svg", ".dxf")
_GAP = 500.0  # mm at true size, between drawings in one file


def shop_ending(path, *, apart=False):
    """The ending, in small letters, of the path of drawings that are to be written by
    write_shop_drawings(). ValueError for one that is none of theirs."""
    endings, ending = _APART if apart else _TOGETHER, Path(path).suffix.lower()
    if ending not in endings:
        named = ", ".join(endings[:-1]) + f" or {endings[-1]}"
        text = f"Drawings can't be written to {Path(path).name}: the name must end in {named}"
        raise ValueError(
            f"{text}; .svg takes a drawing a file." if ending == ".svg" else f"{text}."
        )
    return ending


def write_shop_drawings(drawings, path, *, names=None, paper="A3", progress=None):
    """Writes ShopDrawings and returns the files' paths: one file without names, to .pdf a page each
    at the largest usual scale at which it fits, to .dxf all of them in columns at true size,
    in mm.

    names: one each, for files of their own at true size: of the path "out/shell.pdf" and the name
    "P7" out/shell-P7.pdf, as ShopDrawing.write() divides it into sheets of the paper; .svg and .dxf
    likewise. What is no letter, digit, - or _ in a name becomes -. Either all files are there or
    none has changed. progress: called with the share done, of one file before it is written; what
    it raises ends the work.

    ValueError as shop_ending(), for no drawings, drawings without lines, names that are not one
    each or not different, and as ShopDrawing.write(); OSError if a file can't be written.
    """
    path, drawings, tell = Path(path), list(drawings), progress or (lambda share: None)
    ending = shop_ending(path, apart=names is not None)
    if not drawings:
        raise ValueError("There is no drawing to be written.")
    for drawing in drawings:
        if not drawing.lines:
            raise ValueError(f'The drawing "{drawing.title}" has no lines: leave it out.')
    if names is not None:
        return _write_apart(drawings, path, _file_words(names, len(drawings)), paper, tell)
    tell(0.0)
    if ending == ".pdf":
        write_shop_booklet(drawings, path, paper=paper)
    else:
        _in_columns(drawings).write(path)
    return [path]


def _write_apart(drawings, path, words, paper, tell):
    targets = [path.with_name(f"{path.stem}-{word}{path.suffix}") for word in words]
    with FolderBeside(targets) as folder:
        made = []
        for k, (drawing, target) in enumerate(zip(drawings, targets)):
            tell(k / len(drawings))
            made.append(folder / target.name)
            try:
                drawing.write(made[-1], paper=paper)
            except OSError as error:  # told of the file that was asked for
                raise OSError(str(error).replace(str(made[-1]), str(target))) from error
        folder.hand_over(made)
    return targets


def _file_words(names, count):
    words = ["".join(c if c.isalnum() or c in "-_" else "-" for c in name) for name in names]
    if len(words) != count or len(set(words)) != count:
        raise ValueError(f"{count} drawings need as many different names, not {len(set(words))}.")
    return words


def _in_columns(drawings):
    """All in one ShopDrawing, in columns, about as high as they are broad together."""
    lows, sizes = [], []
    for drawing in drawings:
        points = np.vstack([line for _, line in drawing.lines])
        lows.append(points.min(axis=0))
        sizes.append(points.max(axis=0) - lows[-1] + _GAP)
    broadest, height = max(size[0] for size in sizes), sum(size[1] for size in sizes)
    tallest = max(np.sqrt(broadest * height), max(size[1] for size in sizes))
    whole, x, y = ShopDrawing(drawings[0].title), 0.0, 0.0
    for low, (_, high), drawing in zip(lows, sizes, drawings):
        if y > 0.0 and y + high > tallest:
            x, y = x + broadest, 0.0
        whole.add(drawing, (x - low[0], y - low[1]))
        y += high
    return whole
