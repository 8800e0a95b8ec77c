# SPDX-License-Identifier: GPL-3.0-or-later
"""Run by FreeCAD: what it finds in the CAD files named in the JSON file HULL_FREECAD_FILES; it goes
into the JSON file HULL_FREECAD_REPORT."""

import json
import os

import Part

METRE = 1000.0  # FreeCAD's own unit is the millimetre


def report(path):
    shape = Part.Shape()
    shape.read(path)
    ends = shape.BoundBox
    return {
        "valid": shape.isValid(),
        "solids": len(shape.Solids),
        "shells": len(shape.Shells),
        "closed": [shell.isClosed() for shell in shape.Shells],
        "faces": len(shape.Faces),
        "edges": len(shape.Edges),
        "volume": shape.Volume / METRE**3,
        "area": shape.Area / METRE**2,
        "length": (ends.XMax - ends.XMin) / METRE,
    }


with open(os.environ["HULL_FREECAD_FILES"]) as file:
    found = {path: report(path) for path in json.load(file)}
with open(os.environ["HULL_FREECAD_REPORT"], "w") as file:
    json.dump(found, file)
