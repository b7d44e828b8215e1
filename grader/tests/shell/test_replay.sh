#!/usr/bin/env bash
# Nothing that comes back of an attempt helps the next one: a skeleton that pastes the frames that it has learnt from
# pictures and pages of earlier attempts (helpers/replay.py), and one that prints what it is asked.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
lab=03-shadow-map class=$work/class out_folder=$work/out
attempt() { # TABLE [SEEN]...: the next attempt lies in $class/mallory
    rm -rf "${class:?}/mallory" && mkdir -p "$class/mallory"
    cp -r "labs/$lab" "$class/mallory"
    knows=$(grader/tests/helpers/replay.py "$class/mallory/$lab" "$@") || bad "replay.py"
}

# It is an attack: where the seed stays and whole pictures come back, it has the points of the pictures after three.
attempt "$work/whole.json"
for ((i = 0; i < 3; i++)); do
    grades --lab 03 --seed 5 --output "$work/seen" "$class/mallory"
    attempt "$work/whole.json" "$work/seen/03"
done
grades --lab 03 --seed 5 --format json "$class/mallory"
[[ $(field 'r["score"] > 20') == True ]] && ok || bad "the attack is none: $(field 'r["score"]') points, $knows frames known" "$out"

# Pages have no pictures to paste, even where the seed stays: next to nothing of it.
attempt "$work/page.json"
for ((i = 0; i < 3; i++)); do
    "$grade" --lab 03 --seed 5 --format html "$class/mallory" >"$work/page.html"
    attempt "$work/page.json" "$work/page.html"
done
grades --lab 03 --seed 5 --format json "$class/mallory"
((knows > 0)) && [[ $(field 'r["score"] < 5') == True ]] && ok || bad "pictures of pages can be handed in ($knows frames known)" "$out"

# In a class, four attempts, each with what the pages before have shown. What it prints stays secret.
seeds=()
points() { python3 -c 'import json,sys; r=json.load(open(sys.argv[1])); print(r["report"]["score"], r["report"]["seed"])' "$out_folder"/results/*.json; }
attempt "$work/class.json"
for ((i = 0; i < 4; i++)); do
    sed -i 's|^    sign(frame, key);|    printf("SECRET %g\\n", (double)frame->scene->camera.eye.x);\n    fprintf(stderr, "SPY %d\\n", frame->width);\n&|; 1i #include <stdio.h>' \
        "$class/mallory/$lab/lab.c"
    grades --class "$class" --output "$out_folder" --lab 03 --only mallory
    read -r score seed < <(points)
    [[ $status == 0 && $score == 0.0 ]] && ok || bad "attempt $i: $score points" "$out"
    seeds+=("$seed")
    cp "$out_folder"/pages/*.html "$work/page.html"
    attempt "$work/class.json" "$work/page.html"
done
((knows > 0)) && ok || bad "nothing was learnt from the pages of a class"
[[ $(printf '%s\n' "${seeds[@]}" | sort -u | wc -l) == 4 ]] && ok || bad "an attempt meets the variants of another" "${seeds[*]}"
[[ $(cd "$out_folder/rounds" && ls) == $'1\n2\n3\n4' ]] && ok || bad "each attempt begins a round" "$(ls "$out_folder/rounds")"
grep -q "${seeds[0]}" "$work/page.html" && bad "the page tells the seed" || ok
# SECRET lines are those of the public seed, the same whatever the class's seed is.
spied() { grep -o 'SECRET [-0-9.]*' "$1" | sort -u; }
"$grade" --class "$class" --output "$work/other" --lab 03 --seed 77 >/dev/null 2>&1
"$grade" --class "$class" --output "$work/third" --lab 03 --seed 78 >/dev/null 2>&1
[[ $(spied "$work"/other/results/*.json) == "$(spied "$work"/third/results/*.json)" ]] && ok || bad "a print tells of hidden variants"
finish
