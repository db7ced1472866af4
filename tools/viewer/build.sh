#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds WORK/viewer.html from the viewer's sources, with the packages of package-lock.json.
#
#   build.sh SOURCES WORK AUTO|ON [dev]      dev: with what the tests need too
#
# Where the packages cannot be fetched, AUTO leaves the page out and ON fails.
set -euo pipefail
sources=$1 work=$2 how=$3 kind=${4:-}

mkdir -p "$work"
rm -rf "$work/src"
cp -r "$sources"/{src,{page,playground}.html,{build,bundle,playground}.mjs,eslint.config.js} "$work/"
cp "$sources"/{package.json,tsconfig.json,.npmrc} "$work/"

# With the kind, so that packages are fetched again when the tests are wanted later.
wanted=$(cat "$sources/package-lock.json" && printf '%s' "$kind")
if [[ ! -d $work/node_modules || $(cat "$work/installed" 2>/dev/null) != "$wanted" ]]; then
  cp "$sources/package-lock.json" "$work/"
  omit=()
  [[ $kind == dev ]] || omit=(--omit=dev)
  if ! (cd "$work" && npm ci --ignore-scripts --prefer-offline --fetch-retries=1 \
          --loglevel=error "${omit[@]}" >/dev/null); then
    rm -rf "$work/node_modules"
    printf 'The viewer is left out: npm could not fetch its packages (no network?)\n' >&2
    [[ $how == AUTO ]] || exit 1
    exit 0
  fi
  printf '%s' "$wanted" >"$work/installed"
fi
cd "$work" && node build.mjs "$work"
