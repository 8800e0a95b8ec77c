# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's own operations on hulls, by chance: what is shown after each is what is computed afresh
of the control mesh, and no handler ends in a traceback.

HULL_FOREIGN_STEPS is the number of steps, 2,000 when not said; HULL_FOREIGN_SEED the first seed:
each session of some hundred steps takes the next one, so that runs with first seeds near one
another do the same. With HULL_FOREIGN_WINDOW=1 they are done in a window, which needs a screen, and
takes some times as long.
"""

import os

import bpy
from foreign_operations import operators, own_work, runs

STEPS = int(os.environ.get("HULL_FOREIGN_STEPS", 2000))
SEED = int(os.environ.get("HULL_FOREIGN_SEED", 97000000))
IN_WINDOW = os.environ.get("HULL_FOREIGN_WINDOW") == "1"
# Small: it is drawn after each step.
WINDOW = ("--window-geometry", "0", "0", "800", "600", "-noaudio", "--enable-event-simulate")
HOW = WINDOW if IN_WINDOW else ("--background",)
# Where Blender itself crashes a session ends early, and another one takes its place.
MOST_CRASHES = 2 + STEPS // 400


def test_what_is_left_out_is_blenders_own():
    """Names that Blender has, so that none of them is left out in vain for its spelling, each with
    a reason. What later versions no longer have is told by the first one that is supported."""
    version = bpy.app.version[:2]
    for name in [*operators.LEFT_OUT, *operators.TELL_NOBODY]:
        module, own = name.split(".")
        since = operators.SINCE.get(name)
        if version >= since if since else version < (4, 0):
            assert own in operators.names_of(module), name
    assert set(operators.SINCE) <= set(operators.LEFT_OUT)
    assert all(operators.LEFT_OUT.values())
    types = bpy.types.Modifier.bl_rna.properties["type"].enum_items.keys()
    assert operators.MODIFIERS_LEFT_OUT <= set(types)
    ours = {f"hull.{name}" for name in operators.names_of("hull")}
    assert set(own_work.LEFT_OUT) <= ours


def test_what_is_shown_follows_whatever_is_done(tmp_path):
    done, crashes, seed = 0, [], SEED
    while done < STEPS:
        print("seed", seed)
        steps = min(runs.STEPS_A_SESSION, STEPS - done)
        outcome = runs.run([bpy.app.binary_path, *HOW], seed, steps, tmp_path / str(seed))
        assert not outcome.finding, outcome.finding
        done, seed = done + outcome.steps, seed + 1
        crashes += [outcome.crashed_at] if outcome.crashed_at else []
        assert len(crashes) <= MOST_CRASHES, crashes
    print(done, "steps; Blender itself crashed at", crashes)
