#!/usr/bin/env bash
# The pages of a class in a browser (Chromium, node): no error, no request, no violation of accessibility; keyboard and mouse.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
mkdir -p "$work/class/"{right,"half <img src=x onerror=alert(1)>\"'&",untouched,nothing}
cp -r solutions/03-shadow-map "$work/class/right"
cp -r solutions/03-shadow-map "$work/class/half <img src=x onerror=alert(1)>\"'&"
sed -i 's/lit \* diffuse_specular/(0.5 + 0.5 * lit) * diffuse_specular/' "$work"/class/half*/03-shadow-map/shadow.frag
cp -r labs/03-shadow-map "$work/class/untouched"
grades --class "$work/class" --output "$work/out" --lab 03 --seed 5
expect "a class" 0 "4 submissions, 0 not graded"
browses class.mjs "$work/out"

finish
