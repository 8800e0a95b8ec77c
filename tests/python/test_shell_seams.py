# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams by rules part the shell of any hull in plates: what ends within a plate is left out and
told, knuckles that fade out get a butt, transoms have no seam, demihulls have seams on either
side."""

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_native import surface_areas
from plate_hulls import cylinder, one
from production_hulls import SAMPLES, body_of
from reference_data import foreign_ships, hull_path
from transformation_hulls import grid_mesh


def surface_of(name):
    if name in SAMPLES:
        return body_of(name)[0].surface
    shell = hull_io.shell_arrays(hull_io.read_hull(hull_path(name)))
    return hn.LimitSurface(hn.ControlMesh(*shell.arguments()), "biermann")


def shell_of(name, share=30.0):
    """(surface, seams) by strakes and butts as broad and long as suits the length."""
    surface = surface_of(name)
    length = np.ptp(surface.mesh.points[:, 0])
    rules = [hn.SeamRule("strakes", length / share), hn.SeamRule("butts", length / 6.0)]
    return surface, hn.seams_by_rules(surface, rules)[1]


@pytest.mark.one_in(5)
@pytest.mark.parametrize("name", [*SAMPLES, *foreign_ships()])
def test_every_shell_is_parted_in_plates(name):
    surface, seams = shell_of(name)
    left_out = []
    plates = hn.plates(surface, seams, left_out=left_out)
    assert len(plates) > 12
    whole = surface_areas(surface).areas.sum()
    assert sum(plate.area for plate in plates) == pytest.approx(whole, rel=1e-9)
    lengths = {}
    for seam in seams:
        steps = np.linalg.norm(np.diff(seam.points, axis=0), axis=1)
        lengths[seam.name] = lengths.get(seam.name, 0.0) + steps.sum()
    for found, length, place in left_out:
        assert 0.0 < length <= (1.0 + 1e-6) * lengths[found]
        assert hn.SurfaceTree(surface).closest_points(place[None]).distances[0] < 0.05


def half_seam(surface):
    curves = hn.HullCurves(surface)
    whole = one(curves.in_plane(hn.plane_across("x", 3.0), "half"))
    return curves.pieces(whole, curves.in_plane(hn.plane_across("y", 2.0), "cut"))[0]


def test_what_ends_within_a_plate_is_left_out_where_that_is_asked_for():
    surface = cylinder()
    half, left_out = half_seam(surface), []
    with pytest.raises(ValueError, match='"half" has the same plate on both sides'):
        hn.plates(surface, [half])
    (plate,) = hn.plates(surface, [half], left_out=left_out)
    assert {name for side in plate.loops for name, _ in side} == {""}
    ((name, length, place),) = left_out
    steps = np.linalg.norm(np.diff(half.points, axis=0), axis=1)
    assert name == "half" and length == pytest.approx(steps.sum(), rel=1e-3)
    assert place[0] == pytest.approx(3.0)


def test_the_part_between_others_stays():
    """A seam that goes on beyond the last one that it meets."""
    surface = cylinder()
    curves, left_out = hn.HullCurves(surface), []
    butt = curves.in_plane(hn.plane_across("x", 3.0), "butt")
    seam = one(curves.in_plane(hn.plane_across("y", 2.0), "seam"))
    forward = curves.in_plane(hn.plane_across("x", 4.5), "end")
    pieces = curves.pieces(seam, forward)
    long = max(pieces, key=lambda piece: np.ptp(piece.points[:, 0]))
    plates = hn.plates(surface, [*butt, long], left_out=left_out)
    assert len(plates) == 3
    ((name, length, _),) = left_out
    assert name == "seam" and length == pytest.approx(1.5, rel=1e-6)


def test_a_knuckle_that_fades_out_is_closed_by_a_butt():
    surface, seams = shell_of("research_vessel")
    knuckles = [seam for seam in seams if seam.name == "knuckle"]
    bare = [seam for seam in seams if not seam.name.startswith("Butt")]
    with pytest.raises(ValueError, match='"knuckle" has the same plate on both sides'):
        hn.plates(surface, bare, left_out=[])
    left_out = []
    hn.plates(surface, seams, left_out=left_out)
    faded = sum(length for name, length, _ in left_out if name == "knuckle")
    assert len(knuckles) > 2 and faded < 0.5


def test_seams_of_a_demihull_are_on_both_sides():
    surface, seams = shell_of("catamaran")
    rows = [seam for seam in seams if seam.name.startswith("Seam")]
    middle = 0.5 * (surface.mesh.points[:, 1].min() + surface.mesh.points[:, 1].max())
    sides = {np.sign(seam.points[:, 1].mean() - middle) for seam in rows}
    assert sides == {-1.0, 1.0}
    for seam in rows:
        beyond = (seam.points[:, 1] - middle) * np.sign(seam.points[:, 1].mean() - middle)
        assert beyond.min() > -1e-6


def test_a_transom_has_no_seam_by_girth():
    _, seams = shell_of("barge")
    rows = [seam for seam in seams if seam.name.startswith("Seam")]
    assert len(rows) > 2 and all(np.ptp(seam.points[:, 0]) > 1.0 for seam in rows)


def test_a_seam_around_a_sharp_stem_is_followed():
    """The chord from side to side is far from it, and halving comes no nearer."""
    surface = body_of("catamaran")[0].surface
    curves = hn.HullCurves(surface)
    deck = max(curves.borders(), key=lambda c: c.points[:, 1].mean())
    around = curves.at_girth(deck, 1.0, towards=(0.0, 0.0, -1.0), name="girth")
    pieces = [p for curve in around for p in curves.pieces(curve, curves.knuckles())]
    assert len(pieces) >= 2
    stem = max((p.points[-1] for p in pieces[:-1]), key=lambda p: p[0])
    tree = hn.SurfaceTree(surface)
    assert tree.closest_points(stem[None]).distances[0] < 1e-9 * surface.mesh.size


def test_used_seams_are_the_borders_of_plates():
    """A seam that ends within a plate is left out from the last crossing on; others are whole."""
    surface = surface_of("naval_vessel")
    length = np.ptp(surface.mesh.points[:, 0])
    curves, seams = hn.shell_seams(surface, strake=length / 30.0, plate_length=length / 6.0)
    left_out = []
    plates = hn.plates(surface, seams, left_out=left_out)
    used = hn.used_seams(curves, seams, plates)
    ((name, missing, _),) = left_out

    def total(curves, name):
        lines = [curve.points for curve in curves if curve.name == name]
        return sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines)

    assert total(used, name) == pytest.approx(total(seams, name) - missing, abs=1e-3)
    for other in {seam.name for seam in seams} - {name}:
        assert total(used, other) == pytest.approx(total(seams, other), rel=1e-12)
    # The same plates follow from them, and nothing is left out.
    again = []
    assert len(hn.plates(surface, used, left_out=again)) == len(plates) and not again


def test_butts_beyond_the_surface_are_left_out():
    # The bow bulges by two thirds of what its control points do: the butt at 11.5 m misses it.
    y, z = np.array([[3.0, 4.0], [3.0, 3.0], [3.0, 2.0], [2.0, 0.5], [0.0, 0.0]]).T
    points = np.array([[(x, *yz) for yz in zip(y, z)] for x in np.linspace(0.0, 10.0, 11)])
    points[-1, 2, 0] = 12.0
    surface = hn.LimitSurface(grid_mesh(points))
    ends = hn.HullCurves(surface).borders()
    assert max(c.points[:, 0].max() for c in ends) < 11.5 < 12.0 - 0.3
    seams = hn.shell_seams(surface, strake=1.0, plate_length=1.0)[1]
    butts = {seam.name for seam in seams if seam.name.startswith("Butt")}
    # Places are those of control points' ends.
    assert butts == {f"Butt {0.5 * k:.2f}" for k in range(1, 22)}
