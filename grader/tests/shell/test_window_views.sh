#!/usr/bin/env bash
# What the window shows of a lab, each view held against something else: stages and their captions, counts, haze, texels, the
# frustum, odd sizes, labs that do not draw, and two windows at once.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
scene="table spot" size=240x180
source "$(dirname "$0")/../helpers/display.sh"
shot() { status=0; out=$("$view" --lab "$lab" --size "$size" "$@" --screenshot "$work/shot.png" 2>&1) || status=$?; }
size_of() { identify -format '%wx%h' "$1"; }

# Each stage of each lab has a caption, and no caption is of a stage that is not there.
out=$(python3 - "$root" <<'PYTHON'
import glob, json, os, re, sys
root = sys.argv[1]
keys = open(f"{root}/grader/window/keys.c").read()
common = re.search(r"#define FRAME_VIEW_STAGES.*?\n\n", open(f"{root}/common/frame_view.h").read(), re.S)[0]
for folder in sorted(glob.glob(f"{root}/solutions/[0-9][0-9]-*")):
    source = open(f"{folder}/lab.c").read()
    block = re.search(r"\.stages = (.*?)\n    \.create", source, re.S)
    stages = set(re.findall(r'\{\s*"([^"]+)", &', block[1] + (common.replace("\\\n", "") if "FRAME_VIEW_STAGES" in block[1] else ""))) if block else set()
    path = f"{folder}/captions.json"
    captions = set(json.load(open(path))) if os.path.exists(path) else set()
    if stages != captions:
        print(os.path.basename(folder), "stages and captions differ:", sorted(stages ^ captions))
    # The key that a text names for the truth is the window's.
    for name in "README.md", "afterword.json":
        for key in re.findall(r"[Kk]ey (\w) shows the tru", open(f"{folder}/{name}").read()):
            if f'"{key}", "the truth, by rays' not in keys:
                print(os.path.basename(folder), name, "names another key for the truth:", key)
PYTHON
)
[[ -z $out ]] && ok || bad "captions" "$out"

# Odd sizes of a window.
for size in 1x1 1000x30; do
    shot
    [[ $status == 0 && $(size_of "$work/shot.png") == "$size" ]] && ok || bad "a window of $size" "$out"
done
size=240x180

# Counts: each stage colour is another one of the legend, whatever a driver rounds.
lab=07

scene=$(python3 -c 'import json, sys
scene = json.load(open(sys.argv[1]))["checks"][0]["scene"]
print(scene if isinstance(scene, str) else scene[0])' "$root/solutions/07-shadow-volumes/rubric.json")
shot --scene "$scene" --show reference --bare --view "stencil counts"
expect "counts" 0 "saved as"
headless --view "stencil counts"
pairs=$(convert "$work/wanted.png" "$work/shot.png" +append -depth 8 rgb:- | python3 -c '
import sys
data, width, found = sys.stdin.buffer.read(), 240, {}
for y in range(180):
    row = data[3 * 480 * y:3 * 480 * (y + 1)]
    for x in range(width):
        found.setdefault(tuple(row[3 * x:3 * x + 3]), set()).add(tuple(row[3 * (x + width):3 * (x + width) + 3]))
colours = [c for s in found.values() for c in s]
print(len(found) > 1, all(len(s) == 1 for s in found.values()), len(colours) == len(set(colours)), any(max(c) - min(c) > 100 for c in colours))')
[[ $pairs == "True True True True" ]] && ok || bad "each count has a colour of its own: $pairs"

# Haze by the window is where lab 07's own shader has it.
shot --scene "$scene" --show reference
cp "$work/shot.png" "$work/plain.png"
shot --scene "$scene" --show reference --volumes
headless --view haze
mask() { convert "$1" -threshold 1% -alpha off -colorspace gray -threshold 0 "$2"; }
convert "$work/plain.png" "$work/shot.png" -compose difference -composite "$work/changed.png"
mask "$work/changed.png" "$work/a.png"
mask "$work/wanted.png" "$work/b.png"
wrong=$(compare -metric AE "$work/a.png" "$work/b.png" null: 2>&1)
covered=$(convert "$work/b.png" -format '%[fx:int(mean*w*h)]' info:)
((covered > 1000 && wrong < covered / 20)) && ok || bad "haze: $wrong pixels of $covered differ"

# The light: lines, and texels only where the knob makes them large.
lab=03 scene="table spot"
for wanted in frustum texels; do
    shot --scene "$scene" --light $wanted --knob "map size=64"
    cp "$work/shot.png" "$work/$wanted.png"
done
headless --skeleton --knob "map size=64"
lines=$(compare -metric AE "$work/wanted.png" "$work/frustum.png" null: 2>&1) texels=$(compare -metric AE "$work/frustum.png" "$work/texels.png" null: 2>&1)
((lines > 50 && lines < 240 * 180 / 5 && texels > 500)) && ok || bad "frustum and texels: $lines and $texels pixels"
status=0 out=$("$view" --lab 03 --light moon 2>&1) || status=$?
expect "another light" 2 "takes frustum or texels"

# The check that a watch opens the window on.
shot --check 3.1
cp "$work/shot.png" "$work/check.png"
read -r of view_of < <(python3 -c 'import json, sys
check = next(c for c in json.load(open(sys.argv[1]))["checks"] if c["task"] == "3.1")
scene = check["scene"] if isinstance(check["scene"], str) else check["scene"][0]
print(scene.replace(" ", "_"), check["view"].replace(" ", "_"))' "$root/solutions/03-shadow-map/rubric.json")
shot --scene "${of//_/ }" --view "${view_of//_/ }" --knob "map size=$(python3 -c 'import json, sys
knob = next(c for c in json.load(open(sys.argv[1]))["checks"] if c["task"] == "3.1").get("knobs", {}).get("map size", 512)
print(knob[0] if isinstance(knob, list) else knob)' "$root/solutions/03-shadow-map/rubric.json")"
same "$work/check.png" "$work/shot.png" && ok || bad "a check's scene, view and knobs"
shot --check 3.99
expect "a check of no task" 1 'lab 03 has no check of a task "3.99"'

# Keys, also before there is a frame; another size while the truth is drawn.
open_window
keys x g g
headless --skeleton
wait_for "guides over the first frame" keeps
keys x g
wait_for "and away again" shows
if [[ -x $root/$BUILD/truth_worker ]]; then
    keys 5
    xdotool windowsize "$window" 400 300
    wait_for "the truth" titled "truth: visibility"
    "$view" --lab 03 --scene "$scene" --size 400x300 --show truth --screenshot "$work/wanted.png" >/dev/null
    wait_for "in a window that was resized while it was drawn" shows
    keys 1
fi
# A second window of the same lab.
"$view" --lab 03 --scene "$scene" --size 200x150 --screenshot "$work/second.png" >"$work/second" 2>&1 && [[ $(size_of "$work/second.png") == 200x150 ]] && ok ||
    bad "two windows at once" "$(cat "$work/second")"
close_window

# The names at the split, and the legend, come and go with the text (key H), also in a picture that is saved.
letters_in() { # FILE AREA: white letters stand on the dark ground there
    [[ $(convert "$1" -crop "$2" +repage -colorspace gray -format '%[fx:minima < 0.2 && maxima > 0.95 && mean < 0.5]' info:) == 1 ]]
}
lettered() { picture && letters_in "$work/now.png" "$1"; }
yours=60x20+254+241 reference=90x20+324+241 legend=120x160+525+160
size=640x480 lab=07 scene=nested
for bare in "" --bare; do
    shot --scene "$scene" --show split --view "stencil counts" --knob method=1 $bare
    [[ $(convert "$work/shot.png" -crop 1x1+320+40 +repage -format '%[hex:u.p{0,0}]' info:) == FFD65A* ]] && ok || bad "the line of a split is saved $bare" "$out"
    for area in $yours $reference $legend; do
        letters_in "$work/shot.png" $area && words= || words=--bare
        [[ $words == "$bare" ]] && ok || bad "saved words at $area $bare"
    done
done
open_window --show split --view "stencil counts" --knob method=1
wait_for "the split" titled "mine | reference"
wait_for "both pictures" picture
sleep 1
lettered $reference && bad "names without text" || ok
keys h
wait_for "yours" lettered $yours
wait_for "reference" lettered $reference
wait_for "the legend" lettered $legend
close_window

# Labs that do not draw: a reason, and no picture.
lab=03 scene="table spot" size=240x180
solved broken >/dev/null
echo 'int x = "text" +;' >>"$work/broken/03-shadow-map/lab.c"
rm -f "$work/shot.png"
shot --submission "$work/broken"
expect "a lab that does not compile" 1 "not saved: mine is not there" "lab.c:"
solved loops >/dev/null
sed -i 's|^static void draw_map(const Frame \*frame) {|&\n    for (;;) {}|' "$work/loops/03-shadow-map/lab.c"
shot --submission "$work/loops" --timeout 2
expect "a lab that loops" 1 "not saved: mine is not there" "in shadow map"
[[ ! -e $work/shot.png ]] && ok || bad "half a picture was written"
finish
