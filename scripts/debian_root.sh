# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Functions to work in another Debian below build/: made by debootstrap, entered by chroot. To be sourced by a
# POSIX sh in the root of the checkout; needs the rights of root.

# make_root SUITE FOLDER [PACKAGE,...]: a minimal Debian; one that is there already is kept.
make_root() {
    [ ! -e "$2" ] || return 0
    if [ "$(id -u)" != 0 ]; then
        echo "$0: only root can make and enter another Debian" >&2
        return 1
    fi
    if ! command -v debootstrap >/dev/null; then
        apt-get update -q
        DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends debootstrap
    fi
    rm -rf "$2.part"
    mkdir -p "$(dirname "$2")"
    debootstrap --variant=minbase ${3:+--include="$3"} "$1" "$2.part" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"} \
        >"$2.log" 2>&1 || {
        tail -n 20 "$2.log" >&2
        return 1
    }
    mv "$2.part" "$2"
}

# in_root FOLDER COMMAND [ARGUMENT...]: run the command there, with /proc where mounting is permitted. The mount is
# seen by this command alone and ends with it, so that the folder can be removed at any time.
in_root() {
    in_root_folder=$1
    shift
    # shellcheck disable=SC2016 # expanded by the inner shell
    enter='root=$1; shift
        exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb ${http_proxy:+http_proxy="$http_proxy"} \
            chroot "$root" "$@"'
    # shellcheck disable=SC2016
    if unshare --mount true 2>/dev/null; then
        unshare --mount sh -c 'mount -t proc proc "$1/proc" 2>/dev/null || true; '"$enter" sh "$in_root_folder" "$@"
    else
        sh -c "$enter" sh "$in_root_folder" "$@"
    fi
}

# copy_checkout ROOT: the sources of this checkout there in /house, committed or not, with the reference data; the build
# folder that is there stays.
copy_checkout() {
    mkdir -p "$1/house/checkout"
    find "$1/house/checkout" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
    tar -c --exclude=./build --exclude=./out --exclude=./.git . | tar -x -C "$1/house/checkout"
    copy_shared "$1/house"
}

# copy_shared FOLDER: the reference data beside the checkout, which some tests read, to FOLDER/shared.
copy_shared() {
    if [ -d ../shared ]; then
        mkdir -p "$1"
        rm -rf "$1/shared"
        cp -RL ../shared "$1/shared"
    fi
}
