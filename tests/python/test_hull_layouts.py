# SPDX-License-Identifier: GPL-3.0-or-later
"""One hull's control mesh laid onto another: the paper's pair of ships in kind, members between, a
hull onto itself in other layouts, and what is refused.

HULL_ALL_MEMBERS: eleven members of the paper's pair are written and judged, instead of one; a
coaster comes onto a catamaran's demihull, too.
"""

import os

import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_fairness.lines import judged
from hull_io.mirror import mirror_faces
from test_form_numbers import Sample
from test_hull_families import fuller, remade
from test_hull_features import renumbered

SEED = 20261125
# Of the length: root mean square distance that a parent is met within.
MET = 1e-4
ALL = bool(os.environ.get("HULL_ALL_MEMBERS"))


def length_of(surface):
    return np.ptp(surface.mesh.points[:, 0])


def whole(name):
    """The whole of a sample, both sides, as one surface."""
    data = vessels.vessel(name).data
    mirror_faces(data, range(len(data.faces)))
    return vessels.surface_of(data)


def distances_from(surface, other, random, count=2000):
    """Of random places of the other surface, by area."""
    cells, uv = random.integers(0, other.cell_count, count), random.random((count, 2))
    points, du, dv = other.evaluate(cells, uv, 1)
    area = np.linalg.norm(np.cross(du, dv), axis=1)
    found = hn.SurfaceTree(surface).closest_points(points)
    return np.sqrt((area * found.distances**2).sum() / area.sum())


@pytest.fixture(scope="module")
def ships():
    return Sample("container_ship"), Sample("bulk_carrier")


@pytest.fixture(scope="module")
def fitted(ships):
    first, second = ships
    return hn.fit_layout(first.surface, second.surface)


@pytest.fixture(scope="module")
def the_other_way(ships):
    first, second = ships
    return hn.fit_layout(second.surface, first.surface)


@pytest.fixture(scope="module")
def own_marks(ships):
    """Of the parents together."""
    return sum(marks_of(ship.surface) for ship in ships)


@pytest.fixture(scope="module")
def family(fitted):
    return hn.HullFamily([fitted.first, fitted.second])


def member(fitted, family, t):
    points = family.points([1 - t, t])
    return hn.LimitSurface(fitted.first.mesh.with_points(points), fitted.first.scheme)


def test_the_papers_pair_ends_in_its_parents(ships, fitted):
    first, second = (ship.surface for ship in ships)
    random = np.random.default_rng(SEED)
    length = length_of(second)
    assert fitted.rms <= MET * length and fitted.rms_back <= MET * length
    assert distances_from(fitted.second, second, random) <= MET * length
    assert distances_from(second, fitted.second, random) <= MET * length
    # The first parent is itself: subdivision changes nothing.
    assert distances_from(first, fitted.first, random) <= 1e-12 * length
    assert fitted.fold is None


def test_the_other_way_round(ships, the_other_way):
    length = length_of(ships[0].surface)
    assert max(the_other_way.rms, the_other_way.rms_back) <= MET * length
    assert the_other_way.fold is None and the_other_way.subdivisions == 0


def test_the_bottom_is_flat_between_keel_and_rim_in_all_members(ships, fitted, family):
    """In the second hull its rim runs beside the layout's: none of it is left off the plane."""
    bottoms = [np.abs(ship.surface.mesh.points[:, 2]) == 0.0 for ship in ships]
    curves = hn.crease_curves(fitted.first)
    on_rim = max((curve.vertices for curve in curves if bottoms[0][curve.vertices].all()), key=len)
    flat = next(flat for flat in fitted.flats if np.isin(flat, on_rim).any())
    assert set(on_rim[1:-1]) <= set(flat)
    mesh = fitted.first.mesh
    faces = np.split(mesh.face_vertices, np.cumsum(mesh.face_sizes)[:-1])
    beside = [face for face in faces if np.isin(face, on_rim[1:-1]).sum() == 2]
    inside = [face for face in beside if np.isin(face, flat).all()]
    assert len(inside) == len(on_rim) - 3
    for t in (0.3, 1.0):
        assert not family.points([1 - t, t])[flat, 2].any()


def test_members_between_are_sound(fitted, family):
    length = length_of(fitted.second)
    chains = len(hn.crease_curves(fitted.first))
    for t in np.linspace(0, 1, 11):
        surface = member(fitted, family, t)
        mesh = surface.mesh
        assert family.first_fold(mesh.points) is None
        corners = np.flatnonzero(mesh.vertex_kinds >= 3)
        assert mesh.points[:, 1].min() >= -1e-12 * length
        problems = hn.check_mesh(
            mesh.points, mesh.face_sizes, mesh.face_vertices, mesh.creases, corners
        )
        assert problems == []
        for flat in fitted.flats:
            points = mesh.points[flat] - mesh.points[flat].mean(axis=0)
            assert np.linalg.svd(points)[1][2] <= 1e-6 * length
        curves = hn.crease_curves(surface)
        assert len(curves) == chains


def test_volume_between_is_a_cubic(fitted, family):
    whole_volume = family.whole_volume([1, 0], [0, 1], mirrored=True)
    assert whole_volume.departure <= 1e-9
    for t in (0.15, 0.5, 0.85):
        assert integral(fitted, family, t) == pytest.approx(whole_volume.volume_at(t), rel=1e-9)
    wanted = 0.4 * whole_volume.volume_at(0) + 0.6 * whole_volume.volume_at(1)
    (t,) = whole_volume.at_volume(wanted)
    assert integral(fitted, family, t) == pytest.approx(wanted, rel=1e-9)


def integral(fitted, family, t):
    surface = member(fitted, family, t)
    body = hn.HullBody(surface, mirrored=True)
    return hn.hydrostatics(body, draft=surface.mesh.points[:, 2].max() + 1.0).displaced_volume


def members(few):
    return np.linspace(0, 1, 11) if ALL else few


def marks_of(surface):
    beam = 2.0 * surface.tessellate(4).points[:, 1].max()
    return sum(len(line.found) for line in judged(surface, beam))


# Wanted marks included: what is wanted of a member is told for nobody.
@pytest.mark.parametrize("t", members((1.0,)))
def test_members_have_no_more_marks_than_their_parents_together(fitted, family, own_marks, t):
    of_member = marks_of(member(fitted, family, t))
    print(own_marks, of_member)
    assert of_member <= own_marks


@pytest.mark.parametrize("t", members((1.0,)))
def test_nor_have_they_the_other_way_round(the_other_way, own_marks, t):
    family = hn.HullFamily([the_other_way.first, the_other_way.second])
    of_member = marks_of(member(the_other_way, family, t))
    print(own_marks, of_member)
    assert of_member <= own_marks


@pytest.mark.parametrize("t", members((0.5,)))
def test_members_are_written_as_solids(fitted, family, t, tmp_path):
    path = tmp_path / "member.step"
    hn.write_step(member(fitted, family, t), path, mirrored=True, solid=True)
    report = hn.read_cad_report(path)
    assert report["valid"] and report["closed"] and report["solids"] == 1


@pytest.mark.parametrize("name", ("coaster", "sailing_yacht"))
def test_a_subdivided_and_renumbered_hull_is_itself(name):
    sample = Sample(name)
    finer = hn.LimitSurface(sample.surface.refined_mesh(), sample.surface.scheme)
    other, _ = renumbered(finer, np.random.default_rng(SEED))
    for fit in (hn.fit_layout(sample.surface, other), hn.fit_layout(other, sample.surface)):
        assert max(fit.rms, fit.rms_back) <= 1e-9 * sample.size
        assert max(fit.largest, fit.largest_back) <= 1e-9 * sample.size
        points = hn.HullFamily([fit.first, fit.second]).points([0.3, 0.7])
        assert np.abs(points - fit.first.mesh.points).max() <= 1e-9 * sample.size


def test_a_hull_in_another_layout_is_itself_within_the_tolerance():
    coaster, roro = Sample("coaster").surface, Sample("roro").surface
    moved = hn.fit_layout(roro, coaster).second
    fit = hn.fit_layout(coaster, moved)
    assert max(fit.rms, fit.rms_back) <= MET * length_of(coaster)
    assert fit.fold is None


def test_three_parents_get_one_layout():
    coaster = Sample("coaster")
    finer = hn.LimitSurface(coaster.surface.refined_mesh(), coaster.surface.scheme)
    fuller_one = fuller(coaster)
    hulls = [coaster.surface, fuller_one, finer]
    made = hn.common_layout(hulls)
    assert made.subdivisions == 1 and made.fits[0] is None
    random = np.random.default_rng(SEED)
    for hull, parent in zip(hulls, made.parents):
        assert distances_from(parent, hull, random) <= 1e-9 * coaster.size
    points = made.family.points([0.5, 0.3, 0.2])
    between = remade(
        coaster.surface, points=(0.7 * hulls[0].mesh.points + 0.3 * hulls[1].mesh.points)
    )
    surface = hn.LimitSurface(made.parents[0].mesh.with_points(points), coaster.surface.scheme)
    assert distances_from(surface, between, random) <= 1e-9 * coaster.size
    # A layout of its own: the parents are no longer their own control meshes.
    on_finer = hn.common_layout(hulls[:2], layout=finer)
    assert on_finer.family.point_count == len(finer.mesh.points)
    assert len(on_finer.fits) == 2 and None not in on_finer.fits


def test_a_hull_without_part_in_a_family_is_named():
    coaster, yacht = Sample("coaster").surface, Sample("sailing_yacht").surface
    with pytest.raises(ValueError, match="Hull 2 has no part in the family.*bodies"):
        hn.common_layout([coaster, yacht])
    with pytest.raises(ValueError, match="two hulls or more"):
        hn.common_layout([coaster])
    with pytest.raises(ValueError, match="no hull 4"):
        hn.common_layout([coaster, coaster], layout=4)


def test_what_falls_short_is_told_with_what_to_pair():
    coaster, roro = Sample("coaster").surface, Sample("roro").surface
    fit = hn.fit_layout(coaster, roro, tolerance=1e-7, most_subdivisions=0)
    off = max(fit.rms, fit.rms_back) / length_of(roro)
    assert fit.shortfall.startswith(
        f"The layout is left {off:.2e} of the length off, farthest at ("
    )
    assert "pair" in fit.shortfall
    assert fit.shortfall.endswith("or of a third one, such as the sample coaster's.")
    assert hn.fit_layout(coaster, roro).shortfall == ""


def test_bodies_without_counterpart_are_named():
    coaster, yacht = Sample("coaster").surface, Sample("sailing_yacht").surface
    with pytest.raises(
        ValueError, match="leave out of the second the body between .* and the body"
    ):
        hn.fit_layout(coaster, yacht)
    with pytest.raises(ValueError, match="leave out of the first the body between"):
        hn.fit_layout(yacht, coaster)


# The coaster has a bulb and a flat bottom, which the demihull has not.
@pytest.mark.parametrize("name", ("planing_boat", "coaster") if ALL else ("planing_boat",))
def test_a_half_is_no_demihull_but_its_whole_is(name):
    demihull = Sample("catamaran").surface
    half = Sample(name).surface
    with pytest.raises(ValueError, match="The first hull is a half.*mirror the half"):
        hn.fit_layout(half, demihull)
    with pytest.raises(ValueError, match="The second hull is a half"):
        hn.fit_layout(demihull, half)
    fit = hn.fit_layout(whole(name), demihull)
    print(fit.rms / length_of(demihull), fit.rms_back / length_of(demihull))
    assert max(fit.rms, fit.rms_back) <= MET * length_of(demihull)
    assert fit.fold is None and fit.shortfall == ""


@pytest.mark.skipif(not ALL, reason="HULL_ALL_MEMBERS is not set")
def test_where_the_demihull_s_own_layout_falls_short_it_is_said():
    boat = whole("planing_boat")
    fit = hn.fit_layout(Sample("catamaran").surface, boat)
    assert max(fit.rms, fit.rms_back) > MET * length_of(boat)
    assert "pair by hand the knuckle" in fit.shortfall
    assert "take the layout of the other hull" in fit.shortfall


def test_halves_of_two_sides_are_refused():
    coaster, roro = Sample("coaster").surface, Sample("roro").surface
    mesh = roro.mesh
    starboard = remade(
        roro,
        points=mesh.points * [1.0, -1.0, 1.0],
        face_vertices=np.concatenate(
            [face[::-1] for face in np.split(mesh.face_vertices, np.cumsum(mesh.face_sizes)[:-1])]
        ),
    )
    with pytest.raises(ValueError, match="a half to port and .* to starboard: mirror the second"):
        hn.fit_layout(coaster, starboard)
