#!/usr/bin/env bash
# Diagrams and figures to play with: the diagrams are what their descriptions say, the figures' numbers are right, and they
# work by keys, mouse and finger. The checkers see what is wrong.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
runs() { status=0; out=$("$@" 2>&1) || status=$?; }

# Frames over a knob: what a bias of 0 costs is acne, what a large one costs is light. Closed form: half of a bare floor is dark.
if [[ -x $BUILD/sweep ]]; then
    runs "$BUILD/sweep" --lab 04 --scene bias --over bias --knob method=1 --knob "map size=512" --size 160x120 "$work/frames" 0 0.05
    expect "two frames" 0
    awk -F, 'NR == 1 { acne = $2 > 0.3 && $2 < 0.5 && $3 < 0.01 } NR == 2 { gap = $2 < 0.01 && $3 > 0.02 } END { exit !(acne && gap && NR == 2) }' <<<"$out" && ok || bad "acne, then a gap" "$out"
    cmp -s "$work/frames/0.png" "$work/frames/1.png" && bad "two different pictures" || ok
    runs "$BUILD/sweep" --lab 04 --scene nowhere --over bias "$work/frames" 0
    expect "a scene that is not there" 1 'the study has no "nowhere"'
    runs "$BUILD/sweep" --lab 04 --scene bias --over bias "$work/frames" many
    expect "a value that is no number" 2 'a value is a number, not "many"'
    runs "$BUILD/sweep" --lab 04 --scene bias --over nothing "$work/frames" 1
    [[ $status == 1 ]] && ok || bad "a knob that the lab has not" "$out"
fi

if [[ -n ${QUICK:-} ]]; then skip "figures have no C"; finish; exit; fi
browser=grader/tests/browser
for tool in node npm cmark-gfm chromium; do
    command -v $tool >/dev/null || { skip "there is no $tool (common/setup --test)"; finish; exit; }
done
runs node grader/site/diagrams.mjs --check
expect "the diagrams are as described" 0
runs node $browser/figure_models.mjs "${SEED:-$RANDOM}"
expect "the figures' numbers are right" 0 ", 0 failed"
runs flock $browser/package.json make --no-print-directory BUILD="$work" grader/site/node_modules/.package-lock.json $browser/node_modules/.package-lock.json
expect "npm" 0
runs node grader/site/build.mjs "$work/site"
expect "the site is built" 0
sed -n '/<script type="module">/,/<\/script>/p' "$work"/site/03-*.html | grep 'http' && bad "a figure names no address" || ok
runs node $browser/figure_pages.mjs "$work/site"
expect "the figures in a browser" 0 ", 0 failed"

# What is wrong is seen: a number, a drawing, a picture that a handout does not show, a lab without a diagram.
copy=$work/copy
mkdir -p "$copy/grader/tests"
cp -r grader/site "$copy/grader/site"
cp -r $browser "$copy/grader/tests/browser"
cp -r solutions "$copy/solutions"
cd "$copy" || exit 1
sed -i 's|(1 - x / Math.hypot(x, h)) / 2|(1 - x / Math.hypot(x, h)) / 2.1|' solutions/08-*/figure.mjs
runs node $browser/figure_models.mjs 1
expect "a formula that is wrong" 1 "FAILED: 08: x = 3, h = 4"
rm -r solutions/13-*/diagram.mjs
sed -i 's/M/m/' solutions/04-*/texel.svg
sed -i '/passes.svg/d' solutions/03-*/README.md
runs node grader/site/diagrams.mjs --check
expect "wrong diagrams" 1 "diagram.mjs is missing" "texel.svg is not what" "README.md does not show"
runs node grader/site/diagrams.mjs 04
expect "drawn again" 0 "solutions/04-acne-and-bias/texel.svg"
runs node grader/site/diagrams.mjs 04
expect "the same bytes each time" 0
[[ -z $out ]] && ok || bad "nothing is rewritten" "$out"
for page in "$work"/site/0[3-5]-*.html; do sed -i 's/tan(/cos(/; s/<dd>\${value}/<dd>0/' "$page"; done
runs node $browser/figure_pages.mjs "$work/site"
expect "a script that was changed does not run" 1 "the numbers at the start"
finish
