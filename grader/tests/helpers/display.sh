# A display of one's own (Xvfb), and a window on it to look at and to press keys in. Sourced after lib.sh, with $scene and $size
# set; $lab is 03 until it is set.
view=$root/$BUILD/view frame=$root/$BUILD/frame lab=03
patience=${QUICK:+6} patience=$((150 * ${patience:-1})) # tenths of a second; sanitizers are slow
export TMPDIR=$work/tmp && mkdir "$TMPDIR"
export ASAN_OPTIONS=detect_leaks=0 # of the X11 and GL libraries; the worker has none either

mkfifo "$work/display"
Xvfb -displayfd 3 -screen 0 1024x768x24 -noreset -nolisten tcp 3>"$work/display" 2>/dev/null &
xvfb=$!
trap 'kill $xvfb; rm -rf "$work"' EXIT
read -r number <"$work/display"
export DISPLAY=:$number

# wait_for NAME COMMAND...: the command succeeds in time.
wait_for() {
    local name=$1 i
    shift
    for ((i = 0; i < patience; i++)); do
        "$@" && ok && return
        sleep 0.1
    done
    bad "$name" "$(cat "$work/log"; xdotool getwindowname "$window")"
}
open_window() { # ARGUMENTS...
    "$view" --lab "$lab" --scene "$scene" --size $size --bare "$@" >"$work/log" 2>&1 &
    pid=$!
    local i
    for ((i = 0; i < patience; i++)); do
        window=$(xdotool search --onlyvisible --pid $pid 2>/dev/null | tail -1)
        [[ -n $window ]] && return
        sleep 0.1
    done
    bad "a window opens" "$(cat "$work/log")"
}
close_window() {
    kill $pid
    wait $pid
}
headless() { "$frame" --lab "$lab" --scene "$scene" --size $size "$@" "$work/wanted.png"; }
same() { [[ $(compare -metric AE "$1" "$2" null: 2>&1) == 0 ]]; }
picture() { [[ -n $window ]] && import -window "$window" "$work/now.png"; } # without a name import would wait for a click
shows() { picture && same "$work/now.png" "$work/wanted.png"; }
keeps() { picture && ! same "$work/now.png" "$work/wanted.png"; }
titled() { [[ $(xdotool getwindowname "$window") == *"$1"* ]]; }
told() { grep -qF -- "$1" "$work/log"; }
keys() { xdotool key --window "$window" "$@"; }
# fitted ARGUMENTS...: what the window shows of a stage that is a square: that, in the middle, on grey.
fitted() {
    local side=${size#*x}
    "$frame" --lab "$lab" --scene "$scene" --size "${side}x$side" "$@" "$work/wanted.png" &&
        convert "$work/wanted.png" -background '#282828' -gravity center -extent "$size" "$work/wanted.png"
}
