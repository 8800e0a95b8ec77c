# SPDX-License-Identifier: GPL-3.0-or-later
"""Stations that only touch the surface along lines, as at the flat ends of fine meshes."""

import time
from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np

SAMPLES = Path(__file__).resolve().parents[2] / "samples"


def surface_of(points, face_sizes, face_vertices, creases=(), corners=()):
    return hn.LimitSurface(hn.ControlMesh(points, face_sizes, face_vertices, creases, corners))


def fine_barge():
    """The barge's shown surface, rounded to single precision, as a control mesh without creases."""
    shell = hull_io.shell_arrays(hull_io.read_hull(SAMPLES / "barge.hull.json"))
    coarse = surface_of(*shell.arguments())
    shown = coarse.tessellate(3)
    points = shown.points.astype(np.float32).astype(float)
    return surface_of(points, np.full(len(shown.quads), 4), shown.quads.ravel())


def spent(work):
    """(processor time of the fastest of three, result)."""
    times = []
    for _ in range(3):
        begun = time.process_time()
        result = work()
        times.append(time.process_time() - begun)
    return min(times), result


def test_the_largest_station_does_not_wait_for_those_at_the_ends():
    surface = fine_barge()
    body = hn.HullBody(surface, mirrored=True, tolerance=1e-8)
    z, x = surface.mesh.points[:, 2], surface.mesh.points[:, 0]
    draft = 0.6 * z.max()
    at_end, areas = spent(lambda: hn.section_areas(body, [x.max()], draft=draft).areas)
    in_all, found = spent(lambda: hn.hydrostatics(body, draft=draft))
    # There are two ends, and much else is done.
    assert in_all < 0.5 * at_end
    middle = hn.section_areas(body, [x.mean()], draft=draft).areas[0]
    assert found.largest_section.area >= middle * (1.0 - 1e-9) and areas[0] < 0.1 * middle
