#!/usr/bin/env bash
# Hand-ins as people and learning systems pack them: each gets its points, under its student's name.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

chmod 755 "$work" # the jail's user goes through it
grader/tests/helpers/make_hand_ins "$work/class" >"$work/expected" || bad "make_hand_ins"

# A dry run finds the same in each, says what keeps it from being graded, and writes nothing.
listing() { { find "$work/class" -printf '%p %s %T@ %m\n'; find "$work/tmp" -mindepth 1; } | sort | md5sum; }
mkdir "$work/tmp" && chmod 755 "$work/tmp"
before=$(listing)
status=0
TMPDIR=$work/tmp "$grade" --class "$work/class" --lab 03 --dry-run --output "$work/class/out" >"$work/looked" 2>"$work/errors" || status=$?
out=$(tail -1 "$work/looked"; cat "$work/errors")
expect "a dry run" 1 "need a look (!)" "Nothing was graded or written."
[[ $(listing) == "$before" ]] && ok || bad "a dry run writes" "$(ls -R "$work/tmp")"
python3 - "$work" <<'PYTHON' >"$work/verdicts"
import pathlib, re, sys
work = pathlib.Path(sys.argv[1])
text = (work / "looked").read_text(encoding="utf-8")
blocks = {}
for block in re.split(r"\n(?=\S)", text):
    head, _, rest = block.partition("\n")
    blocks[head] = rest
for line in open(work / "expected", encoding="utf-8"):
    name, student, id, points, words = line.rstrip("\n").split("\t")
    if points == "-":
        print("ok" if any(head.startswith(f"ignored: {name}: ") and re.search(words, head) for head in blocks) else f"dry run: {name} is not ignored")
        continue
    rest = blocks.get(f"{student} ({id}): {name}" if id else f"{student}: {name}")
    if rest is None:
        print(f"dry run: {name}: no {student}, {id}")
        continue
    good = "    lab 03: " in rest and not re.search("^ +! (?!lab 03 is there twice)", rest, re.M)
    if words not in rest or (not good if points == "100" else good and words):
        print(f"dry run: {name}: {points} points, wanted {words!r}: {rest}")
    else:
        print("ok")
PYTHON
while read -r line; do
    [[ $line == ok ]] && ok || bad "$line"
done <"$work/verdicts"
mkdir "$work/class/out"
grades --class "$work/class" --lab 03 --seed 5 --output "$work/class/out"
expect "the class" 0 "0 not graded" '"out" is the output of the class run'
echo "$out" >"$work/said"
python3 - "$work" <<'PYTHON' >"$work/verdicts"
import csv, html, pathlib, re, sys
work = pathlib.Path(sys.argv[1])
rows = {row["submission"]: row for row in csv.DictReader(open(work / "class/out/grades.csv", newline="", encoding="utf-8"))}
pages = {}
for path in (work / "class/out/pages").glob("*.html"):
    text = html.unescape(re.sub(r"<[^>]*>", "", path.read_text()))
    for name in rows:
        if name in text[:400]:
            pages[name] = pages.get(name, "") + text
said = (work / "said").read_text()
for line in open(work / "expected", encoding="utf-8"):
    name, student, id, points, words = line.rstrip("\n").split("\t")
    row = rows.pop(name, None)
    if points == "-":
        print("ok" if row is None and re.search(re.escape(f'"{name}"') + ".*" + words, said) else f"{name}: must be ignored")
    elif row is None:
        print(f"{name}: has no row")
    elif (row["student"], row["id"]) != (student, id) or float(row["total"]) != float(points) or words not in pages.get(name, ""):
        print(f"{name}: {row['total']} points, not {points}; student {row['student']!r}, id {row['id']!r}; {row['reason']}; wanted {words!r}")
    else:
        print("ok")
for name in rows:
    print(f"{name}: a row that nobody expects")
PYTHON
while read -r line; do
    [[ $line == ok ]] && ok || bad "$line"
done <"$work/verdicts"
(($(grep -c . "$work/expected") >= 60)) && ok || bad "fewer than 60 hand-ins"
[[ $(grep -c ',late,"' "$work/class/out/grades.csv") == 1 ]] && ok || bad "who is late is said" "$(grep late "$work/class/out/grades.csv")"

# Each attempt, when asked for. A whole archive is graded alone, too.
grades --class "$work/class" --lab 03 --seed 5 --output "$work/all" --all-attempts --list
expect "all attempts" 0 "doemax"
(($(grep -c '^doemax' <<<"$out") == 2)) && ok || bad "each attempt has a name" "$out"
grades --lab 03 --seed 5 "$work/class/zip in zip.zip"
expect "one archive" 0 "100.00 of 100 points"
grades --lab 03 "$work/class/notes.txt"
expect "a file that is no archive" 2 "is not a folder"
finish
