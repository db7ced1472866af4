#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The demonstration: installs what is missing, builds the program alone, then checks,
# grows, draws and measures the shipped rule sets, proves one, compiles one into a robot's
# program and lets a robot build it. Pictures, models and the robot's report land in out/.
#
#   scripts/demo.sh
#
# STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The sets shown, in this order: name and how its swarm moves.
shown=(
  "staircase walk"
  "stepped-pyramid walk"
  "architecture-4c event"
  "architecture-4n event"
  "coral event"
)

stigc=${STIGC:-}
if [[ -z $stigc ]]; then
  scripts/install.sh build
  say "Building the program"
  configure_and_build quick stigc
  stigc=build/quick/stigc
fi
[[ -x $stigc ]] || die "'$stigc' is no program"
mkdir -p out

say "Checking the shipped rule sets: stigc check rulesets/*.yaml"
"$stigc" check rulesets/*.yaml

for entry in "${shown[@]}"; do
  read -r name motion <<<"$entry"
  command=(explore "rulesets/$name.yaml" --motion "$motion" --seed 1
           -o "out/$name.png" -o "out/$name.glb")
  say "stigc ${command[*]}"
  "$stigc" "${command[@]}"
  [[ -s out/$name.png ]] || die "no picture at out/$name.png"
done

say "Holding every set to what its author expects of it: stigc test rulesets/*.yaml"
"$stigc" test rulesets/*.yaml

say "Proving that every order of work builds the pyramid, and checking the proof by other code"
"$stigc" verify rulesets/stepped-pyramid.yaml --certificate out/stepped-pyramid.cert
"$stigc" certify rulesets/stepped-pyramid.yaml out/stepped-pyramid.cert

say "Compiling the staircase's rules into a robot's program, and letting a robot build it"
"$stigc" compile rulesets/staircase.yaml --report out/staircase.txt -o out/staircase.lua
cat out/staircase.txt
"$stigc" validate rulesets/staircase.yaml --runs 2 -o out/staircase-runs
report=$PWD/out/staircase-runs/report.html

say "Compiling a drawing into rules: stigc synth docs/walkthrough/fountain.txt"
"$stigc" synth docs/walkthrough/fountain.txt --symmetry rotations --start 3,3,0 --floor \
  -o out/fountain.yaml
"$stigc" explore out/fountain.yaml --motion event -o out/fountain.png

say "Done. Pictures to look at, and models for any glTF viewer:"
for entry in "${shown[@]}"; do
  printf '  %s\n' "$PWD/out/${entry%% *}.png"
done
say "The report of the robot's staircase: $report"
