#!/usr/bin/env bash
# A new lab by one command, in a copy of the project: everything must run on it without another file touched.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
copy=$work/copy id=$(printf %02d $((1 + 10#$(basename "$(ls -d "$root"/solutions/[0-9][0-9]-* | tail -1)" | cut -c1-2))))
n=$((10#$id)) lab=$id-soft-edges
mkdir -p "$copy"
cp -a "$root"/{Makefile,README.md,.github,LICENSE,common,shaders,labs,solutions,grader,.clang-format,.clang-tidy,.gitignore} "$copy"
cp -a "$root/$BUILD" "$copy/build"
rm -rf "$copy"/labs/*.backup-*
cd "$copy" || exit 1
git init -q . && git add -A && git -c user.name=t -c user.email=t@t commit -qm start
runs() { status=0; out=$(timeout 300 "$@" 2>&1 </dev/null) || status=$?; }
SHADOW_LAB_PROGRESS=$work/progress.json
export SHADOW_LAB_PROGRESS

# What is refused, before anything is there.
refused() { # NAME PATTERN ARGUMENTS...
    local name=$1 pattern=$2
    shift 2
    runs make --no-print-directory new-lab "$@"
    expect "$name" 2 "$pattern"
}
refused "a number that is taken" "number 03 is taken: solutions/03-shadow-map" LAB=3 NAME=other
refused "no number" 'LAB is a number from 1 to 99, not ""' NAME=other
refused "a number that is none" 'not "1x"' LAB=1x NAME=other
refused "the number 0" 'not "00"' LAB=00 NAME=other
refused "no name" 'NAME is words' LAB="$n"
refused "capitals" 'not "Soft"' LAB="$n" NAME=Soft
refused "a path" 'not "../x"' LAB="$n" NAME=../x
refused "a quote" "not \"a'b\"" LAB="$n" NAME="a'b"
[[ -z $(git status --porcelain) ]] && ok || bad "a refusal leaves nothing" "$(git status --porcelain)"

runs make new-lab LAB="$n" NAME="soft edges"
expect "a new lab" 0 "solutions/$lab is there" "rows $((100 * n + 1))" "mistakes.json" "at least 16"
[[ $(git status --porcelain | sort | xargs) == "?? labs/$lab/ ?? solutions/$lab/" ]] && ok || bad "only new folders" "$(git status --porcelain)"
[[ $(ls "labs/$lab" | xargs) == "README.md lab.c lamp-and-surface.svg picture.png predictions.txt shade.frag" ]] && ok || bad "what students get" "$(ls "labs/$lab")"
runs build/grade --lab "$id" --seed 1 --trusted "solutions/$lab"
expect "the solution" 0 "100.00 of 100 points"
runs build/grade --lab "$id" --seed 1 --trusted labs
expect "the skeleton" 1 " 0.00 of 100 points"
runs build/prove --lab "$id" --seeds 1
expect "the proof" 0 ", 0 failed"
runs build/watch --list
expect "the list" 0 "$id Soft edges"
runs build/watch --lab "$id" --seed 1
expect "a grading by the watch" 1 "$n.1"
if [[ -x build/view ]] && command -v xvfb-run >/dev/null; then
    runs xvfb-run -a build/view --lab "$id" --screenshot "$work/window.png"
    [[ $status == 0 && -s $work/window.png ]] && ok || bad "the window" "$out"
else
    skip "the window: there is no build/view or no xvfb-run (common/setup --test)"
fi
runs env SEEDS=1 grader/scripts/make_kit build "$id"
expect "the kit" 0 "shadow-lab-kit.tar.gz"
tar -xzf build/shadow-lab-kit.tar.gz -C "$work"
[[ -f $work/shadow-lab/grader/recorded/labs/$lab/lab.c && -f $work/shadow-lab/grader/recorded/scenes/$lab/scenes.c ]] && ok || bad "the lab is in the kit" "$(ls "$work/shadow-lab/grader/recorded/labs")"
[[ -z $(find "$work/shadow-lab" -name 'rows*.c' -path '*recorded*' -o -name study.c -o -name witness.c -o -name new_lab) ]] && ok || bad "not for students"
runs grader/tests/helpers/find_answers "$work/shadow-lab"
grep -q "$lab\|were looked for" <<<"$out" && ! grep -q "$lab/" <<<"$out" && ok || bad "no answer is in the kit" "$out"
if [[ -x build/chart ]]; then
    runs build/chart --size 64x48 --frames 1 --scene edges --output "$work/study"
    grep -q "soft edges" "$work/study/chart.csv" && ok || bad "its setting is in the chart" "$out"
    runs build/stability --row $((100 * n + 1)) --output "$work/study"
    expect "its row" 0 "$((100 * n + 1))  pass"
    runs make "build/test_${id}_witness"
    runs "build/test_${id}_witness"
    expect "its witness" 0 "PASSED"
else
    skip "the study: there is no build/chart (common/setup --test)"
fi
if command -v node >/dev/null && command -v cmark-gfm >/dev/null && [[ -d grader/site/node_modules ]]; then
    runs node grader/site/build.mjs "$work/site"
    [[ $status == 0 && -s $work/site/$lab.html ]] && ok || bad "its page" "$out"
else
    skip "its page: there is no node or no cmark-gfm, or make site never ran (common/setup --test)"
fi
runs env SKIP_TIDY=1 make check
expect "the gates" 0 ", 0 failed"
[[ $(git status --porcelain | sort | xargs) == "?? labs/$lab/ ?? solutions/$lab/" ]] && ok || bad "no other file was touched" "$(git status --porcelain)"
finish
