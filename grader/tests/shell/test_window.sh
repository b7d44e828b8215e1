#!/usr/bin/env bash
# The window on a display of its own (Xvfb): its pictures are the headless ones bit for bit, keys do what they say, saved
# files show at once, and neither errors nor loops nor crashes of a lab take it down.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
scene="table spot" size=240x180
source "$(dirname "$0")/../helpers/display.sh"

status=0 out=$("$view" 2>&1) || status=$?
expect "no lab" 2 "make run LAB=05" "usage: build/view"
status=0 out=$("$view" --lab 03 --scene nowhere 2>&1) || status=$?
expect "no such scene" 1 'there is no scene "nowhere"'
status=0 out=$(DISPLAY=:$((number + 1000)) "$view" --lab 03 2>&1) || status=$?
expect "no display" 1 "no window can be opened: " "make grade LAB=NN"

# Screenshots, without any scaling between worker and screen.
headless --skeleton
"$view" --lab 3 --scene "$scene" --size $size --screenshot "$work/shot.png" >/dev/null && same "$work/shot.png" "$work/wanted.png" && ok || bad "mine is the skeleton's picture"
fitted --view "shadow map" --knob "map size=128"
"$view" --lab 03 --scene "$scene" --size $size --show reference --view "shadow map" --knob "map size=128" --screenshot "$work/shot.png" >/dev/null &&
    same "$work/shot.png" "$work/wanted.png" && ok || bad "the reference's shadow map"
if [[ -x $root/$BUILD/truth_worker ]]; then
    headless --view visibility --knob "map size=2048"
    "$view" --lab 03 --scene "$scene" --size $size --show truth --screenshot "$work/shot.png" >/dev/null
    wrong=$(compare -metric AE "$work/shot.png" "$work/wanted.png" null: 2>&1)
    [[ $wrong =~ ^[0-9]+$ ]] && ((wrong > 0 && wrong < 240 * 180 / 40)) && ok || bad "the truth is near the visibility of a fine shadow map: $wrong pixels differ"
fi

# Keys.
open_window
headless --skeleton
wait_for "the window shows the skeleton" shows
keys 2
headless
wait_for "2 shows the reference" shows
wait_for "the title says so" titled "reference: picture of \"$scene\", seed 1"
keys Right
headless --knob "map size=1024"
wait_for "right doubles the map" shows
keys BackSpace n
headless --seed 2
wait_for "backspace and n: the default, another variant" shows
keys v v
fitted --seed 2 --view "shadow map"
wait_for "v v: the shadow map" shows
keys shift+v shift+v shift+n 3
headless && cp "$work/wanted.png" "$work/solution.png" && headless --skeleton
without_line() { convert "$1" -fill black -draw "rectangle 116,0 124,179" "$1"; }
convert "$work/wanted.png" \( "$work/solution.png" -crop 120x180+120+0 +repage \) -geometry +120+0 -composite "$work/wanted.png"
without_line "$work/wanted.png"
halves() { picture && without_line "$work/now.png" && same "$work/now.png" "$work/wanted.png"; }
wait_for "3 shows mine and the reference" halves
xdotool windowsize "$window" 300 200
keys 2
size=300x200 headless
wait_for "a resized window" shows
keys a
wait_for "a turns the camera" keeps
keys r
wait_for "r turns it back" shows
keys space
wait_for "space lets the light swing" keeps
close_window

# One line of where to look, which task and why, as the report has it; again when newer files draw.
solved verdict >/dev/null
sed -i 's/^    frame_bind(frame);//' "$work"/verdict/03-*/lab.c
"$view" --lab 03 --submission "$work/verdict" --size 240x180 >"$work/log" 2>&1 &
pid=$!
wait_for "the window tells where to look" told "=> the fault is in \`draw_picture\` (lab.c)"
cp -r "$root"/labs/03-*/. "$work"/verdict/03-*/
wait_for "... and of newer files, which task is next" told "=> task 3.1 is next: it is not done"
close_window

# Saved files.
solved lab >/dev/null
c=$work/lab/03-shadow-map/lab.c shader=$work/lab/03-shadow-map/shadow.frag
cp "$c" "$work/lab.c" && cp "$shader" "$work/shadow.frag"
restore() { cp "$work/lab.c" "$c" && cp "$work/shadow.frag" "$shader"; }
in_map() { sed -i "s|^static void draw_map(const Frame \*frame) {|&\n    $1|" "$c"; }
size=240x180 timeout=${QUICK:+8} timeout=${timeout:-2}
open_window --submission "$work/lab" --timeout "$timeout"
headless
wait_for "the solution as a submission" shows
keys d d && sleep 0.3
sed -i 's/o_color = vec4(ambient + lit/o_color = vec4(2.0 * ambient + lit/' "$shader"
wait_for "a saved shader shows" keeps
restore && keys r
wait_for "and so does the restored one" shows
sed -i 's/float lit = visibility/float lit = visibilty/' "$shader"
wait_for "a shader's error is told with its line" told "shadow.frag:$(grep -n visibilty "$shader" | cut -d: -f1):"
wait_for "and shown over the picture" keeps
restore
wait_for "the error goes when it is fixed" shows
in_map 'int x = "text" +;'
wait_for "an error in C is told with its line" told "lab.c:$(grep -n '"text" +' "$c" | cut -d: -f1):"
keys 2
wait_for "the window lives on" titled "reference"
keys 1 && restore
wait_for "fixed again" shows
in_map '{ extern int puts(const char *); puts("said by the map pass"); }'
wait_for "what a lab prints is seen" told "said by the map pass"
in_map '*(volatile int *)frame->width = 1;'
wait_for "a crash is told with its place" told "it crashed: Segmentation fault (SEGV) in shadow map (lab.c:"
restore
wait_for "after the crash" shows
in_map 'for (;;) {}'
sleep 0.5 && keys 2
wait_for "keys work while a lab loops" titled "reference"
wait_for "a loop is stopped" told "it was stopped after $timeout s"
told "it was stopped after $timeout s in shadow map (lab.c:" && ok || bad "a loop is told with its pass and its line" "$(cat "$work/log")"
keys 1 && restore
wait_for "after the loop" shows
close_window && ok || bad "the window ends with status $?"
[[ -z $(ls "$TMPDIR") ]] && ok || bad "nothing is left behind" "$(ls "$TMPDIR")"

# A copy for students, without solutions.
mkdir -p "$work/kit/$BUILD" "$work/kit/grader"
cp "$root/$BUILD"/{view,worker} "$work/kit/$BUILD"
for part in labs shaders common; do ln -s "$root/$part" "$work/kit/$part"; done
ln -s "$root/grader/window" "$work/kit/grader/window"
ln -s "$root/$BUILD/include" "$work/kit/$BUILD/include"
ln -s "$root/$BUILD/given" "$work/kit/$BUILD/given"
"$root/$BUILD/record_exams" --lab 03 "$work/kit/grader/recorded" 1 >/dev/null
view=$work/kit/$BUILD/view
headless --skeleton
open_window
wait_for "the kit shows the skeleton" shows
keys 2
wait_for "2 shows a reference that is recorded" titled "reference: "
strip=$(ls "$work"/kit/grader/recorded/03-*/exam-1-*.png | tail -1)
recorded() { # the first frame of the strip, enlarged by whole pixels, stands in the middle of the window
    picture || return 1
    python3 - "$work/now.png" "$strip" <<'PYTHON'
import subprocess, sys
def pixels(path):
    width, height = map(int, subprocess.check_output(["identify", "-format", "%w %h", path], text=True).split())
    return width, height, subprocess.check_output(["convert", path, "-depth", "8", "rgb:-"])
w, h, window = pixels(sys.argv[1])
fw, fh, strip = pixels(sys.argv[2])
row = strip[:3 * fw]  # of the first frame, which is the reference
rows = {window[3 * (y * w + x):3 * (y * w + x + fw)] for y in range(h) for x in range(max(w - fw + 1, 0))}
sys.exit(row not in rows)
PYTHON
}
wait_for "bit for bit" recorded
keys a
wait_for "a turned camera has no reference" titled "mine: "
keys 4
wait_for "4 goes back" titled "difference to the reference"
keys n
wait_for "n: the next variant" titled "seed 1"
keys 5
sleep 0.3
titled "difference" && ok || bad "no truth in this kit" "$(xdotool getwindowname "$window")"
close_window
shot() { status=0; out=$("$view" --lab 03 --size $size "$@" --screenshot "$work/new.png" 2>&1) || status=$?; }
colors() { convert "$work/new.png" -format '%[fx:maxima.r-minima.r > 0 && abs(mean.r-mean.b) > 0.002 ? 1 : 0]' info:; }
solved handed >/dev/null && rm "$work"/handed/03-*/*.json
shot --show difference --submission "$work/handed"
expect "the difference of a solution" 0 "saved as"
[[ $(colors) == 0 ]] && ok || bad "a solution equals the recorded reference"
shot --show difference
[[ $status == 0 && $(colors) == 1 ]] && ok || bad "a skeleton does not" "$out"
rm -f "$work/new.png"
shot --show truth
expect "no truth: no picture" 1 "not saved: the truth is not there: no truth here: it needs Embree"
shot --show split --against-truth
expect "nor half of one" 1 "not saved: the truth is not there"
shot --show reference --seed 77
expect "a seed that is not recorded" 1 "no reference is recorded for this scene, view, seed and knobs"
[[ ! -e $work/new.png ]] && ok || bad "a picture was written all the same"
rm "$work"/kit/grader/recorded/03-*/exam-1-*.png
shot --show reference
expect "recorded frames that are gone" 1 "grader/recorded/03-shadow-map/exam-1-" "cannot read the picture"
finish
