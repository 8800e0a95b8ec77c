# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures that present a hull: what is hidden, what is mirrored, labels that leave each other
room, the same of whole and half hulls, files that are all there or none."""

import math
import resource

import hull_native as hn
import numpy as np
import pytest
import vessels
from hull_native.drawings import (
    figure_form,
    figure_views,
    hull_figures,
    hull_pictures,
    mesh_figures,
    sections_plans,
)
from hull_native.drawings.hidden_lines import Sight
from production_hulls import hemisphere


def form_of(name, **more):
    vessel = vessels.vessel(name)
    given = vessel.data.particulars
    body = hn.HullBody(vessel.surface, mirrored=vessel.data.half)
    values = given.length_pp, given.beam, given.draft, given.depth
    return figure_form.FigureForm(body, vessel.data.name, *values)


def cube():
    """A closed cube of six faces turned outwards, one edge creased."""
    points = np.array([(x, y, z) for z in (0, 1) for y in (-1, 0) for x in (0, 1)], dtype=float)
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return hn.ControlMesh(points, np.full(6, 4), np.ravel(faces), [[0, 1]])


def test_the_far_edges_of_a_cube_are_hidden():
    """From ahead to starboard below, the corner abaft to port above is hidden, with its edges."""
    whole = mesh_figures._WholeMesh(cube(), False)
    view = figure_views.FigureView(whole.points, "bow")
    seen = view.eye.seen(whole.points)
    faces = mesh_figures._Faces(seen, whole.triangles)
    far = 6
    assert faces.covers(seen + (0.0, 0.0, 1e-6)).tolist() == [i == far for i in range(8)]
    pieces = Sight(faces, 1.0, 1e-6).pieces(seen[np.array(whole.edges)])
    for edge, own in zip(whole.edges, pieces):
        assert [is_seen for is_seen, _ in own] == [far not in edge], edge
    assert [edge for edge, is_crease in zip(whole.edges, whole.is_crease) if is_crease] == [(0, 1)]


def test_irregular_points_are_those_without_four_edges():
    assert mesh_figures._irregular(cube()) == set(range(8))
    points = np.array([(x, y, 0) for y in (0, 1) for x in (0, 1, 2)], dtype=float)
    strip = hn.ControlMesh(points, [4, 4], [0, 1, 4, 3, 1, 2, 5, 4])
    assert mesh_figures._irregular(strip) == set()


def test_borders_are_no_creases_of_the_figure():
    form = form_of("coaster")
    whole = mesh_figures._WholeMesh(form.surface.mesh, True)
    borders = {tuple(sorted(pair)) for pair in form.surface.mesh.border_edges.tolist()}
    creases = {edge for edge, is_crease in zip(whole.edges, whole.is_crease) if is_crease}
    assert creases and not creases & borders


def test_values_of_the_nearest_triangle():
    """Two triangles, the nearer one over the lower left half; values linear in the place."""
    corners = np.array([(0, 0, 0), (40, 0, 0), (0, 40, 0), (0, 0, 5), (20, 0, 5), (0, 20, 5.0)])
    values = np.column_stack([corners[:, :2], np.repeat([1.0, 2.0], 3)])
    dots, seen = hn.seen_values(corners, values, [(0, 1, 2), (3, 5, 4)], width=50, height=45)
    x, y = dots % 50 + 0.5, dots // 50 + 0.5
    assert len(dots) == sum(40 - row for row in range(40))
    np.testing.assert_allclose(seen[:, :2], np.stack([x, y], axis=1), atol=1e-5)
    np.testing.assert_array_equal(seen[:, 2], np.where(x + y <= 20.0, 2.0, 1.0))
    with pytest.raises(ValueError, match="no point"):
        hn.seen_values(corners, values, [(0, 1, 9)], width=5, height=5)
    for wrong in (np.nan, np.inf):
        corners[4, 1] = wrong
        with pytest.raises(ValueError, match=r"points\[4\] is not finite"):
            hn.seen_values(corners, values, [(0, 1, 2)], width=5, height=5)


def test_normals_of_a_ball():
    """Each dot's place and normal, and where its ray from the eye meets the ball."""
    body = hn.HullBody(hemisphere(5.0), mirrored=False)
    seen = hull_pictures.SeenHull(figure_form.FigureForm(body, "Ball"))
    for view, (dots, values) in zip(seen.views, seen.sights):
        # At its pole, where sides of faces have no length, and at its border, where a cubic's
        # second derivatives vanish, the surface is no ball.
        inner = np.abs(values[:, 2] + 1.0) < 2.5
        shell = values[inner & (values[:, 6] < 0.5)].astype(float)
        assert len(shell) > 1e6 > np.sum(values[:, 6] > 0.5)
        radii = np.linalg.norm(shell[:, :3], axis=1)
        assert np.abs(radii - 5.0).max() < 2e-4
        off = np.linalg.norm(shell[:, 3:6] - shell[:, :3] / radii[:, None], axis=1)
        assert off.max() < 2e-4
        # All that is seen faces the eye.
        assert np.einsum("ij,ij->i", shell[:, 3:6], view.eye_position - shell[:, :3]).min() > -1e-2
        # A dot shows what is on its own ray.
        size = hull_pictures._size_in_dots(view)
        columns, rows = dots % size[0] + 0.5, dots // size[0] + 0.5
        per_mm = hull_pictures._FINER * hull_pictures._DOTS_PER_MM
        page = view.page(values[:, :3].astype(float)) * per_mm
        assert np.abs(page - np.stack([columns, rows], axis=1)).max() < 0.02


def test_bands_of_a_mirror():
    """A level mirror seen from ahead below shows what the eye's image would: one band."""
    n = 50
    places = np.stack([np.linspace(-1, 1, n), np.zeros(n), np.zeros(n)], axis=1)
    values = np.column_stack([places, np.tile([0.0, 0.0, -1.0], (n, 1)), np.zeros(n)])
    for bearing in np.linspace(0.1, math.pi - 0.1, 40):
        eye = np.array([0.0, 50.0 * math.cos(bearing), -50.0 * math.sin(bearing)])
        colours = hull_pictures._bands(hull_pictures.SeenPlaces(values, eye))
        # Mirrored at the plane z = 0 the ray goes on to y = -cos, z = -sin.
        turn = math.atan2(-math.sin(bearing), -math.cos(bearing)) * hn.LIGHT_BANDS / (2 * math.pi)
        wanted = hull_pictures._LIGHT if turn % 1.0 > 0.5 else hull_pictures._DARK
        if 0.02 < (turn % 0.5) < 0.48:
            np.testing.assert_array_equal(colours, np.tile(wanted, (n, 1)))


@pytest.mark.parametrize("name", vessels.names())
def test_labels_leave_each_other_room(name):
    placed = sections_plans._Plan(form_of(name)).labels
    # Three, where the sections of a slender demihull leave little room.
    assert len(placed.boxes) == len(placed.ends) + len(placed.on_lines) >= 3
    for i, (low, high) in enumerate(placed.boxes):
        for bottom, top in placed.boxes[:i]:
            assert not ((low < top).all() and (bottom < high).all())


def test_parts_to_port():
    line = np.array([(0, -2, 0), (0, -1, 1), (0, 1, 3), (0, 2, 2), (0, -2, 6), (0, -3, 6.0)])
    (part,) = sections_plans.to_port(line, False)
    np.testing.assert_allclose(part, [(0, 0, 2), (0, 1, 3), (0, 2, 2), (0, 0, 4)])
    np.testing.assert_array_equal(sections_plans.to_port(-line[2:4], True)[0][:, 1], [1, 2])
    assert sections_plans.to_port(line[:2], False) == []


def test_what_is_not_given():
    """A box of 10 by 4 by 3 m whose length, draft or origin nobody said."""
    points = np.array([(x, y, z) for z in (0, 3) for y in (-2, 2) for x in (20, 30)], dtype=float)
    faces = [[0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    edges = {tuple(sorted(e)) for f in faces for e in zip(f, f[1:] + f[:1])}
    mesh = hn.ControlMesh(points, np.full(5, 4), np.ravel(faces), sorted(edges))
    surface = hn.LimitSurface(mesh)
    body = hn.HullBody(surface, mirrored=False)
    form = figure_form.FigureForm(body, "Box", length=10.0, draft=9.0)
    assert (form.aft, form.lpp) == pytest.approx((20.0, 10.0), abs=1e-12)
    assert (form.given_length, form.given_draft) == (None, None)
    names = [name for name, _ in form.stations()]
    assert names[:3] == ["½", "1", "1½"] and names[-1] == "19½" and "10" in names
    assert dict(form.stations())["10"] == pytest.approx(25.0)
    assert dict(form.particulars()) == {
        "Length between perpendiculars": "10.00 m", "Draft": "9.00 m",
    }  # fmt: skip


@pytest.mark.parametrize("ending", [".pdf", ".svg", ".png"])
def test_all_figures_are_files(ending, tmp_path):
    form = form_of("barge")
    told = []
    written = hn.write_hull_figures(
        form.body, tmp_path / f"a b'ü%1{ending}", title="a <b> & ü", length=form.length,
        beam=form.beam, draft=form.draft, depth=form.depth, progress=told.append,
    )  # fmt: skip
    assert [path.name for path in written] == [
        f"a b'ü%1-{figure}{ending}" for figure in hn.HULL_FIGURES
    ]
    assert sorted(tmp_path.iterdir()) == sorted(written)
    assert all(path.stat().st_size > 2000 for path in written)
    assert len(told) > 10 and told == sorted(told) and told[-1] == pytest.approx(1.0)


def test_what_is_asked_for_twice_is_written_once(tmp_path):
    how = {"endings": (".svg", ".pdf", ".svg"), "figures": ["control-mesh"] * 2}
    written = hn.write_hull_figures(form_of("barge").body, tmp_path / "barge", **how)
    assert [path.name for path in written] == [f"barge-control-mesh.{e}" for e in ("svg", "pdf")]
    assert sorted(tmp_path.iterdir()) == sorted(written)


def test_refusals(tmp_path):
    form = form_of("barge")
    for path, more, said in (
        ("barge.jpg", {}, 'not as ".jpg"'),
        ("barge", {}, 'not as "barge"'),
        ("barge.png", {"figures": ["profile"]}, 'not "profile"'),
        ("barge.png", {"figures": []}, "no figure"),
    ):
        with pytest.raises(ValueError, match=said):
            hn.write_hull_figures(form.body, tmp_path / path, **more)
    with pytest.raises(OSError, match="Nothing can be written to the folder"):
        hn.write_hull_figures(form.body, tmp_path / "nowhere" / "barge.png")
    assert not list(tmp_path.iterdir())


def test_nothing_is_left_half_written(tmp_path):
    """The work is ended, the disk full, a name taken by a folder: all is as it was."""
    form = form_of("barge")
    kept = tmp_path / "barge-control-mesh.png"
    kept.write_text("before")

    class Stopped(Exception):
        pass

    def stop(share):
        if share > 0.8:
            raise Stopped

    def write(**more):
        figures = ["control-mesh", "lines-plan", "sections-plan"]
        hn.write_hull_figures(form.body, tmp_path / "barge.png", figures=figures, **more)

    with pytest.raises(Stopped):
        write(progress=stop)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (2000, limits[1]))
    try:
        with pytest.raises(OSError):
            write()
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    taken = tmp_path / "barge-sections-plan.png"
    taken.mkdir()
    with pytest.raises(OSError, match="is a folder"):
        write()
    assert sorted(path.name for path in tmp_path.iterdir()) == [kept.name, taken.name]
    assert kept.read_text() == "before"
    taken.rmdir()
    write()
    assert len(list(tmp_path.iterdir())) == 3 and kept.stat().st_size > 2000


@pytest.mark.parametrize("name", ["barge", "sailing_yacht"])
def test_lines_plans_take_the_smallest_sheet_at_their_scale(name, tmp_path):
    plan = hull_figures._LinesPlan(form_of(name), lambda share: None)
    plan.write(str(tmp_path / "lines.pdf"))
    spacing, sheet, scale = plan._how
    smaller = hull_figures._SHEETS[: hull_figures._SHEETS.index(sheet)]
    for one in smaller[-2:]:
        with pytest.raises(ValueError):
            plan._draw(str(tmp_path / "lines.pdf"), spacing, one, scale)


def test_pictures_become_small(tmp_path):
    cairo = pytest.importorskip("cairo")
    from figures import paper

    def paint(context):
        paper.line(context, [(10.0, 50.0), (90.0, 50.0)], 2.0, paper.BLACK)

    paper.draw(tmp_path / "line", 100.0, 100.0, paint)
    paper.make_small(tmp_path / "line.png", tmp_path / "small.png", 200)
    assert cairo.ImageSurface.create_from_png(str(tmp_path / "small.png")).get_width() == 200
