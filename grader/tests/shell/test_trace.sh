#!/usr/bin/env bash
# A frame of a student's lab for a frame debugger: the job, and what apitrace and RenderDoc record of it.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
runs() { status=0; out=$("$@" 2>&1) || status=$?; }

# The student's lab draws what the grader sees of it; a job without its frame holds all that a worker needs.
frame=("$BUILD/frame" --lab 03 --scene "table spot" --size 64x48)
runs "${frame[@]}" --submission solutions/03-shadow-map "$work/a.png"
runs "${frame[@]}" "$work/b.png"
cmp -s "$work/a.png" "$work/b.png" && ok || bad "the solution as a submission draws the solution's frame"
runs "${frame[@]}" --submission labs/03-shadow-map --job "$work/job"
expect "a job" 0
for file in lab.so lab.c shadow.frag request; do
    [[ -s $work/job/$file ]] && ok || bad "the job has no $file"
done
(cd "$work/job" && "$root/$BUILD/worker" egl . "$root/shaders" <request 3>reply) && ok || bad "a worker takes the job"
(($(stat -c %s "$work/job/reply") > 64 * 48 * 4)) && ok || bad "the worker answers the job"
runs "${frame[@]}" --job "$work/job"
expect "a job of nobody" 2 "--job needs --submission"
broken=$(solved broken 03)
echo 'int x = ;' >>"$broken/03-shadow-map/lab.c"
runs "${frame[@]}" --submission "$broken/03-shadow-map" "$work/c.png"
expect "a lab that does not compile" 1 "lab.c does not compile" "expected expression"
runs grader/scripts/trace 77
expect "no such lab" 2 'there is no lab "77"'
runs env TOOL=crystal grader/scripts/trace 03
expect "no such tool" 2 'not "crystal"'

# The tools themselves, in a copy with the solution as the student's work.
copy=$work/copy
mkdir -p "$copy/build"
cp -r "$root"/{common,shaders,solutions,grader} "$copy"
cp -r "$root/solutions" "$copy/labs"
cp -r "$root/$BUILD"/{frame,worker,include,given} "$copy/build"
cd "$copy" || exit 1
if command -v apitrace >/dev/null; then
    runs grader/scripts/trace 03
    expect "apitrace" 0 "build/trace/03/frame.trace"
    [[ $(apitrace dump --color=never build/trace/03/frame.trace | grep -c ' glDrawElements(') == 6 ]] && ok ||
        bad "the trace has the floor, the box and the sphere in both passes" "$(apitrace dump build/trace/03/frame.trace | grep Draw)"
else
    skip "there is no apitrace (common/setup --test)"
fi
if command -v renderdoccmd >/dev/null && [[ -e /usr/include/renderdoc_app.h ]]; then
    TOOL=renderdoc runs grader/scripts/trace 03
    expect "RenderDoc" 0 "build/trace/03/frame_capture.rdc"
    renderdoccmd convert -f build/trace/03/frame_capture.rdc -o frame.xml -c xml >/dev/null 2>&1
    [[ $(grep -c 'name="glDrawElements"' frame.xml) == 6 ]] && ok || bad "RenderDoc's capture has the six draw calls"
else
    skip "there is no RenderDoc, or not its header (common/setup --test)"
fi
finish
