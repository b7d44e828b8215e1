#!/usr/bin/env bash
# The autograder for Gradescope, in the places that it expects (but for the root) and in a box of the size that it gives: half
# a processor, 768 MB, 10 minutes. What stands in its zip, and what it writes. TRIAL=1 measures the solution of each lab, and
# of all in one autograder.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

out=$(grader/scripts/make_gradescope "$BUILD" 03 2>&1) && ok || bad "make_gradescope" "$out"
export AUTOGRADER=$work/autograder
mkdir -p "$AUTOGRADER"/{source,submission,results}
python3 -m zipfile -e "$BUILD/shadow-lab-gradescope.zip" "$AUTOGRADER/source"
[[ -f $AUTOGRADER/source/setup.sh && -f $AUTOGRADER/source/run_autograder && ! -e $AUTOGRADER/source/project/grader/tests ]] && ok ||
    bad "the zip's root" "$(ls -R "$AUTOGRADER/source" | head -20)"
list=$(python3 -c 'import sys,zipfile
for i in zipfile.ZipFile(sys.argv[1]).infolist(): print(oct(i.external_attr >> 16), i.filename)' "$BUILD/shadow-lab-gradescope.zip")
[[ $list == *"755 setup.sh"* && $list == *"755 run_autograder"* ]] && ok || bad "the scripts can be run" "$list"
mkdir -p "$AUTOGRADER/source/project/build" # instead of setup.sh, which compiles for a minute
cp -r "$BUILD"/{grade,worker,include,given} "$BUILD"/jail_* "$AUTOGRADER/source/project/build"

memory=768
[[ -n ${QUICK:-} ]] && memory=8000 # a sanitizer's map of the memory counts, too
boxed() { "$root/grader/tests/helpers/box" 0.5 $memory 600 "$@"; }
run() { # sets $out to results.json, and $status
    status=0
    boxed bash "$AUTOGRADER/source/run_autograder" >"$work/log" 2>&1 || status=$?
    out=$(cat "$AUTOGRADER/results/results.json" 2>&1)
}

# The box itself: by what, and that its limits are some.
status=0 out=$(boxed true 2>&1) || status=$?
expect "the box" 0 "box: by "
echo "$out"
for box in "" watcher; do
    export BOX=$box
    status=0 out=$("$root/grader/tests/helpers/box" 0.5 100 60 python3 -c 'import time; held = bytes([1]) * 400000000; time.sleep(30)' 2>&1) || status=$?
    ((status != 0 && status != 124)) && ok || bad "400 MB in 100 (${box:-as it is chosen})" "$status $out"
    status=0 out=$("$root/grader/tests/helpers/box" 0.5 100 1 setsid sleep 1017 2>&1) || status=$?
    expect "a second is over (${box:-as it is chosen})" 124 "of 1 s"
    pgrep -f "^sleep 1017$" >/dev/null && bad "the box leaves somebody" || ok
done
unset BOX

valid() { python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(sys.stdin), json.load(open("grader/report/gradescope.schema.json")))' 2>&1; }
cp solutions/03-shadow-map/{lab.c,shadow.frag,predictions.txt} "$AUTOGRADER/submission"
run
tail -1 "$work/log"
[[ $status == 0 && $(field 'r["score"], all(t["status"] == "passed" for t in r["tests"])') == "(100.0, True)" ]] && ok || bad "files of a solution" "$out$(cat "$work/log")"
[[ -z $(valid <<<"$out") ]] && ok || bad "results.json" "$(valid <<<"$out")"
mkdir "$AUTOGRADER/submission/03-shadow-map" && cp labs/03-shadow-map/{lab.c,shadow.frag} "$AUTOGRADER/submission/03-shadow-map"
rm "$AUTOGRADER"/submission/*.*
run
[[ $status == 0 && $(field 'r["score"], len(r["tests"])') == "(0.0, 12)" ]] && ok || bad "a folder with the skeleton" "$out$(cat "$work/log")"
[[ -z $(valid <<<"$out") && $(field '"is not done" in r["tests"][0]["output"]') == True ]] && ok || bad "causes" "$out"
[[ $(field 'all(t["output_format"] == "html" for t in r["tests"]), any("<img" in t["output"] and "src=\"data:image/png;base64,iVBOR" in t["output"] for t in r["tests"]), len(json.dumps(r)) < 2000000') == "(True, True, True)" ]] && ok || bad "pictures" "${out:0:2000}"
[[ -z $(valid <<<'{"score": "all", "tests": []}') ]] && bad "the schema takes a score that is no number" || ok
[[ $memory != 768 ]] || BOX=watcher run
[[ $status == 0 && $(field 'r["score"]') == 0.0 ]] && ok || bad "in a box without privileges" "$out$(cat "$work/log")"
if [[ -n ${TRIAL:-} ]]; then
    cp "$BUILD/worker_address" "$AUTOGRADER/source/project/build"
    for lab in $(ls solutions | cut -c1-2) ""; do
        sed -i "s/^LAB=.*/LAB=$lab/" "$AUTOGRADER/source/run_autograder"
        for kind in solutions labs; do
            rm -rf "$AUTOGRADER"/submission/* && cp -r $kind/"$lab"* "$AUTOGRADER/submission"
            run
            printf '%-4s %-9s %-20s %s\n' "${lab:-all}" $kind "$(field 'str(r["score"])' 2>/dev/null || echo "status $status")" "$(grep '^box: ' "$work/log")"
        done
    done
fi
rm "$AUTOGRADER/source/project/build/worker"
run
[[ $status == 3 && ! -e $AUTOGRADER/results/results.json ]] && ok || bad "a fault of ours is not 0 points" "$out"

finish
