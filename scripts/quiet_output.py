# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps Blender's own lines, about every tile and file, off the terminal."""

import contextlib
import os
import sys


@contextlib.contextmanager
def quiet_output():
    sys.stdout.flush()
    terminal = os.dup(1)
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        os.dup2(terminal, 1)
        os.close(terminal)
