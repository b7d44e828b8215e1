#!/usr/bin/env bash
# The stability suite: all rows pass, the JSON and the page are what they promise, and a method with a fault fails.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
study=$work/study

suite() { status=0; out=$("$BUILD/stability" --output "$study" "$@" 2>&1) || status=$?; }
json() { # an expression over the rows of the latest run
    python3 -c 'import json,sys; rows = json.load(open(sys.argv[1]))["rows"]; print(eval(sys.argv[2]))' \
        "$study/stability.json" "$1"
}
valid() {
    python3 -c 'import json,sys,jsonschema
jsonschema.validate(json.load(sys.stdin), json.load(open("grader/stability/stability.schema.json")))' 2>/dev/null
}

# All rows, in the order of their numbers.
mapfile -t rows < <(grep -oHE '^    \{[0-9A-Z_*+ ]+, "' solutions/*/rows*.c | tr -d ' {,"' |
    while IFS=: read -r file number; do
        [[ $file =~ solutions/([0-9]+)- ]] && LAB_NUMBER=$((10#${BASH_REMATCH[1]}))
        echo $((number))
    done | sort -n)
((${#rows[@]} > 20)) && ok || bad "the rows are found in the sources" "${rows[*]}"
mapfile -t chosen < <(printf -- '--row\n%s\n' "${rows[@]}")
suite "${chosen[@]}"
expect "all rows pass" 0
[[ $(grep -E '^ ?[0-9]+  (pass|not-built) ' <<<"$out" | awk '{ print $1 }' | xargs) == "${rows[*]}" ]] &&
    ok || bad "there is a line for each row" "$out"
[[ $(json '" ".join(str(r["id"]) for r in rows)') == "${rows[*]}" ]] && ok || bad "the JSON has all rows" "$out"
valid <"$study/stability.json" && ok || bad "the JSON fits its schema"
sed 's/"status": "pass"/"status": "fine"/' "$study/stability.json" | valid && bad "a wrong status fits it" || ok
passing='[r for r in rows if r["status"] == "pass"]'
curves="all(c['holds'] and c['points'] for f in r['figures'] for c in f['curves'])"
[[ $(json "all(r['figures'] and $curves for r in $passing)") == True ]] && ok ||
    bad "rows that pass have curves, and all of them hold"
absent='[r for r in rows if r["status"] == "not-built"]'
[[ $(json "all(r['figures'] == [] and r['measured'] is None for r in $absent)") == True ]] && ok ||
    bad "rows that are not built claim nothing"

# No object was put into a row that nobody measured.
"$BUILD/chart" --list >"$work/scenes"
out=$(grader/scripts/economy_gaps "$work/scenes" "$study/stability.json") && ok || bad "all objects of the rows were measured" "$out"

# The page needs no network and has every row, its figure and its frames.
page=$study/stability.html
count() { grep -o "$1" "$page" | wc -l; }
[[ $(count '<section id="row-') == "${#rows[@]}" ]] && ok || bad "the page has all rows"
[[ $(count 'data:image/svg+xml;base64,') == $(json 'sum(len(r["figures"]) for r in rows)') ]] &&
    [[ $(count 'data:image/png;base64,') == $(json 'sum(len(r["frames"]) for r in rows)') ]] &&
    ok || bad "the page has all figures and frames"
grep -qE '(src|href)="?https?:' "$page" && bad "the page needs the network" || ok
python3 -c 'import sys,xml.dom.minidom as d; [d.parse(f) for f in sys.argv[1:]]' "$study"/*.svg && ok ||
    bad "the figures are XML"

# A row alone gives the same numbers.
all=$(json 'json.dumps(next(r for r in rows if r["id"] == 17))')
suite --row 17
expect "one row" 0 "17  pass"
[[ $(json 'json.dumps(rows[0])') == "$all" ]] && ok || bad "a row alone gives the same numbers"

# Its slider goes through the frames of the sweep, each a small PNG.
python3 -c 'import base64,json,re,struct,sys
page = open(sys.argv[1]).read()
(reel,) = re.findall(r"<figure class=\"reel\".*?<script type=\"application/json\">(.*?)</script>", page)
pictures = [base64.b64decode(bytes) for words, bytes in json.loads(reel)]
sizes = [struct.unpack(">II", p[16:24]) for p in pictures]
assert len(pictures) > 5 and len(set(pictures)) > 5 and len({words for words, bytes in json.loads(reel)}) > 5
assert f"max=\"{len(pictures) - 1}\"" in page and all(0 < w <= 330 for w, h in sizes) and max(map(len, pictures)) < 60000' \
    "$page" 2>&1 && ok || bad "the slider has the frames of the sweep"

# faulty ROW LAB MISTAKE: the row must fail when the lab draws with this mistake, by what is measured.
faulty() {
    suite --row "$1" --mistake "$2:$3"
    expect "row $1 fails when $3" 1 "$1  fail"
    grep -q "^ *$1  fail .*, expected " <<<"$out" && ok || bad "row $1 measures that $3" "$out"
}
faulty 1 04 "front faces are left out of the map whatever the method"
faulty 4 05 "the kernel is not centred on the point" # the row's own change adds a knob
faulty 8 04 "culling is switched off instead of turned round"
faulty 12 04 "the bias is halved: it is taken in [-1, 1], not in the map's [0, 1]"
faulty 25 07 "facing the light has a tolerance"
faulty 26 07 "the counts do not wrap"
faulty 27 07 "the volumes have a fixed length"
faulty 903 09 "edges are compared at one corner"
faulty 1002 10 "the lamps stand at the cells' corners"
faulty 1002 10 "the jitter is not applied"
faulty 2 04 "the bias is halved: it is taken in [-1, 1], not in the map's [0, 1]"
faulty 3 04 "the factor is left at 0: the offset does not depend on the slope"
faulty 6 04 "the cosine is used where the sine belongs"
faulty 7 04 "the bias has the wrong sign"
faulty 40 03 "the directional light is drawn with a perspective projection"
faulty 41 04 "the normal offset goes into the surface"
faulty 42 04 "culling is switched off instead of turned round"
faulty 44 03 "the size of the map is fixed"
faulty 45 07 "the volumes have a fixed length"
faulty 46 03 "front faces are left out of the map: that is lab 04"
faulty 11 03 "the test for points behind the light is inverted"
faulty 15 05 "the kernel is not centred on the point"
faulty 15 05 "f and 1 - f are exchanged"
faulty 16 06 "the square root is missing: the samples crowd in the middle"
faulty 17 06 "the innermost samples come first"
faulty 18 03 "the size of the map is fixed"
faulty 19 07 "back faces are culled"
faulty 22 07 "z-fail keeps the depth function GL_LESS"
faulty 23 07 "the far caps are wound like the near ones"
faulty 24 07 "the volumes have a fixed length"
broken() { json 'sum(not c["holds"] for r in rows for f in r["figures"] for c in f["curves"] if '"$1"')'; } # curves that do not hold
faulty 28 08 "directions are uniform, not cosine-weighted"
[[ $(broken '"spheres first" in c["name"]') == 1 ]] && ok || bad "so does the bake with spheres"
faulty 29 08 "far occluders count, near ones do not"
[[ $(broken '"two factors" in c["name"] or "half size" in c["name"]') == 4 ]] && ok || bad "so does the faster screen space"
faulty 502 05 "the comparison is inverted"
[[ $(broken True) == 6 ]] && ok || bad "so do all filters in fewer lookups"
faulty 502 05 "the half texel is forgotten"
faulty 31 12 "half a luxel is subtracted in the lookup"
faulty 1201 12 "what moves is baked, too"
faulty 1401 14 "the kernel is as wide as the search"
faulty 1601 16 "the cut is a step"
[[ $(json 'rows[0]["status"]') == fail ]] && ok || bad "the JSON says so"

# Each method of the study has a line in the README's table, and each line a mistake that the lab has (or a failure that the row draws) and
# rows that there are.
"$BUILD/chart" --list | cut -f4 | sed 's/; /\n/g' | sort -u >"$work/methods"
python3 - "$work/methods" "${rows[*]}" >"$work/table" 2>&1 <<'END' && ok || bad "the table of methods, mistakes and rows" "$(cat "$work/table")"
import glob, json, re, sys
methods = set(open(sys.argv[1]).read().splitlines()) - {"no shadow (03)", "hard (05)"}
lines = re.findall(r"^\| (.*?)\| (.+?) \| ([0-9, ]+) \|$", open("grader/stability/README.md").read(), re.M)
told = {method for cell, *_ in lines for method in cell.strip().split("; ")} - {""}
assert len(methods) > 40 and methods == told, f"without a line: {methods - told}; no method of the study: {told - methods}"
for cell, mistake, rows in lines:
    lab = cell.strip()[-3:-1] or lab
    (folder,) = glob.glob(f"solutions/{lab}-*")
    sources = "".join(open(path).read() for path in glob.glob(f"{folder}/rows*.c"))
    known = [m["name"] for m in json.load(open(f"{folder}/mistakes.json"))]
    assert mistake in known or f'"failure: {mistake.strip("*")}' in sources, f"lab {lab} has no mistake {mistake}"
    for row in rows.split(", "):
        assert len(sys.argv[2].split()) < 20 or row in sys.argv[2].split(), f"there is no row {row}"
END

# What a user can get wrong.
suite --row 9999
expect "an unknown row" 2 "--row takes the number of a row, not \"9999\"; the rows are 1, 2"
suite --mistake "04"
expect "a mistake without a name" 2 "--mistake takes NN:NAME"
suite --row 2 --mistake "04:no such thing"
expect "an unknown mistake" 1 "no mistake \"no such thing\"" "1 of 1 rows fail"
suite --row 17 --without 15
expect "an object that the row has not" 1 "none of these rows has an object that is left out"
suite surplus
expect "a surplus argument" 2 "\"surplus\" is not an option"
suite --row 30 --output /proc/nowhere
expect "a folder that cannot be made" 1 "/proc/nowhere"
finish
