#!/usr/bin/env bash
# Builds gripscan and opens its window on the simulated cell. Without a display, or with arguments,
# the same turn is made without a window; arguments go to `gripscan run gripper`, for example:
# ./run.sh --seed 3 --step-deg 20
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source third_party/prepare.sh

install_packages
build release gripscan

if [[ $# == 0 && -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
    mkdir -p build/run
    exec build/release/bin/gripscan --session "build/run/gripper-$(date +%Y-%m-%d-%H%M%S)"
fi

out=build/run/session
for ((i = 1; i <= $#; ++i)); do
    [[ ${!i} == --out=* ]] && out=${!i#--out=}
    if [[ ${!i} == --out ]] && ((i < $#)); then
        next=$((i + 1))
        out=${!next}
    fi
done
arguments=("$@")
if [[ $out == build/run/session ]]; then
    rm -rf "$out"
    mkdir -p build/run
    arguments=(--out "$out" "$@")
fi

status=0
build/release/bin/gripscan run gripper --cell sim "${arguments[@]}" || status=$?
for result in "template:template.pcd" "Table 1:turns.csv" "report:report.html"; do
    file=$out/results/${result#*:}
    [[ -e $file ]] && printf '%-10s %s\n' "${result%%:*}" "$(realpath "$file")" >&2
done
exit "$status"
