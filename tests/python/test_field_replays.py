# SPDX-License-Identifier: GPL-3.0-or-later
"""The published examples of shape fields (Veelo 2004, 6.1 and 6.2) on hulls of ours."""

from functools import cache

import field_replays
import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness import lines

# Where marks of the frigate's fore ship are counted.
FORE_SHIP = np.array([60.0, -1.0, -5.0]), np.array([200.0, 20.0, 20.0])


@cache
def frigate(subdivided=0):
    return field_replays.refined(vessels.vessel(field_replays.NAME).surface, subdivided)


def beam():
    return vessels.vessel(field_replays.NAME).data.particulars.beam


def inflections(surface):
    """How many the waterlines of the frigate's fore ship have together."""
    judged = lines.judged(surface, beam(), within=FORE_SHIP)
    return sum(
        found.mark == "inflection"
        for line in judged
        if line.kind == "waterline"
        for found in line.found
    )


def narrowed(surface, protected):
    """The surface and hull_native.Reshaped; followed to within a few centimetres, unfolded."""
    moved, result = field_replays.follow(surface, field_replays.narrowing(surface, protected))
    assert result.folded_place is None
    assert result.rms < 3e-3 and result.largest < 0.02
    point = field_replays.point_of_narrowing(surface)
    wanted = point - [0.0, field_replays.NARROWER, 0.0]
    assert hn.SurfaceTree(moved).closest_points(wanted[None]).distances[0] < 0.01
    return moved, result


@pytest.mark.parametrize("subdivided", [0, 1])
def test_narrowed_waterlines_inflect_by_what_the_stem_is_protected_with(subdivided):
    surface = frigate(subdivided)
    before = inflections(surface)
    counts = {
        "plane, falloff 1": inflections(narrowed(surface, field_replays.plane_protected(1.0))[0])
    }
    for falloff in (1.0, field_replays.STEM_FALLOFF):
        protected = field_replays.stem_protected(surface, falloff)
        counts[f"stem, falloff {falloff}"] = inflections(narrowed(surface, protected)[0])
    print("before", before, counts)
    recommended = counts.pop(f"stem, falloff {field_replays.STEM_FALLOFF}")
    assert recommended == before == 4
    assert min(counts.values()) >= 18


def test_the_knuckle_stays_a_crease_where_it_moves():
    surface = frigate()
    protected = field_replays.stem_protected(surface, field_replays.STEM_FALLOFF)
    fields = field_replays.narrowing(surface, protected)
    moved, _ = narrowed(surface, protected)
    number = field_replays.knuckle(surface)
    before, after = (hn.crease_curves(s)[number] for s in (surface, moved))
    assert np.array_equal(moved.mesh.creases, surface.mesh.creases)
    assert np.array_equal(after.vertices, before.vertices)
    t = np.linspace(0.0, before.edge_count, 200)
    (points,), (there,) = before.evaluate(t), after.evaluate(t)
    assert np.abs(there - points).max() > 0.4
    wanted = hn.FieldCurve(points + fields.at(points)[0])
    assert wanted.distances(there).max() < 0.02
    # No less of a knuckle anywhere: by less than a degree.
    angles = [hn.knuckle_angles(s, number).angles for s in (surface, moved)]
    np.testing.assert_allclose(angles[1], angles[0], atol=np.radians(1.0))
    # One curve, seen from both sides.
    tree = hn.SurfaceTree(moved)
    assert tree.closest_points(there).distances.max() < 1e-12 * surface.mesh.size


@pytest.mark.parametrize("subdivided", [0, 1])
def test_a_protected_knuckle_stays_where_it_is(subdivided):
    surface = frigate(subdivided)
    number = field_replays.knuckle(surface)
    crease = hn.crease_curves(surface)[number]
    curve = hn.FieldCurve.of_crease(crease)
    protected = field_replays.stem_protected(surface, field_replays.STEM_FALLOFF)
    protected.append(hn.ShapeField.along(curve, extent=8.0, falloff=0.5, protects=True))
    fields = field_replays.narrowing(surface, protected)
    moved, result = field_replays.follow(surface, fields, kept=crease.vertices)
    assert result.folded_place is None and np.abs(result.moves[:, 1]).max() > 0.4
    assert not result.moves[crease.vertices].any()
    t = np.linspace(0.0, crease.edge_count, 200)
    apart = hn.crease_curves(moved)[number].evaluate(t)[0] - crease.evaluate(t)[0]
    assert np.abs(apart).max() < 1e-12 * surface.mesh.size
    # The field is level at its base, the surface has no second derivative across a crease: its
    # sides turn in proportion to the distance of control points.
    angles = [hn.knuckle_angles(s, number).angles for s in (surface, moved)]
    np.testing.assert_allclose(angles[1], angles[0], atol=np.radians(9.0 / 2**subdivided))
