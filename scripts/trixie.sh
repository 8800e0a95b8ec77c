#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Build the add-on's wheel with Debian 13's compiler, in a chroot below build/trixie that is kept for the next run, and
# test the add-on of all wheels in a second one that has Debian's Blender 4.3 and none of our libraries' packages.
# Needs root.
set -eu
cd "$(dirname "$0")/.."
. scripts/debian_root.sh

root=build/trixie/root
plain=build/trixie/plain

# Both begin as the same minimal Debian.
if [ ! -e "$root" ] && [ ! -e "$plain" ]; then
    make_root trixie "$root"
    rm -rf "$plain.part"
    cp -ax "$root" "$plain.part"
    mv "$plain.part" "$plain"
fi
make_root trixie "$root"
copy_checkout "$root"
# Of this system's Python too, where its wheel is made.
mkdir -p "$root/house/checkout/build/wheels"
cp build/wheels/*.whl "$root/house/checkout/build/wheels" 2>/dev/null || true
in_root "$root" /house/checkout/hull wheel

make_root trixie "$plain"
copy_checkout "$plain"
# Debian's Blender but recommends NumPy, which every other Blender brings along.
in_root "$plain" sh -c 'wanted="blender python3-numpy python3-pytest"
    dpkg -s $wanted >/dev/null 2>&1 || {
        apt-get update -q
        DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $wanted
    }'
mkdir -p "$plain/house/checkout/build/package"
cp "$root"/house/checkout/build/package/*-extension.zip "$plain/house/checkout/build/package"
# shellcheck disable=SC2016 # expanded in the chroot
in_root "$plain" sh -c 'cd /house/checkout && blender --command extension validate build/package/*-extension.zip'
# The long random run is the other Blender's, here a part of it; so are long tests of the module's computing, and of tests
# with many cases one in five is tried here. HULL_ALL_IN_BLENDER=1 leaves none out.
if [ "${HULL_ALL_IN_BLENDER:-0}" = 1 ]; then tried='' one_in=1; else tried='not once' one_in=5; fi
# shellcheck disable=SC2016 # expanded in the chroot
in_root "$plain" env HULL_FOREIGN_STEPS="${HULL_FOREIGN_STEPS:-250}" HULL_FOREIGN_SEED="${HULL_FOREIGN_SEED:-20261122}" \
    HULL_ONE_CASE_IN="$one_in" \
    sh -c 'cd /house/checkout && scripts/try_addon.sh build/package/*-extension.zip -m "$1" tests/blender' sh "$tried"
