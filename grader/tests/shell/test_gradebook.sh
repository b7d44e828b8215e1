#!/usr/bin/env bash
# The gradebook of a class: the list of students, overrides, lateness, what is graded again. One small class is graded once.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
class=$work/class output=$work/out
moodle() { echo "$class/$1_$2_assignsubmission_file_"; }
mkdir -p "$(moodle "Ann Lee" 101)" "$(moodle "Zoë Ñandú" 102)" "$(moodle "Bo O'Brien" 103)" "$class/guest"
for to in "Ann Lee_101" "Zoë Ñandú_102"; do cp -r "$(solved right)"/03-* "$class/${to}_assignsubmission_file_"; done
cp -r labs/03-shadow-map "$(moodle "Bo O'Brien" 103)"
cp -r labs/03-shadow-map "$class/guest"
find "$class" -type f -exec touch -d '2026-11-05 12:00' {} +
cat >"$work/roster.csv" <<'CSV'
Surname;First name;ID number;Email address
Lee;Ann;00101;ann@example.org
Ñandú;Zoë;;zoe@example.org
"O'Brien";Bo;103;bo@example.org
"=Cmd()";;104;eve@example.org
CSV
gather() { grades --class "$class" --output "$output" --gather "$@"; }
row() { python3 - "$output/grades.csv" "$@" <<'PYTHON'
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1], newline="", encoding="utf-8")))
found = [row for row in rows if sys.argv[2] in (row["student"], row["id"], row["submission"])]
print(len(found), *[found[0][key] if found else None for key in sys.argv[3:]], sep="|")
PYTHON
}
is() { [[ $2 == "$3" ]] && ok || bad "$1" "$2, not $3"; }

# A class with a list: everybody has a row, by number or by name, and the means are of those who handed in.
grades --class "$class" --output "$output" --lab 03 --seed 4 --roster "$work/roster.csv" --copies
expect "a class with a list, and copies in the same run" 0 "pairs of hand-ins have code in common" 'roster: "guest": not on the roster' "1 of 4 handed in nothing" "4 submissions, 0 not graded"
is "by number, without zeros" "$(row "Ann Lee" "lab 03" status id note)" "1|100.00|passed|00101|"
is "by name, with accents" "$(row "Zoë Ñandú" "lab 03" id)" "1|100.00|zoe@example.org"
is "who handed in nothing" "$(row 104 student "lab 03" total status submission)" "1|'=Cmd()|||not handed in|"
is "who is not on the list" "$(row guest "lab 03" status note)" "1|0.00|failed|not on the roster"
grep -q '4 submissions, 4 graded, 0 not graded, 1 students handed in nothing' "$output/index.html" && ok || bad "the page counts" "$(grep submissions "$output/index.html")"
gather
expect "OUT keeps the list" 0 "1 of 4 handed in nothing" "2 hand-ins have predictions with the sheet of somebody else"
sheets() { sed -n '/<h2>One sheet of predictions/,/<\/table>/p' "$output/index.html" | grep -oE '>(Ann Lee|Zoë Ñandú|guest)</a>' | tr -d '\n'; }
is "whose predictions have one sheet" "$(sheets)" ">Ann Lee</a>>Zoë Ñandú</a>"
sed -i 's/"sheet": [1-9][0-9]*/"sheet": 77/' "$output"/results/Zo*.json "$output"/results/guest*.json # as if each had drawn his own
gather
[[ $out != *sheet* && -z $(sheets) ]] && ok || bad "everybody's own sheet" "$out"

# A dry run looks at the class and at the run, and changes nothing.
state() { find "$output" "$class" -type f -exec md5sum {} + | sort; }
dry() { grades --class "$class" "$@" --dry-run; }
was=$(state)
dry --output "$output" --resume --lab 03
expect "a dry run of what is graded" 1 "Ann Lee (00101): Ann Lee_101_assignsubmission_file_" "was graded, 100.00 points: stays" "lab 03: 03-shadow-map: lab.c, shadow.frag" \
    "! not on the roster" "handed in nothing: =Cmd()" "4 hand-ins: 0 to be graded, 0 graded again, 4 stay; 1 need a look (!); 1 of 4 on the list handed in nothing."
printf '{"due": {"03": "2026-11-02 10:00"}, "percent a day": 10}' >"$work/dry.json"
echo '// more' >>"$class/guest/03-shadow-map/lab.c"
dry --output "$output" --resume --due "$work/dry.json"
expect "a dry run of what changed" 1 "lab 03: 03-shadow-map (4 days late): lab.c, shadow.frag" "was graded, 0.00 points: again, with another submission" \
    "handed in $(date -d '2026-11-05 12:00' '+%Y-%m-%d %H:%M:%S %z'), by the files' times, which a student can set" "0 to be graded, 1 graded again, 3 stay"
sed -i '$d' "$class/guest/03-shadow-map/lab.c" && touch -d '2026-11-05 12:00' "$class/guest/03-shadow-map/lab.c"
[[ $(state) == "$was" ]] && ok || bad "a dry run writes" "$(diff <(state) <(echo "$was"))"
dry --output "$output"
expect "a dry run says what the run would" 3 "holds a class run already"
dry --lab 03
expect "a dry run without an output" 0 "4 hand-ins: 4 to be graded; 0 need a look (!). Nothing was graded or written."
dry --lab 04 --only guest
expect "a lab that nobody handed in" 1 "1 hand-ins" "! not handed in: there is no folder 04-acne-and-bias"
dry --lab 03 --only nobody
expect "a dry run of nobody" 3 'holds no submission "nobody"'
dry --lab 03 --output "$work/never" --roster "$work/roster.csv"
[[ $status == 1 && ! -e $work/never && $out == *"1 of 4 on the list handed in nothing"* ]] && ok || bad "a dry run makes the output" "$out"
for with in --gather --list --copies "--export canvas" "--anonymous $work/x"; do
    dry --output "$output" $with
    expect "a dry run and $with" 2 "--dry-run writes nothing"
done
odd=$work/odd
mkdir -p "$odd"/$'new\nline\e[31m' "$odd/deep/a/b/c/d/e/f/g/h/i/j/k/l/m/03-shadow-map" "$odd/empty" "$odd/named/03-shadow-map" "$odd/two/03-shadow-map" "$odd/two/copy/03-shadow-map"
mkfifo "$odd/pipe" "$odd/two/03-shadow-map/pipe" && ln -s /nowhere "$odd/dead" && ln -s /etc "$odd/link" && echo "no archive" >"$odd/bad.zip" && : >"$odd/empty.tar"
for to in $'new\nline\e[31m' deep/a/b/c/d/e/f/g/h/i/j/k/l/m/03-shadow-map two/03-shadow-map two/copy/03-shadow-map; do cp labs/03-shadow-map/{lab.c,shadow.frag} "$odd/$to"; done
ln "$odd/two/03-shadow-map/lab.c" "$odd/two/03-shadow-map/same.c"
grades --class "$odd" --lab 03 --dry-run
expect "odd hand-ins, looked at" 1 'new\x0aline\x1b[31m: new\x0aline\x1b[31m' "more than 12 folders deep nothing was looked for" "empty: empty" "! lab.c" "lab 03 is there twice" \
    "lab.c is a hard link to another file" "ignored: pipe (not a file of this lab)" "ignored: pipe: is neither" "ignored: dead: is neither" "! the archive" "ignored: link: is neither"
LC_ALL=C grep -q $'[\x1b]' <<<"$out" && bad "bytes of a name reach the terminal" || ok
mkdir "$work/nobody-here"
grades --class "$work/nobody-here" --lab 03 --dry-run
expect "an empty class" 3 "holds no folder and no archive"

# The log, and what is graded again: what changed, and only that.
grep -qE '^[0-9-]+ [0-9:]+ Ann Lee_101_assignsubmission_file_: 100.00 of 100$' "$output/log" && ok || bad "the log" "$(cat "$output/log")"
again() { grades --class "$class" --output "$output" --resume; }
seed_of() { sed -n 's/^ *"seed": "\([0-9]*\)".*/\1/p' "$output/results/$1"*.json; } # of the exam that a hand-in met
first=$(seed_of guest)
[[ $first && $first == "$(seed_of Bo)" ]] && ok || bad "who hands in together meets one exam"
again
[[ $status == 0 && $out != *again* ]] && ok || bad "nothing changed: nothing is graded again" "$out"
cp solutions/03-shadow-map/{lab.c,shadow.frag,predictions.txt} "$class/guest/03-shadow-map"
again
expect "another submission" 0 "graded again: 1 with another submission than when they were graded"
is "it is graded anew" "$(row guest "lab 03")" "1|100.00"
[[ $(seed_of guest) != "$first" ]] && ok || bad "who hands in again meets an exam that he may have seen"
touch "$class"/guest/03-shadow-map/* && mkdir -p "$class/guest/.git" && echo x >"$class/guest/.git/index"
again
[[ $out != *again* ]] && ok || bad "times and version control are no change" "$out"
python3 - "$output" <<'PYTHON'
import glob, json, sys
for path in glob.glob(sys.argv[1] + "/results/*.json"):
    record = json.load(open(path))
    if record["submission"].startswith("Ann"):
        record["made_of"]["rubrics"]["03"] = "0" * 16
    if record["submission"].startswith("Bo"):
        record["made_of"]["grader"] = "0" * 16
    json.dump(record, open(path, "w"))
PYTHON
gather
expect "rubrics are not mixed in silence" 0 "2 were graded with another rubric of lab 03 than today's"
is "the row says it, too" "$(row "Ann Lee" note)" "1|graded with another rubric of lab 03 than today's: --resume grades it again"
again
expect "another rubric, another grader" 0 "graded again: 1 with another rubric of lab 03" "graded again: 1 with another grader"
gather
[[ $out != *today* ]] && ok || bad "all are of one rubric again" "$out"
cp labs/03-shadow-map/{lab.c,shadow.frag,predictions.txt} "$class/guest/03-shadow-map"
grades --class "$class" --output "$output" --only guest
is "--only makes the tables, too" "$(row guest "lab 03")" "1|0.00"
[[ $(seed_of guest) == "$first" && $(seed_of Ann) == "$first" && $(seed_of Bo) == "$first" ]] && ok || bad "what has not changed meets another exam"

# What people decide stands beside what was measured.
cat >"$work/overrides.csv" <<'CSV'
student,lab,check,points,note
bo@example.org,03,,42.5,"shown in class; ""late"" bus"
104,Lab 3,,10,oral
CSV
gather --overrides "$work/overrides.csv"
expect "overrides" 0
is "points by hand" "$(row 103 "lab 03" total "lab 03 measured" status note)" '1|42.50|42.50|0.00|failed|lab 03: 42.50 instead of 0.00: shown in class; "late" bus'
is "points for who handed in nothing" "$(row 104 "lab 03" "lab 03 measured" total)" "1|10.00||10.00"
check=$(python3 -c 'import json,glob,sys; r=json.load(open(glob.glob(sys.argv[1])[0])); c=r["report"]["labs"][0]["checks"][0]; print(c["name"], c["max_score"], sep="|")' "$output/results/AnnLee*.json")
printf 'student\tlab\tpoints\tcheck\tnote\nAnn Lee\t3\t1,5\t%s\tcopied\n' "${check%|*}" >"$work/checks.csv"
gather --overrides "$work/checks.csv"
is "points of a check" "$(row "Ann Lee" "lab 03" "lab 03 measured")" "1|$(python3 -c "print(f'{100 - ${check#*|} + 1.5:.2f}')")|100.00"
rm "$output/overrides.csv"

# Lateness: three days after the date and two hours, of them one free.
late() { printf '{"due": {"03": "2026-11-02 10:00"}, "percent a day": 10%s}' "$1" >"$work/late.json"; gather --due "$work/late.json"; }
late ', "free days": 1'
is "late days" "$(row "Ann Lee" "lab 03" "lab 03 measured" note)" "1|70.00|100.00|lab 03: 4 days late by the files' times, 1 of them free: 30.00 points off"
expect "whose times are trusted" 0 "due: of 4 only the files' times tell when they were handed in"
is "each row says it" "$(row "Ann Lee" "handed in" "time by")" "1|$(date -d '2026-11-05 12:00' '+%Y-%m-%d %H:%M:%S %z')|files"
is "who handed in nothing has no time" "$(row 104 "handed in" "time by")" "1||"
grep -q "When 4 of them were handed in is known by the files' times only" "$output/index.html" && ok || bad "the page says it"
late ', "at most percent": 25'
is "at most" "$(row "Ann Lee" "lab 03")" "1|75.00"
late ', "grace minutes": 120'
is "grace" "$(row "Ann Lee" "lab 03")" "1|70.00"
printf 'student,lab,late,note\n101,03,0,ill\n' >"$work/overrides.csv"
gather --overrides "$work/overrides.csv"
is "days by hand" "$(row "Ann Lee" "lab 03")" "1|100.00"
printf 'student,lab,late,note\n101,03,2,ill\n' >"$work/overrides.csv"
gather --overrides "$work/overrides.csv"
is "days by hand are by no clock" "$(row "Ann Lee" note)" "1|lab 03: 2 days late, 0 of them free: 20.00 points off"
rm "$output"/{overrides.csv,due.json}
sed 's/^\(Surname.*\)/\1;Last modified (submission)/; s/ann@.*/&;"Monday, 2 November 2026, 9:59 AM"/; s/zoe@.*/&;2026-11-02 10:00:01/; s/bo@.*/&;-/' "$work/roster.csv" >"$work/times.csv"
late ''
gather --roster "$work/times.csv"
is "the list's time counts: in time" "$(row "Ann Lee" "lab 03")" "1|100.00"
is "the list's time counts: a second late" "$(row zoe@example.org "lab 03")" "1|90.00"
is "by the list" "$(row "Ann Lee" "time by")" "1|list"
expect "of whom the list says nothing" 0 "due: of 2 only the files' times"
rm "$output/due.json"

# What learning systems import, field by field, and a page a student named by id.
printf '{"due": {"03": "2026-11-05 11:00"}, "percent a day": 10}' >"$work/due.json"
gather --roster "$work/roster.csv" --due "$work/due.json" --export canvas --export moodle --export gradescope --export sqlite
expect "exports" 0
python3 - "$output/export" "$output" <<'PYTHON' && ok || bad "exports, field by field"
import csv, os, pathlib, sqlite3, sys
out = pathlib.Path(sys.argv[1])
read = lambda name: list(csv.reader(open(out / name, newline="", encoding="utf-8")))
canvas = read("canvas.csv")
lab = canvas[0][5]
assert canvas[0][:5] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"] and lab.startswith("Lab 03: "), canvas[0]
assert canvas[1] == ["    Points Possible", "", "", "", "", "100.00"], canvas[1]
assert sorted(canvas[2:]) == sorted([
    ["Lee, Ann", "101", "00101", "ann@example.org", "", "90.00"],
    ["Ñandú, Zoë", "102", "", "zoe@example.org", "", "90.00"],
    ["O'Brien, Bo", "103", "103", "bo@example.org", "", "0.00"],
    ["'=Cmd(), ", "", "104", "eve@example.org", "", ""]]), canvas
moodle = read("moodle.csv")
assert moodle[0] == ["Full name", "ID number", "Email address", lab], moodle[0]
assert moodle[1:][-1] == ["'=Cmd()", "104", "eve@example.org", ""] and ["Ann Lee", "00101", "ann@example.org", "90.00"] in moodle, moodle
scope = read("gradescope.csv")
assert scope[0] == ["First Name", "Last Name", "SID", "Email", "Sections", lab, f"{lab} - Max Points", f"{lab} - Submission Time",
                    f"{lab} - Lateness (H:M:S)", "Total Lateness (H:M:S)"], scope[0]
ann = next(row for row in scope if row[0] == "Ann")
assert ann[1:7] == ["Lee", "00101", "ann@example.org", "", "90.00", "100.00"], ann
late = ann[8]
assert ann[7].startswith("2026-11-05 12:00:00 ") and late == ann[9] == "01:00:00", ann
assert scope[-1][5:] == ["", "100.00", "", "00:00:00", "00:00:00"], scope[-1]
assert all(len(row) == len(table[0]) for table in (canvas, moodle, scope) for row in table)
base = sqlite3.connect(out / "grades.sqlite")
ask = lambda text: base.execute(text).fetchall()
assert ask("SELECT name, id, status, total FROM student WHERE submission = ''") == [("=Cmd()", "104", "not handed in", None)]
assert ask("SELECT name, points, measured, maximum, late_days, taken FROM student JOIN grade USING (student) WHERE id = '00101'") == [("Ann Lee", 90, 100, 100, 1, 10)]
assert ask("SELECT sum(points) FROM student JOIN \"check\" USING (student) WHERE id = '00101'") == [(100,)]
assert ask("SELECT count(*) FROM \"check\" WHERE mistake <> ''")[0][0] > 5 and ask("SELECT lab FROM lab") == [("03",)]
assert ask("SELECT count(*) FROM student") == [(5,)] and ask("PRAGMA integrity_check") == [("ok",)]
assert sorted(os.listdir(out / "feedback")) == ["00101.html", "103.html", "zoe@example.org.html"], os.listdir(out / "feedback")
assert sorted(os.listdir(out)) == ["canvas.csv", "feedback", "grades.sqlite", "gradescope.csv", "moodle.csv"], os.listdir(out)
PYTHON
rm "$output/due.json"
printf 'Identifier,"Full name","Email address",Status,Grade,"Maximum Grade","Feedback comments"\nParticipant 101,Ann Lee,a@x,"Submitted, late",,"100,00",\nParticipant 7,Cy,c@x,-,,"100,00",\n' >"$work/sheet.csv"
gather --roster "$work/sheet.csv" --export moodle
is "Moodle's worksheet comes back with the grade" "$(cat "$output/export/moodle-worksheet.csv")" '"Identifier","Full name","Email address","Status","Grade","Maximum Grade","Feedback comments"
"Participant 101","Ann Lee","a@x","Submitted, late",100.00,"100,00",""
"Participant 7","Cy","c@x","-","","100,00",""'
printf 'Student,ID,SIS User ID,SIS Login ID,Section,"Lab 3 (77)"\n    Points Possible,,,,,100\n"Lee, Ann",101,u1,alee,A,\n' >"$work/canvas.csv"
gather --roster "$work/canvas.csv" --export canvas
is "an assignment of Canvas keeps its name" "$(sed -n '1p;3p' "$output/export/canvas.csv")" 'Student,ID,SIS User ID,SIS Login ID,Section,"Lab 3 (77)"
"Lee, Ann","101","u1","alee","A",100.00'
grades --class "$class" --output "$output" --gather --export excel
expect "an unknown system" 2 'takes canvas, moodle, gradescope or sqlite, not "excel"'

# Without names, and without points.
gather --roster "$work/roster.csv" --anonymous "$work/secret.csv" --no-points
expect "anonymous pages" 0
named=$(cat "$output"/anonymous/*.* "$output"/anonymous/pages/* | sed -E 's/base64,[A-Za-z0-9+\/=]*//g' | grep -oiE '.{0,20}(lee|ñandú|zoë|brien|cmd|example.org|10[1-4]_|guest).{0,20}')
[[ -z $named ]] && ok || bad "a name is left" "$named"
is "a page each" "$(ls "$output/anonymous/pages" | wc -l) $(ls "$output/anonymous/pages" | grep -cE '^s-[0-9a-f]{8}.html$')" "4 4"
grep -rqE '[0-9.]+ of [0-9]+ ?(points|<)|<meter' "$output/anonymous/pages" && bad "points are left" "$(grep -rohE '.{30}of [0-9]+.{20}' "$output/anonymous/pages" | head -5)" || ok
grep -q 'is not done' "$output"/anonymous/pages/*.html && ok || bad "the hints are left out, too"
is "who may read the secret" "$(stat -c %a "$work/secret.csv")" 600
cp "$output/anonymous/grades.csv" "$work/before.csv" && cp "$work/secret.csv" "$work/secret-before.csv"
gather --anonymous "$work/secret.csv"
cmp -s "$work/before.csv" "$output/anonymous/grades.csv" && cmp -s "$work/secret.csv" "$work/secret-before.csv" && ok || bad "pseudonyms stay" "$(diff "$work/before.csv" "$output/anonymous/grades.csv")"
grep -q '<meter' "$output"/anonymous/pages/*.html && ok || bad "with points unless asked"
[[ $(sed 1d "$work/before.csv") == "$(sed 1d "$work/before.csv" | sort)" ]] && ok || bad "the order tells names" "$(cat "$work/before.csv")"
gather --anonymous "$work/roster.csv"
expect "no pseudonyms" 3 "roster.csv:1: these are no pseudonyms"
gather --no-points
expect "points of what" 2 "--no-points goes with --export or --anonymous"
sed -i 's/<!--points-->//g' "$output"/pages/Ann*.html
gather --export canvas --no-points
expect "pages of an older grader" 3 "was made by an older grader"
grades --class "$class" --output "$output" --only "Ann Lee_101_assignsubmission_file_"

# Copies: found with other names, comments and layout; the skeleton's code and that of other people is none.
mkdir -p "$work/pairs"/{one,two,other,skeleton,empty}
cp -r solutions/03-shadow-map "$work/pairs/one" && cp -r labs/03-shadow-map "$work/pairs/skeleton"
cp -r solutions/03-shadow-map "$work/pairs/two" && cp -r labs/03-shadow-map "$work/pairs/other"
rm -f "$work"/pairs/*/*/{scenes,study,rows,witness}*.[ch]
sed -i -E 's/\<(frame|pass|light|bias|visibility|depth|lit)\>/my_\1/g; s/^( *)([a-z])/\1 \1\2/; s/;$/; \/\/ mine/' "$work"/pairs/two/03-shadow-map/{lab.c,shadow.frag}
python3 - "$work/pairs/other/03-shadow-map/shadow.frag" <<'PYTHON'
import sys
with open(sys.argv[1], "a") as file:
    file.write("float f(float x) {\n" + "".join(f"    x = x * {i}.5 + sqrt(x - {i * i}.25) / {i + 3}.0;\n" for i in range(20)) + "    return x;\n}\n")
PYTHON
grades --class "$work/pairs" --output "$work/pairs-out" --lab 03 --only empty --copies
expect "copies" 0 "1 pairs of hand-ins have code in common"
is "the pair" "$(cat "$work/pairs-out/copies.csv")" 'lab,percent,equal,first,second
03,100,all but names,"one","two"'
copies() { grades --class "$work/pairs" --output "$work/pairs-out" --gather --copies; }
grep -q 'Code in common' "$work/pairs-out/index.html" && grep -qE '<td>03</td><td class="number">100</td><td>all but names</td><td class="name">one</td>' "$work/pairs-out/index.html" && ok ||
    bad "the page shows the pair" "$(grep -A12 'Code in common' "$work/pairs-out/index.html")"
cp -r "$work/pairs/one" "$work/pairs/wrong name" && sed -i 's/\<frame\>/frames/' "$work/pairs/wrong name/03-shadow-map/lab.c"
cp -r "$work/pairs/one" "$work/pairs/<b>&same" && sed -i 's/$/ \/\/ mine/' "$work/pairs/<b>&same/03-shadow-map/lab.c"
copies
is "word for word comes before all but names" "$(sed -n '2p' "$work/pairs-out/copies.csv")" '03,100,every word,"<b>&same","one"'
(($(grep -c 'all but names' "$work/pairs-out/copies.csv") >= 3)) && ok || bad "a wrong name" "$(cat "$work/pairs-out/copies.csv")"
grep -q '<td class="name">&lt;b&gt;&amp;same</td>' "$work/pairs-out/index.html" && ! grep -q '<b>&same' "$work/pairs-out/index.html" && ok || bad "names of pairs are escaped"
grades --class "$work/pairs" --output "$work/pairs-out" --gather
grep -q 'Code in common' "$work/pairs-out/index.html" && bad "pairs of an earlier run are not shown as today's" || ok
grades --class "$work/pairs" --output "$work/pairs-out" --gather --copies --anonymous "$work/pairs-secret.csv"
grep -q 'Code in common' "$work/pairs-out/anonymous/index.html" && bad "pairs on the anonymous page" || ok

# Two outputs side by side.
cp -r "$output" "$work/newer"
python3 - "$work/newer" <<'PYTHON'
import glob, json, sys
for path in glob.glob(sys.argv[1] + "/results/*.json"):
    record = json.load(open(path))
    if record["submission"].startswith("Ann"):
        lab = record["report"]["labs"][0]
        lab["checks"][1]["score"] -= 2.25
        lab["score"] = record["report"]["score"] = 97.75
    if record["submission"] == "guest":
        record.update(graded=False, reason="no room", report=None)
    json.dump(record, open(path, "w"))
PYTHON
check=$(python3 -c 'import json,glob,sys; c=json.load(open(glob.glob(sys.argv[1])[0]))["report"]["labs"][0]["checks"][1]; print(c["name"], "|", c["max_score"], sep="")' "$output/results/AnnLee*.json")
grades --compare "$output" "$work/newer" --output "$work/changes"
points() { python3 -c "print(f'{${check#*|} - $1:.2f}')"; }
expect "two outputs" 0 "Ann Lee_101_assignsubmission_file_: 100.00 -> 97.75 (-2.25)" "lab 03, ${check%|*}: $(points 0) -> $(points 2.25)" \
    "guest: graded only in the first" "3 graded in both: 0 have more points, 1 fewer; the mean was 66.67 and is 65.92"
is "the same as CSV" "$(sed 1d "$work/changes/changes.csv" | cut -d, -f2-)" "$(printf '03,"%s",%s,%s,-2.25\n03,"",100.00,97.75,-2.25' "${check%|*}" "$(points 0)" "$(points 2.25)")"
grades --compare "$output" "$output"
expect "an output and itself" 0 "4 graded in both: 0 have more points, 0 fewer"
grades --compare "$output" "$class"
expect "no output" 3 "holds no results of a class run"
grades --compare "$output"
expect "one output" 2 "--compare takes two folders"
grades --compare "$output" "$work/nowhere"
expect "no folder" 2 "nowhere is not a folder"

# What cannot be read names the file, the line and what to do, and nothing is graded.
refuses() { # OPTION NAME TEXT PATTERN...: the content of the file, printf's way
    printf "$3" >"$work/bad.csv"
    grades --class "$class" --output "$work/none" "--$1" "$work/bad.csv"
    expect "$1: $2" 2 "bad.csv" "${@:4}"
    [[ ! -e $work/none ]] || bad "$1: $2: something was written"
}
refuses roster "empty" '' "bad.csv:1: the file is empty"
refuses roster "only heads" 'id,name\n' "bad.csv:1: below the heads there is no student"
refuses roster "no column" 'grade,points\n1,2\n' "bad.csv:1: no column tells who the students are"
refuses roster "twice" 'id,name\n1,A\n\n2,B\n01,C\n1,D\n' 'bad.csv:6: "1" stands already in line 2'
refuses roster "a mail twice" 'mail\na@b\nA@B\n' 'bad.csv:3: "A@B" stands already in line 2'
refuses roster "nobody" 'id,name,group\n1,A,x\n,,y\n' "bad.csv:3: the row names nobody"
refuses roster "an open quote" 'id,name\n1,"A\n2,B\n' "bad.csv:2: a quote is opened here and never closed"
refuses roster "too many cells" 'id,name\n1,Lee, Ann\n' "bad.csv:2: 3 cells below 2 heads" "quotes"
refuses roster "Latin-1" 'id,name\n1,Zo\xeb\n' "bad.csv:2: the text is not UTF-8"
refuses roster "UTF-16" '\xff\xfei\0d\0' "UTF-16: save it as UTF-8"
refuses roster "a zero byte" 'id\n1\0\n' "byte 0"
refuses roster "two columns of one name" 'Id,Id\n1,2\n' 'bad.csv:1: two columns are named "Id" (columns 1 and 2)'
refuses roster "a title above" 'Graphics 2026\n\nid,name\n1,A\n' "bad.csv:3: 2 cells, but the first line has one: remove the lines above"
refuses roster "a rounded number" 'id,name\n1,A\n1.23457E+11,B\n' 'bad.csv:3: "1.23457E+11" is what a spreadsheet has left' "as text"
refuses roster "a web page" '<html><table>\n' "bad.csv is a document" "plain text"
refuses roster "no time" 'id,submitted\n1,yesterday\n' 'bad.csv:2: "yesterday" is no time'
refuses overrides "no note column" 'student,lab,points\n' "the column note is missing"
refuses overrides "two notes" 'student,note,lab,points,note\nA,,3,1,x\n' 'two columns are named "note" (columns 2 and 5)'
refuses overrides "no note" 'student,lab,points,note\nA,3,1,\n' "bad.csv:2: the note is empty"
refuses overrides "no points" 'student,lab,points,note\nA,3,many,x\n' '"many" are no points'
refuses overrides "negative points" 'student,lab,points,note\nA,3,-1,x\n' '"-1" are no points'
refuses overrides "no lab" 'student,lab,points,note\nA,three,1,x\n' '"three" is no lab'
refuses overrides "twice" 'student,lab,points,note\nA,3,1,x\na,03,2,y\n' "bad.csv:3: the same stands already in line 2"
refuses due "no JSON" '{' "bad.csv:1:"
refuses due "no date" '{"due": {"03": "soon"}, "percent a day": 1}' 'lab 03: "soon" is no time: write one as "2026-11-03 23:59"'
refuses due "the 31st of November" '{"due": {"03": "2026-11-31 23:59"}, "percent a day": 1}' '"2026-11-31 23:59" is no time'
refuses due "a year of two digits" '{"due": {"03": "3.11.26 23:59"}, "percent a day": 1}' '"3.11.26 23:59" is no time'
refuses due "another lab" '{"due": {"98": "2026-11-03 23:59"}, "percent a day": 1}' "there is no lab 98"
refuses due "a share" '{"due": {"03": "2026-11-03 23:59"}, "percent a day": 0.1}' "less than one percent: for ten percent write 10"
refuses due "a comma too many" '{"due": {"03": "2026-11-03 23:59",}, "percent a day": 1}' "bad.csv:1:" "a comma too many"
refuses due "a comment" '// late\n{}' "bad.csv:1:" "no comments"
refuses due "round quotes" '{“due”: {}}' "bad.csv:1:" "straight double quotes"
refuses due "no lab" '{"due": {"3": "2026-11-03 23:59"}, "percent a day": 1}' 'write its number, as "03"'
refuses due "too much" '{"due": {"03": "2026-11-03 23:59"}, "percent a day": 101}' "percent a day"
grades --class "$class" --output "$work/none" --roster "$work/nowhere.csv"
expect "no list" 2 "nowhere.csv cannot be read"
grades --roster "$work/roster.csv" labs
expect "a list without a class" 2 "go with --class"
printf 'student,lab,points,note\nNobody,3,1,x\n' >"$work/bad.csv"
gather --overrides "$work/bad.csv"
expect "an override of nobody" 3 'overrides.csv:2: there is no student "Nobody"'
rm "$output/overrides.csv"

# Lists as they come: each has Ann Lee as its only student who handed in.
lists() { # NAME TEXT: printf's way
    printf "$2" >"$work/list.csv"
    gather --roster "$work/list.csv"
    [[ $status == 0 && $(row "Ann Lee_101_assignsubmission_file_" note) == "1|" ]] && ok || bad "a list: $1" "$out$(cat "$output/grades.csv")"
}
lists "a mark, semicolons, CRLF" '\xef\xbb\xbfName;Matrikelnummer\r\nLee, Ann;101\r\n'
lists "CR alone" 'id\r101\r'
lists "sep=, tabs" 'sep=;\nid;name\n101;Ann\n'
lists "Canvas" 'Student,ID,SIS User ID,SIS Login ID,Section,"Lab 03 (77)"\n"    Points Possible",,,,,100\n"Lee, Ann",7,101,alee,A,\n"Student, Test",9,,x,A,\n'
lists "Moodle's worksheet" 'Identifier,Full name,Email address,Status,Grade\nParticipant 101,A. Lee,a@b.c,-,\n'
lists "only names, one composed of marks" 'name\nAnn Le\xcc\x81e\n'
lists "quotes and a line break inside" '"id","name"\n"101","Ann ""A.""\nLee"\n'
lists "wide spaces" 'id,name\n \xc2\xa0101 ,Ann\n'
lists "Gradescope" 'First Name,Last Name,SID,Email,Sections\nAnn,Lee,101,a@b.c,\n'
lists "Name beside Vorname" 'Name;Vorname;Matrikel-Nr.\nLee;Ann;\n'
lists "Moodle in German" 'ID;Vollst\xc3\xa4ndiger Name;Status\nTeilnehmer/in101;A. L.;-\n'
lists "a column of decimals, a text of a spreadsheet, spaces between digits" 'id,user,number\n101.0,x,\n"=""00102""",y,\n1\xc2\xa0030,z,\n'
lists "7 and 007" 'id\n101\n0101\n'
lists "empty lines and short rows" '\n\nid,name,mail\n\n101\n,,\n'
python3 - "$work/list.csv" <<'PYTHON'
import sys
with open(sys.argv[1], "w") as file:
    print("id,name", *(f"{i},Student {i}" for i in range(101, 10101)), sep="\n", file=file)
PYTHON
gather --roster "$work/list.csv"
[[ $status == 0 && $(wc -l <"$output/grades.csv") == 10002 ]] && ok || bad "10,000 students" "$(wc -l "$output/grades.csv")"
printf 'name,id\nAnn Lee,\nAnn Lee,7\nLee Ann,8\n' >"$work/list.csv"
gather --roster "$work/list.csv"
expect "two of one name" 0 "several on the roster have this name"

finish
