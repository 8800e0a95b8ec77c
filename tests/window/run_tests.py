# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests with Blender's real window and real events, one Blender for each file of tests.

python3 run_tests.py FOLDER [FILE[::TEST]...]

Needs a screen; `blender` must have the add-on enabled. Logs, and pictures of what failed, go to
FOLDER. A test fails by itself; a file fails too when Blender ends early or does not end, or when
its log tells of an exception that nothing caught.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent

# No file of tests takes a quarter of this on a slow machine.
FILE_SECONDS = 900
# What a log without trouble does not have. Fixed words of Python and of Blender.
TROUBLE = re.compile(
    r"^(Traceback \(most recent call last\)|\w+Error: |.*Error: (Not freed|Python)"
    r"|WARN \(bpy\.rna\)|.*ERROR \(gpu\.)",
    re.M,
)
BLENDER = (
    "blender",
    "--window-geometry",
    "0",
    "0",
    "1100",
    "760",
    "-noaudio",
    "--python-use-system-env",
    "--enable-event-simulate",
    "--python-exit-code",
    "1",
)


def run_file(which, folder):
    """Runs the tests of one file; returns pairs (name, report), the report "" where it passed."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    command = [*BLENDER, "--python", str(HERE / "in_blender.py"), "--", str(folder), which]
    with open(folder / "log", "w") as log:
        # Its own group: the screen of a wrapper must not outlive it.
        process = subprocess.Popen(
            command, stdout=log, stderr=subprocess.STDOUT, start_new_session=True
        )
        try:
            process.wait(FILE_SECONDS)
            ending = "" if process.returncode == 0 else f"Blender ended with {process.returncode}"
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            ending = f"Blender had not ended after {FILE_SECONDS} s"
    return list(_outcomes(folder, ending))


def _outcomes(folder, ending):
    results = folder / "results"
    lines = results.read_text().splitlines() if results.exists() else []
    found = [json.loads(line) for line in lines]
    for result in found:
        if "test" in result:
            yield result["test"], result["report"]
    log = (folder / "log").read_text(errors="replace")
    has_ended = bool(found) and "ended" in found[-1]
    if ending or not has_ended:
        yield "(end)", f"{ending or 'Blender ended before its tests'}\n{log[-4000:]}"
    trouble = TROUBLE.search(log)
    if trouble:
        yield "(log)", log[trouble.start() :][:4000]


def main():
    folder, *wanted = sys.argv[1:]
    files = wanted or sorted(map(str, HERE.glob("test_*.py")))
    passed = failed = 0
    for which in files:
        path, colons, test = which.partition("::")
        full = str(Path(path).resolve()) + colons + test
        for name, report in run_file(full, Path(folder).resolve() / Path(path).stem):
            print(f"{'FAILED' if report else 'passed'}  {Path(path).stem}::{name}", flush=True)
            passed, failed = passed + (not report), failed + bool(report)
            if report:
                print(report, flush=True)
    print(f"{passed} passed, {failed} failed; logs and pictures in {folder}")
    return 0 if passed and not failed else 1


if __name__ == "__main__":
    sys.exit(main())
