#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Build and test the add-on with Debian 13's compiler and Blender 4.3, in a chroot below build/trixie that is kept
# for the next run. Needs root.
set -eu
cd "$(dirname "$0")/.."
. scripts/debian_root.sh

root=build/trixie/root
house=$root/house
make_root trixie "$root"

# The sources of this checkout, committed or not; the chroot's own build folder stays.
mkdir -p "$house/checkout"
find "$house/checkout" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
tar -c --exclude=./build --exclude=./out --exclude=./.git . | tar -x -C "$house/checkout"
copy_shared "$house"

in_root "$root" /house/checkout/hull package
# shellcheck disable=SC2016 # expanded in the chroot
in_root "$root" sh -c 'cd /house/checkout && blender --command extension validate build/package/*.zip'
# The long random run is this system's; here a part of it.
in_root "$root" env HULL_FOREIGN_STEPS="${HULL_FOREIGN_STEPS:-500}" /house/checkout/hull test blender
