#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/behaviours.md. Run it when behaviours or the pictures have changed.
#
#   scripts/behaviour_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures

# draw NAME SCENE SECONDS
draw() {
  local picture=docs/gallery/behaviour-$1.png
  say "stigc simulate scenes/$2.yaml --at $3 -o $picture"
  "$stigc" simulate "scenes/$2.yaml" --at "$3" -o "$picture" --quiet >/dev/null
  pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
}

draw stack fetch-and-stack 149
draw gripper gripper-cart 7.4
