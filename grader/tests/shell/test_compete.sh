#!/usr/bin/env bash
# The contest: who passes is ranked by what his method costs, painters are not, and one seed gives the same bytes.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
if [[ ! -x $BUILD/record_arena ]]; then
    skip "there is no Embree, which traces what is right"
    finish
    exit
fi
arena=$work/arena lab=14-soft-shadows
"$BUILD/record_arena" --lab 14 --seed 5 "$arena" >"$work/log" 2>&1 && ok || bad "the cameras" "$(cat "$work/log")"
competes() { status=0; out=$("$BUILD/compete" --lab 14 --arena "$arena" "$@" 2>"$work/errors") || status=$?; }

grader/tests/helpers/make_contest "$work/class" || bad "the hand-ins"

competes --class "$work/class" --page "$work/one.html" --anonymous "$work/secret.csv"
expect "a class" 1 'errs at most 0.20 %'
name() { python3 -c 'import csv,sys; print({r["student"]: r["pseudonym"] for r in csv.DictReader(open(sys.argv[1]))}[sys.argv[2]])' "$work/secret.csv" "$1"; }
line() { grep -F -- "$(name "$1")" <<<"$out"; }
cost() { line "$1" | sed -nE 's/.* ([0-9.]+) a pixel:.*/\1/p'; }
order=$(for student in dan cyn ann eve bob; do cost $student; done)
[[ $(wc -l <<<"$order") == 5 && $order == "$(sort -g -u <<<"$order")" ]] && ok || bad "in the order of what they read" "$out"
python3 -c 'import sys; ann, eve = map(float, sys.argv[1:]); assert abs(eve - ann - 512 * 512 / (320 * 240)) < 0.1' "$(cost ann)" "$(cost eve)" 2>/dev/null && ok ||
    bad "a second clear costs its texels" "$out"
[[ $(line ivy) == "  1 "*"; ! with our lab.c its shaders cost "[1-9]*": read its own"* ]] && ok || bad "forged counts" "$out"
grep -qF "with our lab.c its shaders cost" "$work/one.html" && ok || bad "forged counts, on the page" "$(cat "$work/one.html")"
[[ $(for student in ann bob cyn dan eve; do line $student; done) != *!* ]] && ok || bad "honest counts are marked" "$out"
[[ $(line gus) == *"not ranked: it does not pass: "* ]] && ok || bad "a fixed kernel does not pass" "$out"
[[ $(line hal) == *"not ranked: its shadows do not come from a map"* ]] && ok || bad "a painter" "$out$(cat "$work/errors")"
grep -qE 'ann|bob' "$work/one.html" && bad "a page of pseudonyms with names" || ok
grep -qF "$(name ann)" "$work/one.html" && ok || bad "the page has a row for each" "$(cat "$work/one.html")"

# Once more, and alone: the same line, the same page.
rm -r "$work"/class/{bob,cyn,dan,eve,gus,hal,ivy}
before=$(line ann | sed 's/^ *[0-9]*//')
for page in two three; do
    competes --class "$work/class" --page "$work/$page.html" --anonymous "$work/secret.csv"
    [[ $status == 0 && $(line ann | sed 's/^ *[0-9]*//') == "$before" ]] && ok || bad "the same once more" "$out, not $before"
done
cmp -s "$work/two.html" "$work/three.html" && ok || bad "two runs give the same page"

# Gradescope's key, and what says why there is none.
valid() { python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(open(sys.argv[1])), json.load(open("grader/report/gradescope.schema.json")))' "$1" 2>&1; }
"$grade" --lab 14 --seed 1 --format gradescope labs/$lab >"$work/bad.json" 2>"$work/log"
cp "$work/bad.json" "$work/good.json"
competes --results "$work/good.json" "$work/class/ann"
out=$(cat "$work/good.json")
[[ $status == 0 && -z $(valid "$work/good.json") && $(field '[e["name"] for e in r["leaderboard"]], r["leaderboard"][0]["order"], str(r["leaderboard"][0]["value"])') == \
    "(['cost a pixel', 'error, %', 'setting'], 'asc', '$(sed -nE 's/.* ([0-9.]+) a pixel.*/\1/p' <<<"$before")')" ]] && ok || bad "the key leaderboard" "$out$(valid "$work/good.json")"
competes --results "$work/bad.json" labs/$lab
out=$(cat "$work/bad.json")
[[ $status == 1 && -z $(valid "$work/bad.json") && $(field '"leaderboard" in r, "Not on the leaderboard: it does not pass" in r["output"]') == "(False, True)" ]] && ok ||
    bad "no key for who does not pass" "$out$(valid "$work/bad.json")"

# What makes no sense is refused.
out=$("$BUILD/record_arena" --lab 03 "$work/none" 2>&1) && bad "a lab without a contest" "$out" || ok
competes --results "$work/nowhere.json" "$work/class/ann"
[[ $status == 3 ]] && ok || bad "no results to add to" "$status $out"
sed -i 's/"14"/"03"/' "$arena/arena.json"
competes "$work/class/ann"
[[ $status == 3 && $(cat "$work/errors") == *"is of lab 03, not of lab 14"* ]] && ok || bad "cameras of another lab" "$(cat "$work/errors")"
status=0 out=$("$BUILD/compete" --lab 14 labs 2>&1) || status=$?
expect "without cameras" 2 "--arena DIR"

finish
