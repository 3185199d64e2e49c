#!/usr/bin/env bash
# Lets the simulated cell suffer each kind of fault and looks what the advisor makes of it.
# usage: tests/tools/faults.sh OUT [SEED...]
# For every fault and seed (default 1 to 5): the cause that was named, whether it is the right one, and
# whether every merged view stands where the truth says: within 0.5 deg and 1 mm of its place, and
# 0.3 deg more for each step that was taken on the robot's word. Then whole turns without a fault
# (HEALTHY="11 12 13 14 15 16", seeds by which no limit was chosen; HEALTHY= for none): how many of
# their steps were rejected. Ends with status 0 if nine causes of ten are right, no bad view was
# merged and at most one healthy step of 200 was rejected.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
out=${1:?usage: faults.sh OUT [SEED...]}
shift
seeds=("$@")
[[ ${#seeds[@]} -gt 0 ]] || seeds=(1 2 3 4 5)
bin=build/release/bin
read -ra healthy <<<"${HEALTHY-11 12 13 14 15 16}"
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

# measured SESSION: where the merged views stand, "DEG MM"; empty: nothing was merged
measured() {
    "$bin/template_truth" "$1/results/template.pcd" "$1.truth" --turns "$1/results/turns.json" \
        --captures "$1/captures.csv" 2>"$1.truth.err" |
        sed -n '/"poses"/,/"captures"/s/^.*"\(worst_deg\|worst_mm\)": \([0-9.e-]*\).*$/\2/p' |
        tr '\n' ' '
}

# on_robots_word SESSION: merged steps whose angle is the robot's
on_robots_word() {
    grep -c 'axis-locked' "$1/results/turns.csv" 2>/dev/null || true
}

right=0
total=0
bad=0
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
        read -r deg mm <<<"$(measured "$session") "
        merged="nothing merged"
        if [[ -z $deg && -s $session/results/template.pcd ]]; then
            echo "$name $seed: its template cannot be compared with the truth:" >&2
            cat "$session.truth.err" >&2
            exit 2
        fi
        if [[ -n $deg ]]; then
            words=$(on_robots_word "$session")
            merged="merged views right"
            awk "BEGIN { exit !($deg > 0.5 + 0.3 * $words || $mm > 1) }" &&
                merged="BAD VIEW MERGED" && bad=$((bad + 1))
            merged="$merged ($(printf '%.2f deg, %.2f mm' "$deg" "$mm"), $words on the robot's word)"
        fi
        echo "$name $seed: status $status, cause ${cause:-none} $verdict; $merged"
    done
done

steps=0
rejected=0
for seed in "${healthy[@]}"; do
    session=$out/healthy-$seed
    "$bin/gripscan" run gripper --cell sim --seed "$seed" --out "$session" \
        >"$session.out" 2>"$session.err" || true
    # Every look at a step counts: one that was retaken after a rejection was rejected.
    looked=$(grep -cE 'step [0-9]+ -> [0-9]+: ' "$session.err" || true)
    no=$(grep -cE 'step [0-9]+ -> [0-9]+: reject' "$session.err" || true)
    doubted=$(grep -cE 'step [0-9]+ -> [0-9]+: check' "$session.err" || true)
    echo "healthy $seed: $no of $looked steps rejected, $doubted to be checked"
    steps=$((steps + looked))
    rejected=$((rejected + no))
done
echo "$right of $total causes right; bad views merged in $bad of $total turns;" \
    "$rejected of $steps healthy steps rejected"
((10 * right >= 9 * total && bad == 0 && 200 * rejected <= steps))
