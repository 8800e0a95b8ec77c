# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots as files: every kind of diagram in every format, its texts, and words on mistakes."""

import math
import shutil
import subprocess
import xml.etree.ElementTree
from pathlib import Path
from types import SimpleNamespace

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_native.drawings import hydrostatic_plots, plotted_numbers

ROOT = Path(__file__).resolve().parents[2]

DRAFTS = np.linspace(1.0, 5.0, 9)


def hydrostatic_rows():
    shell = hull_io.shell_arrays(hull_io.read_hull(ROOT / "samples" / "coaster.hull.json"))
    arrays = shell.arguments()
    surface = hn.LimitSurface(hn.ControlMesh(*arrays))
    return [hn.upright_hydrostatics(surface, draft=draft, mirrored=True) for draft in DRAFTS]


def hydrostatic_curves():
    return hn.hydrostatic_curves_plot(hydrostatic_rows(), draft=4.0)


def sectional_areas():
    x = np.linspace(0.0, 70.0, 71)
    return hn.sectional_area_plot(x, 45.0 * (1.0 - (x / 35.0 - 1.0) ** 4), lcb=35.2, length_pp=70.0)


def bonjean():
    stations = np.linspace(0.0, 70.0, 11)
    areas = np.outer(1.0 - (stations / 35.0 - 1.0) ** 4, 11.0 * DRAFTS)
    outline = [np.array([[0.0, 0.0], [70.0, 0.0], [72.0, 6.0]])]
    return hn.bonjean_plot(stations, DRAFTS, areas, draft=4.0, outline=outline)


HEEL = np.radians(np.arange(0, 95, 5))


def righting_levers(**more):
    return hn.righting_lever_plot(HEEL, np.sin(2.0 * HEEL), **more)


def full_righting_levers():
    return righting_levers(
        gm=2.0,
        vanishing=math.pi / 2.0,
        deck_edge=math.radians(22.1),
        downflooding=math.radians(48.0),
        areas=[(0.0, math.radians(30.0), 0.25)],
        subtitles=["∇ 2345 m³, KG 4.35 m"],
    )


def cross_curves():
    displacement = np.linspace(500.0, 3000.0, 6)
    heels = np.radians([10, 30, 60])
    return hn.cross_curves_plot(
        displacement, heels, np.outer(5.0 + 300.0 / displacement, np.sin(heels))
    )


PLOTS = {
    "hydrostatic": (
        hydrostatic_curves,
        ["KMt [m]", "LCF from AP [m]", "Displacement Δ [t]"],
    ),
    "sectional": (sectional_areas, ["largest 45 m²", "LCB 35.2 m"]),
    "bonjean": (bonjean, ["x from the after perpendicular [m]", "area of 50 m²", "T 4 m"]),
    "levers": (
        full_righting_levers,
        ["Heel φ [°]", "max 1.000 m at 45.0°", "area 0° to 30°: 0.2500 m·rad", "∇ 2345 m³"],
    ),
    "cross": (cross_curves, ["Displacement Δ [t]", "heel 30°"]),
}


@pytest.mark.parametrize("kind", PLOTS)
def test_every_plot_in_every_format(kind, tmp_path):
    make, texts = PLOTS[kind]
    plot = make()
    for ending in ("pdf", "svg", "png"):
        hn.write_plot(plot, tmp_path / f"plot.{ending}")
    assert (tmp_path / "plot.png").read_bytes().startswith(b"\x89PNG")
    root = xml.etree.ElementTree.parse(tmp_path / "plot.svg").getroot()
    assert root.tag.endswith("svg")
    if shutil.which("pdftotext") is None:
        pytest.skip("pdftotext is not installed: texts of the PDF not read")
    done = subprocess.run(
        ["pdftotext", "-raw", tmp_path / "plot.pdf", "-"], capture_output=True, check=True
    )
    # Only blanks may come out different.
    read = "".join(done.stdout.decode().split())
    for text in texts:
        assert text.replace(" ", "") in read


def test_the_marked_maximum_is_on_the_curve():
    labels = [label["text"] for label in sheet_of(righting_levers()).labels]
    assert any(text.startswith("max 1.000 m") for text in labels)
    # Between the angles given the curve is interpolated: 0, 40, 80 have their top at 45.
    coarse = hn.righting_lever_plot(HEEL[::2], np.sin(2.0 * HEEL[::2]))
    text = next(t["text"] for t in sheet_of(coarse).labels if t["text"].startswith("max"))
    assert float(text.split()[1]) == pytest.approx(1.0, abs=0.01)
    assert float(text.split()[-1].rstrip("°")) == pytest.approx(45.0, abs=1.0)


def test_given_slopes_and_top_are_kept():
    coarse = HEEL[::3]
    plot = hn.righting_lever_plot(
        coarse, np.sin(2.0 * coarse), slopes=2.0 * np.cos(2.0 * coarse), greatest=(math.pi / 4, 1.0)
    )
    assert any(t["text"] == "max 1.000 m at 45.0°" for t in sheet_of(plot).labels)
    # With its slopes a sine is cubic between 15° steps to h⁴ / 384 times its fourth derivative.
    fair_angles, fair_levers = plotted_numbers.fair(
        coarse, np.sin(2.0 * coarse), 2.0 * np.cos(2.0 * coarse)
    )
    bound = 16.0 * math.radians(15.0) ** 4 / 384.0
    assert np.abs(fair_levers - np.sin(2.0 * fair_angles)).max() <= bound


def sheet_of(plot):
    return hn.lay_out_plot(plot, width_mm=120.0, height_mm=85.0)


def test_layout_as_arrays():
    sheet = sheet_of(full_righting_levers())
    left, top, right, bottom = sheet.diagram
    assert 0.0 < left < right < 120.0 and 0.0 < top < bottom < 85.0
    for points, colour, width, dashes in sheet.strokes:
        assert points.shape[1] == 2 and len(points) >= 2 and width > 0.0
        assert len(colour) == 4 and len(dashes) in (0, 4)
    assert len(sheet.areas) == 1
    assert {"text", "size", "centre", "half", "angle"} <= set(sheet.labels[0])


def all_hydrostatic_curves():
    """Those that need the main dimensions, too."""
    data = hull_io.read_hull(ROOT / "samples" / "coaster.hull.json")
    shell, given = hull_io.shell_arrays(data), data.particulars
    arrays = shell.arguments()
    body = hn.HullBody(hn.LimitSurface(hn.ControlMesh(*arrays)), mirrored=True)
    dimensions = {"length_pp": given.length_pp, "beam": given.beam}
    return hn.hydrostatic_curves_plot(hn.hydrostatic_table(body, drafts=DRAFTS, **dimensions))


@pytest.mark.parametrize("size", [(125.0, 88.0), (188.0, 132.0)])
def test_the_legend_of_a_card_names_all_curves(size):
    """Where scales are divisions, curves that share one stand beside one another."""
    plot = all_hydrostatic_curves()
    sheet = hn.lay_out_plot(plot, width_mm=size[0], height_mm=size[1])
    texts = [label["text"] for label in sheet.labels]
    assert not any("more" in text or "…" in text for text in texts), texts
    rows = [
        quantity for quantity in hydrostatic_plots.QUANTITIES if quantity.name in plot.curve_names
    ]
    assert len(rows) == len(plot.curve_names) > 12
    if "Divisions (div)" not in texts:
        assert all(any(text.startswith(one.name) for text in texts) for one in rows)
        return
    legend = [label["text"] for label in sheet.labels if label["centre"][1] > sheet.diagram[3]]
    for one in rows:
        assert any(text.split(":")[0] == one.symbol for text in legend), one.symbol
    scales = [text for text in legend if "/div" in text]
    assert len(scales) == len({one.scale for one in rows})
    assert min(label["size"] for label in sheet.labels) > 1.4


def test_equal_plots_are_equal():
    assert righting_levers() == righting_levers()
    assert righting_levers() != righting_levers(gm=1.0)


def test_hydrostatics_of_parts_and_without_a_number():
    rows = [
        SimpleNamespace(draft=t, kb=0.5 * t, km_transverse=math.inf if t == 0 else 3.0 / t)
        for t in (0.0, 1.0, 2.0)
    ]
    assert hn.hydrostatic_curves_plot(rows).curve_names == ["KB", "KMt"]
    sheet_of(hn.hydrostatic_curves_plot(rows))


def test_mistakes_are_named(tmp_path):
    with pytest.raises(ValueError, match="row"):
        hn.hydrostatic_curves_plot([])
    with pytest.raises(ValueError, match="heel has 3 numbers and gz 2"):
        hn.righting_lever_plot([0, 1, 2], [0, 1])
    with pytest.raises(ValueError, match=r"areas must have shape \(2, 3\)"):
        hn.bonjean_plot([0, 1], [0, 1, 2], np.zeros((3, 2)))
    with pytest.raises(ValueError, match="kn must have shape"):
        hn.cross_curves_plot([0, 1], [0, 1, 2], np.zeros((3, 2)))
    plot = hn.Plot("Empty")
    with pytest.raises(ValueError, match="no x axis"):
        hn.write_plot(plot, tmp_path / "a.pdf")
    plot.add_x_axis("x", "m")
    with pytest.raises(ValueError, match="style"):
        plot.add_curve("a", [0, 1], [0, 1], style="wavy")
    with pytest.raises(ValueError, match="colour"):
        plot.add_curve("a", [0, 1], [0, 1], colour=(0, 0, 2))
    with pytest.raises(ValueError, match="either x or y"):
        plot.add_line(label="nowhere")
    plot.add_curve("a", [0, 1], [0, 1, 2])
    with pytest.raises(ValueError, match='curve "a" has 2 x and 3 y'):
        hn.write_plot(plot, tmp_path / "a.pdf")
    with pytest.raises(ValueError, match="pdf, .svg or .png"):
        hn.write_plot(righting_levers(), tmp_path / "a.dwg")
    with pytest.raises(ValueError, match="A4"):
        hn.write_plot(righting_levers(), tmp_path / "a.pdf", paper="letter")
    with pytest.raises(OSError):
        hn.write_plot(righting_levers(), tmp_path / "missing" / "a.pdf")
    assert not list(tmp_path.iterdir())


def test_a_parallel_midbody_has_no_one_place_of_the_largest_area():
    x, pointed, flat = np.arange(5.0), [0.0, 5.0, 9.0, 5.0, 0.0], [0.0, 9.0, 9.0, 9.0, 0.0]
    for areas, label in ((pointed, "largest 9 m² at 2 m"), (flat, "largest 9 m²")):
        sheet = hn.lay_out_plot(hn.sectional_area_plot(x, areas), width_mm=250.0, height_mm=180.0)
        assert label in [one["text"] for one in sheet.labels]


def test_curves_beside_the_sectional_areas_have_their_colour():
    x, areas, pink = np.arange(5.0), np.array([0.0, 5.0, 9.0, 5.0, 0.0]), (1.0, 0.1, 0.9)
    others = [("ghost", x, 0.9 * areas, pink), ("target", x, 0.8 * areas), ("a", x, areas, None)]
    plot = hn.sectional_area_plot(x, areas, others=others)
    sheet = hn.lay_out_plot(plot, width_mm=250.0, height_mm=180.0)
    dashed = [tuple(colour[:3]) for _, colour, _, dashes in sheet.strokes if sum(dashes)]
    assert any(colour == pytest.approx(pink) for colour in dashed)
    assert len(set(dashed)) >= 3


# Symbols as they were: only numbers differ, which those of scaled arguments have, too.
SIZE = 0.3048
HALVED = hn.PlotUnits({"m": (0.5, "m"), "m²": (0.25, "m²"), "m·rad": (0.5, "m·rad"),
                       "t": (0.5, "t"), "kN": (0.5, "kN")})  # fmt: skip


def test_units_are_those_of_scaled_numbers():
    """A plot in half metres is that of numbers twice as large: powers of two, so bit by bit."""
    given = {"gm": 1.5, "vanishing": 1.5, "areas": [(0.0, 0.5, 0.25)], "greatest": (0.8, 1.0)}
    twice = {**given, "gm": 3.0, "areas": [(0.0, 0.5, 0.5)], "greatest": (0.8, 2.0)}
    levers = np.sin(2.0 * HEEL)
    slopes = 2.0 * np.cos(2.0 * HEEL)
    assert hn.righting_lever_plot(
        HEEL, levers, slopes=slopes, units=HALVED, **given
    ) == hn.righting_lever_plot(HEEL, 2.0 * levers, slopes=2.0 * slopes, **twice)
    x, area = np.linspace(0.0, 10.0, 5), np.array([0.0, 3.0, 4.0, 3.0, 0.0])
    others = [("other", x, area + 1.0)]
    assert hn.sectional_area_plot(
        x, area, lcb=5.0, length_pp=10.0, others=others, frame=((0, 11), (0, 6)), units=HALVED
    ) == hn.sectional_area_plot(
        2.0 * x, 4.0 * area, lcb=10.0, length_pp=20.0,
        others=[("other", 2.0 * x, 4.0 * others[0][2])],
        frame=((0, 22), (0, 24)),
    )  # fmt: skip
    masses, kn = np.array([10.0, 20.0, 30.0]), np.ones((3, 1))
    assert hn.cross_curves_plot(
        masses, [0.5], kn, load_t=15.0, units=HALVED
    ) == hn.cross_curves_plot(2.0 * masses, [0.5], 2.0 * kn, load_t=30.0)
    outline = [np.array([[0.0, 0.0], [10.0, 2.0]])]
    areas = np.outer([0.0, 3.0, 0.0], DRAFTS)
    assert hn.bonjean_plot(
        x[::2], DRAFTS, areas, outline=outline, draft=2.0, labels="abc", units=HALVED
    ) == hn.bonjean_plot(
        2 * x[::2], 2 * DRAFTS, 4 * areas, outline=[2 * outline[0]], draft=4.0, labels="abc"
    )
    rows = [{"speed_kn": 5.0, "total_kN": 8.0}, {"speed_kn": 6.0, "total_kN": 16.0}]
    double = [{**row, "total_kN": 2.0 * row["total_kN"]} for row in rows]
    assert hn.resistance_plot(rows, units=HALVED) == hn.resistance_plot(double)


def test_figures_of_usual_sizes_have_no_exponent():
    for value, text in (
        (9999.7, "10000"), (-9999.7, "-10000"), (9999.4, "9999"), (12345.6, "12346"),
        (0.0000123, "0.0000123"), (-0.00001, "-0.00001"), (0.00012345, "0.0001234"), (0.0, "0"),
        (1.5, "1.5"), (1.23456, "1.235"), (1.23e-9, "1.23e-09"),
    ):  # fmt: skip
        assert hn.PlotUnits().figures(value, "m") == f"{text} m"


def test_units_have_their_symbols():
    feet = hn.PlotUnits({"m": (SIZE, "ft"), "m·rad": (SIZE, "ft·rad")})
    plot = hn.righting_lever_plot(
        HEEL, SIZE * np.sin(2.0 * HEEL), gm=2.0 * SIZE, areas=[(0.0, 0.5, SIZE)], units=feet
    )
    texts = [label["text"] for label in sheet_of(plot).labels]
    for wanted in ("Righting lever GZ [ft]", "max 1.000 ft at 45.0°", "GM 2.000 ft"):
        assert any(wanted in text for text in texts), (wanted, texts)
    assert any("1.0000 ft·rad" in text for text in texts)
    with pytest.raises(ValueError, match="above 0"):
        hn.PlotUnits({"m": (0.0, "ft")})


def test_the_load_is_marked_in_cross_curves():
    plot = hn.cross_curves_plot([10.0, 20.0], [0.5], np.ones((2, 1)), load_t=15.0)
    assert any(label["text"] == "load 15 t" for label in sheet_of(plot).labels)
