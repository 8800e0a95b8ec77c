# SPDX-License-Identifier: GPL-3.0-or-later
"""Enabling the add-on loads what Blender needs at once, and nothing of what is used later."""

import json
import subprocess

import bpy
from addon_under_test import module_name

# Of the add-on's modules, run by enabling it: properties, operators, panels, overlays, and what
# their classes are made with: three to five for each subject that a user meets.
MOST_MODULES = 160
LATER = (
    "hull_native",
    "hull_io.freeship",
    "hull_io.hull_file",
    "hull_io.hull_data",
    "hull_io.new_hulls.barge",
    "hull_io.new_hulls.round_bilge",
    "features.hull.hull_state",
    "features.curves_of_form",
    "features.fairness",
    "features.lines.offset_table",
    "features.stability",
    "features.surface.shown_surface",
    "features.lines.lines",
    "features.conversion.conversions",
    "features.conversion.patches",
    "features.fitting.fitting",
    "features.geometry",
    "hull_fitting",
    "features.modelling.pulling",
    "features.networks",
    "features.studio.cameras",
    "features.studio.water_or_floor",
    "overlays.field_arrays",
    "overlays.legend_arrays",
    "overlays.line_arrays",
    "overlays.mark_arrays",
    "overlays.network_arrays",
    "overlays.plot_arrays",
    "overlays.shapes",
    "overlays.tag_arrays",
    "overlays.tag_drawing",
)
# Modules that have run are of Python's own type.
PROGRAM = """
import gc, json, sys, types
import addon_utils
searches, noted = [], []
gc.callbacks.append(lambda phase, info: searches.append(phase))
turn_off, turn_on = gc.disable, gc.enable
def note():
    noted.append((len(searches), len(sys.modules)))
gc.disable = lambda: (note(), turn_off())
gc.enable = lambda: (note(), turn_on())
addon_utils.enable({name!r})
print("SEARCHES", json.dumps(noted))
print("COLLECTS", json.dumps(gc.isenabled()))
print("RAN", json.dumps([name for name, module in sys.modules.items()
                         if name.startswith({name!r}) and type(module) is types.ModuleType]))
print("FOREIGN", json.dumps(sorted(name for name in sys.modules if "." not in name)))
"""


def enabled():
    """What PROGRAM prints, by its first words, in a fresh Blender that has just enabled the add-on.
    RAN: names of its modules that have run."""
    name = module_name()
    done = subprocess.run(
        [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1"]
        + ["--python-expr", PROGRAM.format(name=name)],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [line.partition(" ") for line in done.stdout.splitlines()]
    found = {
        first: json.loads(rest)
        for first, _, rest in lines
        if first in ("RAN", "FOREIGN", "SEARCHES", "COLLECTS")
    }
    found["RAN"] = [one[len(name) + 1 :] for one in found["RAN"]]
    return found


def test_enabling_loads_little():
    found = enabled()
    own = [name.removeprefix("hull_tools.") for name in found["RAN"]]
    assert "operators.pull" in own and "panels.hull" in own
    for later in LATER:
        assert later not in own and not any(name.startswith(later + ".") for name in own), later
    assert len(own) <= MOST_MODULES
    assert not {"concurrent", "tempfile", "logging"} & set(found["FOREIGN"])
    # Searches for garbage among all that Blender has take a fifth of the time of enabling: there is
    # none while the modules run, but afterwards.
    (before, few), (after, many) = found["SEARCHES"]
    assert before == after and many - few > 100
    assert found["COLLECTS"] is True
