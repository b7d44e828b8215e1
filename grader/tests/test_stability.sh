#!/usr/bin/env bash
# The stability suite: all rows pass, the JSON and the page are what they promise, and a method with a fault fails.
set -u
source "$(dirname "$0")/lib.sh"
cd "$root" || exit 1

suite() { status=0; out=$("$BUILD/stability" --output "$work/study" "$@" 2>&1) || status=$?; }
json() { python3 -c 'import json,sys; rows=json.load(open(sys.argv[1]))["rows"]; print(eval(sys.argv[2]))' "$work/study/stability.json" "$1"; }

suite
expect "all rows pass" 0
[[ $(grep -cE '^ ?[0-9]+  (pass|not-built) ' <<<"$out") == 31 ]] && ok || bad "there is a line for each of 31 rows" "$out"
[[ $(json '[r["id"] for r in rows] == list(range(1, 32))') == True ]] && ok || bad "the JSON has 31 rows" "$out"
valid() { python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(sys.stdin), json.load(open("grader/stability/schema.json")))' 2>/dev/null; }
valid <"$work/study/stability.json" && ok || bad "the JSON fits its schema"
sed 's/"status": "pass"/"status": "fine"/' "$work/study/stability.json" | valid && bad "the schema takes a wrong status" || ok
[[ $(json 'all(len(c["points"]) >= 2 and c["holds"] for r in rows if r["status"] == "pass" for f in r["figures"] for c in f["curves"])') == True ]] &&
    ok || bad "rows that pass have curves, and all of them hold"
[[ $(json 'all(r["figures"] == [] and r["measured"] is None for r in rows if r["status"] == "not-built")') == True ]] &&
    ok || bad "rows that are not built claim nothing"

# The page needs no network and has every row, its figure and its frames.
page=$work/study/stability.html
[[ $(grep -c '<section id="row-' "$page") == 31 && $(grep -c 'data:image/svg+xml;base64,' "$page") == $(json 'sum(r["figure"] is not None for r in rows)') ]] &&
    [[ $(grep -o 'data:image/png;base64,' "$page" | wc -l) == $(json 'sum(len(r["frames"]) for r in rows)') ]] &&
    ! grep -qE '(src|href)="?https?:' "$page" && ok || bad "the page holds all rows, figures and frames"
python3 -c 'import sys,xml.dom.minidom as d; [d.parse(f) for f in sys.argv[1:]]' "$work"/study/*.svg && ok || bad "the figures are XML"

# The same bytes again.
first=$(cat "$work/study/stability.json")
suite --row 16
expect "one row" 0 "16  pass"
[[ $(json 'json.dumps(rows[0])') == $(python3 -c 'import json,sys; print(json.dumps(json.loads(sys.stdin.read())["rows"][15]))' <<<"$first") ]] &&
    ok || bad "a row alone gives the same numbers"

# faulty ROW LAB MISTAKE: the row must fail when the lab draws with this mistake.
faulty() {
    suite --row "$1" --mistake "$2:$3"
    expect "row $1 fails when $3" 1 "$1  fail"
}
faulty 2 04 "the bias is halved: it is taken in [-1, 1], not in the map's [0, 1]"
faulty 3 04 "the factor is left at 0: the offset does not depend on the slope"
faulty 6 04 "the cosine is used where the sine belongs"
faulty 7 04 "the bias has the wrong sign"
faulty 11 03 "the test for points behind the light is inverted"
faulty 13 03 "the size of the map is fixed"
faulty 15 05 "the kernel is not centred on the point"
faulty 16 06 "the square root is missing: the samples crowd in the middle"
faulty 17 06 "the innermost samples come first"
faulty 18 03 "the size of the map is fixed"
faulty 19 07 "back faces are culled"
faulty 22 07 "z-fail keeps the depth function GL_LESS"
faulty 23 07 "the far caps are wound like the near ones"
faulty 24 07 "the volumes have a fixed length"
faulty 28 08 "directions are uniform, not cosine-weighted"
faulty 29 08 "the length of the rays is not limited"
[[ $(json 'rows[0]["status"]') == fail ]] && ok || bad "the JSON says so"

# What a user can get wrong.
suite --row 99
expect "an unknown row" 2 "--row takes the number of a row, 1 to 31"
suite --mistake "04"
expect "a mistake without a name" 2 "--mistake takes NN:NAME"
suite --row 2 --mistake "04:no such thing"
expect "an unknown mistake" 1 "no mistake \"no such thing\""
suite surplus
expect "a surplus argument" 2 "\"surplus\" is not an option"
finish
