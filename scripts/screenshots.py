# SPDX-License-Identifier: GPL-3.0-or-later
"""Make the pictures of the docs in Blender's window, or those named.

blender --enable-event-simulate --python screenshots.py -- FOLDER THEME KIND [NAME...]

THEME is "dark", as the docs have it, or "light", to be looked at; KIND is "panels", for which the
window is to be higher than any of them, or "views" with drawings.
"""

import sys
from pathlib import Path

import bpy

HERE = Path(__file__).resolve().parent
TESTS = HERE.parent / "tests"
# Blender runs a file without its folder on the path.
sys.path[:0] = [str(HERE), str(TESTS / "window"), str(TESTS / "blender")]

from screenshot_panels import PANELS, panel_scene  # noqa: E402
from screenshot_tools import Panels, save_window, use_theme  # noqa: E402
from screenshot_views import DRAWINGS, VIEWS  # noqa: E402
from stepping import Stepper  # noqa: E402
from window import Window  # noqa: E402

# How often Blender gets time to draw: each time a picture gets smoother.
_SMOOTHINGS = 4


class Shots:
    """All pictures, one after the other, each from an empty file; `step` is a timer."""

    def __init__(self, folder, names):
        self._folder = Path(folder)
        self._names = names
        self._panels = Panels()
        self._stepper = None

    def step(self):
        if self._stepper is None:
            if not self._names:
                self._panels.restore()
                bpy.ops.wm.quit_blender()
                return None
            self._begin(self._names.pop(0))
            return 0.1
        pause = self._stepper.step()
        if pause is None:
            if self._stepper.report:
                print(self._stepper.report, flush=True)
            self._stepper = None
        return pause or 0.0

    def _begin(self, name):
        print(f"-- {name}", flush=True)
        bpy.ops.wm.read_homefile(use_empty=True)
        # Smoothing takes the processor longer than all else: only what is kept is smoothed.
        bpy.context.preferences.system.viewport_aa = "OFF"
        self._stepper = Stepper(lambda window: self._shoot(window, name), Window())

    def _shoot(self, window, name):
        path = self._folder / f"{name}.png"
        path.parent.mkdir(parents=True, exist_ok=True)
        if name in DRAWINGS:
            self._panels.restore()
            yield from DRAWINGS[name](window, str(path))
        elif name in PANELS:
            self._panels.show_only(PANELS[name].panels)
            yield from panel_scene(window, PANELS[name])
            region = window.region("UI")
            box = region.x, region.y, region.width, region.height
            save_window(window, path, box, is_trimmed=True)
        else:
            self._panels.show_only(VIEWS[name].panels)
            yield from VIEWS[name].scene(window)
            bpy.context.preferences.system.viewport_aa = "8"
            window.area.tag_redraw()
            yield from (None for _ in range(_SMOOTHINGS))
            save_window(window, path)


def main():
    folder, theme, kind, *wanted = sys.argv[sys.argv.index("--") + 1 :]
    of_kind = {"panels": (*PANELS,), "views": (*VIEWS, *DRAWINGS)}[kind]
    preferences = bpy.context.preferences
    preferences.view.show_splash = False
    preferences.system.use_region_overlap = False  # the 3D view does not shine through
    preferences.use_preferences_save = False
    preferences.filepaths.use_auto_save_temporary_files = False
    use_theme(theme)
    shots = Shots(folder, [name for name in of_kind if not wanted or name in wanted])
    bpy.app.timers.register(shots.step, first_interval=0.5, persistent=True)


main()
