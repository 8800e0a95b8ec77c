# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one session in a Blender of its own, which it may bring down.

blender --background|--enable-event-simulate --python run.py -- SEED STEPS FOLDER

FOLDER/steps.txt tells each step before and after it is done, and how long slow ones took,
FOLDER/python.txt what Python was at when Blender crashed, FOLDER/finding.txt what was found. The
exit code is 3 then.
"""

import faulthandler
import os
import random
import sys
import time
import traceback
from pathlib import Path

import bpy

TESTS = Path(__file__).resolve().parents[2]
# Blender runs a file without its folder on the path.
sys.path[:0] = [str(TESTS / "blender"), str(TESTS / "window")]

from addon_under_test import part  # noqa: E402
from foreign_operations import oracle  # noqa: E402
from foreign_operations.session import Session  # noqa: E402
from foreign_operations.view import in_view, make_small, open_sidebar  # noqa: E402

# Of the clock: what hangs ends here. Other work on the machine may slow long jobs down.
LONGEST_STEP_SECONDS = 900
LONGEST_WORK_SECONDS = 300  # of the processor
SLOW_STEP_SECONDS = 1.0  # of the processor: told in the log
# In a window, between two steps: work for pauses is done in the longest of these.
PAUSES_SECONDS = (0.0, 0.0, 0.0, 0.5)
EVENT_SECONDS = 0.1
# What is joined at the next pause has so long for it.
LONGEST_WAIT_SECONDS = 20.0
# With simulated events Blender never rests between two of them, but looks for the next one all the
# time: it is put to rest so long at a time, and draws and serves other timers between.
REST_SECONDS = 0.02


class Listening:
    """Standard error that remembers."""

    def __init__(self, stream):
        self.stream, self.text = stream, ""

    def write(self, text):
        self.text += text
        return self.stream.write(text)

    def flush(self):
        self.stream.flush()


class Run:
    """A session of `steps` steps; what is shown is judged after each."""

    def __init__(self, seed, steps, folder):
        self._seed, self._steps, self._folder = seed, steps, folder
        self._python = open(folder / "python.txt", "w")
        self._log = open(folder / "steps.txt", "w", buffering=1)
        self._number = 0
        faulthandler.enable(self._python)
        bpy.ops.wm.read_homefile(use_empty=True)
        with in_view():
            self._session = Session(seed, folder)
        self._session.tell = lambda text: print("begin", text, file=self._log)

    def step(self):
        """Does one thing; returns what."""
        python, begun = self._python, time.process_time()
        faulthandler.dump_traceback_later(LONGEST_STEP_SECONDS, exit=True, file=python)
        try:
            with in_view():
                done = self._session.step()
        except Exception:
            done = "FAILED " + traceback.format_exc()
        took = time.process_time() - begun
        if took > LONGEST_WORK_SECONDS:
            done = f"FAILED after {took:.0f} s of processor time: {done}"
        slow = f" ({took:.1f} s)" if took > SLOW_STEP_SECONDS else ""
        print(f"{self._number} {done}{slow}", file=self._log)
        return done

    def judge(self, done):
        """Ends Blender where something is found after a step, and after the last."""
        with in_view():
            found = oracle.differences()
        if f"{os.sep}hull_tools{os.sep}" in sys.stderr.text:  # a traceback
            found.insert(0, sys.stderr.text)
        if done.startswith("FAILED"):
            found.append(done)
        if found:
            what = f"seed {self._seed} step {self._number}: {done}"
            (self._folder / "finding.txt").write_text("\n".join([what, *found]))
            self._end(3)
        self._number += 1
        if self._number == self._steps:
            print("done", file=self._log)
            self._end(0)

    def _end(self, code):
        self._log.flush()
        os._exit(code)


class InWindow:
    """`advance` is a timer: between a step and its judgement Blender handles events, and draws the
    view and the panels, which are open where the seed is odd."""

    def __init__(self, *arguments):
        self._arguments, self._run, self._done = arguments, None, ""
        self._rests_until, self._stepped_at = 0.0, 0.0
        self._chance, self._events = random.Random(arguments[0]), None
        # Drawn by the processor, smoothing takes longer than all else.
        bpy.context.preferences.system.viewport_aa = "OFF"

    def advance(self):
        left = self._rests_until - time.monotonic()
        if left > 0.0:
            time.sleep(min(left, REST_SECONDS))
            return 0.0
        try:
            self._advance()
        except Exception:
            traceback.print_exc()
            os._exit(1)
        pause = EVENT_SECONDS if self._events else self._chance.choice(PAUSES_SECONDS)
        self._rests_until = time.monotonic() + pause
        return 0.0

    def _advance(self):
        # The plain view draws other things, and at other times, than one beside panels.
        has_sidebar = self._arguments[0] % 2 == 1
        if self._run is None:
            self._run = Run(*self._arguments)
            make_small(has_sidebar)
        elif self._events is None:  # what was loaded has been drawn
            self._events = open_sidebar() if has_sidebar else []
        elif self._events:
            self._events.pop(0)()
        elif not (self._done and self._waits()):
            if self._done:
                self._run.judge(self._done)
            self._done, self._stepped_at = self._run.step(), time.monotonic()

    def _waits(self):
        """Whether appendages are to be joined still, now that points rest."""
        if time.monotonic() - self._stepped_at > LONGEST_WAIT_SECONDS:
            return False
        states = part("features.hull.hull_state").known_hulls(bpy.context.view_layer)
        return any(state.ship.waits for _, state in states)


def main(seed, steps, folder):
    sys.stderr = Listening(sys.stderr)
    arguments = int(seed), int(steps), Path(folder)
    if not bpy.app.background:
        bpy.app.timers.register(InWindow(*arguments).advance, first_interval=0.5, persistent=True)
        return
    run = Run(*arguments)
    while True:
        run.judge(run.step())


main(*sys.argv[sys.argv.index("--") + 1 :])
