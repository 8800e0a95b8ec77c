# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests of one file, inside Blender's window.

blender --enable-event-simulate --python in_blender.py -- FOLDER FILE[::TEST]

Writes a line of JSON for each test into FOLDER/results, and a picture of the window at
each failure. Every test begins with an empty file.
"""

import importlib.util
import json
import sys
from pathlib import Path

import bpy

HERE = Path(__file__).resolve().parent
# Blender runs a file without its folder on the path.
sys.path[:0] = [str(HERE), str(HERE.parent / "blender"), str(HERE.parent / "python" / "io")]

import sidebar  # noqa: E402
from stepping import Stepper  # noqa: E402
from window import Window  # noqa: E402


def tests_of(path, wanted):
    """Pairs (name, function) of a file's tests, in its order."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    tests = [(n, f) for n, f in vars(module).items() if n.startswith("test_") and callable(f)]
    return [(name, test) for name, test in tests if wanted in ("", name)]


class Run:
    """All tests of a file, one after the other; `step` is a timer."""

    def __init__(self, tests, folder):
        self._tests, self._folder = tests, folder
        self._name, self._stepper = "", None

    def step(self):
        if self._stepper is None:
            if not self._tests:
                self._end()
                return None
            self._begin()
            return 0.05
        pause = self._stepper.step()
        if pause is not None:
            return pause
        self._note(self._stepper)
        self._stepper = None
        return 0.0

    def _begin(self):
        bpy.ops.wm.read_homefile(use_empty=True)
        self._name, test = self._tests.pop(0)
        print(f"-- {self._name}", flush=True)
        self._stepper = Stepper(test, Window())

    def _note(self, stepper):
        outcome = "failed" if stepper.report else "passed"
        if stepper.report:
            Window().screenshot(self._folder / f"{self._name}.png")
        self._write({"test": self._name, "outcome": outcome, "report": stepper.report})

    def _end(self):
        # Blender 4.2 and later disable add-ons when they quit, with the panels that there were.
        sidebar.put_back_panels()
        self._write({"ended": True})
        bpy.ops.wm.quit_blender()

    def _write(self, result):
        with open(self._folder / "results", "a") as results:
            results.write(json.dumps(result) + "\n")


def main():
    folder, which = sys.argv[sys.argv.index("--") + 1 :]
    path, _, wanted = which.partition("::")
    bpy.context.preferences.view.show_splash = False
    bpy.context.preferences.use_preferences_save = False
    # Drawn by the processor, smoothing takes longer than all else.
    bpy.context.preferences.system.viewport_aa = "OFF"
    bpy.context.preferences.filepaths.use_auto_save_temporary_files = False
    # However slow the machine: a key that opens a pie was tapped, and two clicks are two.
    view, inputs = bpy.context.preferences.view, bpy.context.preferences.inputs
    view.pie_tap_timeout, view.pie_animation_timeout = 1000, 0
    inputs.mouse_double_click_time = 1
    run = Run(tests_of(Path(path), wanted), Path(folder))
    bpy.app.timers.register(run.step, first_interval=0.5, persistent=True)


main()
