#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run tests of the window, all or those of the files named, in this system's Blender with the add-on that try_addon.sh
# has installed, on a screen that nobody sees (Xvfb).
# usage: try_window.sh [FILE...]; logs and pictures go to build/window.
set -eu
cd "$(dirname "$0")/.."
. scripts/plain_profile.sh
LIBGL_ALWAYS_SOFTWARE=1 exec xvfb-run -a -s "-screen 0 1400x1000x24" python3 tests/window/run_tests.py build/window "$@"
