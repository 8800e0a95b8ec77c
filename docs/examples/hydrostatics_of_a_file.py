# SPDX-License-Identifier: GPL-3.0-or-later
"""Hydrostatics of a hull file at several drafts, as a table.

python hydrostatics_of_a_file.py FILE [DRAFT ...]

FILE: a hull file of Hull Tools (.hull.json) or a FREE!ship model (.fbm, .ftm). Without drafts, in
m, half to all of the design draft.
"""

import sys

import hull_io
import hull_native as hn
import numpy as np


def body_of(data):
    """The hull_native.HullBody of a hull_io.HullData: of the faces that count in hydrostatics."""
    shell = hull_io.shell_arrays(data)
    mesh = hn.ControlMesh(*shell.arguments())
    return hn.HullBody(hn.LimitSurface(mesh, data.scheme), mirrored=data.half)


def main(path, *drafts):
    data = hull_io.read_hull(path)
    body, particulars = body_of(data), data.particulars
    chosen = [float(draft) for draft in drafts]
    print(f"{data.name or path}: Lpp {particulars.length_pp:.2f} m, B {particulars.beam:.2f} m")
    print(f"{'T, m':>8}{'∇, m³':>12}{'LCB, m':>10}{'KMt, m':>10}{'S, m²':>10}{'Cb':>8}")
    for draft in chosen or np.linspace(0.5, 1.0, 6) * particulars.draft:
        at = hn.hydrostatics(
            body,
            draft=draft,
            length_pp=particulars.length_pp or None,
            beam=particulars.beam or None,
        )
        print(
            f"{draft:8.3f}{at.displaced_volume:12.2f}{at.lcb:10.3f}{at.km_transverse:10.3f}"
            f"{at.wetted_surface:10.1f}{at.project.block:8.4f}"
        )


if __name__ == "__main__":
    main(*sys.argv[1:])
