#!/usr/bin/env bash
# The mutation test, on a few changes: what a check notices, what is equal in effect, what is a hole; and an equal.json
# with a fault is refused. Works in a copy of the project.
set -u
source "$(dirname "$0")/../helpers/lib.sh"

copy=$work/copy
mkdir -p "$copy/build"
cp -r "$root"/{common,shaders,solutions} "$copy"
mkdir -p "$root/$BUILD/cache"
cp -a "$root/$BUILD"/{mutants,worker,include,given,cache} "$copy/build" # with its time: the cache goes by the worker's
cd "$copy" || exit 1
three=solutions/03-shadow-map

mutants() { status=0; out=$(build/mutants "$@" 2>&1) || status=$?; }
# equal JSON: what lab 03 calls equal in effect from now on.
equal() { echo "$1" >$three/equal.json; }
entry() { echo "[{\"why\": \"a test\", \"changes\": [$1]}]"; }

rm -f $three/equal.json
mutants --lab 03 --only "(3.7): 0.0 (place"
expect "no such change" 0 "| 03 | 0 | 0 | 0 | 0 | 0 | 100.0 |"
mutants --lab 03 --only "(3.7): <= ->"
expect "a survivor" 1 "survived: 03 shadow.frag:" "(3.7): <= -> <" "if (position_light_clip.w <= 0.0)" "| 03 | 5 | 5 | 4 | 0 | 1 | 80.0 |"
equal "$(entry '{"file": "shadow.frag", "line": "position_light_clip.w <= 0.0", "from": "<=", "to": ["<"]}')"
mutants --lab 03 --seeds 2 --only "(3.7): <= ->"
expect "a survivor that is equal" 0 "| 03 | 5 | 5 | 4 | 1 | 0 | 100.0 |"
equal "$(entry '{"file": "shadow.frag", "line": "position_light_clip.w <= 0.0", "from": "<="}')"
mutants --lab 03 --only "(3.7): <= ->"
expect "a change that a check notices, called equal" 1 "refused: equal.json calls this equal in effect, but a check notices it: 03 shadow.frag:"
equal "$(entry '{"file": "shadow.frag", "line": "position_light_clip.w < 0.0", "from": "<"}')"
mutants --lab 03 --only "(3.7): <= ->"
expect "an entry without its change" 1 "refused: lab 03: equal.json names a change that there is not: shadow.frag:"
equal "["
mutants --lab 03
expect "an equal.json that is none" 3 "equal.json:2: "
rm $three/equal.json

# Changes of C are compiled anew, crashes and what does not compile are told apart.
mutants --lab 03 --only "(3.4): glClear("
expect "a dropped call" 0 "| 03 | 1 | 1 | 1 | 0 | 0 | 100.0 |"
mutants --lab 03 --only "(3.5): return depth"
expect "no kind of its own" 0 "| 03 | 0 | 0 |"
mutants --lab 03 --only "(3.5): xy -> y"
expect "a swizzle" 0 "| 03 | 2 | 2 | 2 | 0 | 0 | 100.0 |"
mutants --lab 06 --only "(6.2): sqrtf(square.y) ->"
expect "a change of a header" 0 "| 06 | 1 | 1 | 1 | 0 | 0 | 100.0 |"
mutants --lab 01 --only "(1.1): max(facing, 0.0) ->"
expect "a dropped max" 0 "| 01 | 2 | 2 | 2 | 0 | 0 | 100.0 |"
sed -i 's/    if (position_light_clip.w <= 0.0)/    while (position_light_clip.w <= 0.0)/' $three/shadow.frag
mutants --lab 03 --list --only "(3.7)"
expect "a list" 0 "03 shadow.frag:" "(3.7): <= -> <"

mutants --lab 77
expect "no such lab" 2 'there is no lab "77"'
for wrong in "--seeds 0" "-j 0" "--frobnicate" "03"; do
    mutants $wrong
    expect "$wrong" 2 "usage: build/mutants"
done
finish
