# SPDX-License-Identifier: GPL-3.0-or-later
"""Hollow models and segments with holes for dowels by programs that are not ours: closed, without
anything to be mended, and of the volume that they should have."""

import hull_io
import hull_native as hn
import numpy as np
import pytest
from model_checkers import ADMESH, FREECAD, admesh, freecad
from test_model_parts import sample_model

pytestmark = pytest.mark.skipif(
    ADMESH is None or FREECAD is None, reason="admesh or FreeCAD is not installed"
)


def written(model, folder, name):
    """(path of its STL file, the model as it is there)."""
    shown = model.scaled(1.0)
    hull_io.write_stl(folder / f"{name}.stl", shown.points, shown.triangles)
    return folder / f"{name}.stl", shown


def look(models, folder):
    """Asserts that both programs find a list of (path, model) closed; what FreeCAD found."""
    found = freecad([path for path, _ in models], folder)
    for path, model in models:
        faults, facets, parts, volume = admesh(path)
        assert not faults and facets == {len(model.triangles)}, (path, faults)
        # Both sum in single precision.
        size = np.prod(np.ptp(model.points, axis=0))
        assert volume == pytest.approx(model.volume, abs=3e-3 * size)
        seen = found[str(path)]
        assert seen["solid"] and not seen["loose"] and seen["facets"] == len(model.triangles)
        assert seen["volume"] == pytest.approx(model.volume, abs=3e-3 * size)
        yield parts, seen


@pytest.mark.parametrize("name, wall", [("coaster", 2.0), ("planing_boat", 1.0)])
def test_walls(name, wall, tmp_path):
    """A model at 1:100 with a wall of mm: the outside, and the hollow."""
    hollow = hn.hollowed(sample_model(name, 8e-4), wall, wall)
    assert hollow.hollows == 1
    ((parts, _),) = look([written(hollow.model, tmp_path, name)], tmp_path)
    assert parts == 2


@pytest.mark.parametrize("name", ["coaster", "naval_vessel", "planing_boat", "container_ship"])
def test_segments_with_dowels(name, tmp_path):
    """Several holes in one joint, at equal heights: they are joined to what is around them so that
    no triangle lies over another."""
    model = sample_model(name, 8e-4)
    size = np.ptp(model.points, axis=0)
    machine = (0.45 * size[0], size[1], max(0.6 * size[1], size[2]))
    dowel = min(6.0, 0.05 * size[1])
    found = hn.segmented(model, machine=machine, planes=12, dowel=dowel, dowel_depth=2.0 * dowel)
    assert found.holes >= 12 and len(found.segments) >= 3
    models = [written(one.model, tmp_path, f"{name}-{k}") for k, one in enumerate(found.segments)]
    for parts, seen in look(models, tmp_path):
        # Of the planing boat a joint ends in points that are on one line but for rounding: FreeCAD
        # takes two triangles that touch there for such as cross.
        assert parts == 1 and (name == "planing_boat" or not seen["crossed"])
