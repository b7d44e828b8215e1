#!/usr/bin/env bash
# The checkers themselves: fed something wrong, each must refuse it. Works in a copy of the project.
set -u
source "$(dirname "$0")/../helpers/lib.sh"

copy=$work/copy
mkdir -p "$copy/build"
cp -r "$root"/{Makefile,README.md,.github,common,shaders,labs,solutions,grader,.clang-format} "$copy"
mkdir -p "$root/$BUILD/cache"
cp -a "$root/$BUILD"/{grade,frame,chart,skeletons,prove,worker,include,given,cache} "$root/$BUILD"/jail_* "$copy/build" # with its time: the cache goes by the worker's
cd "$copy" || exit 1
three=solutions/03-shadow-map

runs() { status=0; out=$("$@" 2>&1) || status=$?; }
# with FILE PROGRAM COMMAND...: runs the command while python changed the JSON (j) of the file, then puts it back.
with() {
    local file=$1 program=$2
    shift 2
    cp "$file" "$work/kept"
    python3 -c 'import json,sys; j=json.load(open(sys.argv[1])); exec(sys.argv[2]); json.dump(j, open(sys.argv[1], "w"))' "$file" "$program"
    runs "$@"
    cp "$work/kept" "$file"
}
prove=(build/prove --lab 03 --seeds 1)

# The rubric's proof.
with $three/mistakes.json 'j[:] = [dict(j[0], name="harmless", edits=[dict(file="lab.c", find="LIGHT_DIRECTIONAL)", replace="1 * LIGHT_DIRECTIONAL)")])]' "${prove[@]}"
expect "a mistake that is none" 1 "harmless | 100 | 100 | WRONG: not below the pass mark" ", 1 failed"
with $three/mistakes.json 'j[1]["edits"] = j[2]["edits"]; j[1]["task"] = j[2]["task"]; j[:] = j[1:3]' "${prove[@]}"
expect "two mistakes with one picture" 1 "WRONG:"
with $three/alternatives.json 'j[0] = dict(name="wrong", edits=[dict(file="shadow.frag", find="? 0.0 : 1.0", replace="? 1.0 : 0.0")])' "${prove[@]}"
expect "an alternative that is wrong" 1 "alternative | wrong" "WRONG: comparison: spot light"
with $three/mistakes.json 'j[0]["edits"][0]["find"] = "no such text"' "${prove[@]}"
expect "an edit without its text" 3 'mistakes.json: [0] "' "edits[0]: find: the text to replace stands in " " nowhere" "no such text"
with $three/rubric.json 'j["checks"][0]["scene"] = "moon"' "${prove[@]}"
expect "an unknown scene" 3 'rubric.json: checks[0] "depth map: spot light": scene: there is no scene "moon"; the scenes are'
with $three/rubric.json 'j["checks"][0]["view"] = "moon"' "${prove[@]}"
expect "an unknown stage" 3 'checks[0] "depth map: spot light": view: the lab has no stage "moon"'
with $three/rubric.json 'j["checks"][8]["scene"] = "table sun"' build/grade --lab 03 --seed 1 labs
expect "a check whose task does not show" 3 'check "dark behind the spot light": seed 1 gives only' "of 3 variants in which the task shows" "fix the rubric"

# The gates.
export SKIP_TIDY=1
runs grader/scripts/gates build
expect "the gates of the project as it is" 0 ", 0 failed"
# breaks NAME PATTERN COMMAND: the shell command breaks one thing; `refused` runs the gates, which must tell each of them, and puts
# everything back. What is broken together lies in other files or other gates.
names=() patterns=()
breaks() {
    bash -c "$3"
    names+=("$1") patterns+=("$2")
}
refused() {
    runs grader/scripts/gates build
    for i in "${!names[@]}"; do expect "${names[i]}" 1 "${patterns[i]}"; done
    names=() patterns=()
    rm -rf labs solutions common && cp -r "$root"/{labs,solutions,common} .
}
breaks "a task without a hint" "FAILED: 03-shadow-map: task ids agree" "sed -i 's/\"3.4\": \\[/\"3.44\": [/' $three/hints.json"
breaks "a mistake's hint that holds what is returned" "step order: depth<position_map.z?0.0:1.0" "sed -i '0,/\"name\": \"[^\"]*\"/s//\"name\": \"step order\"/; 0,/\"hint\": \"/s//&depth < position_map.z ? 0.0 : 1.0/' $three/mistakes.json"
breaks "points that do not sum to 100" "FAILED: 03-shadow-map: 100 points" "sed -i '0,/\"points\": [0-9]*/s//\"points\": 88/' $three/rubric.json"
breaks "a long file" "FAILED: files of at most 300 lines" "seq -f '// %g' 301 >common/long.h"
breaks "a long .c that does not say its job" "common/gl.c: its first line says nothing" "sed -i '0,/^#include/{/^\/\//d}' common/gl.c"
breaks "common/ that knows a lab" "FAILED: floors: common/ knows neither labs" "echo '// see solutions/03' >>common/scene/random.h"
breaks "an include that points up" "common/scene/random.c:3: scene includes draw.h, which is up" "sed -i '2a #include \"draw.h\"' common/scene/random.c"
breaks "two types of one name" "Process: common/scene/random.h grader/base/process.h" "echo 'typedef struct Process { int id; } Process;' >>common/scene/random.h"
breaks "two modules of one name" "pipe.c: common/pipe.h grader/base/pipe." "cp common/scene/count.h common/pipe.h"
breaks "two files of one name" "page.css: common/page.css grader/pages/page.css" "cp grader/pages/page.css common"
breaks "a missing picture" "picture.png is missing" "rm labs/03-shadow-map/map.png labs/03-shadow-map/picture.png"
refused
breaks "a task with two hints" "FAILED: 03-shadow-map: task ids agree" "python3 -c 'import json; p = \"$three/hints.json\"; j = json.load(open(p)); del j[\"3.4\"][2]; json.dump(j, open(p, \"w\"))'"
breaks "a skeleton with a warning" "FAILED: 03-shadow-map: the skeleton builds without warnings" "sed -i 's/    UNUSED(light);//' $three/lab.c && sed -i 's/^static void destroy/static int unused;\n&/' $three/lab.c && build/skeletons labs"
breaks "a long student file" "FAILED: student files of at most 120 lines" "seq -f '// %g' 121 >>$three/shadow.frag && build/skeletons labs"
breaks "a package in a room that does not know it" "only truth may include embree3/rtcore.h" "sed -i '2a #include <embree3/rtcore.h>' common/scene/random.c"
breaks "an include without its room" "names no file from common/ or grader/ on" "sed -i '2a #include \"score.h\"' common/scene/random.c"
breaks "a circle" "a circle: common/scene/scene -> common/scene/random -> common/scene/scene" "sed -i '2a #include \"scene/scene.h\"' common/scene/random.c"
refused
breaks "a hint that holds a line of the solution" "3.4: glClear(GL_DEPTH_BUFFER_BIT)" "sed -i 's/clear the depth, and let/glClear( GL_DEPTH_BUFFER_BIT ), and let/' $three/hints.json"
breaks "a task that the handout forgets" "FAILED: 03-shadow-map: task ids agree" "sed -i '/^| 3.5 /d' $three/README.md && build/skeletons labs"
breaks "labs/ edited by hand" "labs/03-shadow-map/shadow.frag differ" "echo >>labs/03-shadow-map/shadow.frag"
refused
cp grader/score/README.md "$work/readme"
echo 'See `score_old.c`, [there](../none), `make nonsense`, `build/nonsense --help` and `grader/score/none`.' >>grader/score/README.md
runs grader/scripts/named_files
expect "a README that names what is gone" 1 "grader/score/README.md: score_old.c is not there" ": ../none is not" ": make nonsense is not" ": build/nonsense is not" ": grader/score/none is not"
cp "$work/readme" grader/score/README.md

# Students' helpers.
echo "// mine" >>labs/03-shadow-map/shadow.frag
runs grader/scripts/reset 03
expect "reset" 0 "your files are kept in labs/03-shadow-map.backup-"
tail -1 labs/03-shadow-map.backup-*/shadow.frag | grep -q mine && cmp -s labs/03-shadow-map/shadow.frag "$root/labs/03-shadow-map/shadow.frag" && ok || bad "reset keeps the old and restores the new"
for n in 1 2; do echo "// again $n" >>labs/03-shadow-map/shadow.frag && runs grader/scripts/reset 03; done
[[ $(cat labs/03-shadow-map.backup-*/shadow.frag | grep -cE '^// (mine|again)') == 3 ]] && ok || bad "each reset keeps its own backup" "$(ls labs)"
runs grader/scripts/reset 03
expect "reset of a skeleton" 0 "is the skeleton already"
runs grader/scripts/reset 77
expect "reset of no lab" 2 'there is no lab "77"; there are 01, 02'
runs grader/scripts/hint 3.2
expect "hint" 0 "Hint 1 of 3 for task 3.2"
runs grader/scripts/hint 3.77
expect "hint of no task" 2 "has no task 3.77; it has 3.1, 3.2"
runs grader/scripts/hint
expect "hint without a task" 2 "make hint TASK=3.2"
runs common/setup --frobnicate
expect "setup with a wrong option" 2 "usage: common/setup"
runs env PATH=/usr/bin:/bin:/usr/sbin:/sbin common/setup
expect "setup with nothing missing" 0
[[ -z $out ]] && ok || bad "setup is silent when nothing is missing" "$out"
mkdir "$work/bin" && for tool in bash dirname cat grep sort paste tr ldconfig; do ln -s "$(command -v $tool)" "$work/bin/"; done
runs env PATH="$work/bin" common/setup
expect "setup without apt-get" 1 "setup: missing: make gcc" "sudo dnf install" "sudo pacman -S" "brew install"

# A test that waits for ever.
rm grader/tests/shell/*
mkdir hang && printf '#!/bin/sh\nsleep 1000\n' >hang/test_hang && chmod +x hang/test_hang
runs env PATIENCE=1 grader/tests/run hang
expect "a test that waits for ever" 1 "stopped after 1 s" "0 passed, 1 failed"

finish
