#!/usr/bin/env bash
# The tables of grader/proof/, with programs in our place that measure nothing: the rows of the labs that are asked for are
# replaced, all others stay, a lab that is gone goes, and what an interrupted run has measured is there.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
copy=$work/copy
mkdir -p "$copy"/{build,grader/scripts,grader/proof,solutions/{01-a,02-b,03-c}}
cp "$root"/grader/scripts/{table,arguments} "$copy/grader/scripts"
cd "$copy" || exit 1
program() { # NAME COMMANDS...: what it does with $2, its lab
    { echo '#!/usr/bin/env bash'; printf '%s\n' "${@:2}"; } >"build/$1"
    chmod +x "build/$1"
}
table() { status=0; out=$(grader/scripts/table "$@" 2>&1 </dev/null) || status=$?; }
has() { # NAME PAGE ROWS: these stand between the page's words
    local rows
    rows=$(sed '1d;$d' "grader/proof/$2" | sed -n '3,$p' | grep '^|' | xargs -d'\n' | tr -d ' ')
    [[ $rows == "$3" && $(head -1 "grader/proof/$2") == before && $(tail -1 "grader/proof/$2") == after ]] && ok ||
        bad "$1" "$(cat "grader/proof/$2")"
}
page() { printf '%s\n' before "<!-- $2 -->" "${@:3}" "<!-- end of $2 -->" after >"grader/proof/$1"; }

page PROOFS.md rubrics "" "| lab | kind |" "|---|---|" "| 01 | old |" "| 01 | older |" "| 02 | old |" "| 09 | gone |" ""
program prove 'echo "| lab | kind |"; echo "|---|---|"; echo "| $2 | new |"; echo "| $2 | newer |"; echo "2 passed, 0 failed"'
table rubrics 2
expect "one lab" 0
has "one lab" PROOFS.md "|lab|kind||---|---||01|old||01|older||02|new||02|newer|"
table rubrics
has "all labs" PROOFS.md "|lab|kind||---|---||01|new||01|newer||02|new||02|newer||03|new||03|newer|"

program prove 'echo "| lab | kind |"; echo "|---|---|"; echo "| $2 | WRONG |"; exit 1'
table rubrics 03
expect "a rubric that is wrong" 1
has "a rubric that is wrong" PROOFS.md "|lab|kind||---|---||01|new||01|newer||02|new||02|newer||03|WRONG|"
program prove 'echo "| lab | kind |"; echo "|---|---|"; ((10#$2 != 2)) || exit 3; echo "| $2 | third |"'
table rubrics
[[ $status != 0 ]] && ok || bad "a lab that cannot be measured" "$out"
has "a lab that cannot be measured" PROOFS.md "|lab|kind||---|---||01|third||02|new||02|newer||03|third|"

page MUTANTS.md mutants "" "| lab | made | compiled | killed | equal | survived | % |" "|---|---|---|---|---|---|---|" \
    "| 01 | 20 | 10 | 9 | 1 | 0 | 100.0 |" "| all | 1 | 1 | 1 | 1 | 1 | 1 |"
program mutants 'echo "| lab | made | compiled | killed | equal | survived | % |"; echo "|---|---|---|---|---|---|---|"
    echo "survived: a change"; echo "| $2 | 20 | 10 | 5 | 0 | 5 | 50.0 |"; exit 1'
table mutants 03
expect "survivors" 0 "survived: a change"
has "the sum" MUTANTS.md "|lab|made|compiled|killed|equal|survived|%||---|---|---|---|---|---|---|\
|01|20|10|9|1|0|100.0||03|20|10|5|0|5|50.0||all|40|20|14|1|5|75.0|"
table mutants 04
expect "no such lab" 2 'there is no lab "04"; there are 01, 02, 03'

# ECONOMY.md: five objects more in a scene or in a row, a scene of no line, an object that changes nothing and has no reason.
gaps() { # NAME PATTERN: there is one more gap, which says so
    status=0 out=$(grader/scripts/economy_gaps scenes rows.json 2>&1) || status=$?
    [[ $status == 1 && $(wc -l <<<"$out") == 1 && $out == *"$2"* ]] && ok || bad "$1" "$out"
}
cp "$root/grader/scripts/economy_gaps" grader/scripts
cat >grader/proof/ECONOMY.md <<'END'
<!-- suite -->
| rows | objects | a row does not fail without | why they stay |
|---|---|---|---|
| 1, 2 | 2 | none | |
| 3 | 3 | object 2 | chance |
<!-- end of suite -->
<!-- study -->
| scene | settings | verdicts that change without each object | without several | why they stay |
|---|---|---|---|---|
| edges | 39 | 2, 0 -> 1 | 1, 2: 3 | |
| dust | 14 | 10, 0 -> 0 | | the eye |
<!-- end of study -->
END
printf 'edges\t2\tPlates\ndust\t2\tDust\n' >scenes
echo '{"rows": [{"id": 1, "objects": 2}, {"id": 2, "objects": 2}, {"id": 3, "objects": 3}]}' >rows.json
out=$(grader/scripts/economy_gaps scenes rows.json 2>&1) && [[ -z $out ]] && ok || bad "no gap" "$out"
sed -i.kept 's/edges\t2/edges\t7/' scenes
gaps "five more in a scene" "edges has 7 objects, and 2 were measured"
cp scenes.kept scenes && printf 'sky\t3\tSky\n' >>scenes
gaps "a new scene" "sky was not measured"
head -1 scenes.kept >scenes
gaps "a scene that is gone" "has no scene dust"
cp scenes.kept scenes
sed -i.kept 's/"id": 2, "objects": 2/"id": 2, "objects": 7/' rows.json
gaps "five more in a row" "row 2 of the suite has 7 objects, and 2 were measured"
sed -i 's/"id": 2, "objects": 7/"id": 4, "objects": 2/' rows.json
gaps "a new row" "row 4 of the suite has 2 objects, and none were measured"
cp rows.json.kept rows.json
sed -i.kept 's/the eye/**say why**/' grader/proof/ECONOMY.md
gaps "no reason for an object of a scene" "dust changes nothing, and no reason"
sed 's/| chance/|/' grader/proof/ECONOMY.md.kept >grader/proof/ECONOMY.md
gaps "no reason for an object of a row" "row 3 of the suite passes without object 2"
finish
