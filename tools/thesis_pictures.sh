#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The pictures of docs/measurements/thesis.md, drawn by the tests that prove what they show: tools/thesis_pictures.sh [BUILD] [FOLDER]
set -e
cd "$(dirname "$0")/.."
folder=${2:-docs/images/thesis}
mkdir -p "$folder"
GHOST_THESIS_PICTURES=$folder "${1:-build/release}/test_live_session" --gtest_also_run_disabled_tests --gtest_filter='thesis_*.DISABLED_Picture'
