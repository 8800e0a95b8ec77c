# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of docs/another-owner.md, by the buttons, fields and dialogs that it names; its numbers
are those that the page tells."""

import tempfile
from pathlib import Path

import bpy
import numpy as np
from addon_under_test import hull_io, part, state_of
from editing import hull_at_hand, select
from expect import assert_follows, edited_points
from sidebar import (
    BESIDE_LIST,
    choose,
    press,
    show_all_panels,
    show_panels,
    to,
    type_in,
    type_in_dialog,
)
from test_panels import is_computed

# From the mouse, which is on the title of a dialog as it opens, to its fields.
TO_LENGTH, TO_BLOCK, TO_LCB = (54, -62), (69, -59), (69, -105)
# Wanted: volume and LCB as they are then, and this KMt.
KMT = 6.346


def test_another_owner(window):
    try:
        for step in (kept, longer, finer, stiffer, faired, compared, exported, gone_back):
            yield from step(window)
    finally:
        show_all_panels()


def numbers():
    return state_of(hull_at_hand()).hydrostatics.values


def kept(window):
    with window.in_view():
        bpy.ops.hull.load_sample(name="coaster")
        bpy.ops.ed.undo_push(message="begin")
    window.look(hull_at_hand())
    window.open_sidebar()
    show_panels(window, "variants", "comparison")
    yield from press(window, "hull.keep_variant", BESIDE_LIST)
    yield from to(window, "active")
    window.click(ctrl=True)
    window.press("A", ctrl=True)
    window.write("As built")
    window.press("RET")
    yield
    assert [entry.name for entry in hull_at_hand().hull.variants.kept] == ["As built"]
    yield from press(window, "show_ghost")
    assert f"{numbers().displaced_volume:.1f}" == "4386.5"
    assert f"{numbers().lcb_percent:.2f} {numbers().kmt:.2f}" == "0.31 6.10"


def longer(window):
    show_panels(window, "hull")
    yield from press(window, "hull.set_dimensions")
    yield from type_in_dialog(window, (TO_LENGTH, "92.4"))
    hull = hull_at_hand()
    assert abs(hull.hull.length_pp - 92.4) < 1e-5 and abs(hull.hull.draft - 5.2) < 1e-6
    assert f"{numbers().displaced_volume:.1f} {numbers().kmt:.2f}" == "4825.2 6.10"
    assert_follows(hull)


def finer(window):
    show_panels(window, "transform")
    yield from press(window, "hull.shift_sections")
    yield from type_in_dialog(window, (TO_BLOCK, "0.72"), (TO_LCB, "1.314"))
    wanted = 0.72 * 92.4 * 13.6 * 5.2
    assert f"{wanted:.1f}" == "4704.9"
    assert abs(numbers().displaced_volume - wanted) < 2e-6 * wanted
    assert abs(numbers().lcb_percent - 1.314) < 2e-4 and f"{numbers().kmt:.2f}" == "6.20"
    assert_follows(hull_at_hand())
    ghost = part("features.variants.ghosts").Ghost
    yield lambda: state_of(hull_at_hand()).of(ghost).groups


def stiffer(window):
    hull, before = hull_at_hand(), numbers()
    rows = hull.hull.targets.rows
    show_panels(window, "targets")
    for quantity in ("VOLUME", "LCB_PERCENT", "KMT"):
        yield from press(window, "hull.add_target", BESIDE_LIST)
        yield from choose(window, "quantity", lambda: rows[-1].quantity == quantity)
    yield from press(window, "sense", across=0.45)
    yield from type_in(window, "value", str(KMT))
    assert [row.sense for row in rows] == ["equal", "equal", "at least"]
    yield from press(window, "hull.solve_targets")
    last_report = part("features.targets.reports").last_report
    yield lambda: last_report(hull)[0] is not None
    report, is_current = last_report(hull_at_hand())
    assert report.is_met and is_current and f"{1e3 * report.rms:.0f}" == "115"
    after = numbers()
    assert abs(after.displaced_volume / before.displaced_volume - 1.0) < 1e-6
    assert abs(after.lcb_percent - before.lcb_percent) < 2e-4 and after.kmt > KMT - 1e-5
    assert f"{after.waterline_beam:.2f}" == "13.60"
    assert_follows(hull_at_hand())


def faired(window):
    """A point at the fore shoulder and its neighbours, by the default deviation."""
    show_panels(window, "marks", "fairness")
    yield from press(window, "hull.count_marks")
    seen = part("features.fairing.seen_marks")
    yield lambda: seen.last_report(hull_at_hand())[1]
    window.move_to_middle()
    window.press("TAB")
    window.press("A", alt=True)
    yield
    show_panels(window, "fair")
    hull = hull_at_hand()
    points = edited_points(hull)
    near = np.abs(points - points.max(axis=0) * [0.75, 1.0, 0.5]).sum(axis=1).argsort()[:4]
    select(hull, *near.tolist())
    yield from press(window, "hull.fair_region")
    moved = np.flatnonzero(np.any(edited_points(hull) != points, axis=1))
    assert moved.size and set(moved) <= set(near)
    assert part("features.fairing.region_fairing").last_report(hull)[1]
    window.move_to_middle()
    window.press("TAB")
    yield
    assert_follows(hull_at_hand())


def compared(window):
    hull = hull_at_hand()
    show_panels(window, "variants", "differences")
    yield lambda: is_computed(hull, "differences")
    found = part("features.analyses").last_outcome(hull, bpy.context.scene, "differences")[0]
    volume = found.result.by[hull.hull.variants.afloat].rows["displaced_volume"]
    assert abs(volume.difference - (numbers().displaced_volume - 4386.5)) < 0.06
    show_panels(window, "variants", "distances")
    yield from choose(window, "colours", lambda: hull.hull.fairness.colours == "DISTANCE")
    yield lambda: state_of(hull).shown.distances is not None


def exported(window):
    folder = Path(tempfile.mkdtemp())
    show_panels(window, "export")
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    for operator, name in (
        ("hull.export_step", "second.step"),
        ("hull.export_hull", "second.hull.json"),
        ("hull.export_lines", "second.pdf"),
    ):
        yield from press(window, operator)
        yield from window.accept_file(folder / name)
        yield (folder / name).exists
        yield lambda: part("features.conversion.conversions").running(hull_at_hand()) is None
    assert (folder / "second.step").read_text().count("B_SPLINE_SURFACE_WITH_KNOTS") > 10
    content = hull_io().read_hull(folder / "second.hull.json")
    points = edited_points(hull_at_hand()).astype(np.float32)
    assert np.array_equal(content.points.astype(np.float32), points)


def gone_back(window):
    show_panels(window, "variants")
    yield from press(window, "hull.go_back_to_variant")
    hull = hull_at_hand()
    assert np.array_equal(edited_points(hull), kept_points(hull))
    assert f"{numbers().displaced_volume:.1f}" == "4386.5"
    assert_follows(hull)


def kept_points(hull):
    return part("bridge.mesh.mesh_points").read(hull.hull.variants.kept[0].mesh)
