# SPDX-License-Identifier: GPL-3.0-or-later
"""What follows a surface whose points move: shown points, which sections can stay, bodies. None
mixes old and new."""

import hull_native as hn
import numpy as np
import pytest


def grid_surface(columns=8, rows=4):
    """A sheet over [0, columns] x [0, rows] that bulges upwards; its border y = 0 stays."""
    points = [
        (i, j, np.sin(0.4 * i) * np.sin(0.5 * j))
        for j in range(rows + 1)
        for i in range(columns + 1)
    ]
    faces = [
        (a, a + 1, a + columns + 2, a + columns + 1)
        for j in range(rows)
        for a in range(j * (columns + 1), j * (columns + 1) + columns)
    ]
    mesh = hn.ControlMesh(np.array(points), [4] * len(faces), np.array(faces).reshape(-1))
    return hn.LimitSurface(mesh)


def moved_points(surface, index, by):
    points = surface.mesh.points.copy()
    points[index] += by
    return points


def test_the_mesh_of_a_surface_follows_its_points():
    surface = grid_surface()
    mesh, before = surface.mesh, surface.mesh.points
    kept = mesh.with_points(before)
    surface.set_points(moved_points(surface, 20, (0.1, 0.2, -0.3)))
    assert (mesh.points[20] - before[20]).tolist() == pytest.approx([0.1, 0.2, -0.3])
    assert (kept.points == before).all()


def test_shown_points_are_those_of_the_tessellation_and_their_images():
    surface = grid_surface()
    shown = hn.ShownPoints(surface, 3, mirrored=True, metres_per_unit=0.5)
    for step in range(3):
        surface.set_points(moved_points(surface, 20 + step, (0.1, 0.2, -0.3)))
        assert shown.update()
        points = surface.tessellate(3).points
        on_plane = np.abs(points[:, 1]) <= 1e-9 * surface.mesh.size
        points[on_plane, 1] = 0.0
        wanted = np.concatenate([points, points[~on_plane] * [1.0, -1.0, 1.0]]) / 0.5
        assert shown.coordinates.dtype == np.float32
        assert np.array_equal(shown.shared, on_plane)
        assert np.abs(shown.coordinates - wanted).max() < 2e-6
    assert surface.revision == 3


def test_the_view_of_coordinates_cannot_be_written_and_outlives_its_owner():
    shown = hn.ShownPoints(grid_surface(), 2, mirrored=False)
    view = shown.coordinates
    kept = view.copy()
    del shown
    assert np.array_equal(view, kept)
    with pytest.raises(ValueError, match="read-only"):
        view[0] = 0.0


def test_the_watch_tells_sections_that_stay():
    surface = grid_surface(30, 4)
    watch = hn.MoveWatch(surface)
    planes = np.array([(1.0, 0.0, 0.0, x) for x in np.linspace(0.0, 30.0, 31)])
    assert not watch.comes_near(planes, margin=0.0).any()
    surface.set_points(moved_points(surface, 31 + 10, (0.0, 0.0, 1.0)))
    watch.update()
    near = watch.comes_near(planes, margin=0.0)
    assert near[10] and not near[:7].any() and not near[14:].any()
    assert len(watch.cells) < surface.cell_count / 3
    assert watch.comes_near(planes, margin=100.0).all()
    for margin in (-1.0, float("nan")):
        with pytest.raises(ValueError, match="margin"):
            watch.comes_near(planes, margin=margin)


STALE = "Call update\\(\\) first"
LOAD = {"mass_t": 3.0, "centre_of_gravity": (4.0, 0.0, 0.2)}
OF_A_BODY = {
    "immersion": lambda body: body.immersion((0.0, 0.0, 1.0), 0.5),
    "shell_area": lambda body: body.shell_area,
    "shell_flux_forms": lambda body: body.shell_flux_forms,
    "hydrostatics": lambda body: hn.hydrostatics(body, draft=0.5),
    "lateral_profile": lambda body: hn.lateral_profile(body, draft=0.5),
    "inflate": lambda body: hn.inflate(body, 1.0, 0.5, draft=0.5),
    "lengthen": lambda body: hn.lengthen(body, 1.0, 0.1, draft=0.5),
    "match_areas": lambda body: hn.match_areas(body, [0.5, 1.0, 1.5], [0.3] * 3, draft=0.5),
    "parallel_body": lambda body: hn.parallel_body(body, draft=0.5),
    "section_areas": lambda body: hn.section_areas(body, [1.0, 2.0], draft=0.5),
    "volume_abaft": lambda body: hn.volume_abaft(body, 4.0, draft=0.5),
    "bonjean": lambda body: hn.bonjean(body, stations=[1.0, 2.0], drafts=[0.2, 0.5]),
    "righting_levers": lambda body: hn.righting_levers(body, **LOAD, heels=[0.0, 0.1]),
    "cross_curves": lambda body: hn.cross_curves(body, displacements_t=[3.0], heels=[0.1]),
    "stability_criteria": lambda body: hn.stability_criteria(body, **LOAD),
    "weather_criterion": lambda body: hn.weather_criterion(body, **LOAD),
    "hydrostatic_table": lambda body: hn.hydrostatic_table(body, drafts=[0.4, 0.5]),
    "equilibrium": lambda body: hn.equilibrium(body, **LOAD),
    "equilibria": lambda body: hn.equilibria(
        body, masses_t=[3.0], centres_of_gravity=[LOAD["centre_of_gravity"]]
    ),
}


def box_surface():
    """A closed box of 8 m by 2 m by 1 m with its corners kept."""
    points = [(x, y, z) for z in (0.0, 1.0) for y in (-1.0, 1.0) for x in (0.0, 8.0)]
    faces = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5]
    edges = [(0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7)]
    edges += [(0, 4), (1, 5), (2, 6), (3, 7)]
    return hn.LimitSurface(hn.ControlMesh(points, [4] * 6, faces, creases=edges))


def test_all_that_takes_a_body_is_tried():
    takers = [
        name
        for name, value in vars(hn._core).items()
        if "(body: " in (getattr(value, "__doc__", "") or "")
    ]
    assert takers and set(takers) <= set(OF_A_BODY)


@pytest.mark.parametrize("ask", OF_A_BODY.values(), ids=OF_A_BODY)
def test_a_body_out_of_date_refuses(ask):
    surface = box_surface()
    body = hn.HullBody(surface, mirrored=False)
    ask(body)
    surface.set_points(surface.mesh.points * [1.0, 1.1, 1.0])
    with pytest.raises(ValueError, match=STALE):
        ask(body)
    body.update()
    ask(body)


def test_a_watch_out_of_date_refuses():
    surface = grid_surface()
    watch = hn.MoveWatch(surface)
    surface.set_points(moved_points(surface, 20, (0.0, 0.0, 1.0)))
    for ask in (
        lambda: watch.cells,
        lambda: watch.comes_near([(1.0, 0.0, 0.0, 2.0)], margin=0.0),
    ):
        with pytest.raises(ValueError, match=STALE):
            ask()
    watch.update()
    assert len(watch.cells)


def test_shown_points_keep_what_was_shown_last():
    surface = grid_surface()
    shown = hn.ShownPoints(surface, 2, mirrored=False)
    before = shown.coordinates.copy()
    surface.set_points(moved_points(surface, 20, (0.0, 0.0, 1.0)))
    assert np.array_equal(shown.coordinates, before)
    shown.update()
    assert not np.array_equal(shown.coordinates, before)


def test_a_tree_keeps_to_the_points_it_was_made_of():
    surface = grid_surface()
    tree = hn.SurfaceTree(surface)
    here = surface.positions([5], [(0.3, 0.4)])
    surface.set_points(surface.mesh.points + [0.0, 0.0, 1.0])
    assert tree.closest_points(here).distances[0] < 1e-12
    tree.refit(surface)
    assert tree.closest_points(here).distances[0] > 0.5
