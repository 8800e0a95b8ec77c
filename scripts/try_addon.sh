#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Install an add-on's zip in this system's Blender, in a profile of its own, and run the tests in Blender on it.
# usage: try_addon.sh ZIP [PYTEST ARGUMENT...]; nothing but Blender and pytest is needed.
set -eu
cd "$(dirname "$0")/.."
zip=$1
shift
profile=$PWD/build/plain-profile
rm -rf "$profile"
mkdir -p "$profile" build/tmp
export BLENDER_USER_RESOURCES="$profile" TMPDIR="$PWD/build/tmp" PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8
for part in config scripts datafiles extensions; do
    name=BLENDER_USER_$(echo $part | tr '[:lower:]' '[:upper:]')
    export "$name=$profile/$part"
done
blender --background --factory-startup --python-exit-code 1 --python scripts/install_addon.py -- "$zip"
blender --background --python-exit-code 1 --python tests/blender/run_tests.py -- "$@"
