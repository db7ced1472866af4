#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests of the playground, in the folder in which the viewer was built.
#
#   run.sh module BUILD STIGC        the module in node, held to the program
#   run.sh page BUILD STIGC          the page in headless Chromium
#   run.sh picture BUILD STIGC PNG   no test: the picture of docs/playground.md
#
# Exit status 77 (skipped) where something is missing, unless STIG_REQUIRE_READERS is set.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(cd "$2" && pwd)
what=$1 viewer=$build/viewer built=$build/playground stigc=$(realpath "$3")

skip() {
  printf '%s\n' "$1"
  [[ -n ${STIG_REQUIRE_READERS:-} ]] && exit 1
  exit 77
}

[[ -e $built/playground.html ]] ||
  skip "the playground is not built: scripts/install.sh viewer playground"
work=$viewer/playground_tests/$what
rm -rf "$work"
mkdir -p "$work"
cp "$here"/*.mjs "$work/"
export STIGC=$stigc PLAYGROUND=$built ROOT=${here%/tests/playground}
if [[ $what == module ]]; then
  exec node --test --test-reporter=spec "$work/module.test.mjs"
fi

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  skip "no Chromium (scripts/install.sh viewer)"
[[ -d $viewer/node_modules/playwright-core ]] || skip "the viewer was built without its tests"
cp "${here%/playground}/viewer/browser.mjs" "$work/"
export BROWSER=$browser
[[ $what == page ]] || exec node "$work/picture.mjs" "$(realpath "$4")"
exec node --test --test-reporter=spec "$work/page.test.mjs"
