# SPDX-License-Identifier: GPL-3.0-or-later
"""What programs that are not ours find of STL files of models: admesh and FreeCAD."""

import json
import os
import shutil
import subprocess

ADMESH = shutil.which("admesh")
FREECAD = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
# What admesh would have to mend.
_FAULTS = (
    "Degenerate facets",
    "Edges fixed",
    "Facets removed",
    "Facets added",
    "Facets reversed",
    "Backwards edges",
)
_SCRIPT = """
import json, os, Mesh
found = {}
for name in json.loads(os.environ["HULL_MODELS"]):
    mesh = Mesh.Mesh(name)
    found[name] = {
        "solid": mesh.isSolid(),
        "loose": mesh.hasNonManifolds(),
        "crossed": mesh.hasSelfIntersections(),
        "facets": mesh.CountFacets,
        "volume": mesh.Volume,
    }
json.dump(found, open(os.environ["HULL_FOUND"], "w"))
"""


def admesh(path):
    """({fault: how often, of those that there are}, number of facets, number of parts, volume) of
    an STL file."""
    told = subprocess.run([ADMESH, path], capture_output=True, text=True, check=True).stdout
    numbers = {}
    for row in told.splitlines():
        name, colon, rest = row.partition(":")
        if colon:
            numbers[name.strip()] = rest.split()
    faults = {fault: int(numbers[fault][0]) for fault in _FAULTS}
    faults["Disconnected"] = int(numbers["Total disconnected facets"][0])
    volume = float(told.split("Volume   :")[1].split()[0])
    facets = {int(number) for number in numbers["Number of facets"]}
    return (
        {name: count for name, count in faults.items() if count},
        facets,
        int(numbers["Number of parts"][0]),
        volume,
    )


def freecad(paths, folder):
    """{path: what FreeCAD finds}: solid, loose (sides of more than two), crossed (triangles that
    cut one another), facets and volume."""
    script, found = folder / "look.py", folder / "found.json"
    script.write_text(_SCRIPT)
    environment = dict(
        os.environ,
        HOME=str(folder),
        HULL_MODELS=json.dumps([str(path) for path in paths]),
        HULL_FOUND=str(found),
    )
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        [FREECAD, script],
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=600,
    )
    assert found.exists(), done.stdout + done.stderr
    return json.loads(found.read_text())
