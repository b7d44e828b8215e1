# For the shell tests: counts, and runs the grader on folders made from the solutions. Sourced with BUILD set.
passed=0 failed=0 skipped=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
grade=$root/$BUILD/grade

ok() { passed=$((passed + 1)); }
skip() { skipped=$((skipped + 1)); echo "skipped: $1"; } # WHY
bad() { failed=$((failed + 1)); echo "FAILED: $1"; [[ -n ${2:-} ]] && sed 's/^/    /' <<<"$2" | head -30; return 0; }

# expect NAME STATUS PATTERN...: the last run (in $out and $status) ended so and printed every pattern (fixed strings).
expect() {
    local name=$1 wanted=$2 pattern
    shift 2
    [[ $status == "$wanted" ]] || { bad "$name: exit status $status, not $wanted" "$out"; return 0; }
    for pattern in "$@"; do
        grep -qF -- "$pattern" <<<"$out" || { bad "$name: no \"$pattern\" in the output" "$out"; return 0; }
    done
    ok
}

# grades ARGUMENTS...: runs the grader; sets $out and $status.
grades() { status=0; out=$("$grade" "$@" 2>&1) || status=$?; }

# field FILTER: a value of the JSON in $out, by python.
field() { python3 -c 'import json,sys; r=json.load(sys.stdin); print(eval(sys.argv[1]))' "$1" <<<"$out"; }

# solved NAME [NN...]: a submission shaped like labs/ with the solutions of these labs (default 03); prints its path.
solved() {
    local to=$work/$1 lab
    shift
    mkdir -p "$to"
    for lab in "${@:-03}"; do cp -r "$root"/solutions/"$lab"-* "$to"; done
    rm -f "$to"/*/{scenes,predictions,study,rows,witness}*.[ch] "$to"/*/*.mjs # the grader's, not of the submission
    echo "$to"
}

# browses SCRIPT ARGUMENTS...: runs a script of browser/ and adds its counts; says so where there is no browser.
browses() {
    local command out browser=$root/grader/tests/browser
    for command in node npm chromium; do
        command -v $command >/dev/null || { skip "there is no $command (common/setup --test installs it)"; return 0; }
    done
    # Tests run side by side: one of them installs.
    flock "$browser/package.json" make --no-print-directory -C "$root" grader/tests/browser/node_modules/.package-lock.json \
        >"$work/npm" 2>&1 || { bad "npm install in $browser" "$(cat "$work/npm")"; return 0; }
    out=$(node "$browser/$1" "${@:2}" 2>&1) || true
    [[ $out =~ ([0-9]+)\ passed,\ ([0-9]+)\ failed$ ]] || { bad "$1" "$out"; return 0; }
    ((BASH_REMATCH[2])) && echo "$out"
    passed=$((passed + BASH_REMATCH[1])) failed=$((failed + BASH_REMATCH[2]))
}

finish() {
    local more=
    ((skipped)) && more=", $skipped skipped"
    echo "$passed passed, $failed failed$more"
    ((failed == 0))
}
