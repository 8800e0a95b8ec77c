# SPDX-License-Identifier: GPL-3.0-or-later
"""The way of one who comes from FREE!ship, as docs/coming-from.md tells it: a model of its is
opened, tagged, tied, given a keel, its resistance looked at, and handed back; points are grouped,
rows shown, a layer made, weights typed, sections written; a yacht's and a ship's tables of
resistance.

HULL_PICTURES=FOLDER keeps a picture of the window at each step.
"""

import csv
import os
import tempfile
from pathlib import Path

import bpy
import numpy as np
from addon_under_test import hull_io, part, state_of
from editing import hull_at_hand, select, selected_indices
from expect import assert_follows, edited_points
from menus import add_to_scene, file_menu
from sidebar import BESIDE_LIST, choose, press, show_all_panels, show_panels, to, type_in
from test_tags import LEFT, crease_values, smooth_edges_within
from window import FROM_PORT

IMPORT_HULL = "Ship hull (.fbm, .ftm, .hull.json, .hul)"
_BELOW_THE_LIST = 85  # of the panel Appendages with one body, in dots
_TURNS_OF_THE_WHEEL = 20


def model_of_freeship(folder):
    """A .fbm, of the sample coaster."""
    data = hull_io().read_hull(part("features.hull.samples").sample_files()["coaster"])
    hull_io().write_freeship(data, folder / "model.fbm", "m")
    return folder / "model.fbm"


def look(window, name):
    """Keeps a picture of the window, where one is wanted."""
    folder = os.environ.get("HULL_PICTURES")
    if folder:
        window.actions.append(lambda: window.screenshot(Path(folder) / f"freeship-{name}.png"))


def ties(hull):
    return part("features.constraints.ties").stored_ties(hull.data)


def opened(window, folder):
    """File › Import › Ship hull; the hull, seen from port."""
    path = model_of_freeship(folder)
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    yield from file_menu(window, "Import", IMPORT_HULL)
    yield from window.accept_file(path)
    yield lambda: hull_at_hand() is not None and part("bridge.objects.hull_objects").is_hull(
        hull_at_hand()
    )
    window.space.shading.type = "WIREFRAME"
    window.look(hull_at_hand(), FROM_PORT)
    yield
    return hull_at_hand()


def saved(window, path):
    """File › Export › FREE!ship hull; what is read of the file."""
    yield from file_menu(window, "Export", "FREE!ship hull (.fbm)")
    yield from window.accept_file(path)
    yield path.exists
    return hull_io().read_hull(path)


def test_from_file_to_file(window):
    folder = Path(tempfile.mkdtemp())
    hull = yield from opened(window, folder)
    assert hull.hull.half and hull.hull.draft > 0.0
    look(window, "opened")
    # Edge › Crease: Shift Q.
    window.press("TAB")
    yield
    assert hull.mode == "EDIT"
    window.press("TWO")
    window.press("A", alt=True)
    yield
    edges = smooth_edges_within(hull, 2)
    select(hull, *edges, kind="edges")
    yield
    window.pie("Q", *LEFT, shift=True)
    yield
    assert (crease_values(hull)[edges] == 1.0).all()
    # Point › Linear constraint: Tie Points, On a Line.
    window.press("ONE")
    window.press("A", alt=True)
    yield
    points = edited_points(hull)
    free = np.flatnonzero(points[:, 1] > 1.0)
    middle = free[np.argmin(np.abs(points[free, 0] - np.median(points[free, 0])))]
    near = free[np.argsort(np.linalg.norm(points[free] - points[middle], axis=1))[:3]]
    select(hull, *near.tolist())
    yield
    window.move_to_middle()
    window.search("on a line")
    yield
    assert [kind for kind, *_ in ties(hull)] == ["LINE"]
    assert_follows(hull)
    window.press("TAB")
    yield
    # Tools › Keel and rudder wizard.
    before = state_of(hull).hydrostatics.values.displaced_volume
    yield from add_to_scene(window, "hull.add_appendage", "FIN_KEEL")
    yield
    look(window, "keel")
    (keel,) = part("bridge.objects.appendages").of_hull(hull)
    assert state_of(hull).hydrostatics.values.displaced_volume > before
    # The keel is selected now: back to the hull.
    assert not bpy.ops.hull.export_freeship.poll()
    window.open_sidebar()
    show_panels(window, "appendages")
    yield
    yield from to(window, "hull.select_appendage", begin=_BELOW_THE_LIST)
    window.click()
    yield
    assert hull_at_hand() == hull
    # Resistance.
    show_panels(window, "resistance")
    yield
    latest = part("features.analyses.live_analyses").latest
    yield lambda: latest(hull, bpy.context.scene, "resistance_curves")[0] is not None
    outcome = latest(hull, bpy.context.scene, "resistance_curves")[0]
    assert not outcome.message and len(outcome.result.rows) > 5
    look(window, "resistance")
    yield
    show_all_panels()
    yield
    # File › Save: Export FREE!ship.
    read = yield from saved(window, folder / "back.fbm")
    np.testing.assert_allclose(read.points, edited_points(hull), atol=1e-5)
    assert len(read.creases) >= 2


def latest_of(hull, name):
    """The outcome of an analysis of the hull as she is; None before it is known."""
    outcome, is_current = part("features.analyses.live_analyses").latest(
        hull, bpy.context.scene, name
    )
    return outcome if is_current else None


def written(window, what, path):
    """Presses a button that writes a file, and gives it this name."""
    yield from press(window, what)
    yield from window.accept_file(path)
    yield path.exists
    yield lambda: part("features.conversion.conversions").running(hull_at_hand()) is None


def points_grouped(window, hull):
    """Add Point To Group: Groups, its buttons."""
    show_panels(window, "tags", "point_groups")
    chosen = [3, 4, 5]
    select(hull, *chosen)
    yield from press(window, "object.vertex_group_add", BESIDE_LIST)
    yield from press(window, "object.vertex_group_assign")
    bpy.ops.mesh.select_all(action="DESELECT")
    yield from press(window, "object.vertex_group_select")
    look(window, "group")
    assert sorted(selected_indices(hull_at_hand())) == chosen
    yield


def rows_shown(window, hull):
    """Control curves: Show Rows, Fair Row."""
    show_panels(window, "fair", "fair_rows")
    bpy.ops.mesh.select_mode(type="EDGE")
    bpy.ops.mesh.select_all(action="DESELECT")
    (edge,) = smooth_edges_within(hull, 1)
    select(hull, edge, kind="edges")
    yield from press(window, "hull.show_rows")
    look(window, "rows")
    assert len(state_of(hull).fairness.combs["row"].rows) == 1
    points = edited_points(hull)
    yield from press(window, "hull.fair_row")
    moved = np.abs(edited_points(hull) - points).max()
    assert 0.0 < moved < 0.1
    assert_follows(hull)


def layer_made(window, hull):
    """Layer › New: New Layer, of the selected faces."""
    show_panels(window, "surface")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    select(hull, 0, 1, 2, kind="faces")
    yield from press(window, "hull.new_layer")
    look(window, "layer")
    yield
    assert hull.hull.layers[-1].material.name.startswith("Layer")


def weights_typed(window, hull):
    """Weights by layers: Plating, and a row of the list."""
    show_panels(window, "stability", "weights")
    yield from type_in(window, "thickness", "0.012")
    yield lambda: latest_of(hull, "weights") is not None
    # The list is below the window's lower edge.
    for _ in range(_TURNS_OF_THE_WHEEL):
        window.hold("WHEELDOWNMOUSE")
    yield
    yield from press(window, "hull.add_weight", BESIDE_LIST)
    yield from type_in(window, "mass_t", "35")
    yield lambda: getattr(latest_of(hull, "weights"), "result", None) is not None
    yield lambda: latest_of(hull, "weights").result.parts[-1].mass_t == 35.0
    look(window, "weights")
    yield
    total, *parts = (
        latest_of(hull, "weights").result.total,
        *latest_of(hull, "weights").result.parts,
    )
    assert abs(hull.hull.weights.thickness - 0.012) < 1e-6
    assert total.mass_t > 100.0 and abs(total.mass_t - sum(p.mass_t for p in parts)) < 1e-6


def test_groups_rows_weights_and_sections(window):
    folder = Path(tempfile.mkdtemp())
    hull = yield from opened(window, folder)
    # Unfolded from their first drawing on.
    show_panels(window, "tags", "point_groups", "fair", "fair_rows", "surface", "stability",
                "weights", "export")  # fmt: skip
    window.open_sidebar()
    window.press("TAB")
    yield
    bpy.ops.mesh.select_mode(type="VERT")
    bpy.ops.mesh.select_all(action="DESELECT")
    try:
        yield from points_grouped(window, hull)
        yield from rows_shown(window, hull)
        yield from layer_made(window, hull)
        window.move_to_middle()
        window.press("TAB")
        yield
        yield from weights_typed(window, hull)
        # Export › GHS: Export Sections.
        show_panels(window, "export")
        look(window, "export")
        yield
        yield from written(window, "hull.export_sections", folder / "sections.gf")
        assert "HULL" in (folder / "sections.gf").read_text(errors="replace")
        back = yield from saved(window, folder / "back.fbm")
        assert [layer.name for layer in back.layers][-1].startswith("Layer")
    finally:
        show_all_panels()


def table_of(window, hull, method, folder):
    """The rows of the table that Resistance writes by a method that is chosen there."""
    resistance = hull.hull.resistance
    yield from choose(window, "method", lambda: resistance.method == method)
    yield lambda: getattr(latest_of(hull, "resistance_curves"), "result", None) is not None
    yield
    look(window, method.lower())
    yield
    path = folder / f"{method}.csv"
    yield from written(window, "hull.export_table", path)
    with open(path, newline="") as file:
        return [row for row in csv.reader(file) if row]


def test_tables_of_resistance(window):
    """Delft yacht series for a yacht with her keel, Holtrop beside it."""
    folder = Path(tempfile.mkdtemp())
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    yield from add_to_scene(window, "hull.add_hull", "CANOE_BODY")
    hull = hull_at_hand()
    window.look(hull)
    yield from add_to_scene(window, "hull.add_appendage", "FIN_KEEL")
    show_panels(window, "appendages", "resistance", "resistance_remarks")
    window.open_sidebar()
    yield
    try:
        show_panels(window, "appendages")
        yield from to(window, "hull.select_appendage", begin=_BELOW_THE_LIST)
        window.click()
        yield
        assert hull_at_hand() == hull
        show_panels(window, "resistance", "resistance_remarks")
        yield from type_in(window, "speed_from", "3")
        yield from type_in(window, "speed_to", "8")
        delft = yield from table_of(window, hull, "DELFT", folder)
        holtrop = yield from table_of(window, hull, "HOLTROP", folder)
        assert len(delft) == len(holtrop) == 7 and delft != holtrop
        assert any("keel" in cell.lower() for cell in delft[0])
        assert [float(row[0]) for row in delft[1:]] == [3.0, 4.0, 5.0, 6.0, 7.0, 8.0]
    finally:
        show_all_panels()
