#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Try the first minutes of a new user: a bare Debian 12 in a chroot below build/bookworm, with git and a clone of the
# last commit, and there ./hull demo, ./hull test, and both again. Needs root. The Debian is made anew each time.
set -eu
cd "$(dirname "$0")/.."
. scripts/debian_root.sh

root=build/bookworm/root
house=$root/house
rm -rf "$root"
make_root bookworm "$root" git
git clone -q --no-hardlinks . "$house/checkout"
copy_shared "$house"

report=
timed() {
    started=$(date +%s)
    in_root "$root" /house/checkout/hull "$1"
    report="$report$(printf '%6d s  ./hull %s' $(($(date +%s) - started)) "$1")
"
}
for command in demo test demo test; do timed "$command"; done
printf '\nIn a bare Debian 12:\n%s' "$report"
