#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what is missing, builds and runs every test; ends with ctest's own summary.
#
#   scripts/test.sh [PRESET]      dev (default), asan-ubsan, tsan or coverage
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

preset=${1:-dev}
purposes=(build test viewer)
[[ $preset != coverage ]] || purposes+=(coverage)
scripts/install.sh "${purposes[@]}"

say "Building (preset $preset)"
configure_and_build "$preset"

say "Testing"
if [[ $preset == coverage ]]; then
  ctest --preset coverage --parallel "$(nproc)"
  say "Lines of lib/ and tools/ that the tests run"
  gcovr --root . --filter lib/ --filter tools/ --exclude-throw-branches build/coverage
else
  exec ctest --preset "$preset" --parallel "$(nproc)"
fi
