#!/usr/bin/env bash
# Prints the figures of docs/acceptance.md that need whole turns of the simulated cell:
#   tests/tools/acceptance.sh WORK_FOLDER [SEED...]
# Needs a build in build/release. Works in WORK_FOLDER, which it creates.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=${1:?usage: acceptance.sh WORK_FOLDER [SEED...]}
shift
seeds=("$@")
[[ ${#seeds[@]} -gt 0 ]] || seeds=(1 2 3 4 5)
bin=build/release/bin
mkdir -p "$work"

for seed in "${seeds[@]}"; do
    session=$work/turn$seed
    truth=$work/truth$seed
    rm -rf "$session" "$truth"
    "$bin/gripscan" run gripper --cell sim --seed "$seed" --out "$session" --truth "$truth" --quiet
    echo "seed $seed, ours:"
    "$bin/gripscan" report "$session" | grep -E '^(verdict|closure)'
    "$bin/template_truth" "$session/results/template.pcd" "$truth" \
        --turns "$session/results/turns.json" --captures "$session/captures.csv" |
        grep -E '"(rms_mm|coverage|worst_deg|worst_mm)"'
    echo "seed $seed, the paper's ICP:"
    "$bin/gripscan" replay "$session" --out "$work/paper$seed" --method paper-icp |
        grep -E '^verdict' || true
    "$bin/template_truth" "$work/paper$seed/template.pcd" "$truth" | grep -E '"(rms_mm|coverage)"'
done

session=$work/turn${seeds[0]}
echo "replay of 37 captures on two cores, twice, and on one:"
for threads in 2 2 1; do
    /usr/bin/time -f "%e s, %M kB" env GRIPSCAN_THREADS=$threads \
        "$bin/gripscan" replay "$session" --out "$work/again" --json --quiet |
        sed "s#$work/again#RESULTS#" | sha256sum
done
