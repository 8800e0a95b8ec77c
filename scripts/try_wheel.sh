#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Try this system's wheel where nothing of ours is: a bare Debian 12 in a chroot below build/bookworm, with Python, NumPy
# and pytest alone, and there the Python tests on the module as pip installs it. Needs root; the Debian is kept for the
# next run.
# usage: try_wheel.sh [PYTEST ARGUMENT...]: all tests of tests/python where none is said.
set -eu
cd "$(dirname "$0")/.."
. scripts/debian_root.sh

root=build/bookworm/plain
make_root bookworm "$root" python3,python3-numpy,python3-venv,python3-pytest
copy_checkout "$root"
mkdir -p "$root/house/checkout/build/wheels"
cp build/wheels/*-cp311-*.whl "$root/house/checkout/build/wheels"
[ $# != 0 ] || set -- tests/python
# shellcheck disable=SC2016 # expanded in the chroot
in_root "$root" sh -c 'set -eu
    cd /house/checkout
    python3 -m venv --clear --system-site-packages build/venv
    build/venv/bin/pip install -q --no-index build/wheels/*-cp311-*.whl
    PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8 exec build/venv/bin/python -m pytest -p no:cacheprovider -r fE "$@"' sh "$@"
