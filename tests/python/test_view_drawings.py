# SPDX-License-Identifier: GPL-3.0-or-later
"""Views without hidden lines, curvature along sections."""

import math

import hull_native as hn
import numpy as np
import pytest
from dxf_audit import assert_audited
from production_hulls import body_of, hemisphere
from read_plots import read_curves


def test_axes_of_views():
    for azimuth, elevation, right, up, eye in (
        (0.0, 0.0, (0, 1, 0), (0, 0, 1), (1, 0, 0)),
        (math.pi / 2, 0.0, (-1, 0, 0), (0, 0, 1), (0, 1, 0)),
        (-math.pi / 2, 0.0, (1, 0, 0), (0, 0, 1), (0, -1, 0)),
    ):
        assert np.allclose(hn.view_axes(azimuth, elevation), (right, up, eye), atol=1e-15)
    axes = hn.view_axes(0.7, -0.3)
    assert np.allclose(axes @ axes.T, np.eye(3)) and np.linalg.det(axes) == pytest.approx(1.0)


def lines_of(drawing, layer):
    return [np.asarray(line) for own, line in drawing.lines if own == layer]


def length_of(lines):
    return sum(np.linalg.norm(np.diff(line, axis=0), axis=1).sum() for line in lines)


def test_ball_from_the_side():
    """Of a ball that is cut level its outline, and of a great circle across the view half."""
    body = hn.HullBody(hemisphere(5.0), mirrored=False)
    drawing = hn.view_drawing(body, axes=hn.view_axes(-math.pi / 2, 0.0), waterlines=[-1.0])
    outline = np.vstack(lines_of(drawing, "OUTLINE")) / 1000.0
    middle = 0.5 * (outline.min(axis=0) + outline.max(axis=0))
    assert np.ptp(outline[:, 0]) == pytest.approx(10.0, abs=2e-3)
    lowest = outline[:, 1].min() + 5.0
    below = outline[outline[:, 1] < lowest]
    assert np.abs(np.hypot(below[:, 0] - middle[0], below[:, 1] - lowest) - 5.0).max() < 3e-3
    # The waterline at -1 is a level line of sqrt(24) to each side: seen once, its far half hidden.
    seen = lines_of(drawing, "WATERLINES")
    assert length_of(seen) / 1000.0 == pytest.approx(2.0 * math.sqrt(24.0), rel=5e-3)
    # From below all of it is seen: a circle.
    below = hn.view_drawing(body, axes=hn.view_axes(0.0, -math.pi / 2), waterlines=[-1.0])
    circle = length_of(lines_of(below, "WATERLINES")) / 1000.0
    assert circle == pytest.approx(2.0 * math.pi * math.sqrt(24.0), rel=1e-3)
    # From above it is hidden by the level cut and the ball.
    above = hn.view_drawing(body, axes=hn.view_axes(0.0, math.pi / 2), waterlines=[-1.0])
    assert not lines_of(above, "WATERLINES")


def test_where_a_line_passes_behind():
    """A meridian's great circle, seen from 30° above its plane: it ends on the outline."""
    body = hn.HullBody(hemisphere(5.0), mirrored=False)
    drawing = hn.view_drawing(
        body, axes=hn.view_axes(-math.pi / 2, -math.radians(30.0)), waterlines=[0.0]
    )
    seen = np.vstack(lines_of(drawing, "WATERLINES")) / 1000.0
    # An ellipse with half axes 5 and 5 sin 30°; its near half is seen, which ends at its vertices.
    assert np.ptp(seen[:, 0]) == pytest.approx(10.0, abs=0.02)
    assert np.ptp(seen[:, 1]) == pytest.approx(2.5, abs=0.2)


def test_hidden_lines_are_the_rest():
    _, body = body_of("coaster")
    options = {"axes": hn.view_axes(-0.7, 0.3), "stations": [10.0, 40.0, 70.0], "tolerance": 0.02}
    seen = hn.view_drawing(body, **options)
    both = hn.view_drawing(body, hidden=True, **options)
    shown = sum(length_of(lines_of(seen, layer)) for layer in ("FRAMES", "OUTLINE", "SHELL"))
    again = sum(length_of(lines_of(both, layer)) for layer in ("FRAMES", "OUTLINE", "SHELL"))
    assert shown == pytest.approx(again, rel=1e-12)
    assert not lines_of(seen, "HIDDEN") and lines_of(both, "HIDDEN")
    # All of the stations: their lengths as the view has them.
    total = 0.0
    for x in options["stations"]:
        for curve in hn.section(body.surface, "x", x, 0.02):
            flat = curve.points @ options["axes"][:2].T
            mirrored = (curve.points * [1, -1, 1]) @ options["axes"][:2].T
            total += length_of([flat, mirrored])
    only = hn.view_drawing(body, hidden=True, knuckles=False, **options)
    outlines = hn.view_drawing(
        body, axes=options["axes"], hidden=True, knuckles=False, tolerance=0.02
    )
    own = sum(length_of(lines_of(only, n)) for n in ("FRAMES", "HIDDEN", "OUTLINE"))
    rest = sum(length_of(lines_of(outlines, n)) for n in ("HIDDEN", "OUTLINE"))
    assert (own - rest) / 1000.0 == pytest.approx(total, rel=1e-4)


def test_perspective_far_away_is_parallel():
    _, body = body_of("coaster")
    options = {"axes": hn.view_axes(-0.7, 0.3), "stations": [40.0], "tolerance": 0.05}
    parallel = hn.view_drawing(body, **options)
    far = hn.view_drawing(body, distance=1e6, **options)
    assert length_of(lines_of(far, "FRAMES")) == pytest.approx(
        length_of(lines_of(parallel, "FRAMES")), rel=5e-3
    )
    # Outlines may be there twice, along triangles without area.
    sizes = [np.ptp(np.vstack(lines_of(d, "OUTLINE")), axis=0) for d in (far, parallel)]
    assert sizes[0] == pytest.approx(sizes[1], rel=1e-4)
    near = hn.view_drawing(body, distance=150.0, **options)
    assert length_of(lines_of(near, "OUTLINE")) != pytest.approx(
        length_of(lines_of(parallel, "OUTLINE")), rel=1e-2
    )


def test_views_are_written_and_refused(tmp_path):
    _, body = body_of("coaster")
    drawing = hn.view_drawing(body, axes=hn.view_axes(-0.6, 0.2), stations=[30.0], tolerance=0.05)
    for ending in ("pdf", "svg", "dxf"):
        path = tmp_path / f"view.{ending}"
        drawing.write(path, scale=0.005)
        assert path.stat().st_size > 2000
    assert_audited(path)
    for options, words in (
        ({"axes": np.eye(3)[:2]}, "three unit vectors"),
        ({"axes": hn.view_axes(0.0, 0.0), "distance": 10.0}, "larger distance"),
    ):
        with pytest.raises(ValueError, match=words):
            hn.view_drawing(body, **options)


# --- curvature along sections ---------------------------------------------------------------------


def test_curvature_of_a_circle():
    surface = hemisphere(5.0)
    # Beside the pole, and the border, where the surface is no sphere.
    for axis, position, radius in (("z", -3.0, 4.0), ("x", 0.0, 5.0)):
        found = hn.section_curvature(surface, axis, position)
        known = np.isfinite(found.curvature) & (np.abs(found.points[:, 2] + 1.6) < 3.0)
        assert np.abs(found.curvature[known] - 1.0 / radius).max() < 2e-3
    circle = hn.section_curvature(surface, "z", -3.0)
    assert circle.length == pytest.approx(8.0 * math.pi, rel=1e-3)


def test_curvature_is_that_of_the_turning_tangent():
    """Its integral from knuckle to knuckle is the angle by which the section turns."""
    _, body = body_of("coaster")
    found = hn.section_curvature(body.surface, "x", 42.0)
    parts = np.split(np.arange(len(found.girth)), np.flatnonzero(np.isnan(found.girth)))
    for part in parts:
        part = part[np.isfinite(found.girth[part])]
        if len(part) < 3:
            continue
        k, s = found.curvature[part], found.girth[part]
        turned = np.sum(0.5 * (k[1:] + k[:-1]) * np.diff(s))
        way = np.diff(found.points[part], axis=0)
        angles = np.unwrap(np.arctan2(way[:, 2], way[:, 1]))
        assert abs(turned) == pytest.approx(abs(angles[-1] - angles[0]), abs=0.02)


def girth_and_curvature(surface, position):
    """Of a station, from the surface's sections alone: one stretch after another."""
    rows, run = [], 0.0
    for curve in hn.section(surface, "x", position):
        for stretch in curve.stretches:
            steps = np.linalg.norm(np.diff(stretch.points, axis=0), axis=1)
            along = np.append(0.0, np.cumsum(steps))
            rows.append(np.stack([run + along, stretch.curvatures], axis=1))
            run += along[-1]
    return rows


def test_curvature_plot(tmp_path):
    """As it is read from the page by its axes: the station's own curve, the one of a ball of 5 m
    dashed at 1/5, and the circle's line at 1/R."""
    _, body = body_of("coaster")
    plot = hn.curvature_plot(
        body.surface, "x", 0.0, radius=2.0, others=[("Ball", hemisphere(5.0))], name="Coaster"
    )
    assert plot.curve_names == ["Coaster", "Ball"]
    sheet = hn.lay_out_plot(plot, width_mm=297.0, height_mm=210.0)
    assert {"Coaster", "Ball", "Circle R 2 m"} <= {label["text"] for label in sheet.labels}
    *curves, (_, line) = read_curves(sheet)
    own, other = (
        np.vstack([curve for dashes, curve in curves if bool(dashes) == dashed])
        for dashed in (False, True)
    )
    # What is drawn is within a hundredth of a millimetre: less than 1e-4 of either axis.
    x_off, y_off = 1e-4 * line[:, 0].max(), 1e-4 * own[:, 1].max()
    assert line[:, 1] == pytest.approx([0.5, 0.5], abs=y_off)
    assert np.ptp(line[:, 0]) > 0.99 * other[:, 0].max()
    # From the level cut at 2.5 m down and up again; at its ends, and at the pole, the ball is none.
    girth = 2.0 * 5.0 * (math.pi / 2 + math.asin(0.5))
    assert np.ptp(other[:, 0]) == pytest.approx(girth, rel=2e-3)
    inside = np.abs(other[:, 0] - 0.5 * girth) < 0.4 * girth
    inside &= np.abs(other[:, 0] - 0.5 * girth) > 0.1 * girth
    assert np.abs(other[inside, 1] - 0.2).max() < 2e-3 + y_off and inside.sum() > 50
    wanted = [row for row in girth_and_curvature(body.surface, 0.0) if len(row) > 1]
    assert np.ptp(own[:, 0]) == pytest.approx(sum(np.ptp(row[:, 0]) for row in wanted), abs=x_off)
    values = np.sort(np.concatenate([row[:, 1] for row in wanted]))
    assert np.sort(own[:, 1]) == pytest.approx(values, abs=y_off)
    hn.write_plot(plot, tmp_path / "curvature.pdf")
    for call, words in (
        (lambda: hn.curvature_plot(body.surface, "x", 500.0), "no section"),
        (lambda: hn.curvature_plot(body.surface, "w", 1.0), "across"),
        (lambda: hn.curvature_plot(body.surface, "x", 42.0, radius=0.0), "radius"),
    ):
        with pytest.raises(ValueError, match=words):
            call()


def test_a_tolerance_of_zero_is_none():
    body = hn.HullBody(hemisphere(5.0), mirrored=False)
    for tolerance in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="tolerance"):
            hn.view_drawing(body, axes=hn.view_axes(0.0, 0.0), tolerance=tolerance)


def test_others_without_a_section_are_told_below_the_title():
    _, body = body_of("coaster")
    others = [("Far", hemisphere(5.0)), ("Near", hemisphere(50.0))]
    plot = hn.curvature_plot(body.surface, "x", 40.0, others=others, name="Coaster")
    assert plot.curve_names == ["Coaster", "Near"]
    sheet = hn.lay_out_plot(plot, width_mm=297.0, height_mm=210.0)
    words = [label["text"] for label in sheet.labels]
    assert any("Far: no section there" in text for text in words)
    assert not any("Near: no" in text for text in words)
