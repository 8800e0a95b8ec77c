# SPDX-License-Identifier: GPL-3.0-or-later
"""What is made of a surface or a body and keeps something of it, after the surface's points were
set: it refuses, keeps to what it was made of, or keeps topology alone. Nothing mixes old and new.
"""

import importlib
import inspect
import re
from copy import copy

import hull_native as hn
import numpy as np
import pytest
from hull_fairness import changes, lines
from surface_holders import ALL, BASE, FOLLOW, KEEP, REFUSE, box_surface, move
from test_live_surface import grid_surface

REFUSAL = "is out of date: the surface's points were set since"
# Of a docstring: how an object is told to keep to what it was made of.
KEEPS = re.compile(r"as (it is|they are) (now|when made)")


def made_of_hulls(value):
    """Whether a class is made of a surface, a body, or something of theirs."""
    if not isinstance(value, type):
        return False
    words = inspect.getdoc(value.__init__) or ""
    if "_core." in words or "__init__(self" in words:
        own = value.__name__
        taken = words.partition("\n")[0].partition(",")[2]
        holds = ("LimitSurface", "HullBody", "BodyDerivatives")
        return any(name in taken for name in holds if name != own)
    try:
        names = inspect.signature(value).parameters
    except (TypeError, ValueError):
        return False
    return not {"surface", "body", "derivatives"}.isdisjoint(names)


def test_all_holders_are_tried():
    modules = ["_core", "_production", "_resistance", "_morphing", "_network", "_drawing"]
    found = {}
    for name in modules:
        found.update(vars(importlib.import_module(f"hull_native.{name}")))
    found.update({name: getattr(hn, name) for name in dir(hn) if not name.startswith("_")})
    holders = {name for name, value in found.items() if made_of_hulls(value)}
    # What a network was fitted to is a plain record of results.
    assert holders - {"NetworkHull"} == set(ALL)


def snapshot(value, depth=0):
    """All that an object tells by its properties, as arrays."""
    if isinstance(value, (list, tuple)):
        return [snapshot(one, depth) for one in value]
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, hn.LimitSurface) or not type(value).__module__.startswith("hull_native"):
        return value
    found = {}
    for name, own in inspect.getmembers(type(value)):
        if isinstance(own, property) and not name.startswith("_") and depth < 4:
            found[name] = snapshot(getattr(value, name), depth + 1)
    return found


def answers(holder, asks):
    return {"": snapshot(holder), **{name: snapshot(ask(holder)) for name, ask in asks.items()}}


def assert_same(found, wanted, place=""):
    if isinstance(wanted, dict):
        assert found.keys() == wanted.keys()
        for name in wanted:
            assert_same(found[name], wanted[name], f"{place} {name}")
    elif isinstance(wanted, list):
        assert len(found) == len(wanted), place
        for one, other in zip(found, wanted):
            assert_same(one, other, place)
    elif not isinstance(wanted, hn.LimitSurface):
        np.testing.assert_array_equal(found, wanted, err_msg=place)


@pytest.mark.parametrize("name", REFUSE)
def test_holders_refuse_once_points_were_set(name):
    own = REFUSE[name]
    surface = box_surface()
    body = hn.HullBody(surface, mirrored=False)
    BASE.clear()
    asked, fresh = own.make(surface, body), own.make(surface, body)
    for ask in own.asks.values():
        ask(asked)
    move(surface)
    for holder in (asked, fresh):
        for what, ask in own.asks.items():
            with pytest.raises(ValueError, match=REFUSAL):
                ask(holder)
                pytest.fail(f"{name} has answered {what}")
    body.update()
    BASE.clear()
    anew = own.make(surface, body)
    for ask in own.asks.values():
        ask(anew)


@pytest.mark.parametrize("change", ["update", "join"])
@pytest.mark.parametrize("name", ["FormNumbers", "MichellIntegral"])
def test_they_stay_out_of_date_when_their_body_goes_on(name, change):
    own = REFUSE[name]
    surface = box_surface()
    body = hn.HullBody(surface, mirrored=False)
    asked = own.make(surface, body)
    body.update()  # of the same points: nothing has changed
    for ask in own.asks.values():
        ask(asked)
    if change == "update":
        move(surface)
        body.update()
    else:
        body.join([])
    for ask in own.asks.values():
        with pytest.raises(ValueError, match="out of date: the body was .* Make it anew"):
            ask(asked)


@pytest.mark.parametrize("name", KEEP)
def test_holders_keep_to_what_they_were_made_of(name):
    own = KEEP[name]
    surface = box_surface()
    body = hn.HullBody(surface, mirrored=False)
    # Nothing is computed when it is asked for first that could be of the surface as it is then.
    asked, fresh = own.make(surface, body), own.make(surface, body)
    before = answers(asked, own.asks)
    move(surface)
    for stage in (lambda: None, body.update):
        stage()
        assert_same(answers(asked, own.asks), before)
        assert_same(answers(fresh, own.asks), before)
    words = f"{getattr(hn, name).__doc__} {getattr(hn, name).__init__.__doc__}"
    assert KEEPS.search(words), words


@pytest.mark.parametrize("name", FOLLOW)
def test_holders_of_topology_answer_as_new_ones(name):
    own = FOLLOW[name]
    surface = box_surface()
    body = hn.HullBody(surface, mirrored=False)
    kept = own.make(surface, body)
    answers(kept, own.asks)
    move(surface)
    body.update()
    assert_same(answers(kept, own.asks), answers(own.make(surface, body), own.asks))


def test_a_copied_surface_goes_its_own_way():
    surface = box_surface()
    own, points = copy(surface), surface.mesh.points.copy()
    places = [3, 7], [(0.3, 0.4), (0.0, 1.0)]
    before = surface.positions(*places)
    move(surface)
    assert np.array_equal(own.mesh.points, points)
    assert np.array_equal(own.positions(*places), before)
    moved = surface.positions(*places)
    own.set_points(2.0 * points)
    assert np.array_equal(surface.positions(*places), moved)


def test_marks_are_told_new_by_the_surface_as_it_was():
    """Of the same surface after set_points(): otherwise it would be compared with itself."""
    surface = box_surface()
    known = changes.Known(surface, 2.0)
    before = surface.mesh.points.copy()
    move(surface)
    assert np.array_equal(known.surface.mesh.points, before)
    judged = lines.judged(surface, 2.0)
    assert judged
    for mark in changes.placed(judged, surface, known.surface):
        apart = hn.SurfaceTree(known.surface).closest_points(mark.extent).distances
        assert apart.max() < 1e-12


def test_distances_beyond_a_border_keep_to_the_surface_as_it_was():
    surface = grid_surface()
    own = hn.DistanceField(surface, mirrored=False)
    points = np.random.default_rng(3).uniform((-2.0, -2.0, -1.0), (10.0, 6.0, 3.0), (400, 3))
    before = own.distances(points)
    assert 0 < np.isnan(before).sum() < len(points)
    surface.set_points(surface.mesh.points @ [[1.0, 0.0, 2.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    assert np.array_equal(own.distances(points), before, equal_nan=True)


SHEARED = np.array([[1.3, 0.0, 0.4], [0.0, 1.0, 0.0], [0.0, 0.0, 1.5]])


def seams_of(surface):
    curves = hn.HullCurves(surface, 1e-3)
    return curves, [
        *curves.in_plane(hn.plane_across("x", 4.2), "butt"),
        *curves.in_plane(hn.plane_across("y", 2.2), "seam"),
    ]


def test_curves_of_the_surface_as_it_was_are_refused():
    surface = grid_surface()
    _, seams = seams_of(surface)
    plate = hn.plates(surface, seams)[0].flat()
    tree = hn.SurfaceTree(surface)
    asks = (
        lambda curves, own: hn.plates(surface, own),
        lambda curves, own: curves.pieces(own[0], []),
        lambda curves, own: curves.pieces(curves.in_plane(hn.plane_across("z", 0.3))[0], own),
        lambda curves, own: curves.at_girth(
            own[0], 0.2, towards=(1.0, 0.0, 0.0), across=(0.0, 1.0, 0.0)
        ),
        lambda curves, own: hn.frame_drawing(surface, 4.0, name="4", mirrored=False, marks=own),
    )
    for ask in asks:
        ask(hn.HullCurves(surface, 1e-3), seams)
    surface.set_points(surface.mesh.points @ SHEARED)
    curves, now = seams_of(surface)
    assert not any(one.is_on(surface) for one in seams) and all(one.is_on(surface) for one in now)
    for ask in asks:
        with pytest.raises(ValueError, match='"(butt|seam)" is not on the surface as it is.*anew'):
            ask(curves, seams)
        ask(curves, now)
    plate.marks(seams[0])
    with pytest.raises(ValueError, match='"butt" is not on the surface as it is'):
        plate.marks(now[0])
    with pytest.raises(ValueError, match="tree is not of the surface as it is .* refit"):
        hn.frame_lines(surface, 4.0, thickness=0.01, tree=tree)
    tree.refit(surface)
    hn.frame_lines(surface, 4.0, thickness=0.01, tree=tree)


def test_curves_of_another_surface_are_refused():
    small, large = grid_surface(2, 2), grid_surface(20, 8)
    _, seams = seams_of(large)
    with pytest.raises(ValueError, match="is not on the surface as it is"):
        hn.plates(small, seams)
    with pytest.raises(ValueError, match="is not on the surface as it is"):
        hn.HullCurves(small).pieces(seams[0], [])


def test_sections_of_the_surface_as_it_was_are_not_judged():
    surface = grid_surface()
    planes = [(1.0, 0.0, 0.0, x) for x in (2.2, 4.2, 6.2)]
    cut = hn.sections(surface, planes)
    assert hn.section_fairness(surface, planes, sections=cut)
    with pytest.raises(ValueError, match=r"sections\[1\] must be SectionCurves"):
        hn.section_fairness(surface, planes, sections=[cut[0], [1], cut[2]])
    # Nobody else holds what an iterator gives.
    fresh = [iter(curves) for curves in hn.sections(surface, planes)]
    judged = hn.section_fairness(surface, planes, sections=fresh)
    for own, others in zip(judged, hn.section_fairness(surface, planes, sections=cut)):
        assert [one.length for one in own] == [other.length for other in others]
    with pytest.raises(ValueError, match="out of date.*Cut it anew"):
        hn.section_fairness(grid_surface(1, 1), planes, sections=cut)
    # Near the middle one alone.
    points = surface.mesh.points.copy()
    points[2 * 9 + 4] += (0.0, 0.0, 0.2)
    surface.set_points(points)
    with pytest.raises(ValueError, match="out of date.*Cut it anew"):
        hn.section_fairness(surface, planes, sections=cut)
    hn.section_fairness(surface, planes, sections=hn.sections(surface, planes))


def test_distances_at_a_tessellation_of_the_surface_as_it_was_are_refused():
    surface = grid_surface()
    own, shown = hn.DistanceField(grid_surface(), mirrored=False), surface.tessellate(3)
    assert hn.surface_distances(surface, shown, own).rms < 1e-12
    surface.set_points(surface.mesh.points @ SHEARED)
    for wrong in (shown, grid_surface(20, 8).tessellate(3)):
        with pytest.raises(ValueError, match="tessellation is not of the surface as it is"):
            hn.surface_distances(surface, wrong, own)
    assert hn.surface_distances(surface, surface.tessellate(3), own).rms > 0.1
