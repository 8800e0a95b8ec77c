# SPDX-License-Identifier: GPL-3.0-or-later
"""The samples as scripts want them: their data, their exact surface, what their sources tell."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import hull_io
import numpy as np
import sources

ROOT = Path(__file__).resolve().parents[1]
SAMPLES = ROOT / "samples"
_ENDING = ".hull.json"


def names():
    """Names of all samples."""
    return sorted(path.name.removesuffix(_ENDING) for path in SAMPLES.glob("*" + _ENDING))


def surface_of(data):
    """The hull_native.LimitSurface of a HullData's shell."""
    import hull_native as hn

    shell = hull_io.shell_arrays(data)
    return hn.LimitSurface(hn.ControlMesh(*shell.arguments()), data.scheme)


def surface_of_sample(name):
    """The same of a sample, one of its own."""
    return surface_of(hull_io.read_hull(SAMPLES / (name + _ENDING)))


def curves_of(surface, stations, waterlines, tolerance, **more):
    """The hull_native.NetworkCurves of so many stations and waterlines, evenly spaced, and of
    borders and creases; tolerance: of the length. more: other arguments of network_curves."""
    import hull_native as hn

    low, high = surface.mesh.points.min(axis=0), surface.mesh.points.max(axis=0)
    return hn.network_curves(
        surface,
        stations=even(low[0], high[0], stations),
        waterlines=even(low[2], high[2], waterlines),
        tolerance=tolerance * (high[0] - low[0]),
        **more,
    )


def triangles_of(surface, parts=8):
    """(points, triangles) of a LimitSurface, each cell's side in so many parts."""
    facets = surface.tessellate(parts)
    quads = facets.quads
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return np.asarray(facets.points), triangles


def even(low, high, count):
    """(count,) places between two, with equal distances, neither of them among them."""
    return np.linspace(low, high, count + 2)[1:-1]


@dataclass(frozen=True)
class Vessel:
    """A hull: name, HullData and the module of its source, None where there is none."""

    name: str
    data: object
    source: object = None

    @cached_property
    def surface(self):
        return surface_of(self.data)

    @property
    def wanted(self):
        return getattr(self.source, "WANTED", ())


def vessel(name):
    """The Vessel of a sample's name, or of the path of any hull file."""
    path = SAMPLES / (name + _ENDING)
    if not path.exists():
        return Vessel(Path(name).name.removesuffix(_ENDING), hull_io.read_hull(Path(name)))
    source = sources.source(name) if name in sources.names() else None
    return Vessel(name, hull_io.read_hull(path), source)
