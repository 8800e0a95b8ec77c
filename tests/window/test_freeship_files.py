# SPDX-License-Identifier: GPL-3.0-or-later
"""More of the way of one who comes from FREE!ship: chines are imported and sections written for
each program by the menus, a control curve has its name, points are anchored and dragged, a planing
boat's resistance is looked at.

HULL_PICTURES=FOLDER keeps a picture of the window at each step.
"""

import tempfile
from pathlib import Path

import bpy
import numpy as np
from addon_under_test import hull_io, part, state_of
from chine_boats import carlson, curves
from editing import bilge_point, hull_at_hand, select, selected_indices
from expect import assert_follows, edited_points
from mathutils import Vector
from menus import add_to_scene, file_menu
from section_file_readers import read_archimedes, read_ghs, read_michlet, read_section_text
from sidebar import BESIDE_LIST, press, show_all_panels, show_panels, to, type_in
from test_freeship_user import IMPORT_HULL, look, opened, saved, table_of, ties
from test_tags import smooth_edges_within

SECTIONS = "Hull sections (.gf, .hll, .mlt, .txt)"


def test_chines_and_sections(window):
    """Import › Chines; Export › GHS, Archimedes, Michlet and the text, by the name's ending."""
    folder = Path(tempfile.mkdtemp())
    path = folder / "skiff.hul"
    path.write_text(carlson(curves()))
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    yield from file_menu(window, "Import", IMPORT_HULL)
    yield from window.accept_file(path)
    yield lambda: hull_at_hand() is not None
    hull = hull_at_hand()
    assert hull.name.startswith("Skiff") and not state_of(hull).status
    window.look(hull)
    yield
    look(window, "chines")
    window.open_sidebar()
    try:
        show_panels(window, "hull")
        for name, text in (("length_pp", "4"), ("beam", "1.8"), ("draft", "0.3")):
            yield from type_in(window, name, text)
        show_panels(window, "sections")
        look(window, "sections")
        yield
    finally:
        show_all_panels()
    for ending in ("gf", "hll", "txt", "mlt"):
        window.move_to_middle()
        yield from file_menu(window, "Export", SECTIONS)
        yield from window.accept_file(folder / f"skiff.{ending}")
        yield (folder / f"skiff.{ending}").exists
    _, sections, _ = read_ghs((folder / "skiff.gf").read_bytes().decode())
    _, both_sides = read_archimedes((folder / "skiff.hll").read_text())
    _, rows = read_section_text((folder / "skiff.txt").read_text())
    assert len(sections) == len(both_sides) == len(rows) > 5
    _, offsets, values = read_michlet((folder / "skiff.mlt").read_bytes().decode())
    volume = state_of(hull).hydrostatics.values.displaced_volume
    assert abs(float(values[0]) - volume) < 1e-3 * volume and offsets.max() > 0.5


def test_a_named_control_curve(window):
    """Curve › New: + in the list, its name typed there, and kept by the hull file."""
    folder = Path(tempfile.mkdtemp())
    hull = yield from opened(window, folder)
    show_panels(window, "fair", "control_curves")
    window.open_sidebar()
    window.press("TAB")
    yield
    bpy.ops.mesh.select_mode(type="EDGE")
    bpy.ops.mesh.select_all(action="DESELECT")
    (edge,) = smooth_edges_within(hull, 1)
    select(hull, edge, kind="edges")
    try:
        yield from press(window, "hull.add_curve", BESIDE_LIST)
        yield from to(window, "active_curve")
        window.click(ctrl=True)
        yield
        window.press("A", ctrl=True)
        window.write("chine")
        window.press("RET")
        yield
        look(window, "curve")
        yield
        assert [curve.name for curve in hull.hull.fairness.curves] == ["chine"]
        assert len(state_of(hull).fairness.combs["row"].rows) == 1
        points = edited_points(hull)
        yield from press(window, "hull.fair_curve")
        assert 0.0 < np.abs(edited_points(hull) - points).max() < 0.1
    finally:
        show_all_panels()
    window.move_to_middle()
    window.press("TAB")
    yield
    path = folder / "model.hull.json"
    yield from file_menu(window, "Export", "Ship hull (.hull.json)")
    yield from window.accept_file(path)
    yield path.exists
    (kept,) = hull_io().read_hull(path).curves
    assert kept.name == "chine" and len(kept.edges) > 3


def beside(hull, leader):
    """The point to port that is the nearest to one, and not behind it as it is seen from port."""
    points = edited_points(hull)
    way = points - points[leader]
    near = np.argsort(np.linalg.norm(way, axis=1))
    return next(int(i) for i in near if abs(way[i, 0]) > 1.0 and points[i, 1] > 1.0)


def tied_by_clicks(window, hull, words):
    """The bilge point and one beside it, which is tied to it: a click on the one, with Shift on the
    other, and the tie by F3."""
    window.press("TAB")
    yield
    window.press("ONE")
    window.press("A", alt=True)
    yield
    leader, place = bilge_point(hull)
    follower = beside(hull, leader)
    window.move_to_point(hull, Vector(edited_points(hull)[follower].tolist()))
    window.click()
    yield
    window.move_to_point(hull, place)
    window.click(shift=True)
    yield
    assert selected_indices(hull) == sorted((follower, leader))
    window.search(words)
    yield
    look(window, words)
    yield
    return leader, follower


def dragged(window, hull, leader):
    """A click on a point, G and the mouse: how far the points of the hull moved."""
    points = edited_points(hull)
    window.press("A", alt=True)
    window.move_to_point(hull, Vector(points[leader].tolist()))
    window.click()
    yield
    window.press("G")
    window.move_by(14, 20)
    window.click()
    yield
    assert_follows(hull)
    return edited_points(hull) - points


def test_points_are_anchored_by_clicks_and_dragged(window):
    """Point › Anchor."""
    hull = yield from opened(window, Path(tempfile.mkdtemp()))
    leader, follower = yield from tied_by_clicks(window, hull, "anchored")
    assert [each[:3] for each in ties(hull)] == [("ANCHOR", follower, (leader,))]
    moved = yield from dragged(window, hull, leader)
    look(window, "dragged")
    yield
    assert np.abs(moved[leader]).max() > 0.01
    assert np.abs(moved[follower] - moved[leader]).max() < 1e-5


def test_points_are_levelled_by_clicks_and_dragged(window):
    """Besides Anchor there is Level: they are equally high, and else where they were."""
    hull = yield from opened(window, Path(tempfile.mkdtemp()))
    leader, follower = yield from tied_by_clicks(window, hull, "tie level")
    assert [each[:3] for each in ties(hull)] == [("LEVEL", follower, (leader,))]
    moved = yield from dragged(window, hull, leader)
    assert abs(moved[leader, 2]) > 0.01 and abs(moved[leader, 0]) > 0.01
    assert abs(moved[follower, 2] - moved[leader, 2]) < 1e-5
    assert np.abs(moved[follower, :2]).max() < 1e-5


def test_savitsky_of_a_planing_boat(window):
    """Resistance › planing ships: Savitsky, with its table."""
    folder = Path(tempfile.mkdtemp())
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    yield from add_to_scene(window, "hull.add_hull", "PLANING")
    hull = hull_at_hand()
    window.look(hull)
    show_panels(window, "resistance", "resistance_remarks")
    window.open_sidebar()
    yield
    try:
        yield from type_in(window, "speed_from", "20")
        yield from type_in(window, "speed_to", "30")
        table = yield from table_of(window, hull, "SAVITSKY", folder)
        assert [float(row[0]) for row in table[1:]] == [float(kn) for kn in range(20, 31)]
        assert any("trim" in cell for cell in table[0])
    finally:
        show_all_panels()
    back = yield from saved(window, folder / "boat.fbm")
    assert len(back.points) == len(edited_points(hull))
    assert part("bridge.objects.hull_objects").is_hull(hull)
