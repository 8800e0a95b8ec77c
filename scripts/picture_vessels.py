# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of vessels with paint, sections and waterlines, and as mirrors of light lines.

PYTHONPATH=python blender --background --python-use-system-env --python-exit-code 1 \
    --python picture_vessels.py -- FOLDER PERCENT NAME ...

into FOLDER/NAME/, as rendering_*.png and reflection_*.png, from two sides each, with PERCENT of
the full width of 1600 dots.
"""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parent))

from enabled_addon import part  # noqa: E402
from figures import reflection_scene  # noqa: E402
from hull_fairness.lights import VIEWS  # noqa: E402
from quiet_output import quiet_output  # noqa: E402

SAMPLES = Path(__file__).resolve().parents[1] / "samples"
# Fine enough that a facet of the surface shows nowhere in a picture.
SAMPLES_PER_CELL = 16


def load(path):
    bpy.ops.wm.read_homefile(use_empty=True)
    with quiet_output():
        bpy.ops.hull.import_hull(filepath=str(path))
    hull = bpy.context.object
    hull.hull.samples = SAMPLES_PER_CELL
    state = part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    if state.status:
        raise ValueError(f"{path}: {state.status}")
    return hull


def render(path, percent):
    bpy.context.scene.render.resolution_percentage = percent
    bpy.context.scene.render.filepath = str(path)
    with quiet_output():
        bpy.ops.render.render(write_still=True)


def paint(path, folder, percent):
    hull = load(path)
    hull.hull.studio.ground, hull.hull.studio.light = "NONE", "STUDIO"
    with quiet_output():
        bpy.ops.hull.make_studio()
    bpy.context.scene.render.dither_intensity = 0.0
    take_views(hull, folder / "rendering", percent)


def mirror(path, folder, percent):
    hull = load(path)
    reflection_scene.set_up(hull.hull.surface_object)
    take_views(hull, folder / "reflection", percent)


def take_views(hull, stem, percent):
    for view in VIEWS:
        reflection_scene.look_from(hull.hull.surface_object, view)
        render(f"{stem}_{view}.png", percent)


def main():
    folder, percent, *names = sys.argv[sys.argv.index("--") + 1 :]
    for name in names:
        path = SAMPLES / f"{name}.hull.json"
        target = Path(folder) / name
        target.mkdir(parents=True, exist_ok=True)
        print(f"Pictures of {name}", flush=True)
        paint(path, target, int(percent))
        mirror(path, target, int(percent))


main()
