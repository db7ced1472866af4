#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of the viewer, in the folder in which it was built.
#
#   run.sh sources BUILT             types, style and layers of its sources
#   run.sh pages BUILT STIGC         pages in headless Chromium
#   run.sh measure BUILT STIGC       a table of what large pages cost, which no test runs
#   run.sh picture BUILT STIGC SCENE PNG   no test: the picture of a live run
#
# Exit status 77 (skipped) where something is missing, unless STIG_REQUIRE_READERS is set.
set -euo pipefail
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
what=$1 built=$2

skip() {
  printf '%s\n' "$1"
  [[ -n ${STIG_REQUIRE_READERS:-} ]] && exit 1
  exit 77
}

[[ -e $built/viewer.html && -d $built/node_modules/typescript ]] ||
  skip "the viewer is not built: it takes node and npm (scripts/install.sh viewer)"
cd "$built"
if [[ $what == sources ]]; then
  node node_modules/typescript/bin/tsc --noEmit
  node "$tests/layers.mjs" src
  exec node node_modules/eslint/bin/eslint.js .
fi

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  skip "no Chromium (scripts/install.sh viewer)"
rm -rf tests
cp -r "$tests" tests
export STIGC=$3 BROWSER=$browser
[[ $what == measure ]] && exec node tests/measure.mjs
[[ $what == picture ]] && exec node tests/picture.mjs "$4" "$5"
exec node --test --test-reporter=spec tests/*.test.mjs
