#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Install an add-on's zip in this system's Blender, in a profile of its own, and run the tests in Blender on it.
# usage: try_addon.sh ZIP [PYTEST ARGUMENT...]; nothing but Blender and pytest is needed.
set -eu
cd "$(dirname "$0")/.."
zip=$1
shift
rm -rf build/plain-profile
. scripts/plain_profile.sh
blender --background --factory-startup --python-exit-code 1 --python scripts/install_addon.py -- "$zip"
blender --background --python-exit-code 1 --python tests/blender/run_tests.py -- "$@"
