#!/usr/bin/env bash
# Our own faults: the n-th call of one kind fails in the grader, and in what it starts until that is another program. Each
# run must give the right points or say that it could not grade. FAULTS=300 tries so many, SEED=N the same ones again.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
if [[ -n ${QUICK:-} ]] || ! strace -qq -o /dev/null true 2>/dev/null; then
    skip "strace does not work here (common/setup --test), or a sanitizer is in the way"
    finish
    exit
fi
RANDOM=${SEED:=$((RANDOM % 10000))}
echo "seed $SEED"

# A call, an error, and about how often a run makes it.
calls=("openat EMFILE 380" "openat ENOSPC 380" "read EIO 600" "write ENOSPC 165" "write EIO 165" "mkdir ENOSPC 22" "clone EAGAIN 9"
    "pipe2 EMFILE 25" "newfstatat ENOMEM 530" "openat2 EMFILE 19" "chown EPERM 3" "poll ENOMEM 600" "poll EINTR 600" "wait4 EINTR 21")
solved right >/dev/null
solved wrong >/dev/null
sed -i 's/GL_NEAREST/GL_LINEAR/' "$work"/wrong/03-*/lab.c
declare -A points states
for name in right wrong; do
    grades --lab 03 --seed 1 --format json "$work/$name"
    points[$name]=$(field 'r["score"]') states[$name]=$status
done
[[ ${points[right]} == 100.0 && ${states[wrong]} == 1 ]] && ok || bad "without a fault" "$out"
faulty() { # SUBMISSION
    local call error often when score
    read -r call error often <<<"${calls[RANDOM % ${#calls[@]}]}"
    when=$((RANDOM % often + 1))
    status=0
    out=$(timeout 100 strace -qq -f -b execve -o /dev/null -e trace="$call" -e inject="$call:error=$error:when=$when" \
        "$grade" --lab 03 --seed 1 --format json "$work/$1" 2>"$work/errors") || status=$?
    score=$(field 'r["score"]' 2>/dev/null)
    [[ $status == "${states[$1]}" && $score == "${points[$1]}" ]] || ((status >= 3 && status != 124)) && ok ||
        bad "$1: $call number $when fails with $error: exit status $status, $score points" "$out $(tail -3 "$work/errors")"
}
for ((i = 0; i < ${FAULTS:-16}; i++)); do
    if ((i % 4)); then faulty right; else faulty wrong; fi
done

# A temporary folder that is full, at each stage. Only root may mount one.
if ((EUID == 0)) && mkdir "$work/small" && mount -t tmpfs -o size=1m,mode=711 tmpfs "$work/small" 2>/dev/null; then
    umount "$work/small"
    for size in 2000k 18500k 19400k 20000k 21000k; do
        mount -t tmpfs -o size=$size,mode=711 tmpfs "$work/small"
        status=0
        out=$(TMPDIR=$work/small "$grade" --lab 03 --seed 1 "$work/right" 2>&1) || status=$?
        ((status == 3)) || [[ $status == 0 && $out == *"100.00 of 100 points"* ]] && ok || bad "a temporary folder of $size: exit status $status" "$out"
        umount "$work/small"
    done
else
    skip "only root can make a full temporary folder"
fi
finish
