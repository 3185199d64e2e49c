#!/usr/bin/env bash
# Lets the simulated cell suffer each kind of fault and looks what the advisor makes of it.
# usage: tests/tools/faults.sh OUT [SEED...]
# For every fault and seed (default 1 to 5): the cause that was named, whether it is the right one, and
# whether every merged view stands where the truth says (0.5 deg, 1 mm; or 0.3 deg a step where a
# view is kept on the robot's word). Last the steps of healthy turns that were refused.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:?usage: faults.sh OUT [SEED...]}
shift
seeds=("$@")
[[ ${#seeds[@]} -gt 0 ]] || seeds=(1 2 3 4 5)
bin=build/release/bin
[[ -e $out ]] && { echo "$out exists; choose another folder" >&2; exit 2; }
mkdir -p "$out"

# FAULT CAUSES STEP_DEG: what to inject ("-": nothing), which causes are right
faults=(
    "ratio ratio 10"
    "backlash@3=1.5 backlash 10"
    "sign sign 10"
    "loose@3 loose 10"
    "slip@3 slip 10"
    "glare@3 exposure 10"
    "defocus@3 texture 10"
    "bump@3 moved_camera 10"
    "intruder@3 mislabelled 10"
    "- overlap 75"
)
right=0
total=0
for seed in "${seeds[@]}"; do
    for line in "${faults[@]}"; do
        read -r fault causes step <<<"$line"
        name=${fault%%[@=]*}
        [[ $fault == - ]] && name=step
        session=$out/$name-$seed
        arguments=(--cell sim --seed "$seed" --step-deg "$step" --out "$session"
            --truth "$session.truth")
        [[ $fault == - ]] || arguments+=(--fault "$fault")
        status=0
        "$bin/gripscan" run gripper "${arguments[@]}" >"$session.out" 2>"$session.err" || status=$?
        # The cause that was decided upon: that of the last advice.
        cause=$(sed -n 's/^.*advice [0-9]* -> [0-9]*: cause=\([a-z_]*\) .*/\1/p' "$session.err" | tail -1)
        verdict=WRONG
        [[ " ${causes//,/ } " == *" ${cause:-none} "* ]] && verdict=right && right=$((right + 1))
        total=$((total + 1))
        worst=$("$bin/template_truth" "$session/results/template.pcd" "$session.truth" \
            --turns "$session/results/turns.json" --captures "$session/captures.csv" 2>/dev/null |
            grep -oE '"(worst_deg|worst_mm|rms_mm)": [0-9.e-]+' | tr -d '"' | tr '\n' ' ' || true)
        echo "$name $seed: status $status, cause ${cause:-none} $verdict; merged: ${worst:-nothing}"
    done
done
echo "$right of $total causes right"
