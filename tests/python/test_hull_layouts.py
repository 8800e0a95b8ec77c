# SPDX-License-Identifier: GPL-3.0-or-later
"""One hull's control mesh laid onto another: the paper's pair of ships in kind, members between, a
hull onto itself in other layouts, and what is refused.

HULL_ALL_MEMBERS: eleven members of the paper's pair are written and judged, instead of one.
"""

import os

import hull_native as hn
import numpy as np
import pytest
from hull_fairness.lines import judged
from test_form_numbers import Sample
from test_hull_families import fuller, remade
from test_hull_features import renumbered

SEED = 20261125
# Of the length: root mean square distance that a parent is met within.
MET = 1e-4
ALL = bool(os.environ.get("HULL_ALL_MEMBERS"))


def length_of(surface):
    return np.ptp(surface.mesh.points[:, 0])


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
def made(ships):
    """Both in the RoRo vessel's layout: their own are turned over on one another."""
    return hn.common_layout([ship.surface for ship in ships], layout=Sample("roro").surface)


@pytest.fixture(scope="module")
def turned_over(ships):
    """The second in the first one's own layout."""
    return hn.fit_layout(*(ship.surface for ship in ships))


@pytest.fixture(scope="module")
def own_marks(ships):
    """Of the parents together."""
    return sum(marks_of(ship.surface) for ship in ships)


def member(made, t):
    first = made.parents[0]
    return hn.LimitSurface(first.mesh.with_points(made.family.points([1 - t, t])), first.scheme)


def test_the_papers_pair_ends_in_its_parents(ships, made):
    random = np.random.default_rng(SEED)
    for ship, fit, parent in zip(ships, made.fits, made.parents):
        length = length_of(ship.surface)
        print(fit.rms / length, fit.rms_back / length, fit.largest, fit.largest_back)
        assert fit.rms <= MET * length and fit.rms_back <= MET * length
        assert distances_from(parent, ship.surface, random) <= MET * length
        assert distances_from(ship.surface, parent, random) <= MET * length
        assert fit.fold is None and fit.shortfall == ""


def test_a_layout_that_is_turned_over_on_the_second_hull_is_told(ships, turned_over):
    """At the neck of the bulb; no member before t = 1 is turned against both parents."""
    second, fit = ships[1].surface, turned_over
    assert max(fit.rms, fit.rms_back) <= MET * length_of(second)
    assert hn.HullFamily([fit.first, fit.second]).first_fold(fit.second.mesh.points) is None
    assert turned_share(fit.second, second) > 1e-4
    assert fit.fold is not None and fit.shortfall.startswith("Members are folded at (")
    assert "or take the layout of the other hull, or of a third one" in fit.shortfall


def test_the_third_layout_is_not_turned_over(ships, made):
    for ship, parent in zip(ships, made.parents):
        assert turned_share(parent, ship.surface) <= 1e-5


def turned_share(layout, hull):
    """Of its area: places, by area, whose normal is turned by more than a right angle against that
    at the foot on the hull. Beside knuckles that is so without a fold, too."""
    shown = layout.tessellate(n=4)
    corners = np.concatenate([shown.quads[:, [0, 1, 2]], shown.quads[:, [0, 2, 3]]])
    a, b, c = np.moveaxis(shown.points[corners], 1, 0)
    across = np.cross(b - a, c - a)
    feet = hn.SurfaceTree(hull).closest_points((a + b + c) / 3.0)
    turned = (across * hull.normals(feet.cells, feet.uv)).sum(axis=1) < 0.0
    areas = np.linalg.norm(across, axis=1)
    return areas[turned].sum() / areas.sum()


def test_the_bottom_is_flat_between_keel_and_rim_in_all_members(ships, turned_over):
    """In the second hull its rim runs beside the layout's: none of it is left off the plane."""
    fitted = turned_over
    family = hn.HullFamily([fitted.first, fitted.second])
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


def test_members_between_are_sound(made):
    family = made.family
    length = length_of(made.parents[1])
    chains = len(hn.crease_curves(made.parents[0]))
    assert common_flats(made)
    for t in np.linspace(0, 1, 11):
        surface = member(made, t)
        mesh = surface.mesh
        assert family.first_fold(mesh.points) is None
        corners = np.flatnonzero(mesh.vertex_kinds >= 3)
        assert mesh.points[:, 1].min() >= -1e-12 * length
        problems = hn.check_mesh(
            mesh.points, mesh.face_sizes, mesh.face_vertices, mesh.creases, corners
        )
        assert problems == []
        for flat in common_flats(made):
            points = mesh.points[flat] - mesh.points[flat].mean(axis=0)
            assert np.linalg.svd(points)[1][2] <= 1e-6 * length
        curves = hn.crease_curves(surface)
        assert len(curves) == chains


def common_flats(made):
    """Points that are in a flat of either parent as they are in one of the layout."""
    return [
        both for a in made.fits[0].flats for b in made.fits[1].flats
        if len(both := np.intersect1d(a, b)) > 2
    ]  # fmt: skip


def test_volume_between_is_a_cubic(made):
    family = made.family
    whole_volume = family.whole_volume([1, 0], [0, 1], mirrored=True)
    assert whole_volume.departure <= 1e-9
    for t in (0.15, 0.5, 0.85):
        assert integral(made, t) == pytest.approx(whole_volume.volume_at(t), rel=1e-9)
    wanted = 0.4 * whole_volume.volume_at(0) + 0.6 * whole_volume.volume_at(1)
    (t,) = whole_volume.at_volume(wanted)
    assert integral(made, t) == pytest.approx(wanted, rel=1e-9)


def integral(made, t):
    surface = member(made, t)
    body = hn.HullBody(surface, mirrored=True)
    return hn.hydrostatics(body, draft=surface.mesh.points[:, 2].max() + 1.0).displaced_volume


def members(few):
    return np.linspace(0, 1, 11) if ALL else few


def marks_of(surface):
    beam = 2.0 * surface.tessellate(4).points[:, 1].max()
    return sum(len(line.found) for line in judged(surface, beam))


# Wanted marks included: what is wanted of a member is told for nobody.
@pytest.mark.parametrize("t", members((0.0, 1.0)))
def test_members_have_no_more_marks_than_their_parents_together(made, own_marks, t):
    of_member = marks_of(member(made, t))
    print(own_marks, of_member)
    assert of_member <= own_marks


@pytest.mark.parametrize("t", members((0.5,)))
def test_members_are_written_as_solids(made, t, tmp_path):
    path = tmp_path / "member.step"
    hn.write_step(member(made, t), path, mirrored=True, solid=True)
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
    assert hn.fit_layout(roro, coaster).shortfall == ""


def test_bodies_without_counterpart_are_named():
    coaster, yacht = Sample("coaster").surface, Sample("sailing_yacht").surface
    with pytest.raises(
        ValueError, match="leave out of the second the body between .* and the body"
    ):
        hn.fit_layout(coaster, yacht)
    with pytest.raises(ValueError, match="leave out of the first the body between"):
        hn.fit_layout(yacht, coaster)


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
