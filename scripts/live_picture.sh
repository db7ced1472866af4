#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the picture of a live run in docs/viewer.md, by the page that build/dev has. Run it when the
# page has changed.
#
#   scripts/live_picture.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scripts/install.sh build test viewer docs
configure_and_build dev stigc viewer
picture=docs/gallery/viewer-live.png
tests/viewer/run.sh picture build/dev/viewer "$PWD/build/dev/stigc" "$PWD/scenes/robot-fetch.yaml" \
  "$PWD/$picture"
pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
