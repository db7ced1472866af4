#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds and runs every test; ends with ctest's own summary.
#
#   scripts/test.sh [PRESET]      dev (default), asan-ubsan, tsan or coverage
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=${1:-dev}
purposes=(build test)
[[ $preset != coverage ]] || purposes+=(coverage)
scripts/install.sh "${purposes[@]}"

say "Building (preset $preset)"
configure_and_build "$preset"

say "Testing"
ctest --preset "$preset" --parallel "$(nproc)"
