# SPDX-License-Identifier: GPL-3.0-or-later
"""The way of one who comes from FREE!ship, as docs/coming-from.md tells it: a model of its is
opened, tagged, tied, given a keel, its resistance looked at, and handed back."""

import tempfile
from pathlib import Path

import bpy
import numpy as np
from addon_under_test import hull_io, part, state_of
from editing import hull_at_hand, select
from expect import assert_follows, edited_points
from sidebar import show_all_panels, show_panels, to
from test_tags import LEFT, crease_values, smooth_edges_within
from window import FROM_PORT

_BELOW_THE_LIST = 85  # of the panel Appendages with one body, in dots


def model_of_freeship(folder):
    """A .fbm, of the sample coaster."""
    data = hull_io().read_hull(part("features.hull.samples").sample_files()["coaster"])
    hull_io().write_freeship(data, folder / "model.fbm", "m")
    return folder / "model.fbm"


def ties(hull):
    return part("features.constraints.ties").stored_ties(hull.data)


def test_from_file_to_file(window):
    folder = Path(tempfile.mkdtemp())
    path = model_of_freeship(folder)
    bpy.context.preferences.view.filebrowser_display_type = "SCREEN"
    with window.in_view():
        bpy.ops.hull.import_hull("INVOKE_DEFAULT", filepath=str(path))
    yield from window.accept_file(path)
    yield lambda: hull_at_hand() is not None and part("bridge.objects.hull_objects").is_hull(
        hull_at_hand()
    )
    hull = hull_at_hand()
    assert hull.hull.half and hull.hull.draft > 0.0
    window.space.shading.type = "WIREFRAME"
    window.look(hull, FROM_PORT)
    yield
    # Edge › Crease: Shift Q.
    window.press("TAB")
    yield
    assert hull.mode == "EDIT"
    bpy.ops.mesh.select_mode(type="EDGE")
    bpy.ops.mesh.select_all(action="DESELECT")
    edges = smooth_edges_within(hull, 2)
    select(hull, *edges, kind="edges")
    yield
    window.pie("Q", *LEFT, shift=True)
    yield
    assert (crease_values(hull)[edges] == 1.0).all()
    # Point › Linear constraint: Tie Points, On a Line.
    bpy.ops.mesh.select_mode(type="VERT")
    bpy.ops.mesh.select_all(action="DESELECT")
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
    window.search("fin keel")
    yield
    yield
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
    show_all_panels()
    yield
    # File › Save: Export FREE!ship.
    back = folder / "back.fbm"
    with window.in_view():
        bpy.ops.hull.export_freeship("INVOKE_DEFAULT", filepath=str(back))
    yield from window.accept_file(back)
    yield back.exists
    read = hull_io().read_hull(back)
    np.testing.assert_allclose(read.points, edited_points(hull), atol=1e-5)
    assert len(read.creases) >= 2
