#!/usr/bin/env bash
# The command lines of all programs and scripts: --help, and what is refused by name, with status 2, before anything is done.
# What each program takes is read from its own --help, so a new program or option is tried without a word here.
set -u
source "$(dirname "$0")/../helpers/lib.sh"

bin=$root/$BUILD scripts=$root/grader/scripts
mkdir "$work/here" && cd "$work/here" || exit 1
seen() { ls -A "$work/here" "$root" "$root/labs" "$root/solutions"; }
seen >"$work/seen"

# refuses NAME PATTERN COMMAND...: status 2, the pattern on standard error, nothing on standard output, no file made.
refuses() {
    local name=$1 pattern=$2 status=0
    shift 2
    timeout 20 "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
    [[ $status == 2 ]] || { bad "$name: exit status $status, not 2" "$(cat "$work/err")"; return; }
    [[ ! -s $work/out ]] || { bad "$name: prints on standard output" "$(cat "$work/out")"; return; }
    grep -qF -- "$pattern" "$work/err" || { bad "$name: no \"$pattern\"" "$(cat "$work/err")"; return; }
    seen | cmp -s - "$work/seen" && ok || { bad "$name: made a file" "$(seen | diff "$work/seen" -)"; seen >"$work/seen"; }
}

helps() { # NAME COMMAND...: --help is on standard output alone, with status 0
    local name=$1 status=0
    shift
    for word in --help -h; do
        timeout 20 "$@" "$word" >"$work/help" 2>"$work/err" </dev/null || status=$?
        [[ $status == 0 && -s $work/help && ! -s $work/err ]] && ok || bad "$name $word: status $status" "$(cat "$work/err")"
    done
}

not_labs=(99 00 7x x3 003 +3 -3 " 3" "3 " 0x3 3.0 3,4 ٣ "$(printf '3\n')x")
not_numbers=(-1 +1 " 1" "1 " 0x10 1e3 1.5 99999999999999999999999 ١ none)
programs=()
for source in "$root"/grader/programs/*.c; do
    [[ -x $bin/$(basename "$source" .c) ]] && programs+=("$(basename "$source" .c)")
done
((${#programs[@]} >= 8)) && ok || bad "the programs are found" "${programs[*]}"

for program in "${programs[@]}"; do
    run=$bin/$program
    helps "$program" "$run"
    cp "$work/help" "$work/$program.help"
    refuses "$program --sed" "--sed: unknown option; --help lists them" "$run" --sed 3
    refuses "$program --sed=3 behind" "--sed: unknown option; --help lists them" "$run" --sed=3 behind
    refuses "$program: option after operand" "--frobnicate: unknown option" "$run" nowhere --frobnicate
    refuses "$program: a letter" "-Q: unknown option" "$run" -Q
    refuses "$program: unicode" "--ščaß: unknown option" "$run" --ščaß
    refuses "$program: --help with a value" "--help takes no value" "$run" --help=3
    refuses "$program: too many" "$program: " "$run" a b c d e f
    while read -r option value; do
        refuses "$program $option, last" "$option needs a value: $value" "$run" "$option"
        refuses "$program $option, empty" "$option needs a value: $value" "$run" "$option" ""
        [[ $option == --* ]] || continue
        refuses "$program $option=" "$option needs a value: $value" "$run" "$option="
        refuses "$program $option before an option" "$option needs a value: $value" "$run" "$option" --help
    done < <(sed -nE 's/^  (--[a-z-]+|-[a-z]) ([A-Za-z:=]+)  .*/\1 \2/p' "$work/$program.help")
    for option in $(sed -nE 's/^  (--[a-z-]+)  .*/\1/p' "$work/$program.help"); do
        refuses "$program $option=3" "$option takes no value" "$run" "$option=3"
    done
    takes() { grep -q -- "^  $1 " "$work/$program.help"; }
    for lab in "${not_labs[@]}"; do
        takes "--lab" && refuses "$program --lab \"$lab\"" "there are 01, 02, 03" "$run" --lab "$lab"
    done
    for number in "${not_numbers[@]}"; do
        takes "--seed" && refuses "$program --seed \"$number\"" "--seed takes a whole number" "$run" --seed "$number"
        takes "--seeds" && refuses "$program --seeds \"$number\"" "--seeds takes a number" "$run" --seeds "$number"
    done
    for size in 0x10 10x0 -1x5 10x 10 10x10x "10 x 10" 99999x1 1x99999999999999999999 "10x10 "; do
        takes "--size" && refuses "$program --size \"$size\"" "--size takes WIDTHxHEIGHT" "$run" --size "$size"
    done
    for seconds in 0 -1 inf nan 0x1 1e9 3601 . "1 " 1.2.3; do
        takes "--timeout" && refuses "$program --timeout \"$seconds\"" "--timeout takes seconds" "$run" --timeout "$seconds"
    done
    takes "--context" && refuses "$program --context glx" "--context takes osmesa or egl" "$run" --context glx
    takes "--knob" && for knob in a =3 a= a=x a=0x3 "a=1 " "$(printf 'n%.0s' {1..90})=1"; do
        refuses "$program --knob \"$knob\"" "--knob takes NAME=VALUE" "$run" --knob "$knob"
    done
done

# Abbreviations are taken while they mean one option; of two values the last one counts; "--" ends the options.
refuses "ambiguous" "--s: which one? --scene, --seed, --size, --skeleton, --submission" "$bin/frame" --s x
frame=("$bin/frame" --lab 03 --scene "table spot" --size 64x48 out.png)
refuses "a knob out of its range" 'frame: the knob "map size" takes a number from 64 to 4096, not 63' "${frame[@]}" --knob "map size=63"
refuses "a knob of another lab" 'frame: the lab has no knob "radius"; its knobs are "map size"' "${frame[@]}" --knob radius=1
refuses "a knob that chooses" 'frame: the knob "method" takes a whole number from 0 to 5, not 1.5' \
    "$bin/frame" --lab 05 --scene "table spot" out.png --knob method=1.5
refuses "a knob of a submission" 'frame: the knob "map size" takes a number from 64 to 4096, not 1e+06' "${frame[@]}" \
    --submission "$root/labs/03-shadow-map" --knob "map size=1000000"
refuses "no such fineness" "--fine takes a number from 1 to 4, not" "${frame[@]}" --fine 5
refuses "no such colours" "--colors takes own or quiet, not" "${frame[@]}" --colors loud
refuses "too fine" "--fine 4 makes the picture larger than 4096 pixels" "${frame[@]}" --size 1100x20 --fine 4
refuses "an abbreviation" "--seed takes a whole number" "$bin/frame" --see x
refuses "a wrong option before a right one" "--seed takes" "$bin/grade" --seed x --seed 1 "$root/labs"
refuses "behind --" "--lab is not a folder" "$bin/grade" -- --lab
refuses "an operand too many" '"two" is one operand too many' "$bin/grade" one two
refuses "an operand too many, of none" '"surplus" is not an option' "$bin/prove" surplus
refuses "an operand too many, behind --" '"--surplus" is not an option' "$bin/prove" -- --surplus
refuses "an empty operand" '"" is no SUBMISSION' "$bin/grade" ""
refuses "no operand" "OUTPUT is missing" "$bin/skeletons"
refuses "no task" "TASK is a task like 3.2" "$bin/skeletons" made 3x
refuses "no seed" "SEED is a whole number" "$bin/record_exams" made 1 0x2
for command in "grade ." mutants "record_exams made 1" scene_table prove chart stability "bench_frames 03"; do
    refuses "a context of the environment: $command" "SHADOW_LAB_CONTEXT is osmesa or egl" env SHADOW_LAB_CONTEXT=glx "$bin/"$command
done
refuses "help that is no option's value" "--output needs a value: DIR" "$bin/grade" --output --help
status=0
"$bin/grade" --help >/dev/full 2>"$work/err" || status=$?
[[ $status == 1 ]] && ok || bad "help that cannot be written: status $status"

# A lab is the same lab under both names, given twice it is one, and the last seed counts.
json() { "$bin/grade" --trusted --format json "$@" "$root/labs" 2>&1 | grep -vE '"(seconds|speed_ratio)"'; }
json --lab 03 --seed 1 >"$work/03"
grep -q '"id": "03"' "$work/03" && ok || bad "grade --lab 03" "$(cat "$work/03")"
json --lab 3 --seed 1 | cmp -s - "$work/03" && ok || bad "grade --lab 3"
json --lab=3 --lab 03 --seed 7 --seed 1 | cmp -s - "$work/03" && ok || bad "grade --lab=3 --lab 03"
(cd "$root" && "$bin/grade" labs --la 3 --trusted --seed 1 --format=json 2>&1 | grep -vE '"(seconds|speed_ratio)"') |
    cmp -s - "$work/03" && ok || bad "grade with options behind the operand"
for lab in 3 03; do
    "$bin/frame" --lab $lab --scene "table spot" --size 64x48 "$work/$lab.png" || bad "frame --lab $lab"
    "$bin/record_exams" --lab $lab "$work/exams-$lab" 1 || bad "record_exams --lab $lab"
done
cmp -s "$work/3.png" "$work/03.png" && ok || bad "frame --lab 3"
[[ -s $work/exams-3/03-shadow-map/rubric.json ]] && diff -r "$work"/exams-{3,03} >"$work/out" && ok || bad "record_exams --lab 3" "$(cat "$work/out")"
# Whose process that draws is killed says so, wherever it was.
"$bin/record_exams" --lab 03 "$work/killed" 1 >"$work/out" 2>&1 &
recording=$!
for ((i = 0; i < 200; i++)); do pkill -KILL -P $recording -x worker && break; sleep 0.05; done
status=0; wait $recording || status=$?
[[ $status == 3 && $(cat "$work/out") == "record_exams: "*"lab"*03* && $(cat "$work/out") != *"endless loop"* ]] && ok || bad "record_exams, killed" "$status $(cat "$work/out")"
# A fine picture is the mean of a large one, by another program; quiet colours change nothing else of the scene.
table=("$bin/frame" --lab 03 --scene "table spot")
"${table[@]}" --size 192x144 "$work/large.png" && "${table[@]}" --size 64x48 --fine 3 "$work/fine.png" || bad "frame --fine"
off=$(convert "$work/large.png" -scale 64x48! "$work/fine.png" -compose difference -composite -depth 8 -format '%[fx:round(255*maxima)]' info:)
[[ $off == [01] ]] && ok || bad "the mean of nine pixels is off by $off"
for view in picture "shadow map"; do
    "${table[@]}" --size 64x48 --view "$view" "$work/plain.png" && "${table[@]}" --size 64x48 --view "$view" --colors quiet "$work/calm.png" || bad "frame --colors quiet"
    cmp -s "$work/plain.png" "$work/calm.png"
    [[ $? == $([[ $view == picture ]] && echo 1 || echo 0) ]] && ok || bad "quiet colours and the $view"
done

[[ -n ${QUICK:-} ]] && { finish; exit; } # scripts are not C

# Scripts.
for script in "$scripts"/*; do
    name=$(basename "$script")
    [[ -f $script && -x $script ]] || continue
    helps "$name" "$script"
    [[ $name == @(publish_chart|bench_class) ]] || refuses "$name --frobnicate" "--frobnicate" "$script" --frobnicate
    [[ $name == @(publish_chart|bench_class|contexts|economy|floors|named_files|table) ]] || refuses "$name: too many" "one operand too many" "$script" 3 b c d
done
refuses "economy: too many" "one operand too many" "$scripts/economy" {1..20}
helps setup "$root/common/setup"
refuses "setup --frobnicate" "usage: common/setup" "$root/common/setup" --frobnicate
refuses "publish_chart --frobnicate" "--frobnicate: unknown option" "$scripts/publish_chart" "$bin" --frobnicate
refuses "bench_class --frobnicate" "unrecognized arguments: --frobnicate" "$scripts/bench_class" "$bin" --frobnicate
refuses "table: no table" '"b" is no table: scenes, rubrics or mutants' "$scripts/table" 3 b
refuses "floors: an operand" "unrecognized arguments: up" "$scripts/floors" up
refuses "bench_class: no lab" 'there is no lab "7x"' "$scripts/bench_class" "$bin" --labs 7x
refuses "bench_class: no count" "no list of counts" "$scripts/bench_class" "$bin" --counts many
refuses "table: no table" '"chairs" is no table' "$scripts/table" chairs
for script in bench contexts gates make_kit make_gradescope new_lab publish_chart; do
    refuses "$script without BUILD" "BUILD is missing" "$scripts/$script"
done
for lab in "${not_labs[@]}"; do
    for script in reset trace pictures; do
        [[ $lab == -* ]] || refuses "$script \"$lab\"" "there are 01, 02, 03" "$scripts/$script" "$lab"
    done
    for script in contexts make_kit make_gradescope; do
        [[ $lab == -* ]] || refuses "$script \"$lab\"" "there are 01, 02, 03" "$scripts/$script" "$bin" "$lab"
    done
    refuses "bench \"$lab\"" "there are 01, 02, 03" env LAB="$lab" "$scripts/bench" "$bin"
done
for task in 3 3. .3 x 3.x 77.1 3.77 "3.2 " 3.2.1; do refuses "hint \"$task\"" "hint: " "$scripts/hint" "$task"; done
refuses "hint that is not there" "has hints 1 to" "$scripts/hint" 3.2 9
for words in reset trace hint; do refuses "$words without a word" "which" "$scripts/$words"; done
[[ $("$scripts/hint" 03.02) == "$("$scripts/hint" 3.2)" ]] && ok || bad "hint 03.02"

# make passes LAB on as it is.
for target in contexts grade run watch reset trace pictures kit gradescope; do
    out=$(make -n -C "$root" BUILD="$BUILD" "$target" LAB="3 4" 2>&1)
    grep -qF "'3 4'" <<<"$out" && ok || bad "make $target LAB" "$out"
done
out=$(make -s -C "$root" BUILD="$BUILD" reset LAB=99 2>&1) && bad "make reset LAB=99" "$out"
grep -qF 'there is no lab "99"' <<<"$out" && ok || bad "make reset LAB=99" "$out"

finish
