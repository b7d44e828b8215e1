#!/usr/bin/env bash
# The rubrics: solutions, skeletons, mistakes and alternatives of every lab with one seed (`make table` takes ten), two
# labs side by side; the same verdicts by both routes to OpenGL (one lab here, all by `make contexts`).
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1

ls solutions | grep -oE '^[0-9]{2}' | xargs -P2 -I{} sh -c "$BUILD/prove --lab {} --seeds 1 >$work/{} 2>&1"
for proof in "$work"/[0-9][0-9]; do
    counts=$(grep -oE '^[0-9]+ passed, [0-9]+ failed' "$proof") || counts="0 passed, 1 failed"
    passed=$((passed + ${counts%% *}))
    right=${counts#*, }
    failed=$((failed + ${right%% *}))
    grep -vE '\| (named|as it should be) \|$|^\| ?(lab|---)|^\|---|passed,' "$proof"
    [[ $(grep -c '| mistake |' "$proof") -ge 10 && $(grep -c '| alternative |' "$proof") -ge 4 ]] && ok ||
        bad "lab $(basename "$proof") has less than 10 mistakes or 4 alternatives"
done
out=$(grader/scripts/contexts "$BUILD" 02 2>&1) && ok || bad "the contexts differ" "$out"
finish
