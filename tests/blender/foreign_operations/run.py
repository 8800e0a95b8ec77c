# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one session in a Blender of its own, which it may bring down.

blender [--background] --python run.py -- SEED STEPS FOLDER

FOLDER/steps.txt tells each step before and after it is done, FOLDER/python.txt what Python was at
when Blender crashed, FOLDER/finding.txt what was found. The exit code is 3 then.
"""

import faulthandler
import os
import sys
import traceback
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from foreign_operations import oracle  # noqa: E402
from foreign_operations.session import Session  # noqa: E402

LONGEST_STEP_SECONDS = 300


class Listening:
    """Standard error that remembers."""

    def __init__(self, stream):
        self.stream, self.text = stream, ""

    def write(self, text):
        self.text += text
        return self.stream.write(text)

    def flush(self):
        self.stream.flush()


def main(seed, steps, folder):
    folder = Path(folder)
    python = open(folder / "python.txt", "w")
    faulthandler.enable(python)
    sys.stderr = Listening(sys.stderr)
    log = open(folder / "steps.txt", "w", buffering=1)
    bpy.ops.wm.read_homefile(use_empty=True)
    session = Session(int(seed), folder)
    session.tell = lambda text: print("begin", text, file=log)
    for number in range(int(steps)):
        faulthandler.dump_traceback_later(LONGEST_STEP_SECONDS, exit=True, file=python)
        try:
            done = session.step()
        except Exception:
            done = "FAILED " + traceback.format_exc()
        print(number, done, file=log)
        found = oracle.differences()
        if f"{os.sep}hull_tools{os.sep}" in sys.stderr.text:  # a traceback
            found.insert(0, sys.stderr.text)
        if done.startswith("FAILED"):
            found.append(done)
        if found:
            (folder / "finding.txt").write_text(
                "\n".join([f"seed {seed} step {number}: {done}", *found])
            )
            log.flush()
            os._exit(3)
    print("done", file=log, flush=True)
    os._exit(0)


main(*sys.argv[sys.argv.index("--") + 1 :])
