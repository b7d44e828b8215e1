#!/usr/bin/env bash
# Untrusted code against the grader, by every route into the jail, as root and as an ordinary user; and what happens
# where no jail holds. `make test-hostile` runs it alone. It is left out with a sanitizer, whose jail is wider.
set -u
BUILD=${BUILD:-build}
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
chmod 755 "$work"
if [[ -n ${QUICK:-} ]]; then skip "a sanitizer's jail is wider"; finish; exit; fi

nobody=()
if ((EUID == 0)); then
    nobody=(setpriv --reuid=65534 --regid=65534 --clear-groups)
    "${nobody[@]}" test -x "$grade" || { skip "not as an ordinary user: $root is closed to others"; nobody=(); }
fi

# The submissions of hostile/, two runs at a time; then without a jail, which shows that the attacks are some.
run() { # NAME COMMAND...
    local name=$1
    shift
    "$@" >"$work/log-$name" 2>&1 &
}
count() { # NAME
    local counts
    counts=$(tail -1 "$work/log-$1")
    grep -v ' passed, ' "$work/log-$1" | sed "s/^/$1: /"
    if [[ $counts =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed$ ]]; then
        passed=$((passed + BASH_REMATCH[1])) failed=$((failed + BASH_REMATCH[2]))
    else
        bad "$1 ended without counts"
    fi
}
hostile=$root/$BUILD/hostile
run bwrap env SHADOW_LAB_QUICK=1 "$hostile" bwrap
run landlock "$hostile" landlock
wait
run nursery env SHADOW_LAB_QUICK=1 "$hostile" nursery
wait
count bwrap
count landlock
count nursery
if ((EUID == 0 && ${#nobody[@]})); then
    run bwrap-as-user env SHADOW_LAB_QUICK=1 "${nobody[@]}" "$hostile" bwrap
    run landlock-as-user env SHADOW_LAB_QUICK=1 "${nobody[@]}" "$hostile" landlock
    wait
    run nursery-as-user env SHADOW_LAB_QUICK=1 "${nobody[@]}" "$hostile" nursery
    wait
    count nursery-as-user
    count bwrap-as-user
    count landlock-as-user
fi
"${nobody[@]}" "$hostile" outside >"$work/log-outside" 2>&1
count outside

# The whole way of a submission. Its folder may hold anything; only files of the manifest are taken, and only whole ones.
three=03-shadow-map
solved odd >/dev/null
echo '#error mine' >"$work/odd/$three/lab.h"
echo 'all: ; touch /tmp/owned' >"$work/odd/$three/Makefile"
echo 'int main(void) { return 1; }' >"$work/odd/$three/-fplugin=evil.c"
: >"$work/odd/$three/"$'\xff\xfe'
: >"$work/odd/$three/"$'\e[31mred'
sed -i 's|^static void draw_picture.*|#include <stdio.h>\n&\n    puts("\\33[2J\\377 score 100");\n    check_fail("\\33[2J\\377");|' "$work/odd/$three/lab.c"
grades --lab 03 --seed 1 "$work/odd"
expect "odd files and words" 0 "ignored: -fplugin=evil.c" "ignored: lab.h" "ignored: Makefile" 'ignored: \xff\xfe' 'ignored: \x1b[31mred' '\x1b[2J\xff' "100.00 of 100"
LC_ALL=C grep -q $'[\x1b\x80-\xff]' <<<"$out" && bad "bytes of a submission reach the terminal" "$out" || ok

mkdir "$work/link" && ln -s "$root/solutions/$three" "$work/link/$three"
grades --lab 03 --seed 1 "$work/link"
expect "a folder that is a link to the solution" 1 "a link is none" "0.00 of 100 points"
solved hard >/dev/null && ln "$work/hard/$three/lab.c" "$work/elsewhere"
grades --lab 03 --seed 1 "$work/hard"
expect "a hard link" 1 "lab.c is a hard link to another file: hand in a copy"
solved large >/dev/null && truncate -s 1M "$work/large/$three/lab.c"
grades --lab 03 --seed 1 "$work/large"
expect "a huge file" 1 "lab.c is larger than 256 KiB"
ln -s "$(solved ours)/$three" "$work/by-teacher"
grades --seed 1 "$work/by-teacher"
expect "the caller's own link to a lab's folder" 0 "100.00 of 100 points"

# A picture that was right for another seed, drawn into every frame by the skeleton.
grades --lab 03 --seed 1 --output "$work/stolen" labs
picture=$work/stolen/03/comparison--spot-light-reference.png
read -r width height < <(identify -format '%w %h\n' "$picture")
mkdir -p "$work/replay" && cp -r labs/$three "$work/replay"
{
    echo "static const unsigned char stolen[] = {$(convert "$picture" -flip -depth 8 gray:- | od -An -v -tu1 -w1 | paste -sd,)};"
    cat <<EOF
static void replay(const Frame *frame) {
    static unsigned char pixels[$width * $height][4];
    for (int i = 0; i < $width * $height; i++)
        for (int c = 0; c < 4; c++)
            pixels[i][c] = stolen[i];
    GLuint texture, framebuffer;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, $width, $height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, frame->framebuffer);
    glBlitFramebuffer(0, 0, $width, $height, 0, 0, frame->width, frame->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}
EOF
} >"$work/replay.c"
python3 - "$work/replay/$three/lab.c" "$work/replay.c" <<'EOF'
import sys
lab = open("labs/03-shadow-map/lab.c").read()
at = lab.index("const Lab lab")
lab = lab[:at] + open(sys.argv[2]).read() + lab[at:].replace('{"picture", draw_picture}', '{"picture", draw_picture}, {"replay", replay}')
open(sys.argv[1], "w").write(lab)
EOF
grades --lab 03 --seed 2 --format json "$work/replay"
[[ $(field 'max(c["score"] for l in r["labs"] for c in l["checks"])') == 0.0 && $(field 'r["labs"][0]["message"]') == "" ]] && ok || bad "a replayed picture scores" "$out"

# Ended from outside in the midst of it, by the user or by force, it leaves no process; by the user also no file.
solved sleeper >/dev/null
sed -i 's|^static void draw_picture.*|#include <unistd.h>\n&\n    sleep(1000);|' "$work/sleeper/$three/lab.c"
for signal in INT TERM KILL; do
    mkdir -p "$work/temporary-$signal" && chmod 755 "$work/temporary-$signal"
    env --default-signal TMPDIR="$work/temporary-$signal" "$grade" --lab 03 --seed 1 "$work/sleeper" >/dev/null 2>&1 &
    grader=$!
    inside() { grep -ls "$work/temporary-$signal" /proc/[0-9]*/maps; }
    for ((i = 0; i < 200; i++)); do
        inside | grep -q . && break
        sleep 0.05
    done
    ((i < 200)) || bad "$signal: nothing ever ran"
    kill -"$signal" $grader
    wait $grader 2>/dev/null
    for ((i = 0; i < 40; i++)); do
        [[ -z $(inside) && ($signal == KILL || -z $(ls "$work/temporary-$signal")) ]] && break
        sleep 0.05
    done
    ((i < 40)) && ok || bad "$signal leaves something" "$(inside; ls "$work/temporary-$signal")"
done

# Which jail it was is said; the first that holds is taken; without one nothing is graded.
without() { local lacking=$1; shift; status=0; out=$("$root/$BUILD/without" $lacking -- "$@" 2>"$work/errors") || status=$?; }
both() { out+=$'\n'$(cat "$work/errors"); }
grade3=("$grade" --lab 03 --seed 1 --format json "$work/ours")
without "" "${grade3[@]}"
[[ $status == 0 && $(field 'r["jail"]') == bwrap && ! -s $work/errors ]] && ok || bad "bwrap is taken first, silently" "$out"
without userns "${grade3[@]}"
[[ $status == 0 && $(field 'r["jail"]') == landlock ]] && grep -q "the fallback jail is in use: landlock, for bwrap: it does not start" "$work/errors" && ok || bad "without user namespaces, the fallback, and not silently" "$out"
without landlock "${grade3[@]}"
[[ $status == 0 && $(field 'r["jail"]') == bwrap ]] && ok || bad "bwrap without Landlock" "$out"
for command in "${grade3[*]}" "${grade3[*]} --jail bwrap" "${grade3[*]} --jail landlock"; do
    without "userns landlock" $command
    [[ -z $out ]] && ok || bad "something is graded where no jail holds" "$out"
    both
    expect "refusal: $command" 3 "no jail holds on this machine" "it does not start" "add --trusted"
done
without userns "${grade3[@]}" --jail bwrap
both
expect "another route than the one asked for" 3 "no jail holds on this machine (bwrap: it does not start"
without "userns landlock" "${grade3[@]}" --trusted
[[ $status == 0 && $(field 'r["jail"]') == none ]] && grep -q -- "--trusted: the submission is compiled and run outside the jail" "$work/errors" && ok || bad "one's own work, outside" "$out"
grades --trusted --jail bwrap labs
expect "two wishes at once" 2 "--trusted and --jail exclude each other"
grades --jail moon labs
expect "a route that is none" 2 '--jail takes bwrap or landlock, not "moon"'

# A jail weakened on purpose is refused, whichever its route.
copy=$work/copy
mkdir -p "$copy/build"
cp -r "$root/$BUILD"/{grade,worker,include,given,jail_probe,jail_unpack} "$copy/build"
ln -s "$root"/{common,shaders,solutions} "$copy"
cp "$root/$BUILD/weak_filter" "$copy/build/jail_shim"
without "" "$copy/build/grade" --lab 03 --seed 1 "$work/ours"
both
expect "a weakened jail" 3 "bwrap: the self-test got through where submissions run" "landlock: the self-test got through"
rm "$copy/build/jail_shim"
without "" "$copy/build/grade" --lab 03 --seed 1 "$work/ours"
both
expect "a jail that was not built" 3 "jail_shim cannot be copied" "No such file or directory"

finish
