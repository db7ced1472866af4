#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# From a drawing to a swarm: runs every command of docs/walkthrough.md and writes what they
# make to docs/walkthrough/. Run it when the synthesiser or the pictures have changed.
#
#   scripts/walkthrough.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures

at=docs/walkthrough
log=$at/transcript.txt
: >"$log"

# run ARGUMENT…: runs the program and keeps what it says; a verdict is no failure here.
run() {
  say "stigc $*"
  {
    printf '$ stigc'
    printf ' %s' "${@//$at\//}"
    printf '\n'
    "$stigc" --color never "$@" 2>&1 | sed "s,$at/,,g" || true
    printf '\n'
  } >>"$log"
}

run draw "$at/fountain.txt" -o "$at/fountain.vox" -o "$at/target.png"
run synth "$at/fountain.vox" --symmetry rotations --start 3,3,0 --floor \
  -o "$at/fountain.yaml" --certificate "$at/fountain.cert" --proof "$at/fewer"
run certify "$at/fountain.yaml" "$at/fountain.cert"
run certify --fewest "$at/fewer"
for deposits in 20 55 88; do
  say "explore, $deposits deposits"
  "$stigc" explore "$at/fountain.yaml" --box 13,13,9 --agents 20 --seed 3 --deposits "$deposits" \
    --quiet -o "$at/built-$deposits.png" >/dev/null
done
# A set that is not sound: a published table, as transcribed.
run verify rulesets/architecture-4n.yaml --witness "$at/4n"

for picture in "$at"/*.png; do
  pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
done
rm -rf "$at/fewer" "$at"/4n*.stigt "$at"/4n*.yaml
