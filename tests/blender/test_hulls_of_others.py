# SPDX-License-Identifier: GPL-3.0-or-later
"""Foreign hulls, and copies of them as other programs might have left them, as meshes that nobody
has mended: what is wrong has a button each, and with those pressed they are measured, drawn and
written.

HULL_ALL_COPIES=1 tries all copies, not a few of each hull, and writes the largest to STEP too.
"""

import os
import re

import bpy
import pytest
from addon_under_test import SHARED, by_path, hull_io, make_active, part

pytestmark = pytest.mark.once

FOLDER = SHARED / "hulls" / "freeship"
SEED = 1723
ALL = os.environ.get("HULL_ALL_COPIES") == "1"
FEW = 1
MOST_FACES = 10**9 if ALL else 130
MOST_BUTTONS = 5
BUTTONS = {
    "SPLIT": bpy.ops.hull.split,
    "PORT": bpy.ops.hull.mirror_to_port,
    "CENTRE": bpy.ops.hull.put_on_centre_plane,
}


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


def press_buttons(hull):
    """Presses what the panel offers for each error, and turns the faces where told so; returns the
    state then."""
    for _ in range(MOST_BUTTONS):
        problems = state_now(hull).ship.check.problems
        errors = [problem for problem in problems if problem.severity == "error"]
        assert all(problem.remedy for problem in errors), [problem.message for problem in errors]
        if errors:
            assert BUTTONS[errors[0].remedy]() == {"FINISHED"}
        elif any("turned inwards" in problem.message for problem in problems):
            bpy.ops.hull.turn_outwards()
        else:
            break
    return state_now(hull)


def merge_by_distance():
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.remove_doubles()
    bpy.ops.object.mode_set(mode="OBJECT")


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
    state = press_buttons(hull)
    assert not state.status
    if (name, kind) in hulls_of_others.REFUSED:
        assert re.search(hulls_of_others.REFUSED[name, kind], state.hydrostatics.status)
        merge_by_distance()  # as it was told
        state = state_now(hull)
    if (name, kind) == hulls_of_others.OPEN_KEEL:
        assert "not closed below the water" in state.hydrostatics.status
    else:
        allowed = hulls_of_others.change_of_volume(name, kind)
        assert volume(state) == pytest.approx(volume(press_buttons(wanted)), rel=allowed)
        make_active(hull)
    lines = tmp_path / "lines.svg"
    assert bpy.ops.hull.export_lines(filepath=str(lines)) == {"FINISHED"}
    assert lines.stat().st_size > 2000
    if len(hull.data.polygons) <= MOST_FACES:
        write_step(hull, tmp_path / "hull.step")


def write_step(hull, path):
    """What noise has put beside the centre plane has a button too."""
    try:
        bpy.ops.hull.export_step(filepath=str(path))
    except RuntimeError as error:
        assert "set y to 0 there" in str(error)
        assert bpy.ops.hull.put_on_centre_plane() == {"FINISHED"}
        assert bpy.ops.hull.export_step(filepath=str(path)) == {"FINISHED"}
    assert part("bridge.native").require().read_cad_report(path)["valid"]
