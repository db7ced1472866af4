#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Redoes the searches of docs/finds.md and its pictures: docs/gallery/find-*.png and the curves
# docs/gallery/finds-*.svg. Some minutes.
#
#   scripts/finds_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# find_all PLAN ID…: searches as the plan says, and draws what these individuals built.
find_all() {
  local plan=$1 id
  shift
  "$stigc" search "plans/$plan.yaml" -o "$work/$plan.sqlite" -q
  for id in "$@"; do
    "$stigc" archive "$work/$plan.sqlite" --pick "$id" -o "$work/find.png" -q
    pngquant --force --strip --speed 1 --output "docs/gallery/find-$plan-$id.png" 64 \
      "$work/find.png"
  done
}

# Three seeds of a plan, for a curve with a band.
curve() {
  local plan=$1 seed beside=()
  for seed in 2 3; do
    { cat "plans/$plan.yaml"; echo "seed: $seed"; } >"$work/$plan-$seed.yaml"
    "$stigc" search "$work/$plan-$seed.yaml" -o "$work/$plan-$seed.sqlite" -q
    beside+=(--beside "$work/$plan-$seed.sqlite")
  done
  "$stigc" archive "$work/$plan.sqlite" "${beside[@]}" --plot evaluated,mean \
    -o "docs/gallery/finds-$plan.svg" -q
}

find_all comb 2784 15788
find_all staircase-shape 1021 3607
find_all towers 2427
find_all modules 12227 9996 10021
find_all spread 51 381
curve staircase-shape
say "Wrote docs/gallery/find-*.png and docs/gallery/finds-*.svg"
