#!/usr/bin/env bash
# The student's kit: no answer is in it, and it grades like the project.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

SEEDS="1 2" grader/scripts/make_kit "$BUILD" 03 >"$work/log" 2>&1 && ok || bad "make_kit" "$(cat "$work/log")"
unpack() { tar -xzf "$BUILD/shadow-lab-kit.tar.gz" -C "$work"; }
unpack && kit=$work/shadow-lab
run() { status=0; out=$("$@" 2>&1 </dev/null) || status=$?; }

# Unpacked by something that forgets what can be started: make sets it right.
cp -r "$kit" "$work/zipped" && chmod -R a-x,u+X "$work/zipped"
run make -C "$work/zipped" --no-print-directory help
[[ $status == 0 && $out == *"the labs are in labs/"*"make watch"* && $out != *denied* ]] && ok || bad "a kit without marks of what can be started" "$out"
rm -r "$work/zipped/labs" "$work/zipped/.kit" "$work/zipped/shaders/"*
run make -C "$work/zipped" --no-print-directory help
[[ $status == 2 && $out == *"this kit is not whole: "*" files are missing, the first is shaders/"*"unpack it again"* ]] && ok || bad "a kit that was half unpacked" "$out"
rm -r "$work/zipped"

# It makes labs/ at the first command. Over an older kit it renews the handouts, and nothing that was written goes.
[[ ! -e $kit/labs ]] && ok || bad "a kit that is unpacked over labs/ overwrites them"
run "$kit/grader/scripts/lay_out"
expect "labs/ is made" 0 "the labs are in labs/"
diff -r -x '*.backup-*' labs "$kit/labs" >"$work/diff" && ok || bad "labs/ is the one of the project" "$(cat "$work/diff")"
cp -r "$kit" "$work/older"
echo '// mine' >>"$kit/labs/03-shadow-map/lab.c"
echo 'my note' >>"$kit/labs/03-shadow-map/README.md"
unpack && run "$kit/grader/scripts/lay_out"
[[ $status == 0 && -z $out && $(tail -1 "$kit/labs/03-shadow-map/lab.c") == "// mine" ]] && ok || bad "the same kit again" "$out"
echo '// newer' | tee -a "$kit"/grader/recorded/labs/0[34]-*/{lab.c,README.md} >/dev/null
touch "$kit/grader/base/gone.c" && mkdir "$kit/build" && touch "$kit/build/worker"
printf '%s\n' "grader/base/gone.c" "= older" | cat - "$kit/.kit/files" | LC_ALL=C sort -o "$kit/.kit/files"
run "$kit/grader/scripts/lay_out"
expect "a newer kit over an older one" 0 "what you wrote there stays: 1 files"
tails() { for file in "$@"; do tail -1 "$kit/labs/$file"; done | paste -sd' '; }
[[ $(tails 03-shadow-map/{lab.c,README.md,README.md.old} 04-acne-and-bias/lab.c) == "// mine // newer my note // newer" ]] && ok || bad "what is whose" "$(ls "$kit/labs/03-shadow-map")"
[[ ! -e $kit/grader/base/gone.c && $kit/grader/base/files.c -nt $kit/build/worker && -z $(find "$kit/labs" -name '*.new') ]] && ok || bad "what an older kit had is gone, and all is built again"
echo '= third' | LC_ALL=C sort -o "$kit/grader/recorded/kit" - "$kit/grader/recorded/kit" && chmod a-w "$kit"
run make -C "$kit" --no-print-directory help
[[ $status == 0 && $out == *"build everything"* ]] && ok || bad "help in a folder that nobody may write to" "$out"
chmod u+w "$kit" && rm -r "$kit" && mv "$work/older" "$kit"

# No answer.
out=$(grader/tests/helpers/find_answers "$kit") && ok || bad "an answer is in the kit" "$out"
[[ ! -e $kit/solutions && ! -e $kit/grader/tests && ! -e $kit/.git ]] && ok || bad "not for students" "$(ls -a "$kit" "$kit/grader")"
grep -q edits "$kit"/grader/recorded/03-*/*.json && bad "the kit tells how mistakes are made" || ok
# The search finds what is there.
finds() { # NAME PATTERN
    out=$(grader/tests/helpers/find_answers "$kit")
    [[ $? == 1 && $out == *"$2"* ]] && ok || bad "$1 is not found" "$out"
}
cp solutions/03-shadow-map/mistakes.json "$kit/grader/recorded/03-shadow-map/leak.json"
finds "a mistake's patch" "leak.json"
rm "$kit/grader/recorded/03-shadow-map/leak.json"
echo '// if (position_map.z > 1.0)' >"$kit/common/leak.h"
finds "an answer in a comment" "common/leak.h: if (position_map.z > 1.0)"
rm "$kit/common/leak.h"

# It grades the same: with the binaries of the project, which are made of the same sources.
for file in grader/*/*.c common/*.c common/scene/*.c; do
    [[ ! -e $kit/$file ]] || cmp -s "$file" "$kit/$file" || bad "$file differs in the kit"
done
mkdir "$kit/build" && cp -r "$BUILD"/{grade,watch,worker,points,include,given} "$kit/build" && cp "$BUILD"/jail_* "$kit/build"
half=$(solved half 03)
sed -i 's/lit \* diffuse_specular/(0.5 + 0.5 * lit) * diffuse_specular/' "$half/03-shadow-map/shadow.frag"
mistaken=$(solved mistaken 03)
sed -i 's/? 0.0 : 1.0/? 1.0 : 0.0/' "$mistaken/03-shadow-map/shadow.frag"
# The points, check by check. What is told of a fault differs: the kit has no function of ours to try in place of theirs.
points() {
    python3 -c 'import json, sys
text = sys.stdin.read()
lab = json.loads(text[text.index("{"):])["labs"][0]
print(lab["status"], lab["score"], *[(c["name"], c["score"], c["passed"], bool(c["cause"])) for c in lab["checks"]], sep="\n")'
}
right=$(solved right 03)
rm "$work"/{half,mistaken,right}/03-*/{*.json,pictures} # of which students know nothing
for submission in labs "$half" "$mistaken" "$right"; do
    grades --lab 03 --seed 2 --trusted --format json "$submission" 2>/dev/null
    there=$(points <<<"$out")
    grade=$kit/build/grade
    grades --lab 03 --seed 2 --trusted --format json "$submission"
    [[ $(points <<<"$out") == "$there" ]] && ok || bad "the kit grades $submission otherwise" "$(diff <(echo "$there") <(points <<<"$out"))"
    grade=$root/$BUILD/grade
done
grade=$kit/build/grade
# It finds the function with a fault, without our solution.
odd=$(solved odd 03)
sed -i 's/depth < position_map\.z/depth < position_map.z * position_map.z/' "$odd/03-shadow-map/shadow.frag"
grades --lab 03 --seed 1 --trusted "$odd"
expect "the kit finds the function" 1 "\`visibility\` (shadow.frag)" "as handed out, the rest draws as it should"
grades --lab 03 --trusted "$half"
expect "the kit chooses a recorded seed" 1 "of 100 points (seed "
[[ $out =~ seed\ [12], && $out != *ignored* ]] && ok || bad "not a recorded seed, or handouts are ignored files" "$out"
grades --lab 03 --seed 7 --trusted "$half"
expect "a seed that is not recorded" 3 "seed 7 is not recorded here"
rm "$kit"/grader/recorded/03-shadow-map/exam-1-02.png
grades --lab 03 --seed 1 --trusted "$half"
expect "a frame that is missing" 3 "exam-1-02.png"

# The watch, hints and reset.
run env SHADOW_LAB_PROGRESS="$work/progress" "$kit/build/watch" --lab 03 --seed 2
expect "the watch" 1 "3.1"
run "$kit/grader/scripts/hint" 3.2
expect "hints" 0 "Hint 1 of 3 for task 3.2"
cp "$half"/03-shadow-map/lab.c "$kit/labs/03-shadow-map"
run "$kit/grader/scripts/reset" 03
expect "reset" 0 "is the skeleton again"
cmp -s labs/03-shadow-map/lab.c "$kit/labs/03-shadow-map/lab.c" && ok || bad "reset in the kit"

# A student's methods beside recorded points. A solution errs as ours did, a lab as it was handed out errs more.
if [[ -x $BUILD/record_study ]]; then
    [[ -s $kit/grader/recorded/03-shadow-map/study.json ]] && ok || bad "no points are recorded" "$(cat "$work/log")"
    chart() { run "$kit/grader/scripts/study_page" build 03 "$1"; }
    errors() { # by which factor yours err more than ours, at least and at most
        python3 -c 'import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))
ratios = [float(mine["error"]) / float(ours["error"]) for ours, mine in zip(rows[0::2], rows[1::2])]
print(all(r["message"] == "" and float(r["ms"]) > 0 for r in rows), min(ratios) > 0.999, max(ratios) < 1.001)' "$kit/build/study-03.csv"
    }
    chart "$right"
    expect "the study of a solution" 0 "your least error" "build/study-03.html: open it"
    [[ $(errors) == "True True True" ]] && ok || bad "a solution errs as ours did: $(errors)" "$(cat "$kit/build/study-03.csv")"
    chart labs
    [[ $status == 0 && $(errors) == "True True False" ]] && ok || bad "a skeleton errs more: $(errors)" "$out"
    grep -qE '(src|href)="?https?:' "$kit/build/study-03.html" && bad "the page needs no network" || ok
    mv "$kit"/grader/recorded/03-shadow-map/study.json "$work"
    chart labs
    expect "a kit without points" 3 "no points of lab 03 are recorded here"
    mv "$work/study.json" "$kit"/grader/recorded/03-shadow-map
else
    skip "there are no points to record (no Embree)"
fi
run "$kit/grader/scripts/study_page" build
expect "the study of no lab" 2 "make study LAB=05"

# Where Embree is missing the kit builds all but the truth.
names=$(make -C "$kit" -n --no-print-directory BUILD=build EMBREE= programs 2>/dev/null | grep -oE ' -o build/[a-z_]+ ' | sort -u)
[[ $names == *build/points* && $names == *build/grade* && $names != *truth_worker* ]] && ok || bad "without Embree" "$names"

# Each command of make that its texts name is there; what is not is said in one line.
in_kit() { status=0; out=$(make -C "$kit" --no-print-directory "$@" 2>&1) || status=$?; }
named=$(cat "$kit"/README.md "$kit"/labs/*/README.md "$kit"/common/DEBUGGING.md | grep -oE '(^|`)make [a-z-]+( [A-Z]+=[0-9.]+)?' | tr -d '`' | sort -u | grep -vE '^make (even|sure|it|the|a|no|your|one|its|two|them|what|all|this|up|something|an|that)\b')
while read -r _ target operand; do
    in_kit -n "$target" $operand
    [[ $status == 0 ]] && ok || bad "make $target is named in the kit" "$out"
done <<<"$named"
in_kit help
expect "help" 0 "make watch" "make hand-in" "make study LAB=05"
[[ $out != *mutants* && $out != *"make demo"* ]] && ok || bad "help lists what is not there" "$out"
status=0 out=$(LC_ALL=xx_YY make -C "$kit" --no-print-directory help 2>&1) || status=$?
[[ $status == 0 && $out != *locale* ]] && ok || bad "a language that is not installed" "$out"
in_kit demo
expect "a teacher's target" 2 "make demo is not in this kit; make help lists what is"
grep -q '^| \[13 ' "$kit/README.md" && ! grep -q '@LABS@' "$kit/README.md" && ok || bad "the table of labs in the kit's README" "$(cat "$kit/README.md")"
[[ -s $kit/grader/recorded/03-shadow-map/afterword.json && -z $(find "$kit/labs" -name 'afterword*') ]] && ok || bad "what is told after the lab"
grep -qE -- '--mistake|--skeleton' "$kit"/grader/recorded/*/pictures && bad "pictures of what is not the student's" || ok
grep -q "New variants" "$kit/README.md" && ok || bad "how new variants are had"
grep -q "make watch" "$kit/README.md" && ! grep -qE 'build/grade --class|make demo' "$kit/README.md" && ok || bad "the kit's README"
in_kit hand-in LAB=03
expect "hand in" 0 "build/lab-03.tar.gz" "03-shadow-map/lab.c" "still to do: TODO(3.1)"
printf '{\n  "labs": {\n    "03": {\n      "done": true\n    }\n  }\n}\n' >"$work/done"
in_kit hand-in LAB=03 SHADOW_LAB_PROGRESS="$work/done"
[[ $status == 0 && $out != *"still to do"* ]] && ok || bad "a lab that is done, with its TODOs" "$out"
# Of all labs those are packed that were begun: what the watch draws into the predictions is no work.
in_kit hand-in
expect "nothing is begun" 2 "labs/ is as it was handed out; nothing was packed"
echo '// mine' >>"$kit/labs/04-acne-and-bias/lab.c"
sed -i 's/$/\r/' "$kit"/labs/05-pcf/lab.c
sed -i '1i sheet 77' "$kit"/labs/06-*/predictions.txt
sed -i 's/^a ?/a 3/' "$kit"/labs/07-*/predictions.txt
echo '{"labs": {"04": {"done": false, "score": 41.7, "max_score": 100}}}' >"$work/open"
in_kit hand-in SHADOW_LAB_PROGRESS="$work/open"
expect "all that was begun" 0 "build/labs.tar.gz" "04-acne-and-bias: 41 of 100 points" "07-shadow-volumes: not graded yet" "not begun, and not in it: 01 02 03 05 06 08"
[[ $(tar -tzf "$kit/build/labs.tar.gz" | cut -c1-2 | sort -u | paste -sd' ') == "04 07" ]] && ok || bad "what is packed" "$(tar -tzf "$kit/build/labs.tar.gz")"
# Names that a browser, an editor or a link made are packed, as they are graded; what is missing is said.
mv "$kit/labs/03-shadow-map/lab.c" "$work/elsewhere.c" && ln -s "$work/elsewhere.c" "$kit/labs/03-shadow-map/LAB (1).c"
mv "$kit/labs/03-shadow-map/shadow.frag" "$kit/labs/03-shadow-map/shadow.frag.txt"
in_kit hand-in LAB=03
expect "hand in under other names" 0 "03-shadow-map/LAB (1).c" "03-shadow-map/shadow.frag.txt" "still to do: TODO(3.1)"
tar -tvzf "$kit/build/lab-03.tar.gz" | grep -q '^l' && bad "a link is packed" || ok
rm "$work/elsewhere.c" && touch "$kit/labs/03-shadow-map/labyrinth.c"
in_kit hand-in LAB=03
expect "a file is missing" 2 "missing: labs/03-shadow-map/lab.c; make reset"
in_kit reset LAB=03
in_kit hand-in LAB=03
expect "after a reset" 0 "03-shadow-map/lab.c"
in_kit -B build/grader/base/files.o BUILD=build
[[ $status == 0 && $(wc -l <<<"$out") -le 2 && $out == *"building the programs"* ]] && ok || bad "the kit builds in silence" "$out"
grade=$root/$BUILD/grade
grades --lab 03 --seed 2 --trusted "$kit/build/lab-03.tar.gz"
expect "what was packed is graded" 1 "0.00 of 100 points"
[[ $out != *"! "* ]] && ok || bad "what was packed is whole" "$out"

# In a folder with spaces and letters that are not ASCII.
mv "$kit" "$work/Schatten-Übung (neu)" && kit="$work/Schatten-Übung (neu)"
grade=$kit/build/grade
grades --lab 03 --seed 2 --trusted "$right"
expect "a folder with spaces" 0 "100.00 of 100 points"
if [[ -x $BUILD/record_study ]]; then
    run "$kit/grader/scripts/study_page" build 03 "$right"
    expect "the study there" 0 "your least error"
fi

finish
