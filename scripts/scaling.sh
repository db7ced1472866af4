#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# How a swarm's work scales: `stigc validate` with 1, 2, 3, 4 and 8 robots that are bound to their
# sides, and with two, three and four that are not, as a markdown table on standard output; progress
# goes to standard error.
#
#   scripts/scaling.sh [--runs R] [--seed N] [--duration S] [RULESET]
#
# R seeds each (default 5) from N on (default 1), at most S simulated seconds (default 2400). What
# validate says of each stays in out/scaling-*.json. STIGC=PATH uses a program that is built already.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

runs=5 seed=1 duration=2400 rules=rulesets/stepped-pyramid.yaml
while [[ $# -gt 0 ]]; do
  case $1 in
    --runs) runs=${2:?--runs needs a number}; shift ;;
    --seed) seed=${2:?--seed needs a number}; shift ;;
    --duration) duration=${2:?--duration needs a number}; shift ;;
    -h | --help) sed -n '3,10s/^# \{0,1\}//p' "$0"; exit 0 ;;
    -*) die "unknown argument '$1'; see --help" ;;
    *) rules=$1 ;;
  esac
  shift
done

stigc=${STIGC:-}
if [[ -z $stigc ]]; then
  scripts/install.sh build >&2
  configure_and_build dev stigc >&2
  stigc=build/dev/stigc
fi
mkdir -p out
files=()
for work in {1,2,3,4,8}-fixed {2,3,4}-dynamic; do
  file=out/scaling-$work.json
  say "${work/-/ robots, }" >&2
  status=0
  "$stigc" validate "$rules" --robots "${work%-*}" --allocation "${work#*-}" --runs "$runs" \
    --seed "$seed" --duration "$duration" --json --quiet >"$file" || status=$?
  # Structures that are not complete belong in the table.
  [[ $status -le 1 ]] || die "stigc validate failed with status $status"
  files+=("$file")
done
python3 scripts/scaling_table.py "${files[@]}"
