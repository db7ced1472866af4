#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the readers that npm has in FOLDER, as package-lock.json has them, and runs a script of
# SOURCES beside them.
#
#   run_node.sh SOURCES FOLDER SCRIPT [ARGUMENT…]
#
# Exit status 77 (skipped) without node, npm or the packages, unless
# STIG_REQUIRE_READERS is set.
set -euo pipefail
sources=$1 work=$2 script=$3
shift 3

skip() {
  printf '%s\n' "$1"
  [[ -n ${STIG_REQUIRE_READERS:-} ]] && exit 1
  exit 77
}

for tool in node npm; do
  command -v "$tool" >/dev/null || skip "$tool is not installed (apt-get install nodejs npm)"
done

mkdir -p "$work"
if ! cmp -s "$sources/package-lock.json" "$work/package-lock.json" || [[ ! -d $work/node_modules ]]; then
  cp "$sources/package.json" "$sources/.npmrc" "$work/"
  cp "$sources/package-lock.json" "$work/package-lock.json"
  (cd "$work" && npm ci --ignore-scripts --loglevel=error) || {
    rm -rf "$work/node_modules"
    skip "npm could not install the readers: no network?"
  }
fi
cp "$sources/$script" "$work/"
node "$work/$script" "$@"
