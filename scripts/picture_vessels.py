# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of vessels with paint, sections and waterlines, and as mirrors of light lines.

blender --background --python-exit-code 1 --python scripts/picture_vessels.py -- FOLDER NAME ...

into FOLDER/NAME/, as rendering_*.png and reflection_*.png, from two sides each.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

from enabled_addon import part  # noqa: E402
from figures import reflection_scene  # noqa: E402
from quiet_output import quiet_output  # noqa: E402

# Of the studio: whole hulls, from below the bow and over the stern.
VIEWS = {"bow": "UNDERWATER", "stern": "STERN"}
# Room beside the hull.
WIDER = 0.95
SAMPLES = Path(__file__).resolve().parents[1] / "samples"
# Fine enough that a facet of the surface shows nowhere in a picture.
SAMPLES_PER_CELL = 16


def load(path):
    bpy.ops.wm.read_homefile(use_empty=True)
    with quiet_output():
        bpy.ops.hull.import_hull(filepath=str(path))
    hull = bpy.context.object
    hull.hull.samples = SAMPLES_PER_CELL
    state = part("bridge.hull_state").refresh(hull, bpy.context.scene)
    if state.status:
        raise ValueError(f"{path}: {state.status}")
    return hull


def render(path):
    bpy.context.scene.render.filepath = str(path)
    with quiet_output():
        bpy.ops.render.render(write_still=True)


def paint(path, folder):
    hull = load(path)
    hull.hull.studio.ground, hull.hull.studio.light = "NONE", "STUDIO"
    with quiet_output():
        bpy.ops.hull.make_studio()
    bpy.context.scene.render.dither_intensity = 0.0
    for name, view in VIEWS.items():
        with quiet_output():
            bpy.ops.hull.studio_view(view=view)
        bpy.context.scene.camera.data.lens *= WIDER
        render(folder / f"rendering_{name}.png")


def mirror(path, folder):
    hull = load(path)
    reflection_scene.set_up(hull.hull.surface_object)
    for view in reflection_scene.VIEWS:
        reflection_scene.look_from(hull.hull.surface_object, view)
        render(folder / f"reflection_{view}.png")


def main():
    folder, *names = sys.argv[sys.argv.index("--") + 1 :]
    for name in names:
        path = SAMPLES / f"{name}.hull.json"
        target = Path(folder) / name
        target.mkdir(parents=True, exist_ok=True)
        print(f"Pictures of {name}", flush=True)
        paint(path, target)
        mirror(path, target)


main()
