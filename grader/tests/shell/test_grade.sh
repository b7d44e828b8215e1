#!/usr/bin/env bash
# The command line, the JSON, the evidence, and the two contexts.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

# Solutions and skeletons.
grades --seed 1 --format json solutions
[[ $status == 0 && $(field 'r["score"] == r["max_score"] > 0') == True ]] && ok || bad "solutions get full marks" "$out"
solution_json=$out
grades --seed 1 --format json labs
[[ $status == 1 && $(field 'max(c["score"] for l in r["labs"] for c in l["checks"])') == 0.0 ]] && ok || bad "skeletons get nothing" "$out"
[[ $(field 'all(c["cause"] for l in r["labs"] for c in l["checks"])') == True ]] && ok || bad "each failed check has a cause" "$out"

# The schema takes what the grader prints, and refuses something wrong.
valid() { python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(sys.stdin), json.load(open("grader/report/report.schema.json")))' 2>/dev/null; }
valid <<<"$out" && valid <<<"$solution_json" && ok || bad "the JSON fits grader/report/report.schema.json" "$out"
sed 's/"version": 1/"version": 2/' <<<"$out" | valid && bad "the schema takes a wrong version" || ok
sed 's/"status": "failed"/"status": "sad"/' <<<"$out" | valid && bad "the schema takes a wrong status" || ok

# One seed, the same bytes (but for times); another seed, other frames.
times() { grep -vE '"(seconds|speed_ratio)"'; }
first=$(times <<<"$out")
grades --seed 1 --format json labs
[[ $(times <<<"$out") == "$first" ]] && ok || bad "the same seed gives the same JSON"
half=$(solved half 03)
sed -i 's/lit \* diffuse_specular/(0.5 + 0.5 * lit) * diffuse_specular/' "$half/03-shadow-map/shadow.frag"
grades --lab 03 --seed 7 --format json "$half"
one=$(times <<<"$out")
grades --lab 03 --seed 7 --format json "$half"
[[ $(times <<<"$out") == "$one" && $status == 1 ]] && ok || bad "the same seed gives the same JSON for a half right lab"
grades --lab 03 --seed 8 --format json "$half"
[[ $(times <<<"$out") != "$one" ]] && ok || bad "another seed gives other variants"
grades --lab 03 --format json "$half"
[[ $(field 'len(r["seed"]) > 9') == True ]] && ok || bad "without --seed one is drawn and said" "$out"

# One lab's folder; text.
grades --seed 1 solutions/03-shadow-map
expect "one lab's folder" 0 "Lab 03: Basic shadow map" "ok     6.00/6   3.2  light matrix: spot light" "100.00 of 100 points, passed"
grades --lab 03 --seed 1 labs
expect "hints in the text" 1 "task 3.1 is not done" "It is task 2.4 of the last lab again" "[..............................] 0.00 of 100 points, failed"
[[ $out != *$'\033'* ]] && ok || bad "no colour codes in a pipe"

# A lab solved half-way, and one without its optional tasks.
"$BUILD/skeletons" "$work/upto" 3.5 >/dev/null
grades --lab 03 --seed 1 "$work/upto"
expect "half solved" 1 "ok    11.00/11  3.5  comparison: spot light" "FAIL   0.00/8   3.6  lit outside the map" "points, failed"
"$BUILD/skeletons" "$work/optional" 8.7 >/dev/null
grades --lab 08 --seed 1 "$work/optional"
expect "without the optional tasks and the predictions" 0 "(optional)" "predictions 0/5" "82.00 of 100 points, passed"
sed -i 's/    return false;/    return true;/' "$work"/optional/08-*/ssao.frag
grades --lab 08 --seed 1 "$work/optional"
expect "an optional task done wrong" 1 "82.00 of 100 points, failed"

# Evidence.
grades --lab 03 --seed 1 --output "$work/evidence" "$half"
[[ $(ls "$work"/evidence/03/*-{yours,reference,difference}.png | wc -l) -ge 3 ]] && ok || bad "--output writes pictures" "$(ls -R "$work/evidence")"
grades --lab 03 --seed 1 --output "$work/none" solutions
[[ ! -e $work/none ]] && ok || bad "--output writes nothing when nothing failed"

# Usage.
usage() { local name=$1 text=$2; shift 2; grades "$@"; expect "$name" 2 "$text" "usage: build/grade"; }
usage "no submission" "give one SUBMISSION"
usage "two submissions" '"solutions" is one operand too many' labs solutions
usage "unknown option" "unknown option" --frobnicate labs
usage "no such folder" "no-such-folder is not a folder" no-such-folder
usage "bad seed" "--seed takes a whole number" --seed -1 labs
usage "large seed" "--seed takes a whole number" --seed 99999999999999999999999 labs
usage "bad context" 'there is no context "glx"' --context glx labs
usage "bad format" "--format takes text, json, html" --format xml labs
usage "bad timeout" "--timeout takes seconds" --timeout 0 labs
grades --help
expect "help" 0 "exit status: 0 all passed"

# Contexts: the same bits, each without the other's library.
for view in picture visibility "shadow map"; do
    for context in osmesa egl; do
        "$BUILD/frame" --lab 03 --scene "table spot" --view "$view" --context $context "$work/$context.png" || bad "frame with $context"
    done
    cmp -s "$work/osmesa.png" "$work/egl.png" && ok || bad "osmesa and egl differ in $view"
done
grades --lab 03 --seed 1 --context egl --format json solutions
[[ $status == 0 && $(field 'r["context"], r["score"]') == "('egl', 100.0)" ]] && ok || bad "grading through EGL" "$out"
loaded() { LIBGL_ALWAYS_SOFTWARE=1 LD_DEBUG=files "$BUILD/worker" "$1" - shaders </dev/null 2>&1 | grep -c "calling init:.*$2"; }
[[ $(loaded osmesa libOSMesa) -gt 0 && $(loaded osmesa libEGL) == 0 ]] && ok || bad "osmesa needs no EGL"
[[ $(loaded egl libEGL) -gt 0 && $(loaded egl libOSMesa) == 0 ]] && ok || bad "egl needs no OSMesa"
SHADOW_LAB_CONTEXT=egl grades --lab 03 --seed 1 --format json labs
[[ $(field 'r["context"]') == egl ]] && ok || bad "SHADOW_LAB_CONTEXT chooses the context"

# On a machine without OSMesa each program that draws takes EGL by itself, and says so.
osmesa=$(ldconfig -p 2>/dev/null | awk '/libOSMesa.so.8/ { print $NF; exit }')
osmesa=${osmesa:-$(/sbin/ldconfig -p | awk '/libOSMesa.so.8/ { print $NF; exit }')}
python3 -c 'import sys; open(sys.argv[1], "wb").write(open("/etc/ld.so.cache", "rb").read().replace(b"libOSMesa", b"libXSMesa"))' "$work/ld.so.cache"
without=(bwrap --dev-bind / / --ro-bind "$work/ld.so.cache" /etc/ld.so.cache ${osmesa:+--ro-bind /dev/null "$(realpath "$osmesa")"})
if ! "${without[@]}" true 2>/dev/null; then
    skip "no machine without OSMesa can be made up here"
else
    draws() { # NAME COMMAND...
        local name=$1
        status=0 out=$("${without[@]}" "$root/$BUILD/$1" "${@:2}" 2>&1) || status=$?
        expect "$name without OSMesa" 0 "$name: there is no OSMesa here: EGL draws"
    }
    draws frame --lab 03 --scene "table spot" "$work/first.png"
    draws record_exams --lab 03 "$work/recorded" 1
    draws sweep --lab 03 --scene edges --over "map size" --size 64x48 "$work/swept" 64
    draws mutants --lab 03 --only "nothing has this name"
    draws scene_table --lab 03
    cmp -s "$work/first.png" <("$BUILD/frame" --lab 03 --scene "table spot" /dev/stdout) && ok || bad "another picture without OSMesa"
    status=0 out=$("${without[@]}" env SHADOW_LAB_CONTEXT=osmesa "$root/$BUILD/record_exams" --lab 03 "$work/recorded" 1 2>&1) || status=$?
    expect "who asks for OSMesa gets no other" 3 "OSMesa is not installed"
    status=0 out=$("${without[@]}" "$grade" --compare "$work" "$work" 2>&1) || status=$?
    [[ $out != *"EGL draws"* ]] && ok || bad "who draws nothing says nothing of contexts" "$out"
fi

finish
