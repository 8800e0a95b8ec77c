# SPDX-License-Identifier: GPL-3.0-or-later
"""Saves each sample as a hull in a .blend file of its own, beside its hull file.

blender --background --python-exit-code 1 --python scripts/sample_blends.py
"""

import sys
from pathlib import Path

import bpy

# Blender runs a file without its folder on the path.
sys.path[:0] = [str(Path(__file__).resolve().parent)]

from enabled_addon import part  # noqa: E402
from quiet_output import quiet_output  # noqa: E402

SAMPLES = Path(__file__).resolve().parents[1] / "samples"


def main():
    for path in sorted(SAMPLES.glob("*.hull.json")):
        bpy.ops.wm.read_homefile(use_empty=True)
        target = path.with_name(path.name.replace(".hull.json", ".blend"))
        with quiet_output():
            bpy.ops.hull.import_hull(filepath=str(path))
            status = part("features.hull.hull_state").state_of(bpy.context.object).status
            bpy.ops.wm.save_as_mainfile(filepath=str(target), compress=True)
        if status:
            sys.exit(f"{path}: {status}")
        print(f"samples/{target.name}", flush=True)


main()
