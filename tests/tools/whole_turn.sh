#!/usr/bin/env bash
# The window driven from outside, by real mouse and key events, through a whole turn of 36 steps: cell
# check, steps by hand with one Retry, one Halve and one Undo, the rest by Run, export. The exported file
# must be the one that the program makes of the recording without a window. `./test.sh` runs the same on
# a turn of larger steps.
# usage: tests/tools/whole_turn.sh
# Ends with status 0 if all of it went as it should. Needs a release build, Xvfb and xdotool; four
# minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
export GRIPSCAN_WINDOW_STEP_DEG=10
exec build/release/bin/window_tests --gtest_filter='WholeProcedure.ByHand*:WholeProcedure.ARun*'
