#!/usr/bin/env bash
# The watch in a terminal (tmux): from the skeleton to the solution, keys, sizes, signals; and without a terminal.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
command -v tmux >/dev/null || { echo "tmux is missing: common/setup --test"; echo "0 passed, 1 failed"; exit 1; }

# A copy of the project, whose build/ has no window.
copy=$work/copy
mkdir -p "$copy/build"
cp -r "$root"/{common,shaders,labs,solutions} "$copy"
cp -r "$root/$BUILD"/{watch,worker,skeletons,include,given} "$copy/build"
[[ -d $root/$BUILD/cache ]] && cp -r "$root/$BUILD/cache" "$copy/build"
find "$root/$BUILD" -maxdepth 1 -name 'jail_*' -exec cp {} "$copy/build" \;
cd "$copy" || exit 1
labs=(solutions/[0-9][0-9]-*) all=$((100 * ${#labs[@]}))
export SHADOW_LAB_PROGRESS=$work/progress.json TMPDIR=$work/tmp
mkdir "$TMPDIR"
terminal() { tmux -S "$work/tmux" "$@"; }
trap 'terminal kill-server 2>/dev/null; rm -rf "$work"' EXIT
screen() { terminal capture-pane -p -t watch; }
type() { terminal send-keys -t watch "$@"; }

# sees NAME PATTERN: the pattern (extended) comes to the screen within 30 s; sets $out.
sees() {
    local n
    for ((n = 0; n < 300; n++)); do
        out=$(screen)
        grep -qE -- "$2" <<<"$out" && { ok; return 0; }
        sleep 0.1
    done
    bad "$1: no \"$2\" on the screen" "$out"
}
points() { grep -oE 'Lab 04: .*\] +[0-9]+ of' <<<"$out" | grep -oE '[0-9]+ of' | cut -d' ' -f1; }

terminal -f /dev/null new-session -d -s watch -x 100 -y 30 "env PS1='ready> ' bash --norc --noprofile"
type 'stty -a >before; build/watch --lab 04 --seed 1' Enter

# Task by task: each save is noticed, the points rise, the next task is named with its place and a hint.
sees "the skeleton is graded" "Task 4\.1  labs/04-acne-and-bias/[a-z.]+:[0-9]+"
sees "the first hint stands there from the start" "Hint 1 of 3"
sees "predictions are asked for" "Predict first: labs/04-acne-and-bias/predictions\.txt \(5 points\)"
sheet=$(grep -oE '^sheet [0-9]+' labs/04-*/predictions.txt)
[[ -n $sheet && $(grep -c '^[abc] ?$' labs/04-*/predictions.txt) == 3 ]] && ok || bad "a sheet is drawn" "$(cat labs/04-*/predictions.txt)"
cmp -s labs/05-*/predictions.txt "$root"/labs/05-*/predictions.txt && ok || bad "a sheet for a lab that nobody came to"
before=$(points)
for task in 4.1 4.2 4.3 4.4; do
    build/skeletons "$work/upto" "$task" >/dev/null
    cp "$work"/upto/04-*/*.{c,frag} labs/04-*/
    sees "after task $task the next one is named" "Task 4\.$((${task#*.} + 1))  labs/"
    # A verdict over the files before this save may come first, and name the next task, too.
    for ((n = 0; n < 300; n++)); do
        now=$(points)
        ((now > before)) && break
        sleep 0.1
        out=$(screen)
    done
    ((now > before)) && ok || bad "task $task: $now points after $before" "$out"
    before=$now
done
sed -i 's/^a ?/a 1e999/' labs/04-*/predictions.txt
sees "what is no number is told" "a: 1e999 is beyond all numbers"
cp solutions/04-*/predictions.txt labs/04-*/
sees "a save of the predictions is noticed" "Predictions: 5 of 5 points"
cp solutions/04-*/*.{c,frag} labs/04-*/
sees "the lab is done" "Lab 04 is done: 100 of 100 points"
sees "how to go on" "This lab is done\. n goes on to lab 05"
sees "the answers to its questions" "The handout's three questions, answered"
type n
sees "the next lab is graded" "Task 5\.1  labs/05"
[[ $out != *"questions, answered"* ]] && ok || bad "an answer to a lab that is not done" "$out"
python3 -c 'import json,sys; l=json.load(open(sys.argv[1]))["labs"]; assert l["04"]["done"] and l["04"]["best"] == 100 and not l["05"]["done"]' "$SHADOW_LAB_PROGRESS" && ok || bad "the progress is kept" "$(cat "$SHADOW_LAB_PROGRESS")"

# Keys.
type h; sees "another hint" "Hint 2 of 3"
type h; sees "the last hint" "Hint 3 of 3"
type h; sees "no more hints" "no more hints"
type l; sees "the list" "04 Acne and bias .*100 of 100, done on 20"
type Up Enter; sees "a lab that is done stays on the desk" "This lab is done\. n goes on"
type n; sees "next" "Lab 05: .*0 of 100"
type r; sees "no window: says so" "there is no window: build/view was not built"
printf '#!/bin/sh\necho "$*" >%s/view\necho "view: no display" >&2\nexit 1\n' "$work" >build/view
chmod +x build/view
type r; sees "the window's own words when it fails" "the window has ended: view: no display"
[[ $(cat "$work/view") =~ ^--lab\ 05(\ --check\ 5\.[0-9]+)?$ ]] && ok || bad "the window gets the lab" "$(cat "$work/view")"

# What does not compile; points that were there stay. A save in another lab brings it to the desk.
echo 'int x = ;' >>labs/05-pcf/lab.c
sees "a compile error with its place" "lab\.c:[0-9]+:[0-9]+: error"
grep -q "100 of $all points" <<<"$out" && ok || bad "a compile error takes no points from the progress" "$out"
touch labs/04-acne-and-bias/lab.c
sees "a save in another lab" "Lab 04: .*100 of 100"

# Sizes: the keys stay in the last row.
terminal resize-window -t watch -x 44 -y 7
sees "a small terminal" "a larger window shows more"
[[ $(screen | sed -n 7p) == "h hint"* ]] && ok || bad "the keys are in the last row" "$(screen)"
for ((n = 0; n < 40; n++)); do type Down; done
sees "the end of what is told, by the keys" "the shadow moves by"
[[ $(screen | sed -n 7p) == "h hint"* && $(screen) != *"larger window"* ]] && ok || bad "the end of a screen that was scrolled" "$(screen)"
terminal resize-window -t watch -x 100 -y 30
for ((n = 0; n < 40; n++)); do type Up; done
sees "a large terminal again" "This lab is done\. n goes on"

# Ctrl-Z and back; q; signals. Each time the terminal is as it was.
restored() { # NAME STATUS
    sees "$1: back in the shell" "^ready>$"
    type 'echo status $?; stty -a >after; cmp before after && echo same' Enter
    sees "$1: exit status $2" "^status $2$"
    sees "$1: the terminal's modes" "^same$"
    [[ $(terminal display -p -t watch '#{alternate_on} #{cursor_flag}') == "0 1" ]] && ok || bad "$1: the screen and its cursor"
    type clear Enter
}
type C-z; sees "Ctrl-Z" "Stopped"
type fg Enter; sees "fg" "This lab is done\. n goes on"
type q; sees "what q leaves" "100 of $all points; .make watch. goes on"
restored q 0
for signal in INT:130 TERM:143 HUP:129 SEGV:139; do
    type 'build/watch --lab 04' Enter
    sees "$signal: the watch" "This lab is done"
    kill -"${signal%:*}" "$(pgrep -P "$(terminal display -p -t watch '#{pane_pid}')")"
    restored "$signal" "${signal#*:}"
    [[ $signal == SEGV* ]] && rm -rf "$TMPDIR"/* # a fault of ours has no time to clean up
    [[ -z $(ls "$TMPDIR") ]] && ok || bad "$signal: temporary files stay behind" "$(ls "$TMPDIR")"
done

# A lab that never ends: q does not wait for it, and nothing of it stays.
sed -i 's/^static void draw_picture.*{$/&\n    for (;;) {\n    }/' labs/03-shadow-map/lab.c
type 'build/watch --lab 03' Enter
sees "an endless loop is being graded" "grading \.\.\."
sleep 1
type q
restored "q while a lab runs" 0
sleep 0.3
pgrep -f "$copy/build/worker" >/dev/null && bad "workers stay behind" "$(pgrep -af "$copy/build/worker")" || ok
[[ -z $(ls "$TMPDIR") ]] && ok || bad "temporary files stay behind" "$(ls "$TMPDIR")"

# A damaged progress is kept and told of; without a terminal there are plain lines and a remedy.
echo '{"version": 1, "labs"' >"$SHADOW_LAB_PROGRESS"
status=0
out=$(build/watch --lab 04 </dev/null 2>&1) || status=$?
expect "without a terminal" 0 "was damaged" "ok   4.1 " "100 of 100" "not a terminal" 'Run `make watch` in a terminal'
[[ $out != *$'\033'* ]] && ok || bad "no colour codes without a terminal" "$out"
grep -q '"labs"$' "$SHADOW_LAB_PROGRESS.damaged-1" && ok || bad "a damaged progress is kept"
status=0
out=$(build/watch --lab 05 </dev/null 2>&1) || status=$?
expect "without a terminal, not done" 1 "does not compile"

# The answer on paper: only of what is done. A reset takes the points back.
answers() { status=0; out=$(build/watch "$@" 2>&1 </dev/null) || status=$?; }
answers --lab 04 --answer
expect "the answer of a lab that is done" 0 "The idea" "The handout's three questions, answered" "To try in the window" "make showcase"
# What make study has measured, in words; what is older than the files is said to be.
for ours in '1,0.02 2,0.005' '3,0.001 7,0.001'; do
    printf '"a","Plates, two of them","%s","9 x 9","recorded",%s,""\n"a","Plates, two of them","%s","9 x 9","yours",%s,""\n' "m ${ours%%,*}" "${ours% *}" "m ${ours%%,*}" "${ours#* }"
done | sed '1i scene,title,method,setting,whose,ms,error,message' >build/study-04.csv
answers --lab 04 --answer
expect "error against time" 0 "Your methods: error against time" "Plates, two of them" "your most accurate: m 3, 9 x 9: 0.1 % in 7 ms (our solution: 0.1 % in 3 ms)" \
    "in at most half of that time: m 3" "build/study-04.html"
[[ $out != *"older than"* ]] && ok || bad "numbers of now" "$out"
touch -d "last year" build/study-04.csv
answers --lab 04 --answer
expect "numbers of long ago" 0 "older than your files: make study again"
echo '<html>' >build/study-04.csv
answers --lab 04 --answer
expect "what is no table" 0 "To try in the window"
[[ $out != *"Your methods"* ]] && ok || bad "nothing was recorded" "$out"
echo '{}' >solutions/04-acne-and-bias/study.json
answers --lab 04 --answer
expect "what could be measured" 0 'make study LAB=04 SUBMISSION=labs` measures them'
rm build/study-04.csv solutions/04-acne-and-bias/study.json
answers --lab 05 --answer
expect "no answer of a lab that is open" 1 "Lab 05 is not done yet"
[[ $out != *"answered"* ]] && ok || bad "an answer too early" "$out"
answers --answer
expect "the answer of which lab?" 2 "go with --lab NN"
answers --lab 04 --begin-again
expect "begun again" 0
answers --list
expect "the list after that" 0 "0 of 100, best 100"
[[ $out != *"done on"* ]] && ok || bad "still done" "$out"
status=0
out=$(build/watch --lab 77 2>&1) || status=$?
expect "no such lab" 2 'there is no lab "77"'
status=0
out=$(build/watch --frobnicate 2>&1) || status=$?
expect "unknown option" 2 "usage: build/watch"
finish
