#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the picture of docs/playground.md, of the page that build/dev has. Run it when the page has
# changed.
#
#   scripts/playground_picture.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scripts/install.sh build test viewer playground docs
configure_and_build dev stigc viewer playground
picture=docs/gallery/playground.png
tests/playground/run.sh picture build/dev build/dev/stigc "$picture"
pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
