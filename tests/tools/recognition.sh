#!/usr/bin/env bash
# Prints the figures of docs/acceptance.md on recognition:
#   tests/tools/recognition.sh WORK_FOLDER [VIEWS [EMPTY_VIEWS [IMAGE_FRACTION]]]
# Renders the views (100 with templates, 20 without; full size) unless they are there, and recognises
# six templates in each. Needs recognition_views and recognition_score in build/release. Exit status 0:
# at least 97 % right within 1 deg and 1.5 mm, and no absent template reported.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=${1:?usage: recognition.sh WORK_FOLDER [VIEWS [EMPTY_VIEWS [IMAGE_FRACTION]]]}
bin=build/release/bin
[[ -f $work/truth.json ]] ||
    "$bin/recognition_views" --out "$work" --count "${2:-100}" --empty "${3:-20}" \
        --image-fraction "${4:-1}"
"$bin/recognition_score" "$work"
