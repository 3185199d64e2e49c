#!/usr/bin/env bash
# Makes the pictures of the README with the scripted driver: a turn in the simulated cell.
# usage: tests/tools/animation.sh OUT
# OUT receives turn.gif (the turn, 720 px wide), window.png (1600 x 1000, the finished turn) and the
# pictures between. Needs Xvfb and ImageMagick's convert; about four minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:?usage: animation.sh OUT}
command -v convert >/dev/null || { echo "convert is missing; install imagemagick" >&2; exit 2; }
source tests/tools/virtual_screen.sh
open_screen "$out"

n=100
shot() {
    echo "pause ${1:-0.2}"
    echo "picture $out/$n.png"
    n=$((n + 1))
}
{
    echo "wait start.simulated"
    shot 1
    echo "click start.simulated"
    echo "wait step.check_cell"
    shot 1
    echo "click step.check_cell"
    echo "wait step.warm_up"
    shot 0.5
    echo "click step.warm_up"
    echo "wait step.capture"
    shot 0.5
    echo "click step.capture"
    echo "wait step.step"
    shot 1
    echo "key Space"
    echo "wait step.step"
    shot 1
    echo "click mode.run"
    echo "drag view3d.scene 1 0" # the pointer away from the switch and its explanation
    for _ in $(seq 20); do shot 6; done
    echo "wait window.export 900"
    echo "pause 2"
    echo "picture $out/window.png"
    shot
    for _ in $(seq 5); do
        echo "drag view3d.scene 70 -6"
        shot
    done
    echo "click page.template"
    shot 4
} >"$out/script.txt"
"$gripscan" --script "$out/script.txt"

# Half a second a picture, the first and the last longer. Few colours: the window has few.
pictures=("$out"/1[0-9][0-9].png)
convert -delay 150 "${pictures[0]}" -delay 60 "${pictures[@]:1:${#pictures[@]}-2}" -delay 300 \
    "${pictures[-1]}" -filter Lanczos -resize 720x -dither None -colors 64 -layers OptimizeTransparency \
    -loop 0 "$out/turn.gif"
ls -l "$out/turn.gif" "$out/window.png"
