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
finish
