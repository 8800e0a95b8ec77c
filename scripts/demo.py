# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that the add-on makes of one hull file, into a folder.

blender --background --python-exit-code 1 --python demo.py -- FILE FOLDER PERCENT

Makes hydrostatics.csv, plots of sectional areas, hydrostatic curves and righting levers,
lines.pdf, lines.svg and lines.dxf, offsets.csv, hull.step, render.png and hull.blend. The picture's
sides are PERCENT of 1600 and 900 dots.
"""

import math
import sys
import time
from pathlib import Path

import bpy

# Blender runs a file without its folder on the path.
sys.path[:0] = [str(Path(__file__).resolve().parent)]

from enabled_addon import part  # noqa: E402
from quiet_output import quiet_output  # noqa: E402

PLOTS = {
    "sectional_areas.svg": "sectional_areas",
    "hydrostatic_curves.svg": "hydrostatic_table",
    "righting_levers.svg": "righting_levers",
}


class Progress:
    """One line on the terminal for each step, with the seconds it took."""

    def __init__(self, steps):
        self.steps = steps
        self.done = 0

    def __call__(self, name, work):
        self.done += 1
        print(f"[{self.done}/{self.steps}] {name} ... ", end="", flush=True)
        start = time.monotonic()
        result = work()
        print(f"{time.monotonic() - start:.1f} s", flush=True)
        return result


def load(path):
    bpy.ops.wm.read_homefile(use_empty=True)
    with quiet_output():
        bpy.ops.hull.import_hull(filepath=str(path))
    hull = bpy.context.object
    state = part("features.hull.hull_state").state_of(hull)
    if state.status:
        raise ValueError(state.status)
    return hull


def describe(hull):
    """The hull's main numbers on the terminal."""
    state = part("features.hull.hull_state").state_of(hull)
    found, check = state.hydrostatics.values, state.ship.check
    print(f"      {hull.name}: {check.face_count} faces, {check.irregular_count} irregular points")
    if found is not None:
        print(
            f"      draft {found.draft:.3f} m, displacement {found.displacement_t:.1f} t, "
            f"LCB {found.lcb:.3f} m, KB {found.kb:.3f} m, KMt {found.kmt:.3f} m"
        )


def describe_patches(found):
    """How good the patches of the STEP file are, by their hull_native.QualityReport."""
    print(
        f"      {found.patch_count} patches, at most {1e3 * found.largest_distance:.3g} mm from "
        f"the exact surface, normals within {math.degrees(found.largest_seam_angle):.2g} degrees"
    )


def draw_plots(hull, folder):
    """A plot that this hull has not, such as levers of one that sinks, is told of and left out."""
    for file_name, analysis in PLOTS.items():
        path = str(folder / file_name)
        try:
            part("features.exchange.exports").export_plot(hull, bpy.context.scene, analysis, path)
        except ValueError as error:
            print(f"no {file_name}: {error} ", end="")


def draw_lines(hull, folder):
    for ending in ("pdf", "svg", "dxf"):
        path = str(folder / f"lines.{ending}")
        part("features.exchange.exports").export_lines_drawing(hull, bpy.context.scene, path)


def render(hull, path, percent):
    """The hull in its studio, seen over the bow quarter."""
    part("features.studio").make(hull, bpy.context.scene)
    bpy.context.scene.render.resolution_percentage = percent
    bpy.context.scene.render.filepath = str(path)
    with quiet_output():
        bpy.ops.render.render(write_still=True)


def save(path):
    with quiet_output():
        bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=True)


def make(source, folder, percent):
    exports = part("features.exchange.exports")
    step = Progress(8)
    hull = step(f"reading {source.name}", lambda: load(source))
    describe(hull)
    scene = bpy.context.scene
    table, offsets, solid = (
        str(folder / name) for name in ("hydrostatics.csv", "offsets.csv", "hull.step")
    )
    step("hydrostatics.csv", lambda: exports.export_table(hull, scene, "hydrostatic_table", table))
    step("plots", lambda: draw_plots(hull, folder))
    step("lines.pdf, .svg, .dxf", lambda: draw_lines(hull, folder))
    step("offsets.csv", lambda: exports.export_table(hull, scene, "offset_table", offsets))
    written = step(
        "hull.step", lambda: part("features.exchange.cad_files").export(hull, scene, solid)
    )
    describe_patches(written.converted.quality)
    step("render.png", lambda: render(hull, folder / "render.png", percent))
    step("hull.blend", lambda: save(folder / "hull.blend"))


def main():
    source, folder, percent = sys.argv[sys.argv.index("--") + 1 :]
    source, folder = Path(source), Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    try:
        make(source, folder, int(percent))
    except (ValueError, OSError, RuntimeError) as error:
        message = str(error).removeprefix("Error: ").strip()
        print(f"\nhull: {message}", file=sys.stderr)
        sys.exit(1)


main()
