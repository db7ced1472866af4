#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/behaviours.md, and the camera's of docs/sensing.md. Run it when behaviours or the pictures have changed.
#
#   scripts/behaviour_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures

# draw NAME SCENE SECONDS [OPTION…]
draw() {
  local picture=docs/gallery/$1.png
  say "stigc simulate scenes/$2.yaml --at $3 -o $picture ${*:4}"
  "$stigc" simulate "scenes/$2.yaml" --at "$3" --duration "$3" -o "$picture" "${@:4}" --quiet >/dev/null
  pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
}

draw behaviour-stack fetch-and-stack 149
draw behaviour-gripper gripper-cart 7.4
draw camera-view fetch-and-stack 107 --camera "bebot 1"
