#!/usr/bin/env bash
# Builds gripscan with its tests and runs them; arguments go to ctest, for example: ./test.sh -R cloud
# GRIPSCAN_TEST_SANITIZE=1 first runs the quick tests under the address, undefined-behaviour and
# thread sanitizers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
source third_party/prepare.sh

# Programs of tests/unit whose folders hardly call libraries the sanitizers cannot see into.
address_tests=(base_tests concurrency_tests geometry_tests cloud_tests)
thread_tests=(concurrency_tests)

# run_sanitized PRESET PROGRAM...
run_sanitized() {
    local preset=$1
    shift
    build "$preset" "$@"
    ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)" \
        -R "^($(IFS='|' && echo "$*"))\\."
}

install_packages
if [[ ${GRIPSCAN_TEST_SANITIZE:-0} == 1 ]]; then
    export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1
    export UBSAN_OPTIONS=print_stacktrace=1
    run_sanitized asan "${address_tests[@]}"
    run_sanitized tsan "${thread_tests[@]}"
fi
build release
ctest --test-dir build/release --output-on-failure -j "$(nproc)" "$@"
