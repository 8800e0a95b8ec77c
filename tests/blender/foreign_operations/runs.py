# SPDX-License-Identifier: GPL-3.0-or-later
"""Sessions in Blenders of their own, one after the other, until enough steps are done."""

import os
import resource
import subprocess
from dataclasses import dataclass
from pathlib import Path

STEPS_A_SESSION = 250
_FOUND, _SECONDS = 3, 3600
# Some operators of Blender's take all memory there is, by chance: that ends their session alone.
_MOST_BYTES = 8 * 1024**3
_OURS = ("hull_tools", "hull_native")


@dataclass(frozen=True)
class Outcome:
    """steps: how many were done. finding: what was found, or "". crashed_at: the step at which
    Blender itself crashed, with nothing of the add-on at work; or ""."""

    steps: int
    finding: str = ""
    crashed_at: str = ""


def run(blender, seed, steps, folder):
    """The Outcome of one session. blender: its program, with arguments."""
    folder = Path(folder)
    folder.mkdir(parents=True)
    script = Path(__file__).with_name("run.py")
    command = [*blender, "--python-exit-code", "1", "--python", str(script), "--"]
    with open(folder / "output.txt", "w", encoding="utf-8") as output:
        done = subprocess.run(
            [*command, str(seed), str(steps), str(folder)],
            env={**os.environ, "TMPDIR": str(folder)},
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=subprocess.STDOUT,
            timeout=_SECONDS,
            check=False,
            preexec_fn=_bounded,
        )
    return _judged(done.returncode, seed, folder)


def _bounded():
    resource.setrlimit(resource.RLIMIT_AS, (_MOST_BYTES, _MOST_BYTES))


def _judged(code, seed, folder):
    log = _text(folder / "steps.txt").splitlines()
    steps = sum(line.split(" ", 1)[0].isdigit() for line in log)
    if code == 0:
        return Outcome(steps)
    if code == _FOUND:
        return Outcome(steps, "\n".join([_text(folder / "finding.txt"), *log[-12:]]))
    at = _text(folder / "python.txt")
    stacks = at + "".join(_text(path) for path in folder.glob("**/*crash.txt"))
    if not at or any(name in stacks for name in _OURS):
        last = _text(folder / "output.txt").splitlines()[-20:]
        return Outcome(steps, "\n".join([f"seed {seed}: exit code {code}", *log[-12:], at, *last]))
    return Outcome(steps, crashed_at=f"seed {seed}: {log[-1] if log else ''}")


def _text(path):
    return path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
