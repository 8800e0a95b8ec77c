# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines plan: DXF read by ezdxf, PDF by pdfinfo, offsets against rays at the surface."""

import re
import shutil
import subprocess
from math import cos, radians, tan

import hull_io
import hull_native as hn
import numpy as np
import pytest
from lines_plans import FREESHIP, ROOT, SAMPLES, draw, dxf_of, read


@pytest.fixture(params=(*SAMPLES, "demo 3"))
def hull(request):
    if request.param != "demo 3":
        return read(ROOT / "samples" / f"{request.param}.hull.json")
    if not FREESHIP.is_file():
        pytest.skip(f"reference data missing: {FREESHIP}")
    return read(FREESHIP)


@pytest.fixture
def coaster():
    return read(ROOT / "samples" / "coaster.hull.json")


# --- DXF ---


def test_dxf_has_a_layer_for_each_kind_and_says_its_unit(hull, tmp_path):
    for unit, code in (("m", 6), ("mm", 4)):
        document = dxf_of(hull, tmp_path, dxf_unit=unit)
        assert document.dxfversion == "AC1015"
        assert document.header["$INSUNITS"] == code
        used = {entity.dxf.layer for entity in document.modelspace()}
        wanted = {
            "STATIONS", "WATERLINES", "DESIGN_WATERLINE", "BUTTOCKS", "DIAGONALS",
            "DIAGONAL_TRACES", "OUTLINE", "GRID", "BASE_LINE", "PERPENDICULARS", "MIDSHIP",
            "CENTRE_LINE", "FRAME_SPACING", "FRAME", "TABLES", "TEXT",
        }  # fmt: skip
        assert wanted <= used
        assert used <= {layer.dxf.name for layer in document.layers}


def curves_on(document, layer):
    """Points (n, 2) of each curve on a layer but straight lines, close together."""
    for entity in document.modelspace().query(f'*[layer=="{layer}"]'):
        if entity.dxftype() == "SPLINE":
            knots = np.unique(np.array(entity.knots))
            shares = np.linspace(0.0, 1.0, 32, endpoint=False)
            places = (knots[:-1, None] + np.diff(knots)[:, None] * shares).ravel()
            points = entity.construction_tool().points([*places, knots[-1]])
            yield np.array([(p.x, p.y) for p in points])
        elif entity.dxftype() == "LWPOLYLINE":
            yield np.array([(p[0], p[1]) for p in entity.get_points()])


def distances(points, lines):
    """From points (n, 2) to the nearest of the polylines [(k, 2)]."""
    starts = np.concatenate([line[:-1] for line in lines])
    ways = np.concatenate([np.diff(line, axis=0) for line in lines])
    squares = np.maximum((ways**2).sum(axis=1), 1e-300)
    shares = ((points[:, None, :] - starts) * ways).sum(axis=2) / squares
    nearest = starts + np.clip(shares, 0.0, 1.0)[..., None] * ways
    return np.sqrt(((points[:, None, :] - nearest) ** 2).sum(axis=2)).min(axis=1)


def test_buttocks_and_waterlines_of_dxf_are_those_of_the_surface(hull, tmp_path):
    """At true size: x and z of the profile are the ship's."""
    data, surface = hull
    size = np.ptp(surface.mesh.points, axis=0).max()
    offsets = [data.particulars.beam / 8 * k for k in (1, 2, 3)]
    document = dxf_of(hull, tmp_path, offsets=False, buttocks=offsets)
    sections = [
        curve.points[:, [0, 2]]
        for y in offsets
        for curve in hn.section(surface, "y", y, 1e-6 * size)
    ]
    kinds = {e.dxftype() for e in document.modelspace().query('*[layer=="BUTTOCKS"]')}
    assert kinds == {"SPLINE"}
    found = list(curves_on(document, "BUTTOCKS"))
    for points in found:
        assert distances(points, sections).max() < 4e-6 * size
    # And nothing is missing: the sections' points are near the curves.
    assert distances(np.concatenate(sections), found).max() < 4e-6 * size


def test_knuckles_and_borders_of_dxf_are_splines_of_the_surface(hull, tmp_path):
    _, surface = hull
    size = np.ptp(surface.mesh.points, axis=0).max()
    document = dxf_of(hull, tmp_path, offsets=False)
    outline = document.modelspace().query('*[layer=="OUTLINE"]')
    assert {entity.dxftype() for entity in outline} == {"SPLINE"}
    exact = [
        curve.points[:, [0, 2]]
        for curve in hn.feature_curves(surface, 256)
        if np.ptp(curve.points[:, [0, 2]], axis=0).max() > 0.0
    ]
    compared = 0
    for points in curves_on(document, "OUTLINE"):
        # The profile's, which are where the ship is; other views lie below and beside it.
        low, high = surface.mesh.points.min(axis=0), surface.mesh.points.max(axis=0)
        if points[:, 1].min() < low[2] - 1e-6 or points[:, 0].max() > high[0] + 1e-6:
            continue
        if points[:, 1].max() > high[2] + 1e-6 or points[:, 0].min() < low[0] - 1e-6:
            continue
        assert distances(points, exact).max() < 1e-5 * size
        compared += 1
    assert compared > 0


def test_millimetres_are_a_thousand_times_metres(coaster, tmp_path):
    texts = []
    for unit in ("m", "mm"):
        document = dxf_of(coaster, tmp_path, dxf_unit=unit)
        texts.append(
            np.array(
                [(t.dxf.insert.x, t.dxf.insert.y) for t in document.modelspace().query("TEXT")]
            )
        )
    assert np.allclose(1000.0 * texts[0], texts[1], rtol=1e-12, atol=1e-6)


# --- Paper ---


@pytest.mark.parametrize("paper, size", [("A3", (420, 297)), ("A1", (841, 594)), ((700, 400),) * 2])
def test_pdf_is_one_page_of_the_sheet(hull, tmp_path, paper, size):
    if not shutil.which("pdfinfo"):
        pytest.skip("pdfinfo is missing")
    path = draw(hull, tmp_path / "plan.pdf", paper=paper)
    told = subprocess.run(["pdfinfo", path], capture_output=True, text=True, check=True).stdout
    assert re.search(r"Pages:\s+1\n", told)
    found = re.search(r"Page size:\s+([\d.]+) x ([\d.]+) pts", told)
    assert [float(x) / 72 * 25.4 for x in found.groups()] == pytest.approx(size, abs=0.2)


def same_but_for_rounding(one, other):
    """Whether two DXF files have the same lines, numbers to within rounding."""
    lines = [path.read_text().splitlines() for path in (one, other)]
    assert len(lines[0]) == len(lines[1])
    for a, b in zip(*lines):
        if a != b and float(a) != pytest.approx(float(b), rel=1e-9, abs=1e-9):
            return False
    return True


def test_positions_one_by_one_by_spacing_and_in_frames_are_the_same(coaster, tmp_path):
    frames = np.arange(21) * coaster[0].particulars.length_pp / 20 / 0.6
    by_spacing = draw(coaster, tmp_path / "a.dxf", station_spacing=0.6)
    even = hn.frame_table([(-20, 60, 0.6), (60, 170, 0.6)])
    for options in (
        {"stations": frames[::-1], "stations_in": "frames"},
        {"stations": frames * 0.6, "station_spacing": 0.6},
        {"stations": frames, "stations_in": "frames", "frames": even, "frame_spacing": None},
    ):
        assert same_but_for_rounding(by_spacing, draw(coaster, tmp_path / "b.dxf", **options))


TABLE = hn.frame_table([(-2, 4, 5.0), (4, 6, 16.0)], in_roman=True)


def test_stations_in_frames_of_ranges(coaster, tmp_path):
    """As those in metres, named by the table's frames, which the scale below the profile has."""
    in_metres = draw(coaster, tmp_path / "a.dxf", stations=[-5.0, 12.5, 36.0], frame_spacing=None)
    numbers = [-1, 2.5, 5]
    named = draw(
        coaster, tmp_path / "b.dxf",
        stations=numbers, stations_in="frames", frames=TABLE, frame_spacing=None,
    )  # fmt: skip
    words = [set(path.read_text().splitlines()) for path in (in_metres, named)]
    assert {"2.5", "V", "III"} <= words[1] and not {"V", "III"} & words[0]


def test_diagonals_by_spacing(coaster, tmp_path):
    given = [(2.0 * k, radians(30.0)) for k in (1, 2, 3, 4)]
    by_spacing = {"diagonals": 2.0, "diagonal_angle": radians(30.0)}
    one = draw(coaster, tmp_path / "a.dxf", **by_spacing)
    assert same_but_for_rounding(one, draw(coaster, tmp_path / "b.dxf", diagonals=given))


@pytest.mark.parametrize(
    "wrong, said",
    [
        ({"scale": 20}, "1:20 .* does not fit A2; 1:[0-9]+ does"),
        ({"scale": -1}, "scale"),
        ({"paper": "B5"}, "paper"),
        ({"paper": (10, 10)}, "100 mm"),
        ({"stations": 0.001}, "more than 400 stations"),
        ({"stations": np.arange(0.0, 84.0, 0.09), "offsets": False}, "run together"),
        ({"stations": np.arange(0.0, 84.0, 0.09)}, "table of offsets"),
        ({"waterlines": [np.nan]}, "finite"),
        ({"buttocks": [-1.0]}, "buttock"),
        ({"diagonals": [(3.0, 2.0)]}, "angle"),
        ({"frame_spacing": 0.0}, "frame spacing"),
        ({"stations_in": "frames", "frame_spacing": None}, "frame_spacing"),
        ({"stations_in": "feet"}, "frames"),
        ({"stations_in": "frames", "stations": [8], "frames": TABLE}, "Frame 8 is beyond"),
        ({"dxf_unit": "ft"}, "dxf_unit"),
        ({"title_block": [("a", "b")] * 9}, "rows below the title"),
        ({"paper": "A4", "waterlines": 0.1, "buttocks": 0.1}, "table of offsets|run together"),
    ],
)
def test_what_is_wrong_is_said_and_nothing_written(coaster, tmp_path, wrong, said):
    for name in ("plan.pdf", "plan.dxf"):
        with pytest.raises(ValueError, match=said):
            draw(coaster, tmp_path / name, **wrong)
    with pytest.raises(ValueError, match=r"\.dxf"):
        draw(coaster, tmp_path / "plan.dwg")
    with pytest.raises(OSError):
        draw(coaster, tmp_path / "nowhere" / "plan.dxf")
    assert not list(tmp_path.iterdir())


# --- Offsets ---


def table_of(hull):
    data, surface = hull
    given = data.particulars
    return hn.offset_table(
        surface,
        stations=given.length_pp * (np.arange(1, 20) / 20 + 1e-3),
        waterlines=given.draft * (np.arange(1, 6) / 5 + 1e-3),
        buttocks=given.beam * np.arange(4) / 8,
    )


def test_offsets_are_where_rays_hit_the_surface(hull):
    """Half-breadths from starboard's side outwards, heights from below."""
    _, surface = hull
    size = np.ptp(surface.mesh.points, axis=0).max()
    table = table_of(hull)
    tree = hn.SurfaceTree(surface)
    compared = 0
    for i, x in enumerate(table.stations):
        for j, z in enumerate(table.waterlines):
            found = table.half_breadths[i, j]
            hit = first_hit(tree, (x, 2.0 * size, z), (0.0, -1.0, 0.0))
            if np.isnan(found):
                assert hit == np.inf
                continue
            assert 2.0 * size - hit == pytest.approx(found, abs=1e-5 * size)
            compared += 1
        for j, y in enumerate(table.buttocks):
            found = table.heights[i, j]
            if y == 0.0 or np.isnan(found):
                continue
            hit = first_hit(tree, (x, y, -2.0 * size), (0.0, 0.0, 1.0))
            assert hit - 2.0 * size == pytest.approx(found, abs=1e-5 * size)
            compared += 1
    assert compared > 80


def first_hit(tree, origin, direction):
    return tree.ray_hits([origin], [direction]).distances[0]


def test_offsets_of_features_lie_on_the_feature_curves(hull):
    _, surface = hull
    table = table_of(hull)
    curves = [curve.points for curve in hn.feature_curves(surface, 512)]
    size = np.ptp(surface.mesh.points, axis=0).max()
    assert table.features
    for feature in table.features:
        reached = ~np.isnan(feature.heights)
        assert reached.any()
        points = np.column_stack([table.stations, feature.half_breadths, feature.heights])[reached]
        for point in points:
            nearest = min(np.linalg.norm(curve - point, axis=1).min() for curve in curves)
            assert nearest < 2e-3 * size  # of sampled points
    assert [f.name for f in table.features if f.kind == "border"] == ["Deck edge"]


def test_a_whole_hull_has_the_offsets_of_its_half():
    """Also where its knuckles are: on both sides."""
    data, surface = read(ROOT / "samples" / "barge.hull.json")
    whole = hn.LimitSurface(hn.ControlMesh(*mirrored_arrays(data)))
    lines = {"stations": [10.0, 30.0, 60.0], "waterlines": [1.0, 3.0], "buttocks": [2.0, 4.0]}
    a, b = hn.offset_table(surface, **lines), hn.offset_table(whole, **lines)
    assert np.allclose(a.half_breadths, b.half_breadths, atol=1e-4, equal_nan=True)
    assert np.allclose(a.heights, b.heights, atol=1e-4, equal_nan=True)


def mirrored_arrays(data):
    shell = hull_io.shell_arrays(data)
    points = shell.points
    on_centre = np.abs(points[:, 1]) < 1e-9
    image = np.where(on_centre, np.arange(len(points)), 0)
    image[~on_centre] = len(points) + np.arange((~on_centre).sum())
    both = np.vstack([points, points[~on_centre] * [1.0, -1.0, 1.0]])
    starts = np.concatenate([[0], np.cumsum(shell.face_sizes)])
    faces = [shell.face_vertices[a:b] for a, b in zip(starts[:-1], starts[1:])]
    faces += [image[face][::-1] for face in faces]
    creases = {tuple(sorted(pair)) for pair in shell.creases.tolist()}
    creases |= {tuple(sorted(image[list(pair)].tolist())) for pair in creases}
    corners = set(shell.corners.tolist()) | set(image[shell.corners].tolist())
    return (
        both,
        [len(face) for face in faces],
        np.concatenate(faces),
        np.array(sorted(creases)).reshape(-1, 2),
        np.array(sorted(corners), dtype=int),
    )


def test_diagonal_of_the_coaster_is_expanded_below_the_centre_line(coaster, tmp_path):
    """The expanded diagonal reaches as far as the plane meets the flat of side."""
    height, angle = 6.0, radians(25.0)
    document = dxf_of(coaster, tmp_path, diagonals=[(height, angle)], offsets=False)
    lowest = min(curve[:, 1].min() for curve in curves_on(document, "DIAGONALS"))
    centre = [
        line.dxf.start.y
        for line in document.modelspace().query('LINE[layer=="CENTRE_LINE"]')
        if line.dxf.start.y == line.dxf.end.y
    ]
    half_beam = 0.5 * coaster[0].particulars.beam
    assert height - half_beam * tan(angle) > 2.5  # above the bilge
    depth = centre[0] - lowest
    assert depth == pytest.approx(half_beam / cos(angle), rel=2e-3)
