#!/usr/bin/env bash
# The study from outside, on tiny pictures: the table, the pictures, going on after a kill, a wrong submission, bad usage.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
chart=$root/$BUILD/chart
studies() { status=0; out=$("$chart" --size 64x48 --frames 2 "$@" 2>&1) || status=$?; }

# table FILE EXPRESSION: python's value of the expression over the rows of a chart.csv.
table() { python3 -c 'import csv,sys; rows=list(csv.DictReader(open(sys.argv[1]))); print(eval(sys.argv[2]))' "$1" "$2"; }

studies --scene volumes --output "$work/one"
expect "a study of one scene" 0 "volumes: " "chart.html"
csv=$work/one/chart.csv
count=$(table "$csv" 'len(rows)') # of the settings that the labs bring to this scene
[[ $count -gt 10 && $(table "$csv" '{len(r) for r in rows}, None in rows[0]') == "({39}, False)" ]] && ok ||
    bad "chart.csv has rows of 39 named fields" "$(table "$csv" 'len(rows), {len(r) for r in rows}')"
[[ $(table "$csv" 'all(float(r[k]) >= 0 for r in rows for k in list(r)[5:37])') == True ]] && ok || bad "chart.csv holds numbers"
[[ $(table "$csv" 'all(abs(float(r["false_shadow"]) + float(r["false_light"]) - float(r["error"])) < 1e-6 for r in rows)') == True ]] &&
    ok || bad "false shadow and false light add up"
[[ $(table "$csv" '{r["frames"] for r in rows if r["lab"] != "rays"}, sum(r["chosen"] == "1" for r in rows)') == "({'2'}, 1)" ]] && ok ||
    bad "two frames of each setting, one is chosen"
[[ $(table "$csv" 'all(float(r["fragments"]) > 0 for r in rows if "volumes" in r["method"])') == True ]] && ok || bad "volumes have fragments"
# Ray tracing with more rays errs less; nothing errs less than the truth's own noise; FLIP and RMSE are there.
rays='[float(r["error"]) for r in rows if r["lab"] == "rays"]'
[[ $(table "$csv" "len($rays) == 5 and sorted($rays, reverse=True) == $rays and $rays[-1] > 0") == True ]] && ok ||
    bad "more rays err less" "$(table "$csv" "$rays")"
[[ $(table "$csv" 'all(float(r["error_low"]) <= float(r["error"]) <= float(r["error_high"]) and float(r["rmse"]) >= float(r["error"]) and
    0 < float(r["flip"]) < 1 for r in rows)') == True ]] && ok || bad "the views enclose the mean; RMSE is no less than the mean; FLIP is a share"
[[ $(table "$csv" 'all(r["on_front"] == r["chosen"] == "0" for r in rows if r["lab"] == "rays")') == True ]] && ok || bad "rays stand aside"
python3 -c 'import sys, xml.dom.minidom as x; x.parse(sys.argv[1])' "$work/one/volumes.svg" && ok || bad "the SVG is XML"
(($(wc -c <"$work/one/volumes.svg") < 100000)) && ok || bad "the SVG fits into a README"
grep -qE '(src|href)="?https?:' "$work/one/chart.html" && bad "the page needs no network" || ok
[[ $(grep -oF '"frame":"data:image/png;base64,' "$work/one/chart.html" | wc -l) == "$count" ]] && ok || bad "the page holds each setting's frame"
[[ $(grep -c '^errors' "$work/one/state") == $((6 * count)) && $(grep -c '^time' "$work/one/state") == $((2 * (count - 5) + 5 * 6)) ]] && ok || bad "the state has each measurement once"

[[ $(table "$work/one/views.csv" '{sum(r[k] == row[k] for r in rows for k in ["setting"] if r["method"] == row["method"] and r["lab"] == row["lab"]) for row in rows}') == "{6}" ]] &&
    ok || bad "views.csv has each setting six times"

browses chart.mjs "$work/one/chart.html"

# Killed at any time, it goes on: nothing that is on disk is measured again.
"$chart" --size 64x48 --frames 4 --scene edges --output "$work/two" >/dev/null 2>&1 &
pid=$!
for _ in $(seq 400); do
    lines=$(grep -c '^time' "$work/two/state" 2>/dev/null)
    ((${lines:-0} > 20)) && break
    sleep 0.05
done
kill -9 $pid
wait $pid 2>/dev/null
cp "$work/two/state" "$work/before"
[[ ! -e $work/two/chart.csv ]] && ok || bad "a study that was killed leaves no table"
status=0 out=$("$chart" --size 64x48 --frames 4 --scene edges --output "$work/two" 2>&1) || status=$?
expect "goes on after kill -9" 0 "edges: "
cmp -s -n "$(wc -c <"$work/before")" "$work/before" "$work/two/state" && ok || bad "the state only grows"
[[ $(grep -c '^time' "$work/two/state") == $((4 * ($(table "$work/two/chart.csv" 'len(rows)') - 5) + 5 * 6)) ]] && ok ||
    bad "each setting has 4 frames in all"
[[ $(table "$work/two/chart.csv" '{r["frames"] for r in rows if r["lab"] != "rays"}') == "{'4'}" ]] && ok || bad "the table counts them"

# A worker that ends takes the study with it, with one message; so does one of another build, whose records have other sizes.
"$chart" --size 64x48 --frames 40 --scene edges --output "$work/lost" >/dev/null 2>"$work/said" &
pid=$!
for _ in $(seq 400); do
    [[ -s $work/lost/state ]] && break
    sleep 0.05
done
pgrep -P $pid -x worker | xargs kill -9 # one may just be beginning
status=0
wait $pid || status=$?
out=$(grep '^chart: ' "$work/said")
expect "a worker that was killed" 3 "could not draw: " "Killed"
[[ $(wc -l <<<"$out") == 1 ]] && ok || bad "one message" "$out"
mkdir -p "$work/other/build"
ln -s "$root"/{solutions,shaders,common,grader} "$work/other"
ln -s "$root/$BUILD"/* "$work/other/build"
cp --remove-destination "$chart" "$work/other/build"
rm "$work/other/build/worker"
printf '#!/bin/sh\nprintf OLD! >&3\nexec sleep 60\n' >"$work/other/build/worker"
chmod +x "$work/other/build/worker"
status=0 out=$("$work/other/build/chart" --size 64x48 --frames 1 --scene edges --output "$work/lost" 2>&1) || status=$?
expect "a worker of another build" 3 "the worker is of another build than this program: run make"
rm "$work/other/build/worker"
status=0 out=$("$work/other/build/chart" --size 64x48 --frames 1 --scene edges --output "$work/lost" 2>&1) || status=$?
expect "no worker" 3 "chart: "

# The tables of the README are made from those of a study; one that lacks a filter makes none.
mkdir -p "$work/copy/grader/study"
cp -r "$root/grader/scripts" "$work/copy/grader"
cp "$root/grader/study/README.md" "$work/copy/grader/study"
cp "$root/README.md" "$work/copy"
findings() { status=0; out=$("$work/copy/grader/scripts/findings" "$@" 2>&1) || status=$?; }
findings "$work/two" "$root/grader/study/README.md"
expect "the tables of a study" 0
best=$(table "$work/two/chart.csv" 'min((float(r["rmse"]), r["method"]) for r in rows if r["scene"] == "edges" and r["lab"] == "05" and
    r["setting"] == "4096 x 4096" and r["method"] in ("hard", "linear", "box 5 x 5", "3 x 3 by gathers"))[1].replace(" 5 x 5", "").replace("3 x 3 by ", "")')
grep -q "^| the root of the mean square |.* | $best |$" "$work/copy/grader/study/README.md" && ok || bad "the table names the filter with the least RMSE" "$best"
grep -q '^| edges | [0-9.]* | [0-9.]* % of 0.01 | [0-9.]* | [0-9.]* % of 0.5 |$' "$work/copy/grader/study/README.md" && ok || bad "the table has the truth's noise"
grep -q '^1 scenes in both' "$work/copy/grader/study/README.md" && ok || bad "the table compares two studies"
cp -r "$root/solutions" "$work/copy"
cp "$root/grader/study/README.md" "$work/copy/grader/study"
cp "$root/README.md" "$work/copy"
findings "$work/one" "$root/grader/study/README.md"
expect "the tables of a study of one scene" 0
others() { grep -vE '^[|-] [*]?(volumes|The eye in a shadow)|scenes in both' "$1"; }
for page in grader/study/README.md README.md; do
    cmp -s <(others "$root/$page") <(others "$work/copy/$page") && ok || bad "what $page tells of other scenes stays"
done
sed -i '/"linear"/d' "$work/two/chart.csv"
findings "$work/two"
expect "a study that lacks a filter" 1 "the scene edges lacks filters"
findings "$work/nowhere"
expect "no study" 2 "chart.csv is missing"
findings "$work/one" "$work/nowhere"
expect "no earlier study" 2 "nowhere is missing"

# Faster ways to the same picture: a box from fewer lookups, a map that is kept, one of casters alone.
studies --scene "faster edges" --lab 05 --submission "$(solved fast 05)" --trusted --output "$work/faster"
expect "filters that are faster" 0 "faster edges: "
same='len({r["error"] for r in rows if r["method"] in (%s) and r["setting"] == "256 x 256"})'
for kind in '"linear", "linear, the map is kept", "linear, a map of casters"'; do
    [[ $(table "$work/faster/chart.csv" "${same/\%s/$kind}") == 1 ]] && ok || bad "$kind draw the same"
done
theirs='{r["method"] for r in rows if r["whose"] == "submission"}'
[[ $(table "$work/faster/chart.csv" "'box 5 x 5, 9 gathers' in $theirs and 'linear, the map is kept' not in $theirs") == True ]] && ok ||
    bad "a submission is charted with changes of its shaders only" "$(table "$work/faster/chart.csv" "$theirs")"
near='(lambda e: max(e) - min(e) < 2e-4 < max(e))([float(r["error"]) for r in rows if r["method"].startswith("box") and r["setting"] == "1024 x 1024"])'
[[ $(table "$work/faster/chart.csv" "$near") == True ]] && ok || bad "all boxes of 5 x 5 err alike"

# Costs are counted: exact differences between settings, whatever the scene. A kept map costs nothing.
count_of() { table "$1" "next(int(r['counted']) for r in rows if r['method'] == '$2' and r['setting'] == '$3')"; }
csv=$work/faster/chart.csv
(($(count_of "$csv" "box 5 x 5" "256 x 256") - $(count_of "$csv" linear "256 x 256") ==
    3 * ($(count_of "$csv" "box 5 x 5, 9 gathers" "256 x 256") - $(count_of "$csv" linear "256 x 256")))) && ok ||
    bad "a box of 25 reads costs 24 more than one read, 9 gathers 8"
(($(count_of "$csv" "linear, the map is kept" "4096 x 4096") == $(count_of "$csv" "linear, the map is kept" "256 x 256"))) && ok ||
    bad "a map that is kept costs the same, whatever its size"
studies --frames 1 --scene "wide lamp" --output "$work/wide"
expect "a wide lamp" 0 "wide lamp: "
csv=$work/wide/chart.csv
lamps='[(int(r["setting"][0]) ** 2, float(r["texels"]), float(r["bytes"])) for r in rows if r["lab"] == "11"]'
[[ $(table "$csv" "len($lamps) > 5 and all(t == n * 256 ** 2 and b == 4 * t for n, t, b in $lamps)") == True ]] && ok ||
    bad "n x n lamps clear and keep n x n maps" "$(table "$csv" "$lamps")"
(($(count_of "$csv" "variance map" "blur of 9, 512 x 512") - $(count_of "$csv" "variance map" "blur of 5, 512 x 512") == 2 * 512 * 512 * (9 - 5))) && ok ||
    bad "a blur reads 2 x (2 r + 1) times a texel"
soft='[(float(r["taps"]), sum(map(int, r["setting"].split(" taps")[0].split(" + ")))) for r in rows if r["lab"] == "14"]'
[[ $(table "$csv" "len($soft) > 5 and all(0.2 * n < t < 1.13 * n for t, n in $soft) and max(t / n for t, n in $soft) > 1.5 * min(t / n for t, n in $soft)") == True ]] &&
    ok || bad "a lit pixel ends after the search" "$(table "$csv" "$soft")"
[[ -s $work/wide/wide\ lamp-cost.svg ]] && ok || bad "error is charted against cost, too" "$(ls "$work/wide")"
csv=$work/one/chart.csv

studies --scene "faster sky" --output "$work/sky"
expect "occlusion that is faster" 0 "faster sky: "
bakes='[{r["error"] for r in rows if r["method"].startswith("baked") and r["setting"] == s} for s in {r["setting"] for r in rows if "spheres" in r["method"]}]'
[[ $(table "$work/sky/chart.csv" "len($bakes) > 1 and {len(e) for e in $bakes} == {1}") == True ]] && ok || bad "all bakes are the same"
screens='{r["method"]: float(r["error"]) for r in rows if r["method"].startswith("screen space")}'
[[ $(table "$work/sky/chart.csv" "len($screens) == 3 and max($screens.values()) < 1.2 * min($screens.values())") == True ]] && ok ||
    bad "half the size and two factors err alike" "$(table "$work/sky/chart.csv" "$screens")"

# A submission without bias lies far off; the solution as a submission lies on our points.
submission=$(solved wrong 05)
sed -i 's/glPolygonOffset(2 \* reach, 2)/glPolygonOffset(0, 0)/' "$submission"/05-*/lab.c
studies --scene volumes --lab 05 --submission "$submission" --output "$work/one"
expect "a submission on the chart" 0 "volumes: "
worst='[float(r["interior_false_shadow"]) for r in rows if r["whose"] == "%s" and r["method"] == "linear" and "4096" not in r["setting"]]'
[[ $(table "$csv" "min(${worst/\%s/submission}) > 0.05 > 50 * max(${worst/\%s/ours})") == True ]] && ok ||
    bad "no bias: acne" "$(table "$csv" "${worst/\%s/submission}, ${worst/\%s/ours}")"
[[ $(grep -c '^time' "$work/one/state") == $((2 * (count - 5) + 5 * 6 + 20)) ]] && ok || bad "ours are not measured again"
right=$(solved right 05)
studies --scene volumes --lab 05 --submission "$right/05-pcf" --output "$work/one"
errors='[r["error"] for r in rows if r["whose"] == "%s" and r["lab"] == "05"]'
[[ $(table "$csv" "${errors/\%s/submission} == ${errors/\%s/ours}") == True ]] && ok || bad "a right submission errs as we do"

costs='[[r[k] for k in ("taps", "texels", "fragments", "rays", "bytes", "counted")] for r in rows if r["whose"] == "%s" and r["lab"] == "05"]'
[[ $(table "$csv" "${costs/\%s/submission} == ${costs/\%s/ours} and len(${costs/\%s/ours}) > 5") == True ]] && ok ||
    bad "a right submission costs as much as we do"
[[ $(table "$csv" 'all(float(r["bytes"]) == 4 * float(r["texels"]) == 4 * int(r["setting"].split()[0]) ** 2 for r in rows if r["lab"] == "05")') == True ]] &&
    ok || bad "a map is cleared once, and takes four bytes a texel"
[[ $(table "$csv" 'sorted({float(r["bytes"]) for r in rows if r["lab"] == "07"})') == "[$((64 * 48 * 12)).0]" ]] && ok ||
    bad "volumes take two colours, depth and stencil a pixel"
bare='[r for r in rows if r["method"] == "no shadow"]'
[[ $(table "$csv" "len($bare) == 1 and {$bare[0][k] for k in ('on_front', 'chosen', 'enough', 'bytes')} == {'0'}") == True ]] && ok ||
    bad "the frame without shadows stands aside"
grep -q 'stroke-dasharray="1 3"' "$work/one/volumes.svg" && ok || bad "the chart has a line for it"

# A submission that does not compile is said to be so, and ours are charted.
echo "int" >"$right/05-pcf/lab.c"
studies --scene volumes --lab 05 --submission "$right" --output "$work/one"
expect "a submission that does not compile" 0 "not drawn: the submission does not compile: " "lab.c:" "error: "

# Ours and a submission are measured under one condition: neither worker is told to compile shaders in haste.
right=$(solved same 05)
"$chart" --size 64x48 --frames 40 --scene edges --lab 05 --submission "$right" --trusted --output "$work/same" >/dev/null 2>&1 &
pid=$!
for _ in $(seq 600); do
    mapfile -t workers < <(pgrep -P $pid -x worker)
    ((${#workers[@]} > 2)) && break
    sleep 0.05
done
for worker in "${workers[@]}"; do
    tr '\0' '\n' <"/proc/$worker/environ" | grep -v '^MESA_SHADER_CACHE' | sort
    echo --
done >"$work/environments"
kill -9 $pid
wait $pid 2>/dev/null
kinds=$(python3 -c 'import sys; print(len(set(filter(None, sys.stdin.read().split("--\n")))))' <"$work/environments")
[[ ${#workers[@]} -gt 2 && $kinds == 1 ]] && ok || bad "all workers of a study have one environment" "$(cat "$work/environments")"
grep -q GALLIVM_PERF "$work/environments" && bad "shaders that are measured are compiled in haste" || ok

# By EGL: times of its renderer, which is named with the way to it; a jail has no GPU.
studies --scene edges --context egl --output "$work/egl"
expect "a study by EGL" 0 "edges: "
grep -q '"renderer":"[^"]*(EGL [a-z]*[^"]*)","clock":"GPU"' "$work/egl/chart.html" && ok || bad "the page names the renderer and the clock"
[[ $(table "$work/egl/chart.csv" 'all(float(r["ms"]) > 0 for r in rows)') == True ]] && ok || bad "EGL's timers tell times"
export SHADOW_LAB_EGL_DEVICE=0
studies --scene edges --context egl --output "$work/device"
grep -q '(EGL device 0)' "$work/device/chart.html" && ok || bad "a device of EGL is chosen" "$out"
drawn='[(r["method"], r["setting"], r["error"], r["edge_off_pixels"], r["rmse"]) for r in rows]'
[[ $(table "$work/egl/chart.csv" "$drawn") == "$(table "$work/device/chart.csv" "$drawn")" ]] && ok || bad "both ways draw the same"
export SHADOW_LAB_EGL_DEVICE=70
studies --scene edges --context egl --output "$work/device"
expect "a device that is not there" 3 'SHADOW_LAB_EGL_DEVICE is "70"; EGL lists '
unset SHADOW_LAB_EGL_DEVICE
studies --scene edges --lab 05 --context egl --submission "$right" --output "$work/egl"
expect "a submission by EGL" 2 "--trusted only"

# A truth on disk that is not what was written is traced again.
for truth in "$work/one/truth"/*; do head -c "$(stat -c %s "$truth")" /dev/zero >"$truth"; done
cp "$work/one/views.csv" "$work/views"
rm "$work/one/state"
studies --scene volumes --output "$work/one"
cmp -s <(grep -v '^rays\|submission' "$work/views") <(grep -v submission "$work/one/views.csv") && ok || bad "a truth of other bytes is not believed"
studies --scene edges --without 15 --output "$work/one"
expect "an object that no scene has" 1 "none of these scenes has an object 15"

mkdir "$work/empty"
studies --scene edges --lab 05 --submission "$work/empty" --output "$work/one"
expect "a submission without the lab" 1 "there is no lab 05 in $work/empty"

studies --scene nowhere
expect "unknown scene" 2 'there is no scene "nowhere"' "penumbra"
studies --submission labs
expect "a submission without its lab" 2 "--lab"
studies --lab 01 --output "$work/three"
expect "a lab without settings" 1 "no scene of the study has settings of lab 01"
status=0 out=$("$chart" --compare "$csv" "$csv" 2>&1) || status=$?
expect "compare a table with itself" 0 "0 swapped"
status=0 out=$("$chart" --compare "$csv" "$work/nothing.csv" 2>&1) || status=$?
expect "compare with a file that is not there" 2 "nothing.csv"
status=0 out=$("$chart" --frames 0 2>&1) || status=$?
expect "no frames" 2 "a number from 1"
finish
