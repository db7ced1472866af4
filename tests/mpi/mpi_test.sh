#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A study by MPI ends in the bytes of the same study by threads, and a search in the content of the
# same search: with 2 and 4 ranks, after a worker was killed, and after rank 0 was.
#
#     mpi_test.sh STIGC STIGC_MPI MPIRUN
set -euo pipefail
stigc=$1 mpi=$2 mpirun=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# As root in a container, more ranks than cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none

cat >plan.yaml <<'PLAN'
stigc_sweep: 1
command: explore
file: rulesets/wall.yaml
options: {agents: 1, box: [60, 60, 60], steps: 200000}
vary: {seed: 1..100}
PLAN

same() {
  cmp whole.jsonl "$1.jsonl" || { printf 'not the same: %s\n' "$1" >&2; exit 1; }
  [[ ! -e $1.jsonl.journal ]] || { printf 'a journal is left: %s\n' "$1" >&2; exit 1; }
}
ranks() {
  "$mpirun" -n "$1" "$mpi" sweep plan.yaml -q -o "$2.jsonl" >/dev/null
}

"$stigc" sweep plan.yaml -q -o whole.jsonl >/dev/null
for n in 1 2 4; do
  ranks "$n" "of-$n"
  same "of-$n"
done

# killed NAME WHICH RUN BEGUN COMMAND IN_USE COMPARE
#
# Begins `RUN 3 NAME`, and kills rank WHICH (0; -1: the last) of COMMAND once `BEGUN NAME` is true. Goes on with
# `RUN 2 NAME` as soon as that no longer says IN_USE, and compares.
killed() {
  local name=$1 which=$2 run=$3 begun=$4 command=$5 in_use=$6 compare=$7
  local pids=() ended=0
  "$run" 3 "$name" >/dev/null 2>&1 &
  local job=$!
  until "$begun" "$name"; do
    kill -0 "$job" 2>/dev/null || { ended=1; break; }
    sleep 0.05
  done
  mapfile -t pids < <(pgrep -f "^$mpi $command -q -o $name\\." | sort -n)
  if [[ $ended -eq 0 && ${#pids[@]} -gt 0 ]] && kill -9 "${pids[$which]}"; then
    printf 'killed: %s\n' "$name"
  else
    printf 'ended before it could be killed: %s\n' "$name"
  fi
  wait "$job" || true
  # The rest of the ranks end by themselves, or by MPI's hand.
  for _ in {1..100}; do
    "$run" 2 "$name" 2>error.txt && break
    grep -qE "$in_use" error.txt || { cat error.txt >&2; exit 1; }
    sleep 0.1
  done
  "$compare" "$name"
}

sweep_begun() { [[ $({ wc -l <"$1.jsonl.journal"; } 2>/dev/null || echo 0) -gt 3 ]]; }
sweep_killed() { killed "$1" "$2" ranks sweep_begun 'sweep plan.yaml' 'in use' same; }
sweep_killed worker -1
sweep_killed leader 0

# The same of a search.
cat >search.yaml <<'PLAN'
stigc_search: 1
name: by-ranks
method: genetic
score: [{objective: modules, weight: 0.1}, {objective: same_ends}]
rules: 10
box: 12
deposits: 200
orders: 2
proof: 100000
batch: 128
evaluations: 2560
PLAN

"$stigc" search search.yaml -q --threads 1 -o whole.sqlite >whole.txt
grep -q content whole.txt
alike() {
  cmp whole.txt "$1.txt" || { printf 'another content: %s\n' "$1" >&2; exit 1; }
}
search() {
  "$mpirun" -n "$1" "$mpi" search search.yaml -q -o "$2.sqlite" --color=never >"$2.txt"
}
"$stigc" search search.yaml -q --threads 2 -o threads.sqlite >threads.txt
alike threads
for n in 1 2 4; do
  search "$n" "found-$n"
  alike "found-$n"
done

search_begun() { "$stigc" archive "$1.sqlite" --json 2>/dev/null | grep -q '"evaluated": [1-9]'; }
search_killed() { killed "$1" "$2" search search_begun 'search search.yaml' 'meanwhile|locked' alike; }
search_killed search-worker -1
search_killed search-leader 0

# A program that has no score ends on all ranks.
code=0
sed 's/^score:.*/score: none.lua/' search.yaml >unscored.yaml
printf 'function score(one)\n  return one.id < 200 and 1 or nil\nend\n' >none.lua
"$mpirun" -n 3 "$mpi" search unscored.yaml -o unscored.sqlite 2>unscored.txt || code=$?
[[ $code -eq 1 ]] || { printf 'a score that is missing ends with %s\n' "$code" >&2; exit 1; }
grep -q 'C501' unscored.txt && grep -q 'individual 200,' unscored.txt ||
  { cat unscored.txt >&2; exit 1; }

# A plan that is none ends on all ranks, with the same status.
code=0
printf 'stigc_sweep: 1\n' >bad.yaml
"$mpirun" -n 2 "$mpi" sweep bad.yaml -o bad.jsonl 2>/dev/null || code=$?
[[ $code -eq 1 ]] || { printf 'a bad plan ends with %s\n' "$code" >&2; exit 1; }
printf 'all the same\n'
