#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds WORK/playground.html from the module there, with the packages that the viewer was built
# with.
#
#   build.sh VIEWER WORK ROOT
set -euo pipefail
viewer=$1 work=$2 root=$3

if [[ ! -d $viewer/node_modules/yaml ]]; then
  printf 'The playground is left out: the viewer has no packages (no network?)\n' >&2
  exit 0
fi
cd "$viewer" && node playground.mjs "$work" "$work/playground.wasm" "$root"
