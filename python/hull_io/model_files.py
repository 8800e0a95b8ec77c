# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed models for printers and mills: 3MF, and layers as CLI. STL is in stl.py.

Lengths are in millimetres. All raise HullFileError where the file can't be written, leaving what
was there, and ValueError for what is no model.
"""

import io
import zipfile
from pathlib import Path
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from .bytes_on_disk import write_bytes
from .face_arrays import checked_faces, lines_of

_NAMESPACE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_CONTENT_TYPES = f"""<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="{_PACKAGE}/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONSHIPS = f"""<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="{_PACKAGE}/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
# Of single precision, as hull_native.ClosedModel.scaled() makes coordinates: to be told apart.
_PLACE = "%.9g"


def write_3mf(path, points, triangles, *, title="Hull"):
    """A 3MF file of one object: points (n, 3) in mm, triangles (m, 3) counter-clockwise seen from
    outside. The same model gives the same bytes."""
    write_bytes(Path(path), bytes_of_3mf([(title, points, triangles)], title))


def bytes_of_3mf(objects, title):
    """The bytes of a 3MF file of objects (name, points (n, 3) in mm, triangles (m, 3)), which lie
    where their points are."""
    model = b"".join(
        [
            b'<?xml version="1.0" encoding="UTF-8"?>\n'
            b'<model unit="millimeter" xml:lang="en-US" xmlns="%s">\n' % _NAMESPACE.encode(),
            b'<metadata name="Title">%s</metadata>\n' % escape(title).encode("utf-8"),
            b"<resources>",
            *(_mesh_of(number, *one) for number, one in enumerate(objects, 1)),
            b"</resources>\n<build>",
            *(b'<item objectid="%d"/>' % number for number in range(1, len(objects) + 1)),
            b"</build>\n</model>\n",
        ]
    )
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as package:
        for name, content in (
            ("[Content_Types].xml", _CONTENT_TYPES),
            ("_rels/.rels", _RELATIONSHIPS),
            ("3D/3dmodel.model", model),
        ):
            entry = zipfile.ZipInfo(name)  # of 1 January 1980, whenever it is written
            entry.compress_type = zipfile.ZIP_DEFLATED
            package.writestr(entry, content)
    return buffer.getvalue()


def _mesh_of(number, name, points, triangles):
    """One object of a 3MF model."""
    points, triangles = checked_faces(points, triangles, 3)
    vertex = f'<vertex x="{_PLACE}" y="{_PLACE}" z="{_PLACE}"/>'
    head = f'<object id="{number}" name={quoteattr(name)} type="model"><mesh>\n<vertices>\n'
    return b"".join(
        [
            head.encode("utf-8"),
            lines_of(points, vertex),
            b"</vertices>\n<triangles>\n",
            lines_of(triangles, '<triangle v1="%d" v2="%d" v3="%d"/>'),
            b"</triangles>\n</mesh></object>",
        ]
    )


def write_cli(path, layers):
    """A CLI file (Common Layer Interface 2.0, text, unit 1 mm) of `hull_native.ModelLayers` of a
    model in mm: z counts from the model's lowest point, contours are those of the middles of
    layers, counter-clockwise outside (1) and clockwise around what is hollow (0)."""
    if not layers.slices:
        raise ValueError("There is no layer to write.")
    lines = [
        "$$HEADERSTART\n$$ASCII\n$$UNITS/1\n$$VERSION/200\n$$LABEL/1,hull\n",
        f"$$LAYERS/{len(layers.slices)}\n$$HEADEREND\n$$GEOMETRYSTART\n$$LAYER/0\n",
    ]
    for one, top in zip(layers.slices, layers.tops):
        lines.append(f"$$LAYER/{top - layers.bottom:.9g}\n")
        for contour in one.contours:
            closed = np.vstack([contour, contour[:1]]) + 0.0
            following = np.roll(contour, -1, axis=0)
            turn = np.sum(contour[:, 0] * following[:, 1] - following[:, 0] * contour[:, 1])
            places = ",".join(f"{x:.6f}" for x in closed.ravel())
            lines.append(f"$$POLYLINE/1,{int(turn > 0.0)},{len(closed)},{places}\n")
    lines.append("$$GEOMETRYEND\n")
    write_bytes(Path(path), "".join(lines).encode("ascii"))
