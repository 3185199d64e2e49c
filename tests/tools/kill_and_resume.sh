#!/usr/bin/env bash
# Kills gripper registrations at random moments, resumes them, and compares what they end with.
# A moment is an entry of the journal, any of those that the undisturbed run wrote, and some time
# after it: however busy the machine is, every part of a run is hit.
# usage: tests/tools/kill_and_resume.sh OUT [RUNS] [STEP_DEG] [SEED]
# RUNS (default 30) with the cell in the killed process, and as many with `gripscan simcell` living
# on in its own. Ends with status 0 if every run ends as the undisturbed one did: the same status and
# the same template, byte for byte.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:?usage: kill_and_resume.sh OUT [RUNS] [STEP_DEG] [SEED]}
runs=${2:-30}
step=${3:-20}
seed=${4:-1}
gripscan=$PWD/build/release/bin/gripscan
RANDOM=$seed
[[ -e $out ]] && { echo "$out exists; choose another folder" >&2; exit 2; }
mkdir -p "$out"

simcell=
trap '[[ -n $simcell ]] && kill "$simcell" 2>/dev/null; true' EXIT

# start_simcell LOG CELL_DIR
start_simcell() {
    "$gripscan" simcell --port 0 --seed "$seed" --step-deg "$step" --time-scale 20 --cell-out "$2" \
        >"$1" 2>&1 &
    simcell=$!
    for _ in $(seq 100); do
        grep -q '^listening ' "$1" && return
        sleep 0.1
    done
    echo "simcell did not start: $(cat "$1")" >&2
    exit 2
}
stop_simcell() {
    kill "$simcell" 2>/dev/null || true
    wait "$simcell" 2>/dev/null || true
    simcell=
}

# registration KIND SESSION: how to call one, in the array `call`
registration() {
    local cell=(--cell sim --seed "$seed")
    [[ $1 == own ]] && cell=(--cell "$2.cell/cell.yaml" --live)
    call=("$gripscan" run gripper "${cell[@]}" --step-deg "$step" --out "$2" --quiet)
}

begin_ms=$(date +%s%3N)
wanted=0
registration in "$out/undisturbed"
"${call[@]}" || wanted=$?
whole_ms=$(($(date +%s%3N) - begin_ms))
echo "undisturbed: status $wanted, $whole_ms ms"
[[ -s $out/undisturbed/results/template.pcd ]] || { echo "it made no template" >&2; exit 2; }

entries=$(wc -l <"$out/undisturbed/journal")

# lines FILE: how many it has; 0 before there is one
lines() {
    if [[ -e $1 ]]; then wc -l <"$1"; else echo 0; fi
}

# draw BELOW: a random number, in `drawn`; a subshell would draw the same one every time
draw() {
    drawn=$(((RANDOM * 32768 + RANDOM) % $1))
}

failed=0
for i in $(seq "$runs"); do
    for kind in in own; do
        session=$out/$kind-$i
        [[ $kind == own ]] && start_simcell "$session.log" "$session.cell"
        registration "$kind" "$session"
        # The program itself, not a shell that runs it: it is what has to die.
        "${call[@]}" >/dev/null 2>&1 &
        pid=$!
        draw "$entries"
        after=$drawn
        while (($(lines "$session/journal") < after)) && kill -0 "$pid" 2>/dev/null; do
            sleep 0.01
        done
        draw $((2 * whole_ms / entries))
        after_ms=$drawn
        sleep "$(printf '%d.%03d' $((after_ms / 1000)) $((after_ms % 1000)))"
        kill -KILL "$pid" 2>/dev/null || true
        wait "$pid" 2>/dev/null || true
        views=$(ls "$session/frames" 2>/dev/null | grep -c left || true)
        status=0
        # Killed before it had anything in its folder there is nothing to resume.
        resume=(--resume)
        [[ -n $(ls -A "$session" 2>/dev/null) ]] || resume=()
        "${call[@]}" "${resume[@]}" >"$session.resumed" 2>&1 || status=$?
        verdict=same
        cmp -s "$out/undisturbed/results/template.pcd" "$session/results/template.pcd" ||
            verdict=DIFFERENT
        [[ $verdict == same && $status == "$wanted" ]] || failed=$((failed + 1))
        echo "$kind $i: killed $after_ms ms after entry $after of $entries, $views views; resumed: status $status, $verdict"
        [[ $kind == own ]] && stop_simcell
        [[ $verdict == same ]] && rm -rf "$session" "$session.cell"
    done
done
echo "$((2 * runs - failed)) of $((2 * runs)) ended with the template of the undisturbed run"
[[ $failed == 0 ]]
