# SPDX-License-Identifier: GPL-3.0-or-later
"""A STEP or IGES file read in a process of its own, within bounded memory and time.

python -m hull_native.cad_process FILE OUTPUT CHORD_SHARE MEMORY_BYTES SECONDS

Open CASCADE can be ended by damaged files, or never come back from them: then only this process is
lost. What read_cad_geometry finds goes to OUTPUT, a NumPy archive in which all curves and all faces
follow one another; shares of the work that is done go to the standard output, and what a file is
refused for to the standard error, with the exit status 3.
"""

import json
import resource
import sys

REFUSED = 3


def flat(found):
    """Arrays and one text for an archive: numbers of all, one after the other, and how many are
    whose."""
    curves, faces = found.pop("curves"), found.pop("faces")
    arrays = {"points": found.pop("points")}
    for kind, parts, names in (
        ("curve", curves, ("knots", "weights", "points")),
        ("face", faces, ("points", "triangles")),
    ):
        for name in names:
            values = [part.pop(name) for part in parts]
            arrays[f"{kind}_{name}_sizes"] = np.array([len(value) for value in values], dtype=int)
            if values:
                arrays[f"{kind}_{name}"] = np.concatenate(values)
    about = {**found, "curves": curves, "faces": faces}
    return {**arrays, "about": np.frombuffer(json.dumps(about).encode(), dtype=np.uint8)}


def main(path, output, chord_share):
    def tell(share):
        print(f"{share:.3f}", flush=True)

    try:
        found = read_cad_geometry(path, chord_share=float(chord_share), progress=tell)
        np.savez(output, **flat(found))
    except (OSError, RuntimeError, MemoryError) as error:
        print(str(error) or "there is not enough memory", file=sys.stderr)
        sys.exit(REFUSED)


if __name__ == "__main__":
    *words, memory, seconds = sys.argv[1:]
    # Before anything large is loaded.
    resource.setrlimit(resource.RLIMIT_AS, (int(memory), int(memory)))
    resource.setrlimit(resource.RLIMIT_CPU, (int(seconds), int(seconds)))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    import numpy as np

    from ._exchange import read_cad_geometry

    main(*words)
