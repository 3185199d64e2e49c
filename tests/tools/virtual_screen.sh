# shellcheck shell=bash
# Sourced by tools that look at the window: a screen in memory and a user of its own.

# open_screen OUT: makes the folder, which must not be there; sets `out` to its full path, `gripscan` to
# the program, HOME and DISPLAY. The screen ends with the script. From the root of the sources.
open_screen() {
    out=$1
    gripscan=$PWD/build/release/bin/gripscan
    [[ -e $out ]] && { echo "$out exists; choose another folder" >&2; exit 2; }
    mkdir -p "$out"
    out=$(cd "$out" && pwd)
    export HOME=$out/home XDG_STATE_HOME=$out/home/state XDG_CONFIG_HOME=$out/home/config
    export LIBGL_ALWAYS_SOFTWARE=1
    mkdir -p "$HOME"

    Xvfb -displayfd 3 -screen 0 1600x1000x24 -nolisten tcp 3>"$out/display" 2>/dev/null &
    screen=$!
    trap 'kill $screen 2>/dev/null; true' EXIT
    for _ in $(seq 100); do [[ -s $out/display ]] && break; sleep 0.1; done
    DISPLAY=:$(cat "$out/display")
    export DISPLAY
}
