#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/validate.md, reproduction.md, compiler.md, staircase.md and the robots'
# film of pictures.md. Run it when controllers or the pictures have changed.
#
#   scripts/validate_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
say "stigc validate rulesets/staircase.yaml --runs 25"
# Runs that go wrong belong in the picture.
"$stigc" validate rulesets/staircase.yaml --runs 25 -o "$folder" --quiet >/dev/null || true
cp "$folder/progress.svg" docs/gallery/validate-progress.svg
picture=docs/gallery/validate-staircase.png
"$stigc" render "$folder/run-1.stigp" -o "$picture" --quiet >/dev/null
pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"

say "stigc validate rulesets/stepped-pyramid.yaml --robots 4 --runs 5"
"$stigc" validate rulesets/stepped-pyramid.yaml --robots 4 --runs 5 -o "$folder/four" --quiet \
  >/dev/null || true
cp "$folder/four/progress.svg" docs/gallery/validate-pyramid.svg
# Without ffmpeg, the film stays as it is.
if command -v ffmpeg >/dev/null; then
  "$stigc" render "$folder/four/run-1.stigp" -o docs/gallery/pyramid-robots.gif --size 480x320 \
    --fps 6 --quiet
fi

say "stigc validate tests/compiler/wall.yaml --robots 2"
"$stigc" validate tests/compiler/wall.yaml --robots 2 -o "$folder/wall" --quiet >/dev/null || true
picture=docs/gallery/validate-wall.png
"$stigc" render "$folder/wall/run-1.stigp" -o "$picture" --quiet >/dev/null
pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"

# The second graph of the two: the chart.
"$stigc" compile rulesets/staircase.yaml --target dot -o "$folder/graphs.dot" --quiet
dot -Tsvg -O "$folder/graphs.dot"
cp "$folder/graphs.dot.2.svg" docs/gallery/chart.svg
