#!/usr/bin/env bash
# Every bad input ends in one clear message; none stops the grading of the other labs. All cases are made in one folder.
set -u
source "$(dirname "$0")/../helpers/lib.sh"

c() { echo "$work/$1/03-shadow-map/lab.c"; }
shader() { echo "$work/$1/03-shadow-map/shadow.frag"; }

# put NAME LINE: a solved lab 03 whose pass draw_map begins with LINE.
put() {
    solved "$1" >/dev/null
    sed -i "s|^static void draw_map(const Frame \*frame) {|#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>\n&\n    $2|" "$(c "$1")"
}

# case NAME STATUS PATTERN...: grades the case with a short time limit.
case_() {
    local name=$1
    shift
    grades --lab 03 --seed 1 --timeout "${timeout:-20}" "$work/$name"
    expect "$name" "$@"
}

put compile-error 'int x = "text" +;'
line=$(grep -n '"text" +' "$(c compile-error)" | cut -d: -f1)
case_ compile-error 1 "lab.c does not compile" "lab.c:$line:" "error: expected expression"

put warning 'int unused_variable;'
case_ warning 0 "note: ./lab.c:" "unused variable" "100.00 of 100 points"

solved glsl-error >/dev/null
sed -i 's/float lit = visibility/float lit = visibilty/' "$(shader glsl-error)"
line=$(grep -n 'visibilty' "$(shader glsl-error)" | cut -d: -f1)
case_ glsl-error 1 "shadow.frag does not compile" "shadow.frag:$line:" "error: no function with name 'visibilty'"
[[ $out != *"0:$line("* ]] && ok || bad "each error is told once" "$out"
[[ $out != *"the fault is in"* ]] && ok || bad "no search where the compiler has said it" "$out"

solved missing-file >/dev/null && rm "$(shader missing-file)"
case_ missing-file 1 "shadow.frag cannot be read: No such file"

mkdir -p "$work/empty-folder"
case_ empty-folder 1 "not handed in: there is no folder 03-shadow-map"

grades --lab 99 "$root/labs"
expect unknown-lab 2 'there is no lab "99"'

put crash '*(volatile int *)frame->width = 1;'
case_ crash 1 "it crashed: Segmentation fault (SEGV) in shadow map (lab.c:"

# The other checks go on in a new worker.
put crash-now-and-then 'if (frame->scene->lights[0].kind == LIGHT_DIRECTIONAL) *(volatile int *)frame->width = 1;'
case_ crash-now-and-then 1 "it crashed: Segmentation fault (SEGV) in shadow map (lab.c:" "ok     9.00/9   3.1" "ok     6.00/6   3.2" \
    "FAIL   0.00/11  3.3" "ok     8.00/8   3.7"

put exit-now-and-then 'if (frame->scene->lights[0].kind == LIGHT_DIRECTIONAL) exit(0);'
case_ exit-now-and-then 1 "it ended by itself with exit status 0" "ok     9.00/9   3.1" "FAIL   0.00/11  3.3" "ok     8.00/8   3.7"

put endless-recursion 'draw_map(frame);'
case_ endless-recursion 1 "it crashed: Segmentation fault (SEGV) in shadow map"

# What a lab prints is shown as its own, whatever it looks like; none of it is read.
put prints-a-crash 'puts("it crashed in picture @0x1234@");'
case_ prints-a-crash 0 "note: it printed:" "it crashed in picture @0x1234@" "100.00 of 100 points"

put prints-and-crashes 'printf("in picture @0x1234@"); fflush(stdout); *(volatile int *)frame->width = 1;'
case_ prints-and-crashes 1 "it crashed: Segmentation fault (SEGV) in shadow map (lab.c:" "in picture @0x1234@"
grep -A1 "it printed:" <<<"$out" | tail -1 | grep -q "note: in picture @0x1234@$" && ok || bad "what a lab prints before its crash is shown as it is" "$out"

put says-a-place 'check_fail("no map @0x1234@ (lab.c:1)");'
case_ says-a-place 0 "note: no map @0x1234@ (lab.c:1)"

# Where memory was damaged is said where the sanitizer's library is there.
if [[ -s $root/$BUILD/worker_address ]]; then
    put overflow 'int *made = malloc(40); for (volatile int i = 0; i <= 10; i++) made[i] = 1; free(made); abort();'
    line=$(grep -n 'made = malloc' "$(c overflow)" | cut -d: -f1)
    case_ overflow 1 "it crashed: Aborted (ABRT) in shadow map" \
        "heap-buffer-overflow in draw_map (lab.c:$line): writes 4 bytes, just past the end of an array of 40 bytes, made at lab.c:$line"
    solved overflow-08 08 >/dev/null
    sed -i 's/y < chart->height + atlas->padding;/y <= chart->height + atlas->padding;/; s/x < chart->width + atlas->padding;/x <= chart->width + atlas->padding;/' \
        "$work"/overflow-08/*/lab.c
    grades --lab 08 --seed 1 "$work/overflow-08"
    expect overflow-08 1 "heap-buffer-overflow in pad_chart (lab.c:" "past the end of an array of" "ok     7.00/7   8.8" "ok     6.00/6   8.9"
    solved null >/dev/null # through the other jail
    sed -i 's/^    const Light \*light = &frame->scene->lights\[0\];/    const Light *light = NULL;/' "$(c null)"
    grades --lab 03 --seed 1 --jail landlock "$work/null"
    expect null 1 "AddressSanitizer: SEGV in light_clip_from_world (lab.c:" "through a pointer that is NULL, or nearly"
    put aborts 'abort();'
    case_ aborts 1 "it crashed: Aborted (ABRT) in shadow map"
    grep -q AddressSanitizer <<<"$out" && bad "the sanitizer repeats what is known" "$out" || ok
fi

limit=${QUICK:+12} limit=${limit:-3} # sanitizers are slow
timeout=$limit
put endless-loop 'for (;;) {}'
case_ endless-loop 1 "it was stopped after $limit s in shadow map (lab.c:" "): is there an endless loop?" ", timeout"

for where in create destroy; do
    solved "endless-$where" >/dev/null
    sed -i "/^static [a-z]* $where(/a for (;;) {}" "$work/endless-$where"/*/lab.c
    case_ "endless-$where" 1 "it was stopped after $limit s in $where (lab.c:" ", timeout"
done

put sleeper 'sleep(1000);'
case_ sleeper 1 "it was stopped after $limit s" ", timeout"

put endless-shader 'for (int i = 0; i < 1000; i++) draw_scene(frame, \&frame->programs[PROGRAM_SHADOW], frame_clip_from_world(frame), vec3_make(0, 0, 0));'
sed -i 's|^void main()|float spin() { float x = 0.5; for (int i = 0; i >= 0; i++) x = fract(x * 3.7 + sin(x)); return x; }\n&|; s|vec3 ambient = phong_ambient();|vec3 ambient = phong_ambient() + 1e-9 * spin();|' "$(shader endless-shader)"
case_ endless-shader 1 "it was stopped after $limit s" ", timeout"
timeout=20

put early-exit 'exit(0);'
case_ early-exit 1 "it ended by itself with exit status 0 before the frame was drawn"

solved nothing-drawn >/dev/null
sed -i 's|frame_bind(frame);|frame_bind(frame); return;|' "$(c nothing-drawn)"
case_ nothing-drawn 1 "nothing drawn: the whole picture has one colour"

solved not-a-number >/dev/null
sed -i 's|o_color = vec4(ambient + lit|o_color = vec4(sqrt(-1.0 - ambient) + lit|' "$(shader not-a-number)"
case_ not-a-number 1 "some pixels are not finite numbers"

put memory 'for (volatile char *p;;) { p = malloc(1 << 26); for (int i = 0; i < 1 << 26; i += 4096) p[i] = 1; }'
[[ -n ${QUICK:-} ]] || # a sanitizer needs more addresses than a limit would leave
    case_ memory 1 "it crashed: Segmentation fault" "memory ends at 2048 MiB"

put flood 'for (;;) puts("all work and no play");'
case_ flood 1 "it printed more than 4 MiB and was stopped"

solved unreadable >/dev/null
chmod 000 "$(c unreadable)" && chmod 755 "$work"
if ((EUID == 0)); then
    status=0
    out=$(setpriv --reuid=65534 --regid=65534 --clear-groups "$grade" --lab 03 "$work/unreadable" 2>&1) || status=$?
    expect unreadable 1 "lab.c cannot be read: Permission denied"
else
    case_ unreadable 1 "lab.c cannot be read: Permission denied"
fi

solved link >/dev/null
mv "$(c link)" "$work/elsewhere.c" && ln -s "$work/elsewhere.c" "$(c link)"
case_ link 1 "lab.c is a symbolic link: hand in the file itself"

solved device >/dev/null
rm "$(c device)" && mkfifo "$(c device)"
case_ device 1 "lab.c is not a regular file"

solved extra >/dev/null
echo 'all: ; touch /tmp/owned' >"$work/extra/03-shadow-map/Makefile"
echo x >"$work/extra/03-shadow-map/notes.txt"
touch "$work"/extra/03-shadow-map/{lab.c~,'#lab.c#',.lab.c.swp} # of editors
case_ extra 0 "ignored: Makefile (not a file of this lab)" "ignored: notes.txt"
[[ $out != *"lab.c~"* && $out != *"#lab"* && $out != *.swp* ]] && ok || bad "what an editor leaves is told of" "$out"

solved no-table >/dev/null
sed -i 's/^const Lab lab/const Lab my_lab/' "$(c no-table)"
case_ no-table 1 "lab.c defines no complete table"

solved undefined >/dev/null
sed -i 's/frame_bind(frame);/draw_too_frame(frame);/' "$(c undefined)"
case_ undefined 1 "draw_too_frame"

solved gl-error >/dev/null
sed -i 's/glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24/glTexImage2D(GL_TEXTURE_2D, -1, GL_DEPTH_COMPONENT24/' "$(c gl-error)"
case_ gl-error 1 "GL_INVALID_VALUE in glTexImage2D (lab.c:1"

solved wrong-uniform >/dev/null
sed -i 's/"u_shadow_map"/"u_shadowmap"/' "$(c wrong-uniform)"
case_ wrong-uniform 0 "the uniform u_shadowmap is set but declared neither in scene.vert nor in shadow.frag"
solved short-uniform >/dev/null
sed -i 's/"u_light_clip_from_world"/"u_light_clip"/' "$(c short-uniform)"
case_ short-uniform 1 "the uniform u_light_clip is set but declared neither in scene.vert nor in shadow.frag"

# What a lecturer wrote: one message and status 3, from every program that reads it.
home=$work/home
mkdir -p "$home/build" && cp -r "$root"/{common,shaders,solutions} "$home" && cp -r "$root/$BUILD"/{grade,frame,prove,watch,worker,include,given} "$home/build" && cp "$root/$BUILD"/jail_* "$home/build"
rubric() { # FIND REPLACE: changes the rubric of the copy's lab 03
    sed "s|$1|$2|" "$root"/solutions/03-*/rubric.json >"$home/solutions/03-shadow-map/rubric.json"
    [[ $1 == "$2" ]] || ! cmp -s "$root"/solutions/03-*/rubric.json "$home/solutions/03-shadow-map/rubric.json" || bad "lab 03's rubric has no $1"
}
by() { status=0; out=$("$home/build/$1" "${@:2}" 2>&1) || status=$?; }
entry='rubric.json: checks[0] "depth map: spot light": '
rubric '"variants": 3' '"variants": 60'
for command in "grade --lab 03 --seed 1 $root/labs" "prove --lab 03 --seeds 1" "watch --list" "frame --lab 03 --scene x $work/x.png"; do
    by $command
    expect "60 variants: $command" 3 "${entry}variants: 60 does not fit; write a whole number from 1 to 8"
done
rubric '"view": "shadow map"' '"view": "moon"'
by grade --lab 03 --seed 1 "$root/labs"
expect "a stage that is none" 3 "${entry}view: the lab has no stage \"moon\"; write one of \"picture\", \"visibility\", \"shadow map\""
rubric '\(another map size.*\)\[[0-9, ]*\]' '\199999'
by grade --lab 03 --seed 1 "$root/labs"
expect "a knob out of its range" 3 'rubric.json: checks[4] "map pass at another map size": knobs: "map size": 99999 is outside'
rubric '"task": "3.1"' '"task": "3.30"'
by grade --lab 03 --seed 1 "$root/labs"
expect "a task without a check" 3 '"the size of the map is fixed": task: no check of rubric.json is about task "3.1"'
rubric x x
cp -r "$home"/solutions/03-shadow-map "$home/solutions/03-twice"
by grade --seed 1 "$root/labs"
expect "two labs of one number" 3 "solutions holds two folders of lab 03; rename one"
rm -r "$home/solutions/03-twice"
mv "$home/solutions" "$home/kept" && mkdir "$home/solutions"
mkdir -p "$work/nobody/ann" && cp -r labs/03-shadow-map "$work/nobody/ann"
for command in "$root/labs" "--class $work/nobody --output $work/none" "--class $work/nobody --output $work/none --dry-run"; do
    by grade $command
    expect "no lab of ours: $command" 3 "there is no lab in $home/solutions"
done
rmdir "$home/solutions" && mv "$home/kept" "$home/solutions"

# None of them stops the grading of the other labs.
for name in compile-error crash endless-loop missing-file; do
    cp -r "$root"/solutions/02-* "$work/$name"
    grades --lab 02 --lab 03 --seed 1 --timeout "$limit" --format json "$work/$name"
    [[ $(field '[l["score"] for l in r["labs"]]') == "[100.0, 0.0]" ]] && ok || bad "$name stops lab 02" "$out"
done

finish
