# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads damaged copies of a hull file in a process of its own, within bounded memory.

python corruption_worker.py FILE SEED NUMBER MEMORY_BYTES

Prints one JSON object: how many copies were read and refused, the longest processor time of one
(s), the largest memory (bytes), and every failure as [number of the copy, what happened].
"""

import json
import random
import resource
import struct
import sys
import tempfile
import time
import traceback
from pathlib import Path

import hull_io

ABSURD = (-(2**31), -1, 1, 255, 65_536, 249_999, 250_000, 16_777_216, 2**31 - 1)


def count_places(data, name):
    """Where the reader meets a count: (offset, length) of each in the undamaged file."""
    from hull_io import cursors, freeship

    places = []
    original = cursors.Cursor.count

    def noting(cursor, *arguments):
        before = cursor.offset
        number = original(cursor, *arguments)
        places.append((before, cursor.offset - before))
        return number

    cursors.Cursor.count = noting
    try:
        freeship.read_stored_sections(data, name)
    finally:
        cursors.Cursor.count = original
    return places


def damaged(data, places, binary, choice):
    """One damaged copy: cut short, some bits turned, or a count made absurd."""
    kind = choice.randrange(4)
    if kind == 0:
        return data[: choice.randrange(len(data))]
    if kind == 1:
        copy = bytearray(data)
        for _ in range(choice.choice((1, 2, 8, 64))):
            copy[choice.randrange(len(copy))] ^= 1 << choice.randrange(8)
        return bytes(copy)
    value = choice.choice(ABSURD)
    if kind == 2:
        start, length = choice.choice(places)
    else:
        start, length = choice.randrange(len(data) - 4), 4
    new = struct.pack("<i", value) if binary else b"%d\n" % value
    return data[:start] + new + data[start + length :]


def check_hull(hull):
    """What every consumer relies on, whatever the file was."""
    count = len(hull.points)
    assert (abs(hull.points) <= 1e6).all()
    assert len(hull.face_layers) == len(hull.faces)
    for face, layer in zip(hull.faces, hull.face_layers):
        assert len(set(face)) == len(face) >= 3
        assert all(0 <= point < count for point in face)
        assert 0 <= layer < len(hull.layers)
    assert all(0 <= point < count for point in hull.corners)
    shell = hull_io.shell_arrays(hull)
    assert shell.face_sizes.sum() == len(shell.face_vertices)


def try_to_read(path, with_sections):
    """Whether the file was read (True) or refused in one sentence (False)."""
    try:
        if with_sections:
            hull_io.stored_sections(path)
        check_hull(hull_io.read_hull(path))
    except hull_io.HullFileError as error:
        assert str(error).startswith(path.name) and str(error).endswith(".")
        return False
    return True


def peak_memory():
    """Bytes this process held at most. Not ru_maxrss, which counts what its parent held before."""
    status = Path("/proc/self/status").read_text()
    line = next(line for line in status.splitlines() if line.startswith("VmHWM:"))
    return int(line.split()[1]) * 1024


def main():
    source, seed, number, memory = Path(sys.argv[1]), *map(int, sys.argv[2:])
    data = source.read_bytes()
    places = count_places(data, source.name)
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    choice = random.Random(seed)
    result = {"read": 0, "refused": 0, "longest": 0.0, "failures": []}
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / source.name
        for copy in range(number):
            path.write_bytes(damaged(data, places, source.suffix == ".fbm", choice))
            start = time.process_time()
            try:
                result["read" if try_to_read(path, copy % 4 == 0) else "refused"] += 1
            except Exception:
                result["failures"].append([copy, traceback.format_exc()])
            result["longest"] = max(result["longest"], time.process_time() - start)
    result["memory"] = peak_memory()
    print(json.dumps(result))


if __name__ == "__main__":
    main()
