#!/usr/bin/env bash
# The pages of a class in a browser (Chromium, node): no error, no request, no violation of accessibility; keyboard and mouse.
set -u
source "$(dirname "$0")/lib.sh"
cd "$root" || exit 1
for command in node npm chromium; do
    command -v $command >/dev/null || { echo "skipped: there is no $command (common/setup --check installs it)"; finish; exit 0; }
done
browser=grader/tests/browser
out=$(make --no-print-directory $browser/node_modules/.package-lock.json 2>&1) || { bad "npm install in $browser" "$out"; finish; exit 1; }

mkdir -p "$work/class/"{right,"half <img src=x onerror=alert(1)>\"'&",untouched,nothing}
cp -r solutions/03-shadow-map "$work/class/right"
cp -r solutions/03-shadow-map "$work/class/half <img src=x onerror=alert(1)>\"'&"
sed -i 's/lit \* diffuse_specular/(0.5 + 0.5 * lit) * diffuse_specular/' "$work"/class/half*/03-shadow-map/shadow.frag
cp -r labs/03-shadow-map "$work/class/untouched"
grades --class "$work/class" --output "$work/out" --lab 03 --seed 5
expect "a class" 0 "4 submissions, 0 not graded"
out=$(node $browser/audit.mjs "$work"/out/index.html "$work"/out/pages/*.html 2>&1) && ok || bad "audit.mjs" "$out"
echo '<title>x</title><img src="https://example.org/x.png">' >"$work/wrong.html"
node $browser/audit.mjs "$work/wrong.html" >/dev/null 2>&1 && bad "audit.mjs takes a page that is wrong" || ok
out=$(node $browser/class.mjs "$work/out" 2>&1) || true
[[ $out =~ ([0-9]+)\ passed,\ ([0-9]+)\ failed$ ]] || { bad "class.mjs" "$out"; finish; exit 1; }
((BASH_REMATCH[2])) && echo "$out"
passed=$((passed + BASH_REMATCH[1])) failed=$((failed + BASH_REMATCH[2]))

finish
