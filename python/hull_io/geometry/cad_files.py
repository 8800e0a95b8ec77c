# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves and surfaces of STEP and IGES files, by way of Open CASCADE in a process of its own.

Damaged files can end Open CASCADE or keep it busy for ever, and then only that process is lost. It
is `hull_native.cad_process`, beside this package; memory and time are bounded.
"""

import io
import json
import os
import subprocess
import sys
import tempfile
import threading
import zlib
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from ..errors import HullFileError
from ..limits import (
    CAD_MEMORY_BYTES,
    CAD_MEMORY_PER_BYTE,
    CAD_SECONDS,
    CAD_SECONDS_PER_MB,
    FURTHEST_POINT,
    MAX_GEOMETRY_CURVES,
    MAX_GEOMETRY_POINTS,
)
from .splines import Spline
from .values import METRES_PER_UNIT, Geometry, GeometryMesh, spline_curve

_REFUSED = 3
_SPLINE_PARTS = ("knots", "weights", "points")
_REMEDY = "export it again from the program it comes from, as STEP AP214 if that can be chosen"


def is_cad(data):
    """Whether bytes begin as a STEP or an IGES file does."""
    return b"ISO-10303-21" in data[:80] or data[72:73] == b"S" and data[73:80].strip().isdigit()


def read_cad(path, chord_share, progress=None):
    """The Geometry of a STEP or IGES file, its numbers in the file's own unit where that is known.

    chord_share: of the size, how far triangles may be from their face. progress: called with the
    share that is done; what it raises ends the reading. HullFileError.
    """
    path = Path(path)
    with tempfile.TemporaryDirectory(prefix="hull_cad_") as folder:
        output = Path(folder) / "geometry.npz"
        _run(path, output, chord_share, progress)
        try:
            with np.load(output, allow_pickle=False) as archive:
                return _geometry(dict(archive), path.name)
        except HullFileError:
            raise
        except (OSError, KeyError, ValueError, EOFError, BadZipFile, zlib.error) as error:
            raise HullFileError(
                f"{path.name}: what was read of it can't be used ({error}); {_REMEDY}."
            ) from error


def _run(path, output, chord_share, progress):
    size = path.stat().st_size
    seconds = CAD_SECONDS + int(CAD_SECONDS_PER_MB * size / 2**20)
    memory = CAD_MEMORY_BYTES + CAD_MEMORY_PER_BYTE * size
    command = [sys.executable, "-m", "hull_native.cad_process"]
    command += [str(path.resolve()), str(output), repr(chord_share)]
    command += [str(memory), str(seconds)]
    with tempfile.TemporaryFile() as complaints:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=complaints,
            env=_environment(),
        )
        # The process ends itself by the time that it computes; this is for one that sleeps.
        watch = threading.Timer(20 * seconds, process.kill)
        watch.start()
        try:
            for line in process.stdout:
                if progress is not None:
                    progress(_share(line))
        finally:
            watch.cancel()
            if process.poll() is None and sys.exc_info()[0] is not None:
                process.kill()
            process.wait()
            process.stdout.close()
        if process.returncode:
            complaints.seek(0)
            raise _refusal(path, process.returncode, complaints.read(100_000), seconds)


def _share(line):
    try:
        return min(max(float(line[:20]), 0.0), 1.0)
    except ValueError:
        return 0.0


def _environment():
    """With this package's folder, where an add-on has hull_native, in the Python path; and one
    thread, for others take address space that nothing uses."""
    # Not resolved: a build has links to this package beside hull_native.
    folders = [str(Path(__file__).absolute().parents[2]), *filter(None, sys.path)]
    return {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(folders),
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
    }


def _refusal(path, status, complaints, seconds):
    text = complaints.decode(errors="replace").strip()
    if status == _REFUSED:
        reason = (text.splitlines() or [""])[-1].replace(f'Cannot read "{path.resolve()}": ', "")
    elif "No module named" in text:
        return HullFileError(
            f"{path.name}: STEP and IGES files are read by the native module, which is not there; "
            "install the add-on's package of this system."
        )
    elif status == -9 or status == -24:
        reason = f"it takes Open CASCADE more than {seconds} s"
    else:
        reason = "Open CASCADE breaks off in it; it is damaged or too large"
    return HullFileError(f"{path.name}: {reason.rstrip('.')[:300]}; {_REMEDY}.")


def _geometry(arrays, name):
    about = json.load(io.BytesIO(arrays.pop("about").tobytes()))
    unit = about["unit"] or "m"
    scale = 1.0 / METRES_PER_UNIT[unit]
    curves, meshes = about["curves"], about["faces"]
    count = sum(int(arrays[f"{kind}_points_sizes"].sum()) for kind in ("curve", "face"))
    if count > MAX_GEOMETRY_POINTS or len(curves) > MAX_GEOMETRY_CURVES:
        raise HullFileError(
            f"{name}: it has {count} points and {len(curves)} curves, more than is read; export "
            "the hull alone."
        )
    parts = {key: _parts(arrays, key) for key in ("curve_knots", "curve_weights", "curve_points")}
    parts |= {key: _parts(arrays, key) for key in ("face_points", "face_triangles")}
    left_out = [
        f"{about[f'{kind}s_left_out']} {kind}s of which nothing could be made are left out."
        for kind in ("curve", "face")
        if about[f"{kind}s_left_out"]
    ]
    made, wrong = [], 0
    for k, told in enumerate(curves):
        curve = _curve(told, scale, *(parts[f"curve_{key}"][k] for key in _SPLINE_PARTS))
        wrong += curve is None
        made += [curve] if curve is not None else []
    if wrong:
        left_out.append(f"{wrong} curves that are no splines, or have no length, are left out.")
    faces = tuple(
        GeometryMesh(
            scale * parts["face_points"][k],
            parts["face_triangles"][k].astype(int),
            told["name"],
            told["layer"],
            is_exact=False,
        )
        for k, told in enumerate(meshes)
    )
    found = Geometry(
        name, about["format"], unit, tuple(made), faces, scale * arrays["points"], tuple(left_out)
    )
    points = found.all_points()
    if found.is_empty or not np.abs(points).max() <= FURTHEST_POINT / METRES_PER_UNIT[unit]:
        raise HullFileError(
            f"{name}: it holds nothing, or what is further than {FURTHEST_POINT:.0f} m from the "
            f"origin; {_REMEDY}."
        )
    return found


def _parts(arrays, key):
    sizes = arrays[f"{key}_sizes"]
    if not len(sizes):
        return []
    return np.split(arrays[key], np.cumsum(sizes)[:-1])


def _curve(told, scale, knots, weights, points):
    """None where it is no curve."""
    weights = weights if len(weights) else np.ones(len(points))
    kind = "" if told["faces"] == 0 else "border" if told["faces"] == 1 else "edge"
    try:
        spline = Spline(told["degree"], knots, scale * points, weights)
        return spline_curve(spline, name=told["name"], kind=kind, group=told["layer"])
    except ValueError:
        return None
