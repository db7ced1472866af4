#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the gallery: runs every shipped rule set, writes docs/gallery/*.png, a film of the pyramid
# and the page docs/gallery.md around them. Run it when a rule set or the pictures have changed.
# Without ffmpeg, the film stays as it is.
#
#   scripts/gallery.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program_for_pictures
most_bytes=120000 # of a picture: the gallery is part of every clone
most_film_bytes=1000000
last_arguments=() # of the picture before
page=docs/gallery.md
mkdir -p docs/gallery

cat >"$page" <<'END'
# Gallery

Every rule set that comes with the program, drawn by the program with the command under its
picture. `scripts/gallery.sh` runs them all, reduces the pictures to 64 colours, which makes
them small, and writes this page.

END

# film NAME SET "WHAT IT SHOWS" [ARGUMENT OF stigc render…]: of the run that SET's picture shows.
film() {
  local name=$1 set=$2 line=$3 film=docs/gallery/$1.gif
  shift 3
  local trace=$set.stigt
  local explore=(explore "rulesets/$set.yaml" "${last_arguments[@]}" --trace "$trace")
  local render=(render "$trace" -o "$film" "$@")
  if command -v ffmpeg >/dev/null; then
    say "stigc ${render[*]}"
    "$stigc" "${explore[@]}" --quiet >/dev/null
    "$stigc" "${render[@]}" --quiet
    rm "$trace"
  fi
  local bytes
  bytes=$(stat -c %s "$film")
  ((bytes < most_film_bytes)) || die "$film has $bytes bytes, more than $most_film_bytes"
  {
    printf '%s\n\n![%s](gallery/%s.gif)\n\n' "$line" "$name" "$name"
    printf '```\nstigc %s\nstigc %s\n```\n\n' "${explore[*]}" "${render[*]}"
  } >>"$page"
}

# show NAME "WHAT IT SHOWS" [ARGUMENT OF stigc explore…]
show() {
  local name=$1 line=$2 picture=docs/gallery/$1.png
  shift 2
  last_arguments=("$@")
  local command=(explore "rulesets/$name.yaml" "$@" -o "$picture")
  say "stigc ${command[*]}"
  "$stigc" "${command[@]}" --quiet >/dev/null
  pngquant --force --strip --speed 1 --output "$picture" 64 "$picture"
  local bytes
  bytes=$(stat -c %s "$picture")
  ((bytes < most_bytes)) || die "$picture has $bytes bytes, more than $most_bytes"
  {
    printf '## [%s](../rulesets/%s.yaml)\n\n%s\n\n' "$name" "$name" "$line"
    printf '![%s](gallery/%s.png)\n\n```\nstigc %s\n```\n\n' "$name" "$name" "${command[*]}"
  } >>"$page"
}

show staircase "Four short rules with heights and wildcards; every order of events ends here." \
  --motion walk --box 9,9,9 --seed 1
show stepped-pyramid "The same four rules in four orientations: 513 structures on the way, one end." \
  --motion walk --box 11,11,11 --seed 1
film pyramid stepped-pyramid "The same run as a film; what is still to come is drawn as of glass." \
  --view orbit --ghost --speed 2 --to 20 --fps 8 --size 480x320
show staircase-exact "The staircase from four exact patterns, without heights or wildcards." \
  --motion event --seed 1
show stepped-pyramid-exact "The pyramid from ten exact patterns and their turns." \
  --motion event --seed 1
show wall "The first course is counted by colour, the others by height." \
  --motion walk --box 10,7,8 --seed 1
show plate "From the middle outwards, alike in all eight orientations." \
  --motion event --seed 1
show order-dependent "One of its two ends. With another seed the step may come first, and there is no hat." \
  --motion event --seed 1
show architecture-4n "A published table in nine steps. Step 6 is a race; this is one of many ends." \
  --motion event --seed 1
show architecture-4c "A published hexagonal set: 73 deposits, whatever their order." \
  --motion event --seed 1
show tiling "Endless, stopped after 400 deposits. All colours follow from the first two bricks." \
  --motion event --deposits 400 --seed 1
show coral "Chance at work, after 300 deposits: a count, probabilities, weights, two stages." \
  --motion event --deposits 300 --seed 2

sed -i '$d' "$page"
say "Wrote $page and $(find docs/gallery -name '*.png' | wc -l) pictures"
