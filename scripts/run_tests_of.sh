#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run a program of native tests and tell what it said where it failed, and how long it took.
# usage: run_tests_of.sh PROGRAM
log=$1.log
begun=$(date +%s)
timeout 1500 "$1" --gtest_brief=1 >"$log" 2>&1
status=$?
[ $status = 0 ] || cat "$log"
echo "${1##*/}: $(grep PASSED "$log" | tail -n 1), $(($(date +%s) - begun)) s"
exit $status
