#!/usr/bin/env bash
# The window, driven from outside through a turn by hand and by itself, under sanitizers.
# usage: tests/tools/sanitized_window.sh OUT [asan] [tsan]
# Builds the program with each (default both) and drives it by mouse and keys, Retry, Halve, Undo and
# export included. Ends with status 0 if the turns ended as they should, and no report names a line of
# our sources; reports without one come from libraries that were built without the sanitizer: they are
# counted. Needs Xvfb and xdotool; 20 to 40 minutes with the builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source third_party/prepare.sh
out=${1:?usage: sanitized_window.sh OUT [asan] [tsan]}
shift
presets=("$@")
[[ ${#presets[@]} -gt 0 ]] || presets=(asan tsan)
[[ -e $out ]] && fail "$out exists; choose another folder"
mkdir -p "$out"
out=$(cd "$out" && pwd)
export GRIPSCAN_WINDOW_STEP_DEG=${GRIPSCAN_WINDOW_STEP_DEG:-60} GRIPSCAN_WINDOW_PATIENCE=10

bad=0
for preset in "${presets[@]}"; do
    build "$preset" gripscan window_tests
    # What a library keeps until the end is no leak of ours; a report does not end the program, so
    # that one run shows all of them.
    export ASAN_OPTIONS=detect_leaks=0:detect_stack_use_after_return=1:strict_string_checks=1:halt_on_error=0:log_path=$out/report.asan
    export UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=0:log_path=$out/report.ubsan
    export TSAN_OPTIONS=halt_on_error=0:exitcode=0:history_size=4:ignore_noninstrumented_modules=1:log_path=$out/report.tsan
    status=0
    "build/$preset/bin/window_tests" --gtest_filter='WholeProcedure.ByHand*' || status=$?
    [[ $status == 0 ]] || { echo "$preset: the turn did not end as it should"; bad=1; }
done

reports=0
ours=0
for report in "$out"/report.*; do
    [[ -e $report ]] || continue
    here=$(grep -cE '^(WARNING|==[0-9]+==ERROR|.*runtime error)' "$report" || true)
    reports=$((reports + here))
    if grep -qE "^ +#[0-9]+ .* $PWD/(app|core|ui)/|^$PWD/(app|core|ui)/.*runtime error" "$report"; then
        ours=$((ours + 1))
        echo "our code is named in $report"
    fi
done
echo "$reports reports; in $ours of their files a line of our sources"
[[ $bad == 0 && $ours == 0 ]]
