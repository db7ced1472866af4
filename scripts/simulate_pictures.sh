#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/simulate.md. Run it when physics or the pictures have changed.
#
#   scripts/simulate_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures

# draw NAME [ARGUMENT OF stigc simulate…]
draw() {
  local name=$1 picture=docs/gallery/simulate-$1.png
  shift
  say "stigc simulate scenes/$name.yaml $* -o $picture"
  "$stigc" simulate "scenes/$name.yaml" "$@" -o "$picture" --quiet >/dev/null
  pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
}

draw drop
draw bridge --duration 1
