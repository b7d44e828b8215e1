#!/usr/bin/env bash
# Classes: odd names, killed and resumed runs, faults of ours, the CSV, the pages and the JSON.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
class=$work/class seed=11
grader/tests/helpers/make_class "$class" 14 03 3 >"$work/kinds" || bad "make_class"
rm -rf "${class:?}"/*not\ utf-8* "$class"/Zo* "$class"/😀* # noise, a crash and an endless loop: other tests have them
common=(--class "$class" --lab 03 --seed $seed)
times() { grep -vE '"(seconds|speed_ratio)"'; }
facts() { for file in "$1"/results/*.json; do basename "$file"; times <"$file"; done; cat "$1/grades.csv"; }

# A whole run, by two processes.
grades "${common[@]}" --output "$work/whole" -j 2
expect "a class" 0 "submissions, 0 not graded" "Ann Lee" "new\\x0aline"
[[ $(head -1 "$work/whole/grades.csv") == "submission,lab 03,total,status,student,id,late,reason" ]] && ok || bad "the head of grades.csv" "$(head -3 "$work/whole/grades.csv")"
rows=$(($(wc -l <"$work/whole/grades.csv") - 1))
[[ $rows == $(ls "$work"/whole/results | wc -l) && $rows == $(ls "$work"/whole/pages | wc -l) && $rows -ge 10 ]] && ok || bad "a row, a record and a page a submission" "$(ls -R "$work/whole")"
seeds() { sed -n 's/^ *"seed": "\([0-9]*\)".*/\1/p' "$1"/results/*.json | sort -u; }
[[ $(seeds "$work/whole" | wc -l) == 1 && $(ls "$work/whole/rounds") == 1 ]] && ok || bad "who hands in together meets one exam" "$(seeds "$work/whole")"
of() { # NAME PATTERN: the row of the submission
    grep -E "^\"$1(\.zip|\.tar\.gz)?\"," "$work/whole/grades.csv" | cut -d'"' -f3 | grep -qE "$2" && ok || bad "the grade of $1 is not $2" "$(cat "$work/whole/grades.csv")"
}
of "Ann Lee" '^,95\.00,95\.00,passed,$' # all but the predictions, which these hand-ins do not have
of "'=2\+3" '^,0\.00,0\.00,failed,$'
of "'@at" '^,95\.00,95\.00,passed,$'
of "new.x0aline" '^,0\.00,0\.00,failed,$'
of "é+" '^,0\.00,0\.00,failed,$' # links to the solution
python3 - "$work/whole/grades.csv" <<'PYTHON' && ok || bad "a spreadsheet runs no name"
import csv, sys
rows = list(csv.reader(open(sys.argv[1], newline="", encoding="utf-8")))
assert all(len(row) == 8 for row in rows) and not any(cell[:1] in "=+-@\t\r" for row in rows for cell in row if cell)
PYTHON

# A name with a semicolon, and an archive that is called as a message of ours: names are names. A mistake is counted by its
# kind, whole, also when its name has a semicolon.
mkdir -p "$work/odd/semi; colon" && cp -r labs/03-shadow-map "$work/odd/semi; colon"
printf 'no archive' >"$work/odd/the archive cannot be read; .zip"
grades --class "$work/odd" --output "$work/odd-out" --lab 03
expect "odd names" 0 "semi; colon: 0.00 of 100" "2 submissions, 0 not graded"
grep -q '"the archive cannot be read; .zip",0.00,0.00,failed' "$work/odd-out/grades.csv" && ok || bad "a bad archive is a 0" "$(cat "$work/odd-out/grades.csv")"
python3 - "$work/odd-out" <<'PYTHON'
import glob, json, sys
for path in glob.glob(sys.argv[1] + "/results/*.json"):
    record = json.load(open(path))
    for check in (record["report"] or {"labs": []})["labs"][0]["checks"] if record["report"] else []:
        if check["cause"]:
            check["cause"]["mistake"] = check["cause"]["kind"] = "first; second"
    json.dump(record, open(path, "w"))
PYTHON
grades --class "$work/odd" --output "$work/odd-out" --gather
grep -q '<td>first; second</td>' "$work/odd-out/index.html" && ok || bad "a mistake is cut at a semicolon" "$(grep -A3 'commonest' "$work/odd-out/index.html")"

# Killed three times at random moments and resumed, by other numbers of processes: the same bytes.
RANDOM=$seed
grades_killed() { # SECONDS ARGUMENTS...
    "$grade" "${@:2}" >/dev/null 2>&1 &
    local pid=$!
    sleep "$1"
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    (($? == 137)) && kills=$((kills + 1))
}
kills=0
for jobs in 1 3 2; do
    grades_killed "$((RANDOM % 3)).$((RANDOM % 10))" "${common[@]}" --output "$work/killed" -j $jobs --resume
done
((kills > 0)) && ok || bad "no run was killed"
before=$(ls "$work/killed/results" | wc -l)
stamps() { stat -c '%n %y' "$work"/killed/results/*.json 2>/dev/null; }
stamps >"$work/stamps"
grades "${common[@]}" --output "$work/killed" -j 2 --resume
expect "a run that was killed is resumed" 0 "submissions, 0 not graded"
cmp -s "$work/whole/grades.csv" "$work/killed/grades.csv" && ok || bad "killed and resumed: another grades.csv" "$(diff "$work/whole/grades.csv" "$work/killed/grades.csv")"
[[ $(facts "$work/whole") == "$(facts "$work/killed")" ]] && ok ||
    bad "killed and resumed: other records" "$(diff <(facts "$work/whole") <(facts "$work/killed"))"
stamps | comm -13 - "$work/stamps" | grep -q . && bad "what was finished before is graded again ($before were)" || ok
[[ -z $(find "$work/killed" -name '.new-*' -o -name work) ]] && ok || bad "a killed run leaves something" "$(find "$work/killed")"

# What goes on, and what does not.
grades "${common[@]}" --output "$work/whole"
expect "an OUT that is taken" 3 "holds a class run already" "--resume"
grades "${common[@]}" --output "$work/whole" --resume --seed 12
expect "another seed" 3 "was begun with --seed $seed"
grades --class "$class" --output "$work/whole" --resume --lab 04
expect "other labs" 3 "was begun with other labs"
grades "${common[@]}" --output "$work/whole" --only "nobody"
expect "nobody" 3 'holds no submission "nobody"'
echo torn >"$work/whole/results/$(ls "$work/whole/results" | head -1)"
grades "${common[@]}" --output "$work/whole" --resume
expect "a torn record is made again" 0 "done before"
cmp -s "$work/whole/grades.csv" "$work/killed/grades.csv" && ok || bad "after a torn record"
usage() { local name=$1 text=$2; shift 2; grades "$@"; expect "$name" 2 "$text"; }
usage "a class without OUT" "--class needs --output" --class "$class"
usage "a class and a submission" "there is no SUBMISSION" --class "$class" --output "$work/x" labs
usage "a class outside the jail" "in the jail only" --class "$class" --output "$work/x" --trusted
usage "no number of processes" "-j takes a number" --class "$class" --output "$work/x" -j many
usage "-j alone" "go with --class" -j 2 labs
usage "--dry-run alone" "go with --class" --dry-run labs

# One submission at a time, as a job array would: the same records.
mapfile -t names < <("$grade" --class "$class" --list)
[[ ${#names[@]} == "$rows" ]] && ok || bad "--list" "${names[*]}"
grades "${common[@]}" --output "$work/array" --only "${names[0]}" --only "${names[1]}" &
"$grade" "${common[@]}" --output "$work/array" --only "Ann Lee" >/dev/null 2>&1
wait
[[ $(seeds "$work/array") == "$(seeds "$work/whole")" ]] && ok || bad "tasks meet another exam" "$(seeds "$work/array")"
grades --class "$class" --output "$work/array" --gather
expect "some are missing" 3 "$((rows - 3)) not graded"
grep -q '^"Ann Lee",95.00,95.00,passed,' "$work/array/grades.csv" && grep -q ',,,not graded,' "$work/array/grades.csv" && ok || bad "gathered" "$(cat "$work/array/grades.csv")"

# Of two folders of a lab the one that has its name counts; a folder around it is stepped into.
mkdir -p "$work/two/both/wrapped" && cp -r labs/03-shadow-map "$work/two/both/wrapped/03-a-try"
cp -r solutions/03-shadow-map "$work/two/both/wrapped"
grades --class "$work/two" --output "$work/twice" --lab 03
expect "two folders of a lab" 0 "both: 100.00 of 100"

# A fault of ours is nobody's 0: here our own solution is broken. It is tried again once it is fixed.
mkdir -p "$work/home/build" "$work/few/one" && cp -r solutions/03-shadow-map "$work/few/one"
cp -r "$root"/{common,shaders,solutions,grader} "$work/home" && cp -r "$BUILD"/{grade,worker,jail_*,include,given} "$work/home/build"
sed -i 's/^#ifdef SOLUTION/int broken(;\n&/' "$work/home/solutions/03-shadow-map/lab.c"
grade=$work/home/build/grade
grades --class "$work/few" --output "$work/fault" --lab 03
expect "our own fault" 3 "one: not graded" "1 not graded" "--resume tries again"
[[ $(tail -1 "$work/fault/grades.csv") == '"one",,,not graded,"one",'* ]] && ok || bad "our fault is no grade" "$(cat "$work/fault/grades.csv")"
cp solutions/03-shadow-map/lab.c "$work/home/solutions/03-shadow-map/lab.c"
grades --class "$work/few" --output "$work/fault" --resume
expect "our fault, fixed" 0 "1 submissions, 0 not graded"
[[ $(tail -1 "$work/fault/grades.csv") == '"one",100.00,100.00,passed,'* ]] && ok || bad "graded after all" "$(cat "$work/fault/grades.csv")"
grade=$root/$BUILD/grade

# Who ignores the signal that the time is over is killed, and is still told of the time.
mkdir -p "$work/late/stubborn" && cp -r solutions/03-shadow-map "$work/late/stubborn"
sed -i 's|^static bool create(const Frame \*frame) {|#include <signal.h>\n&\n    signal(SIGXCPU, SIG_IGN);\n    for (volatile int i = 0;; i++)\n        ;|' \
    "$work"/late/stubborn/03-shadow-map/lab.c
grades --class "$work/late" --output "$work/late-out" --lab 03 --seed $seed --timeout 1
out+=$(cat "$work"/late-out/results/*.json)
expect "a loop that ignores SIGXCPU" 0 '"status": "timeout"' "it was stopped after 1 s: is there an endless loop?"

# The JSON fits its schemas; the schemas refuse what is wrong.
python3 - "$work/whole" <<'PYTHON' && ok || bad "records and class.json fit their schemas"
import glob, json, sys, jsonschema
load = lambda path: json.load(open(path))
lab, record, plan = load("grader/report/report.schema.json"), load("grader/class/record.schema.json"), load("grader/class/class.schema.json")
jsonschema.validate(load(f"{sys.argv[1]}/class.json"), plan)
for path in glob.glob(f"{sys.argv[1]}/results/*.json"):
    jsonschema.validate(load(path), record)
    jsonschema.validate(load(path)["report"], lab)
def refuses(schema, instance):
    try:
        jsonschema.validate(instance, schema)
    except jsonschema.ValidationError:
        return True
one = load(path)
assert refuses(plan, {}) and refuses(record, {**one, "graded": "yes"}) and refuses(record, {**one, "graded": True, "report": None})
PYTHON
for format in gradescope check50; do
    out=$("$grade" --lab 03 --seed 1 --trusted --format $format labs 2>/dev/null)
    python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(sys.stdin), json.load(open(sys.argv[1])))' "grader/report/$format.schema.json" <<<"$out" && ok || bad "$format fits its schema" "$out"
done

finish
