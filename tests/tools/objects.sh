#!/usr/bin/env bash
# Registers objects in the simulated gripper and measures the templates and the slip against the truth.
# usage: tests/tools/objects.sh OUT [SEED...]
# For every seed (default 1 2 3): the gripper, then each of OBJECTS (default "carton jug bracket hexagon":
# box-like, curved, flat, near-symmetric) held by it. Wanted: RMS ≤ 0.4 mm, at least 85 % of the object's
# visible surface, fewer than 0.5 % foreign points, and no slip reported. Then, with SLIPS=N (default 10)
# seeds from 21 on: an object that slides by 1 mm and one that turns by 1 deg in the gripper during
# step 2, which must stop the run with cause slip in 18 of 20. STEP_DEG (default 10) is the step.
# Ends with status 0 if all of it holds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:?usage: objects.sh OUT [SEED...]}
shift
seeds=("$@")
[[ ${#seeds[@]} -gt 0 ]] || seeds=(1 2 3)
read -ra objects <<<"${OBJECTS-carton jug bracket hexagon}"
bin=build/release/bin
step=${STEP_DEG:-10}
mkdir -p "$out"
good=0
total=0
alarms=0
clean=0

# gripper SEED: its session, made once
gripper() {
    local session=$out/gripper-$1
    [[ -e $session/results/template.pcd ]] ||
        "$bin/gripscan" run gripper --cell sim --seed "$1" --step-deg "$step" --out "$session" \
            --quiet >&2
    echo "$session"
}

# figure FILE NAME
figure() { sed -n "s/^ *\"$2\": \([0-9.e-]*\),*$/\1/p" "$1" | head -1; }

for seed in "${seeds[@]}"; do
    held_by=$(gripper "$seed")
    for object in "${objects[@]}"; do
        session=$out/$object-$seed
        rm -rf "$session" "$session.truth"
        status=0
        "$bin/gripscan" run object --cell sim --seed "$seed" --step-deg "$step" --object "$object" \
            --gripper "$held_by" --out "$session" --truth "$session.truth" \
            >"$session.out" 2>"$session.err" || status=$?
        "$bin/template_truth" "$session/results/template.pcd" "$session.truth" --object \
            >"$session.score" || true
        rms=$(figure "$session.score" rms_mm)
        seen=$(figure "$session.score" coverage)
        foreign=$(figure "$session.score" foreign)
        slips=$(grep -c 'cause=slip' "$session.err" || true)
        steps=$(grep -cE 'step [0-9]+ -> [0-9]+: ' "$session.err" || true)
        echo "$object $seed: status $status, RMS $rms mm, visible $seen, foreign $foreign," \
            "$slips slips in $steps steps"
        total=$((total + 1))
        clean=$((clean + 1))
        ((slips == 0)) || alarms=$((alarms + 1))
        awk "BEGIN { exit !(${rms:-9} <= 0.4 && ${seen:-0} >= 0.85 && ${foreign:-1} < 0.005) }" &&
            good=$((good + 1))
    done
done

found=0
slipped=0
for ((i = 0; i < ${SLIPS:-10}; ++i)); do
    seed=$((21 + i))
    held_by=$(gripper "${seeds[$((i % ${#seeds[@]}))]}")
    seed=${seeds[$((i % ${#seeds[@]}))]}
    object=${objects[$((i % ${#objects[@]}))]}
    for fault in object_slip@2=1 object_twist@2=1; do
        session=$out/${fault%%@*}-$i
        rm -rf "$session"
        "$bin/gripscan" run object --cell sim --seed "$seed" --step-deg "$step" --object "$object" \
            --gripper "$held_by" --fault "$fault" --out "$session" \
            >"$session.out" 2>"$session.err" || true
        cause=$(sed -n 's/^.*advice \([0-9]* -> [0-9]*\): cause=\([a-z_]*\) .*/\1 \2/p' "$session.err" |
            grep -v none | tail -1)
        slipped=$((slipped + 1))
        [[ $cause == *slip ]] && found=$((found + 1))
        echo "$fault, $object $seed: ${cause:-nothing found}"
    done
done
echo "$good of $total templates good; slip found in $found of $slipped; false alarms in $alarms of" \
    "$clean clean turns"
((good == total && alarms == 0 && 10 * found >= 9 * slipped))
