# SPDX-License-Identifier: GPL-3.0-or-later
"""Foreign hulls, and copies of them as other programs might have left them, as meshes that nobody
has mended: what is wrong has a button each, and with those pressed they are measured, drawn and
written.

HULL_ALL_COPIES=1 tries all copies, not a few of each hull, and writes the largest to STEP and IGES
too.
"""

import os
import re

import bpy
import pytest
from addon_under_test import SHARED, by_path, hull_io, make_active, part
from test_panels import Drawn, context

pytestmark = pytest.mark.once

FOLDER = SHARED / "hulls" / "freeship"
SEED = 1723
ALL = os.environ.get("HULL_ALL_COPIES") == "1"
FEW = 1
MOST_BUTTONS = 6
MENDING = part("panels.doubts")._MENDING
HALF = "hull.make_half", {"cut": True}
# Of the volume, that lies beside the centre plane where both sides reach across it, and is cut off.
CUT_OFF = 1e-4
SINGLE_PRECISION = 1e-5  # of the volume, by what FREE!ship files keep of each coordinate


hulls_of_others = by_path("hulls_of_others")


def names():
    return sorted(path.name for path in FOLDER.glob("*.f[bt]m"))


def copies_of(name):
    data = hull_io().read_hull(FOLDER / name)
    return hulls_of_others.copies(data, SEED, hull_io("mirror").mirror_faces)


def hull_of(data):
    scene = bpy.context.scene
    hull = part("features.hull.hull_creation").hull_object(data, scene, scene.collection)
    make_active(hull)
    return hull


def state_now(hull):
    return part("features.hull.hull_state").refresh(hull, bpy.context.scene)


def remedy_of(hull):
    """The kind of what helps first, "" where nothing is wrong: all that is refused has one."""
    state = state_now(hull)
    errors = [problem for problem in state.ship.check.problems if problem.severity == "error"]
    assert all(problem.remedy for problem in errors), [problem.message for problem in errors]
    if errors:
        return errors[0].remedy
    assert not state.status
    found = state.hydrostatics
    if found.values is not None and not found.values.remark:
        return ""
    kinds = part("features.hull.remedies").of_volume(hull, state)
    # Selecting borders shows where, and mends nothing.
    return next(kind for kind in kinds if kind != "BORDERS")


def press_buttons(hull):
    """Presses what the panels offer for what is wrong until nothing is; returns the state then, and
    the names of the buttons."""
    pressed = []
    while kind := remedy_of(hull):
        name, options = HALF if kind == "MAKE_HALF" else (MENDING[kind][0], {})
        assert f"operator {name}" in drawn("check") + drawn("hydrostatics")
        assert getattr(bpy.ops.hull, name.split(".")[1])(**options) == {"FINISHED"}
        pressed.append(name)
        assert len(pressed) < MOST_BUTTONS, pressed
    return state_now(hull), pressed


def drawn(name):
    """What a panel shows."""
    panel = Drawn(getattr(bpy.types, f"HULL_PT_{name}"))
    panel.draw(context())
    return panel.layout.noted


def volume(state):
    found = state.hydrostatics.values
    assert found is not None, state.hydrostatics.status
    return found.displaced_volume


@pytest.mark.parametrize(
    "name, kind", hulls_of_others.chosen_copies(names(), copies_of, 0 if ALL else FEW)
)
def test_a_copy_is_mended_by_its_buttons(name, kind, tmp_path):
    data = copies_of(name)[kind]
    wanted = hull_of(hull_io().read_hull(FOLDER / name))
    wanted.hull.draft = wanted.hull.draft or 0.5 * max(v.co.z for v in wanted.data.vertices)
    hull = hull_of(data)
    hull.hull.draft = wanted.hull.draft
    said = state_now(hull).hydrostatics.status
    state, pressed = press_buttons(hull)
    if (name, kind) in hulls_of_others.REFUSED:
        assert re.search(hulls_of_others.REFUSED[name, kind], said)
        assert "hull.join_points" in pressed
    if (name, kind) == hulls_of_others.OPEN_KEEL:
        assert "not closed below the water" in said and pressed == ["hull.make_half"]
    allowed = hulls_of_others.change_of_volume(name, kind)
    if HALF[0] in pressed:
        allowed = max(allowed, CUT_OFF)
    assert volume(state) == pytest.approx(volume(press_buttons(wanted)[0]), rel=allowed)
    make_active(hull)
    lines = tmp_path / "lines.svg"
    assert bpy.ops.hull.export_lines(filepath=str(lines)) == {"FINISHED"}
    assert lines.stat().st_size > 2000
    if ALL or len(hull.data.polygons) <= hulls_of_others.most_faces(kind):
        for ending in ("step", "iges"):
            write(hull, tmp_path / f"hull.{ending}")


def write(hull, path):
    """What noise has put beside the centre plane has a button too, where it is told."""
    export = getattr(bpy.ops.hull, f"export_{path.suffix[1:]}")
    try:
        export(filepath=str(path))
    except RuntimeError as error:
        assert "use Put on Centre Plane" in str(error)
        assert "operator hull.put_on_centre_plane" in drawn("export")
        assert bpy.ops.hull.put_on_centre_plane() == {"FINISHED"}
        assert export(filepath=str(path)) == {"FINISHED"}
    assert part("bridge.native").require().read_cad_report(path)["valid"]


KINDS = ("noise 1e-09", "noise 1e-05", "whole", "to starboard", "of triangles", "torn",
         "with a wall", "pinched")  # fmt: skip
SMALL = ("FREE!ship demo 2.fbm", "FREE!ship demo tug.fbm", "ellipsoid321.fbm", "Motorboat.fbm",
         "pdock+weght_symm.fbm")  # fmt: skip


def files():
    """Pairs (name, kind, ending): each kind as each kind of file, of all small hulls in turn."""
    there = [name for name in SMALL if name in names()]
    for index, kind in enumerate(KINDS if there else ()):
        for ending in ("hull.json", "fbm"):
            for name in there if ALL else [there[index % len(there)]]:
                yield name, kind, ending


@pytest.mark.parametrize("name, kind, ending", files())
def test_a_copy_comes_from_a_file(name, kind, ending, tmp_path):
    """Read by the operator it is mended, which is told; what is left has buttons."""
    data = copies_of(name)[kind]
    path = tmp_path / f"copy.{ending}"
    files = hull_io()
    (files.write_hull_file if ending == "hull.json" else files.write_freeship)(data, path)
    read, original = files.read_mended(path), files.read_hull(FOLDER / name)
    notes = read.notes
    if kind in ("with a wall", "pinched"):
        assert any("were split" in note for note in notes)
    assert any("mirrored to port" in note for note in notes) == (
        kind == "to starboard" and data.half
    )
    if (kind, ending) == ("with a wall", "fbm"):
        # Of points where three creases meet, as at the ends of a wall, FREE!ship makes corners.
        original.corners = sorted({p for p in read.corners if p < len(original.points)})
    wanted = hull_of(original)
    assert bpy.ops.hull.import_hull(filepath=str(path)) == {"FINISHED"}
    hull = bpy.context.object
    wanted.hull.draft = hull.hull.draft = wanted.hull.draft or 0.5 * max(
        v.co.z for v in wanted.data.vertices
    )
    state, pressed = press_buttons(hull)
    # What has been told on import is done.
    assert not {"hull.split", "hull.mirror_to_port"} & set(pressed)
    allowed = max(hulls_of_others.change_of_volume(name, kind), SINGLE_PRECISION)
    assert volume(state) == pytest.approx(volume(press_buttons(wanted)[0]), rel=allowed)
    make_active(hull)
    for export, ending in (("lines", "svg"), ("hull", "hull.json"), ("freeship", "fbm")):
        written = tmp_path / f"again.{ending}"
        assert getattr(bpy.ops.hull, f"export_{export}")(filepath=str(written)) == {"FINISHED"}
        assert written.stat().st_size > 1000
    write(hull, tmp_path / "hull.step")
