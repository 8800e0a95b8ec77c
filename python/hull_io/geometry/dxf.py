# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves of DXF drawings: lines, polylines with bulges, arcs, ellipses, splines, points, faces, and
what is inserted of blocks. Layers become groups; texts, dimensions and hatches are left out."""

from collections import Counter

import numpy as np

from ..errors import HullFileError
from ..limits import FURTHEST_POINT, MAX_GEOMETRY_CURVES, MAX_GEOMETRY_POINTS
from .dxf_entities import Placement, shape_of
from .dxf_records import DxfError, read_drawing
from .values import Geometry, GeometryMesh

_UNITS = {"1": "in", "2": "ft", "4": "mm", "5": "cm", "6": "m"}
_DEEPEST_BLOCK = 8
_NOT_DRAWN = {"TEXT", "MTEXT", "DIMENSION", "HATCH", "LEADER", "ATTRIB", "ATTDEF", "VIEWPORT"}


def read_dxf(data, name):
    """The Geometry of the bytes of a file. HullFileError with line and remedy."""
    drawing = read_drawing(data, name)
    reader = _Reader(name, drawing.blocks)
    try:
        reader.add_all(drawing.entities, Placement(), 0, "0")
    except DxfError as error:
        raise HullFileError(f"{name}: {error}; draw it anew, or take it out.") from error
    found = Geometry(
        name,
        "DXF",
        _UNITS.get(drawing.header.get("$INSUNITS", "")),
        tuple(reader.curves),
        reader.meshes(),
        np.array(reader.points).reshape(-1, 3),
        reader.left_out(),
    )
    if found.is_empty:
        raise HullFileError(
            f"{name}: there is no line, polyline, arc or spline in it; draw the hull's lines so."
        )
    return found


class _Reader:
    def __init__(self, name, blocks):
        self.name, self.blocks = name, blocks
        self.curves, self.points, self.faces = [], [], {}
        self.others, self.count, self.copies = Counter(), 0, 0

    def add_all(self, records, placement, depth, layer):
        for record in records:
            own = record.text(8, "0")
            # What lies on layer 0 of a block is on the layer of what inserts it.
            own = layer if own == "0" else own
            if record.flags(67):
                self.others["in paper space"] += 1
            elif record.type == "INSERT":
                self._insert(record, placement, depth, own)
            else:
                self._add(record, placement, own)

    def _add(self, record, placement, layer):
        try:
            shape = shape_of(record)
        except ValueError as error:
            if isinstance(error, DxfError):
                raise
            raise DxfError(f"line {record.line}: {record.type}: {error}") from error
        if shape is None:
            self.others[record.type] += 1
            return
        kind, value = shape
        if kind == "curve":
            curve = placement.curve(value, group=layer, name=f"{layer} {len(self.curves) + 1}")
            if curve is not None:
                self.curves.append(curve)
                self._hold(record, curve.points)
        elif kind == "point":
            self.points.append(placement.points(value)[0])
            self._hold(record, self.points[-1:])
        else:
            self.faces.setdefault(layer, []).append(placement.points(value))
            self._hold(record, value)

    def _count(self, record, more):
        self.count += more
        if self.count > MAX_GEOMETRY_POINTS or len(self.curves) > MAX_GEOMETRY_CURVES:
            raise DxfError(f"line {record.line}: there is more than is read")

    def _hold(self, record, points):
        self._count(record, len(points))
        if not np.abs(points).max() <= FURTHEST_POINT:
            raise DxfError(
                f"line {record.line}: {record.type} lies further than {FURTHEST_POINT:.0f} from "
                "the origin"
            )

    def _insert(self, record, placement, depth, layer):
        block = self.blocks.get(record.text(2))
        if block is None:
            self.others[f"INSERT of '{record.text(2)[:40]}', which is no block"] += 1
            return
        if depth == _DEEPEST_BLOCK:
            raise DxfError(f"line {record.line}: blocks insert one another without end")
        columns, rows = (max(1, record.flags(code)) for code in (70, 71))
        if columns * rows > 1000:
            raise DxfError(f"line {record.line}: INSERT repeats a block {columns * rows} times")
        self._count(record, 2)
        inner = placement.inserted(record, block)
        for row in range(rows):
            for column in range(columns):
                self._hold_copies(record, block)
                shift = (column * record.number(44), row * record.number(45), 0.0)
                self.add_all(block.parts, inner.shifted(shift), depth + 1, layer)

    def _hold_copies(self, record, block):
        """Blocks of texts alone draw nothing, and take their time all the same."""
        self.copies += 1
        self._count(record, len(block.parts))
        if self.copies > MAX_GEOMETRY_CURVES:
            raise DxfError(
                f"line {record.line}: blocks are inserted more than {MAX_GEOMETRY_CURVES} times"
            )

    def meshes(self):
        meshes = []
        for layer, faces in self.faces.items():
            corners = np.array([face[[0, 1, 2, 0, 2, 3]] for face in faces]).reshape(-1, 3)
            points, indices = np.unique(corners, axis=0, return_inverse=True)
            triangles = indices.reshape(-1, 3)
            is_whole = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
            meshes.append(GeometryMesh(points, triangles[is_whole], layer, layer))
        return tuple(meshes)

    def left_out(self):
        told = [
            f"{count} of {what} {'are' if count > 1 else 'is'} left out."
            for what, count in sorted(self.others.items())
            if what not in _NOT_DRAWN
        ]
        texts = sum(count for what, count in self.others.items() if what in _NOT_DRAWN)
        return (
            *told,
            *([f"Texts, dimensions and hatches ({texts}) are left out."] if texts else []),
        )
