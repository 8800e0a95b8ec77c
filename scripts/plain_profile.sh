# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Blender's user folders below build/plain-profile, for what tries a zip of the add-on on another system. To be sourced
# by a POSIX sh in the root of the checkout.

profile=$PWD/build/plain-profile
mkdir -p "$profile" build/tmp
export BLENDER_USER_RESOURCES="$profile" TMPDIR="$PWD/build/tmp" PYTHONDONTWRITEBYTECODE=1 LC_ALL=C.UTF-8
for part in config scripts datafiles extensions; do
    name=BLENDER_USER_$(echo $part | tr '[:lower:]' '[:upper:]')
    export "$name=$profile/$part"
done
