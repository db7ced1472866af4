#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs every command of docs/from-a-drawing.md as it stands there, and draws the page's pictures.
# Run it when the page, the robots' programs or the pictures have changed.
#
#   scripts/drawing_pictures.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
program=$(realpath "$stigc")
export program

# The page's commands call stigc by its name.
stigc() {
  printf 'stigc %s\n' "$*"
  "$program" --quiet "$@" >/dev/null
}
export -f stigc

page=docs/from-a-drawing.md
say "The commands of $page"
awk '$0 == "```sh" { on = 1; next } $0 == "```" { on = 0 } on' "$page" >"$folder/commands.sh"
# Two of them are refused, as the page says.
(cd "$folder" && bash commands.sh)
for refused in mound low; do
  [[ ! -e $folder/$refused/rules.yaml ]] || die "there are rules for $refused, unlike the page says"
done

# keep FILE NAME: a picture of the page, small enough for every clone.
keep() {
  [[ -s $folder/$1 ]] || die "the page's commands did not draw $1"
  pngquant --force --strip --speed 1 --output "docs/gallery/drawing-$2.png" 64 "$folder/$1"
}
keep fort/target.png target
keep at-work.png at-work
keep fort/built.png built
keep overhang/built.png overhang
keep tower/built.png tower
for report in fort tower; do
  grep -q '"complete": true' "$folder/$report/report.json" || die "$report is not complete"
done
