#!/usr/bin/env bash
# The contest: who passes is ranked by what his method costs, painters are not, and one seed gives the same bytes.
set -u
source "$(dirname "$0")/../helpers/lib.sh"
cd "$root" || exit 1
if [[ ! -x $BUILD/record_arena ]]; then
    skip "there is no Embree, which traces what is right"
    finish
    exit
fi
arena=$work/arena lab=14-soft-shadows
"$BUILD/record_arena" --lab 14 --seed 5 "$arena" >"$work/log" 2>&1 && ok || bad "the cameras" "$(cat "$work/log")"
competes() { status=0; out=$("$BUILD/compete" --lab 14 --arena "$arena" "$@" 2>"$work/errors") || status=$?; }

# hand_in NAME [FILE FIND REPLACE]...: the solution with these texts exchanged, in the class's folder.
hand_in() {
    local to
    to=$(solved "class/$1" 14)/$lab
    shift
    python3 - "$to" "$@" <<'END' || bad "a text is not there" "$*"
import pathlib, sys
folder, *edits = sys.argv[1:]
for file, find, replace in zip(*[iter(edits)] * 3):
    path = pathlib.Path(folder, file)
    text = path.read_text()
    assert text.count(find) == 1, (file, find)
    path.write_text(text.replace(find, replace))
END
}

# Four methods of one picture. Where all that the search meets is a blocker, the filter finds nothing lit; where a surface faces
# away, nobody sees its shadow.
core=(pcss.glsl "float mean_blocker(" $'bool g_all = false;\nfloat mean_blocker('
    pcss.glsl "return found > 0 ?" $'g_all = found == u_search_taps * u_search_taps;\n    return found > 0 ?'
    shadow.frag "        side = kernel_side(blocker, receiver);" $'        if (g_all)\n            return 0.0;\n        side = kernel_side(blocker, receiver);')
away=(shadow.frag "lit = visibility(v_position_world);"
    "lit = dot(normalize(v_normal_world), direction_to_light(0, v_position_world)) > 0.0 ? visibility(v_position_world) : 0.0;")
hand_in ann
hand_in bob pcss.glsl "float depth = texture(u_shadow_map, place).r;" "float depth = 0.5 * (texture(u_shadow_map, place).r + texture(u_shadow_map, place).r);"
hand_in cyn "${core[@]}"
hand_in dan "${core[@]}" "${away[@]}"
# Who clears the map twice pays for its texels: 512 x 512 of them for 320 x 240 pixels are 3.4.
hand_in eve lab.c "    glCullFace(GL_FRONT);" $'    glClear(GL_DEPTH_BUFFER_BIT);\n    glCullFace(GL_FRONT);'
# One wide kernel for all; and one who traces rays through the scene and draws what is right, with no more reads than a search.
hand_in gus shadow.frag "if (!u_fixed)" "if (false)"
hand_in hal lab.c "    program_set_int(program, \"u_filter_taps\"" '    mat4s inverse[16];
    int shapes[16];
    vec3s lamp[3] = {light->position};
    light_axes(light, &lamp[1], &lamp[2]);
    for (int i = 0; i < frame->scene->object_count; i++) {
        inverse[i] = glms_mat4_inv(frame->scene->objects[i].world_from_object);
        shapes[i] = (int)frame->scene->objects[i].shape;
    }
    glProgramUniformMatrix4fv(program->id, program_find(program, "u_inverse"), frame->scene->object_count, GL_FALSE, inverse[0].raw[0]);
    glProgramUniform1iv(program->id, program_find(program, "u_shapes"), frame->scene->object_count, shapes);
    glProgramUniform1i(program->id, program_find(program, "u_objects"), frame->scene->object_count);
    glProgramUniform3fv(program->id, program_find(program, "u_lamp"), 3, lamp[0].raw);
    program_set_int(program, "u_filter_taps"' shadow.frag "in vec3 v_normal_world;" 'in vec3 v_normal_world;
uniform mat4 u_inverse[16];
uniform int u_shapes[16], u_objects;
uniform vec3 u_lamp[3];
bool is_hit(int shape, vec3 from, vec3 to) {
    vec3 along = to - from;
    if (shape == SPHERE) {
        float a = dot(along, along), b = dot(from, along), c = dot(from, from) - 1.0, root = b * b - a * c;
        return root > 0.0 && -b - sqrt(root) > 1e-3 * a && -b - sqrt(root) < a;
    }
    vec3 one = (-1.0 - from) / along, other = (1.0 - from) / along, low = min(one, other), high = max(one, other);
    return shape == BOX && max(max(low.x, low.y), max(low.z, 1e-3)) < min(min(high.x, high.y), min(high.z, 1.0)) - 1e-3;
}
float paint(vec3 point) {
    float lit = 0.0;
    for (int k = 0; k < 256; k++) {
        vec2 at = (vec2(k / 16, k % 16) + 0.5) / 16.0 - 0.5;
        vec3 lamp = u_lamp[0] + u_lamp_side * (at.x * u_lamp[1] + at.y * u_lamp[2]);
        bool hit = false;
        for (int i = 0; i < u_objects && !hit; i++)
            hit = is_hit(u_shapes[i], (u_inverse[i] * vec4(point, 1.0)).xyz, (u_inverse[i] * vec4(lamp, 1.0)).xyz);
        lit += hit ? 0.0 : 1.0 / 256.0;
    }
    return lit;
}' shadow.frag "lit = visibility(v_position_world);" \
    "lit = u_search_taps == 2 ? paint(v_position_world) : visibility(v_position_world);"
for shape in SPHERE BOX; do
    number=$(grep -oE 'SHAPE_[A-Z]+' common/scene/mesh.h | grep -n "^SHAPE_$shape$" | head -1 | cut -d: -f1)
    sed -i "s/\b$shape\b/$((number - 1))/g" "$work/class/hal/$lab/shadow.frag"
done

competes --class "$work/class" --page "$work/one.html" --anonymous "$work/secret.csv"
expect "a class" 1 'errs at most 0.20 %'
name() { python3 -c 'import csv,sys; print({r["student"]: r["pseudonym"] for r in csv.DictReader(open(sys.argv[1]))}[sys.argv[2]])' "$work/secret.csv" "$1"; }
line() { grep -F -- "$(name "$1")" <<<"$out"; }
cost() { line "$1" | sed -nE 's/.* ([0-9.]+) a pixel:.*/\1/p'; }
order=$(for student in dan cyn ann eve bob; do cost $student; done)
[[ $(wc -l <<<"$order") == 5 && $order == "$(sort -g -u <<<"$order")" ]] && ok || bad "in the order of what they read" "$out"
python3 -c 'import sys; ann, eve = map(float, sys.argv[1:]); assert abs(eve - ann - 512 * 512 / (320 * 240)) < 0.1' "$(cost ann)" "$(cost eve)" 2>/dev/null && ok ||
    bad "a second clear costs its texels" "$out"
[[ $(line gus) == *"not ranked: it does not pass: "* ]] && ok || bad "a fixed kernel does not pass" "$out"
[[ $(line hal) == *"not ranked: its shadows do not come from a map"* ]] && ok || bad "a painter" "$out$(cat "$work/errors")"
grep -qE 'ann|bob' "$work/one.html" && bad "a page of pseudonyms with names" || ok
grep -qF "$(name ann)" "$work/one.html" && ok || bad "the page has a row for each" "$(cat "$work/one.html")"

# Once more, and alone: the same line, the same page.
rm -r "$work"/class/{bob,cyn,dan,eve,gus,hal}
before=$(line ann | sed 's/^ *[0-9]*//')
for page in two three; do
    competes --class "$work/class" --page "$work/$page.html" --anonymous "$work/secret.csv"
    [[ $status == 0 && $(line ann | sed 's/^ *[0-9]*//') == "$before" ]] && ok || bad "the same once more" "$out, not $before"
done
cmp -s "$work/two.html" "$work/three.html" && ok || bad "two runs give the same page"

# Gradescope's key, and what says why there is none.
valid() { python3 -c 'import json,sys,jsonschema; jsonschema.validate(json.load(open(sys.argv[1])), json.load(open("grader/report/gradescope.schema.json")))' "$1" 2>&1; }
"$grade" --lab 14 --seed 1 --format gradescope labs/$lab >"$work/bad.json" 2>"$work/log"
cp "$work/bad.json" "$work/good.json"
competes --results "$work/good.json" "$work/class/ann"
out=$(cat "$work/good.json")
[[ $status == 0 && -z $(valid "$work/good.json") && $(field '[e["name"] for e in r["leaderboard"]], r["leaderboard"][0]["order"], str(r["leaderboard"][0]["value"])') == \
    "(['cost a pixel', 'error, %', 'setting'], 'asc', '$(sed -nE 's/.* ([0-9.]+) a pixel.*/\1/p' <<<"$before")')" ]] && ok || bad "the key leaderboard" "$out$(valid "$work/good.json")"
competes --results "$work/bad.json" labs/$lab
out=$(cat "$work/bad.json")
[[ $status == 1 && -z $(valid "$work/bad.json") && $(field '"leaderboard" in r, "Not on the leaderboard: it does not pass" in r["output"]') == "(False, True)" ]] && ok ||
    bad "no key for who does not pass" "$out$(valid "$work/bad.json")"

# What makes no sense is refused.
out=$("$BUILD/record_arena" --lab 03 "$work/none" 2>&1) && bad "a lab without a contest" "$out" || ok
competes --results "$work/nowhere.json" "$work/class/ann"
[[ $status == 3 ]] && ok || bad "no results to add to" "$status $out"
sed -i 's/"14"/"03"/' "$arena/arena.json"
competes "$work/class/ann"
[[ $status == 3 && $(cat "$work/errors") == *"is of lab 03, not of lab 14"* ]] && ok || bad "cameras of another lab" "$(cat "$work/errors")"
status=0 out=$("$BUILD/compete" --lab 14 labs 2>&1) || status=$?
expect "without cameras" 2 "--arena DIR"

finish
