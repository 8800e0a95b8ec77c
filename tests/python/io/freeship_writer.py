# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes small FREE!ship files of any version, straight from the description of the format.

One function says what stands in a file; two sinks say how. Nothing here is shared with the reader.
"""

import struct

VERSION_TABLE = """
100 110 120 130 140 150 160 165 170 180 190 191 195 198 200 201 210 220 230 240 250 260 270 280 290
295 296 297 298 300 302 303 305 309 310 313 314 317 327 332 335 421 430 462 500
"""
VERSIONS = [int(word) for word in VERSION_TABLE.split()]


class BinarySink:
    def __init__(self, version):
        self.parts = []
        self.string("FREE!ship")
        self.parts.append(bytes([VERSIONS.index(version)]))

    def int(self, *values):
        self.parts.extend(struct.pack("<i", value) for value in values)

    def float(self, *values):
        self.parts.extend(struct.pack("<f", value) for value in values)

    def bool(self, *values):
        self.parts.extend(bytes([bool(value)]) for value in values)

    def string(self, text):
        data = text.encode("cp1251")
        self.int(len(data))
        self.parts.append(data)

    def jpeg(self, data):
        self.int(4, 3, len(data))
        self.parts.append(data)

    def row(self, *values):
        self.float(*values)

    def content(self):
        return b"".join(self.parts)


class TextSink:
    def __init__(self, version, comma=False, words=False, line_end="\n"):
        self.lines = ["FREE!ship", f"{version / 100:g}"]
        self.comma, self.words, self.line_end = comma, words, line_end

    def _number(self, value):
        text = f"{struct.unpack('<f', struct.pack('<f', value))[0]:.10G}"
        return text.replace(".", ",") if self.comma else text

    def int(self, *values):
        self.lines.extend(str(value) for value in values)

    def float(self, *values):
        self.lines.extend(self._number(value) for value in values)

    def bool(self, *values):
        spelling = ("False", "True") if self.words else ("0", "1")
        self.lines.extend(spelling[bool(value)] for value in values)

    def string(self, text):
        self.lines.append(text.replace("\\", "\\\\").replace("\n", "\\n"))

    def jpeg(self, data):
        self.int(4, 3, len(data))
        self.lines.append(data.hex().upper())

    def row(self, *values):
        self.lines.append(" ".join(self._number(value) for value in values))

    def content(self):
        return (self.line_end.join(self.lines) + self.line_end).encode("cp1251")


def box_model():
    """Half a box 10 x 4 x 3 m, open on top and in the centre plane, its bilge edge a knuckle.

    The bottom face is turned inwards; a deck in a layer of its own is not part of the shell.
    """
    xs, ys, zs = (0.0, 10.0), (0.0, 2.0), (0.0, 3.0)
    return {
        "name": "Ящик",
        "designer": "A\nB \\ C",
        "length": 10.0,
        "beam": 4.1,
        "draft": 1.3,
        "dimensions_set": True,
        "density": 1.025,
        "units": 0,
        "precision": 1,
        "jpeg": b"\xff\xd8 no picture \xff\xd9",
        # name, colour 0xBBGGRR, symmetric, in hydrostatics
        "layers": [("Shell", 0x0000FF, True, True), ("Deck", 0x00FF00, True, False)],
        # x, y, z, type
        "points": [
            (x, y, z, 3 if (x, y, z) == (10.0, 2.0, 0.0) else 0) for x in xs for y in ys for z in zs
        ],
        # start, end, crease; the last one belongs to no face
        "edges": [(2, 6, True), (2, 3, False), (6, 4, True), (0, 7, True)],
        "curves": [[2, 6], [0, 4]],
        # points, layer: side, bottom (inwards), transom, bow, deck
        "faces": [
            ([2, 3, 7, 6], 0),
            ([0, 4, 6, 2], 0),
            ([0, 1, 3, 2], 0),
            ([4, 6, 7, 5], 0),
            ([1, 5, 7, 3], 1),
        ],
        # per family: (type, plane, curves of (x, y, z, knuckle))
        "stations": [
            (1, (1, 0, 0, -2.5), [[(2.5, 0, 0, 0), (2.5, 2, 0, 1), (2.5, 2, 3, 0)]]),
            (1, (1, 0, 0, -5), []),
        ],
        "buttocks": [(2, (0, 1, 0, -0.5), [[(0, 0.5, 0, 0), (10, 0.5, 0, 0)]])],
        "waterlines": [(3, (0, 0, 1, -1), [[(0, 0, 1, 0), (0, 2, 1, 1), (10, 2, 1, 1)], []])],
        "diagonals": [(4, (0, 0.5, 0.5, -1.5), [[(0, 2, 1, 0), (10, 2, 1, 0)]])],
    }


def write_model(sink, version, model):
    """The content of a file of this version that holds the model."""
    sink.int(model["precision"])
    _visibility(sink, version)
    _project(sink, version, model)
    _layers(sink, version, model)
    _mesh(sink, version, model)
    families = ["stations", "buttocks", "waterlines"]
    if version >= 180:
        families.append("diagonals")
    for family in families:
        _sections(sink, version, model[family])
    if version >= 191:
        sink.int(0)
    return sink.content()


def _visibility(sink, version):
    sink.int(1)
    sink.bool(*[index % 2 for index in range(10)])
    sink.float(0.5)
    if version >= 195:
        sink.bool(1)
    if version >= 210:
        sink.float(0.1)
    if version >= 220:
        sink.bool(1, 0, 1, 0, 1, 1)
    if version >= 250:
        sink.bool(0)


def _project(sink, version, model):
    sink.string(model["name"])
    sink.string(model["designer"])
    sink.float(model["length"], model["beam"], model["draft"])
    sink.bool(model["dimensions_set"])
    sink.float(model["density"], 1.005)
    sink.bool(1)
    sink.int(0xF0F0F0, model["units"])
    sink.bool(1)
    sink.float(5.0)
    sink.bool(0)
    sink.string("a comment")
    sink.string("a test")
    if version >= 210:
        sink.int(1)
        sink.bool(model["jpeg"])
        if model["jpeg"]:
            sink.jpeg(model["jpeg"])
    if version >= 230:
        sink.bool(1)
    if version >= 250:
        sink.float(0.5, 1.5, 0.1, 0.0)
        sink.int(1)
        sink.float(7.5)
        sink.float(1.0, 2.0, 3.0)
        sink.bool(1)
        sink.int(2)
        sink.float(10.0, 20.0)
        sink.int(0)
        sink.bool(1)
        sink.float(1.25)
    if version >= 317:
        sink.bool(0)
    if version >= 332:
        sink.bool(1)
    if version >= 500:
        sink.int(7)


def _layers(sink, version, model):
    sink.int(len(model["layers"]))
    for index, (name, colour, symmetric, in_hydrostatics) in enumerate(model["layers"]):
        sink.string(name)
        sink.int(20 + index, colour)
        sink.bool(1, symmetric, index in model.get("developable", ()))
        if version >= 180:
            sink.bool(0, in_hydrostatics)
        if version >= 191:
            sink.float(7.8, 6.0)
        if version >= 201:
            sink.bool(1)
        if version >= 260:
            sink.int(255)
    sink.int(0)


def _mesh(sink, version, model):
    sink.int(len(model["points"]))
    for x, y, z, kind in model["points"]:
        sink.row(x, y, z)
        sink.int(kind)
        sink.bool(0)
        if version >= 198:
            sink.bool(1)
    sink.int(len(model["edges"]))
    for start, end, crease in model["edges"]:
        sink.int(start, end)
        sink.bool(crease, 0)
    if version >= 195:
        sink.int(len(model["curves"]))
        for curve in model["curves"]:
            sink.int(len(curve), *curve)
            sink.bool(0)
    sink.int(len(model["faces"]))
    for face, layer in model["faces"]:
        sink.int(len(face), *face, layer)
        sink.bool(0)


def _sections(sink, version, sections):
    sink.int(len(sections))
    for kind, plane, curves in sections:
        sink.int(kind)
        if version >= 191:
            sink.bool(1)
        sink.row(*plane)
        sink.bool(bool(curves))
        sink.int(len(curves))
        for curve in curves:
            sink.int(len(curve))
            for *point, knuckle in curve:
                if version >= 160 and 1 <= kind <= 3:
                    del point[kind - 1]
                sink.row(*point)
                sink.bool(knuckle)


def binary_file(model, version):
    return write_model(BinarySink(version), version, model)


def text_file(model, version, **spelling):
    return write_model(TextSink(version, **spelling), version, model)
