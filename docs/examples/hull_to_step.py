# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull file as a closed STEP solid, or as a shell in an IGES file.

python hull_to_step.py FILE OUTPUT.step|OUTPUT.igs

Written are few large B-spline patches that are the exact surface but for vanishing squares at
irregular points; what was written is read back, and told.
"""

import sys

import hull_io
import hull_native as hn


def surface_of(data):
    """The hull_native.LimitSurface of a hull_io.HullData's shell."""
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.LimitSurface(mesh, data.scheme)


def main(path, output):
    data = hull_io.read_hull(path)
    surface = surface_of(data)
    if output.lower().endswith((".igs", ".iges")):
        report = hn.write_iges(surface, output, mirrored=data.half)
    else:
        report = hn.write_step(surface, output, mirrored=data.half, solid=True, unit="mm")
    for name, value in report.items():
        print(f"{name}: {value}")


if __name__ == "__main__":
    main(*sys.argv[1:])
