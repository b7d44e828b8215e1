#!/usr/bin/env bash
# The page of a student's own pictures: what stands on it, what cannot be drawn, a progress of any kind; and the report as a page.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
export SHADOW_LAB_PROGRESS=$work/progress.json
made=$work/build
mkdir "$made"
ln -s "$root/$BUILD"/{frame,grade,worker,include,given,jail_probe,jail_shim,jail_unpack} "$made"
[[ -d $root/$BUILD/cache ]] && cp -r "$root/$BUILD/cache" "$made"
labs=$(solved labs 03 04 05)
sed -i 's/? 0.0 : 1.0/? 1.0 : 0.0/' "$labs"/03-*/shadow.frag
echo 'int x = ;' >>"$labs/05-pcf/lab.c"
shows() { status=0; out=$(grader/scripts/showcase "$made" "$labs" 2>&1) || status=$?; page=$(cat "$made/showcase.html" 2>/dev/null); }
has() { local text; for text in "$@"; do grep -qF -- "$text" <<<"$page" && ok || bad "no \"$text\" on the page" "$out"; done; }

shows
expect "nothing begun" 1 "there are no points yet"
cat >"$SHADOW_LAB_PROGRESS" <<'END'
{"version": 1, "labs": {
 "03": {"score": 100, "max_score": 100, "best": 100, "done": true, "done_on": "2026-11-20", "seconds": 9000, "mistakes": ["<b>&\"", 3]},
 "05": {"score": 80.5, "max_score": 100, "best": 90, "done": false, "seconds": "long", "mistakes": 7},
 "07": {"score": 0, "max_score": 100, "best": 0, "done": false}, "09": 5, "x": {"best": 1}}}
END
shows
expect "two labs" 0 "showcase.html: 2 labs"
has "Lab 03: Basic shadow map" "100 of 100 points, done on 2026-11-20, about 2.5 hours" "&lt;b&gt;&amp;&quot;" "80.5 of 100 points" \
    "180.5 points, 1 of 2 labs"
[[ $page != *"Lab 04"* && $page != *"Lab 07"* ]] && ok || bad "a lab that was not begun"
# The picture is the student's own, and what does not draw says why.
python3 - "$made/showcase.html" "$work" <<'PYTHON'
import base64, re, sys
for n, data in enumerate(re.findall(r'src="data:image/png;base64,([^"]*)"', open(sys.argv[1]).read())):
    open(f"{sys.argv[2]}/shown-{n}.png", "wb").write(base64.b64decode(data))
PYTHON
first=$(head -1 solutions/03-*/pictures)
eval "words=(${first#* })"
"$root/$BUILD/frame" --lab 03 --colors quiet --fine 2 "${words[@]}" --size 800x600 --submission "$labs/03-shadow-map" "$work/own.png"
cmp -s "$work/own.png" "$work/shown-0.png" && ok || bad "the student's own picture"
"$root/$BUILD/frame" --lab 03 --colors quiet --fine 2 "${words[@]}" --size 800x600 "$work/ours.png"
cmp -s "$work/ours.png" "$work/shown-0.png" && bad "ours in its place" || ok
has "soft shadows: lab.c does not compile"
# A disk that is full, and Ctrl-C: a line, and the page of before.
whole=$page
ln -s /dev/full "$made/showcase.html.new"
shows
expect "a full disk" 1 "showcase.html cannot be written: No space left on device"
[[ $out != *Traceback* && $page == "$whole" && ! -L $made/showcase.html.new ]] && ok || bad "nothing is lost on a full disk" "$out"
out=$(timeout -s INT 0.4 grader/scripts/showcase "$made" "$labs" 2>&1) && bad "Ctrl-C" "$out"
[[ $out == "stopped; nothing was written" && $(<"$made/showcase.html") == "$whole" ]] && ok || bad "Ctrl-C" "$out"
# The chart of what make study has measured: a lab's own, and nothing where the table is damaged.
[[ $page != *"<svg"* ]] && ok || bad "a chart of nothing"
chart() { # MS ERROR MESSAGE: of the student
    printf '%s\n' scene,title,method,setting,whose,ms,error,message 'a,"Plates <1>",box,"5 x 5, 9",recorded,4,0.002,' "a,\"Plates <1>\",box,\"5 x 5, 9\",yours,$1,$2,${3:-}" >"$made/study-03.csv"
    shows
}
chart 5 0.004 ""
expect "a chart" 0 "2 labs"
has "<svg" "<circle" "Plates &lt;1&gt;, measured on $(date +%F)" "Most accurate: box, 5 x 5, 9, 0.4 % in 5 ms (the solution: 0.2 % in 4 ms)"
[[ $(grep -o '<figure class="chart">' <<<"$page" | wc -l) == 1 ]] && ok || bad "one chart" "$page"
for odd in "x 0.1" "5 x" "0 0.1" "5 0.1 crashed" "nan 0.1" "5 inf"; do
    chart $odd
    [[ $status == 0 && $page != *"<svg"* ]] && ok || bad "no chart of $odd" "$out"
done
rm "$made/study-03.csv"
for text in '{' '[]' '{"labs": 3}'; do
    echo "$text" >"$SHADOW_LAB_PROGRESS"
    shows
    expect "a progress like $text" 1 "there are no points yet"
done
status=0; out=$(grader/scripts/showcase "$made" nowhere 2>&1) || status=$?
expect "no such folder" 2 "nowhere is not a folder"

# The report as a page: of what failed, too; nothing is left of one that could not be made.
report() { status=0; out=$(ARGS="--seed 1 --trusted" DISPLAY= WAYLAND_DISPLAY= grader/scripts/report_page "$made" "$@" 2>&1) || status=$?; }
report 3 "$labs"
expect "a report" 0 "report: $made/report-03.html"
grep -q "</html>" "$made/report-03.html" && grep -q "data-compare" "$made/report-03.html" && ok || bad "the report is whole, with pictures"
report 3 "$work/nowhere"
expect "a report of nothing" 2 "nowhere"
report 77 "$labs"
expect "a report of no lab" 2 'there is no lab "77"'
# A grading that was made is no error of make, whatever its points.
status=0; out=$(make -s BUILD="$BUILD" grade LAB=03 SUBMISSION=labs ARGS="--seed 1 --trusted" 2>&1) || status=$?
expect "make grade of the skeleton" 0 "0.00 of 100 points"
[[ $out != *"***"* ]] && ok || bad "make complains" "$out"
status=0; out=$(make -s BUILD="$BUILD" grade LAB=77 2>&1) || status=$?
expect "make grade of no lab" 2 "77"
[[ -z $(ls "$made" | grep new) ]] && ok || bad "something is left" "$(ls "$made")"
finish
