#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs three.js beside the samples, as package-lock.json has it, and runs
# check_three.mjs.
#
#   run_three.sh SOURCES FOLDER
#
# Exit status 77 (skipped) without node, npm or the package, unless
# STIG_REQUIRE_READERS is set.
set -euo pipefail
sources=$1 folder=$2

skip() {
  printf '%s\n' "$1"
  [[ -n ${STIG_REQUIRE_READERS:-} ]] && exit 1
  exit 77
}

for tool in node npm; do
  command -v "$tool" >/dev/null || skip "$tool is not installed (apt-get install nodejs npm)"
done

work=$folder/three
mkdir -p "$work"
if ! cmp -s "$sources/package-lock.json" "$work/package-lock.json" || [[ ! -d $work/node_modules ]]; then
  cp "$sources/package.json" "$sources/.npmrc" "$work/"
  cp "$sources/package-lock.json" "$work/package-lock.json"
  (cd "$work" && npm ci --ignore-scripts --loglevel=error) || {
    rm -rf "$work/node_modules"
    skip "npm could not install three.js: no network?"
  }
fi
cp "$sources/check_three.mjs" "$work/"
node "$work/check_three.mjs" "$folder"
