# SPDX-License-Identifier: GPL-3.0-or-later
"""A family of hulls between two: the second one gets the first one's control mesh, and members in
between are blends of both.

python family_of_hulls.py FIRST SECOND FOLDER [MEMBERS]

Writes FOLDER/member-0.00.hull.json and the like, and prints draft, displacement and block
coefficient of each.
"""

import sys
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np

CORNER = 3  # and 4, the tip of a cone: see ControlMesh.vertex_kinds


def surface_of(data):
    """The hull_native.LimitSurface of a hull_io.HullData's shell."""
    shell = hull_io.shell_arrays(data)
    return hn.LimitSurface(hn.ControlMesh(*shell.arguments()), data.scheme)


def hull_of(surface, name, half, particulars):
    """The hull_io.HullData of a surface's control mesh."""
    mesh = surface.mesh
    faces = np.split(mesh.face_vertices, np.cumsum(mesh.face_sizes)[:-1])
    return hull_io.HullData(
        name=name,
        points=mesh.points,
        faces=[face.tolist() for face in faces],
        creases=[tuple(sorted(edge)) for edge in mesh.creases.tolist()],
        corners=np.flatnonzero(mesh.vertex_kinds >= CORNER).tolist(),
        half=half,
        scheme=surface.scheme,
        particulars=particulars,
    )


def blend(first, second, t):
    """hull_io.Particulars between two hulls'."""
    values = {
        key: (1.0 - t) * value + t * getattr(second, key) for key, value in vars(first).items()
    }
    return hull_io.Particulars(**values)


def main(first, second, folder, members="5"):
    hulls = [hull_io.read_hull(path) for path in (first, second)]
    layout = hn.common_layout([surface_of(data) for data in hulls])
    print(f"The second hull is met within {layout.fits[1].rms:.4f} m (root mean square)")
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    parent = layout.parents[0]
    for t in np.linspace(0.0, 1.0, int(members)):
        points = layout.family.points([1.0 - t, t])
        surface = hn.LimitSurface(parent.mesh.with_points(points), parent.scheme)
        particulars = blend(hulls[0].particulars, hulls[1].particulars, t)
        body = hn.HullBody(surface, mirrored=hulls[0].half)
        at = hn.hydrostatics(body, draft=particulars.draft)
        print(
            f"t {t:.2f}: T {particulars.draft:.3f} m, ∇ {at.displaced_volume:.1f} m³, "
            f"Cb {at.immersed.block:.4f}"
        )
        name = f"member-{t:.2f}"
        data = hull_of(surface, name, hulls[0].half, particulars)
        hull_io.write_hull_file(data, folder / f"{name}.hull.json")


if __name__ == "__main__":
    main(*sys.argv[1:])
