#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The long checks and the benchmarks, written up as markdown on standard output and in
# out/acceptance.md; progress goes to standard error.
#
#   scripts/acceptance.sh [--fuzz-seconds N] [--fuzz-jobs J] [--seed S] [--runs N] [--targets N]
#                         [--against R] [PART…]
#
# Parts: against bench engines laws validate robots five viewer packages assembly fuzz sanitizers;
# without one, all but robots and assembly, which take hours. `robots` lets robots build with the
# seeds S, S + 1 … of N runs (20) a row, of five or ten times as many where so many are asked for, says
# what their simulation costs, and lets one robot and two build N / 5 drawn targets of each kind; rows of
# `validate` and `robots` that stand in out/ for this commit and these arguments are not done again;
# `assembly` draws N targets (10) of each kind.
# `engines` sets what the lattice's engines do a second beside what is aimed at, in a few minutes;
# `against` sets the speed against that of revision R (e10fcc8). Each fuzz target runs for N seconds
# (600), J of them at a time (as many as there are cores). S is the seed of the laws' random cases,
# of the fuzzers, of robots and of drawn targets (the time); the report begins with it, for
# repeating.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

fuzz_seconds=600 fuzz_jobs=$(nproc) seed=$(date +%s) runs=20 targets=10 against=e10fcc8 parts=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --fuzz-seconds) fuzz_seconds=${2:?--fuzz-seconds needs a number}; shift ;;
    --fuzz-jobs) fuzz_jobs=${2:?--fuzz-jobs needs a number}; shift ;;
    --seed) seed=${2:?--seed needs a number}; shift ;;
    --runs) runs=${2:?--runs needs a number}; shift ;;
    --targets) targets=${2:?--targets needs a number}; shift ;;
    --against) against=${2:?--against needs a revision}; shift ;;
    against | bench | engines | laws | validate | robots | five | viewer | packages | assembly | fuzz | sanitizers) parts+=("$1") ;;
    -h | --help) sed -n '3,19s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) die "unknown argument '$1'; see --help" ;;
  esac
  shift
done
[[ $seed =~ ^[1-9][0-9]{0,8}$|^[1-3][0-9]{9}$ ]] ||
  die "--seed takes a number from 1 to 3999999999, not '$seed'"
[[ $runs =~ ^[1-9][0-9]{0,3}$ ]] || die "--runs takes a number from 1 to 9999, not '$runs'"
[[ $targets =~ ^[1-9][0-9]{0,3}$ ]] || die "--targets takes a number from 1 to 9999, not '$targets'"
[[ ${#parts[@]} -gt 0 ]] || parts=(against bench engines laws validate five viewer packages fuzz sanitizers)

failures=0
mkdir -p out

machine() {
  printf '# Acceptance, %s\n\n' "$(date -u +%F)"
  printf -- '- Commit: %s\n' "$(git describe --always --dirty 2>/dev/null || echo unknown)"
  printf -- '- Processor: %s, %s cores\n' \
    "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" "$(nproc)"
  printf -- '- Memory: %s\n' "$(awk '/^MemTotal/{printf "%.0f GB", $2 / 1e6}' /proc/meminfo)"
  printf -- '- Compiler: %s\n' "$(c++ --version | head -n 1)"
  printf -- '- Seed: %s (--seed %s draws the same cases again)\n' "$seed" "$seed"
}

# Runs a command whose output is no markdown; its exit status.
fenced() {
  local status=0
  printf '```\n'
  "$@" || status=$?
  printf '```\n'
  return "$status"
}

against_part() {
  printf '\n## Speed against %s\n\n' "$against"
  scripts/install.sh build bench >&2
  scripts/speed_against.py "$against" || failures=$((failures + 1))
}

bench_part() {
  printf '\n## Benchmarks\n'
  scripts/install.sh build bench >&2
  configure_and_build release >&2
  local program found=''
  while IFS= read -r program; do
    found=1
    say "$program" >&2
    printf '\n### %s\n\n' "$(basename "$program")"
    # Those that print tables of their own also say which bounds or shares were missed.
    if [[ $program == */bench_physics ]]; then
      "$program" || failures=$((failures + 1))
    elif "$program" --benchmark_out=out/bench.json --benchmark_out_format=json >&2; then
      python3 scripts/bench_table.py out/bench.json
    else
      printf '**failed**\n'
      failures=$((failures + 1))
    fi
  done < <(find build/release -name 'bench_*' -type f -executable ! -name 'bench_assembly*' | sort)
  rm -f out/bench.json
  [[ -n $found ]] || { printf '\nNo benchmark was built.\n'; failures=$((failures + 1)); }
}

engines_part() {
  printf '\n## Engines of the lattice\n'
  scripts/install.sh build bench >&2
  configure_and_build release bench_search bench_event bench_walk >&2
  scripts/engine_figures.py build/release || failures=$((failures + 1))
}

# Runs one test program on the laws' other cases; its log and result stand in out/.
law_one() {
  local name
  name=$(basename "$1")
  if RC_PARAMS="seed=$2 max_success=500" STIG_WORLDS=10000 STIG_TRIALS=100 \
    "$1" >"out/laws-$name.log" 2>&1; then
    echo clean >"out/laws-$name.result"
  else
    echo "**failed**, see out/laws-$name.log" >"out/laws-$name.result"
  fi
}

laws_part() {
  local program name log result programs
  printf '\n## Laws on other random cases, seed %s\n\n| tests | result |\n|---|---|\n' "$seed"
  scripts/install.sh build test >&2
  configure_and_build dev >&2
  mapfile -t programs < <(find build/dev/tests -name 'test_*' -type f -executable | sort)
  export -f law_one
  say "${#programs[@]} test programs" >&2
  printf '%s\0' "${programs[@]}" |
    xargs -0 -P "$(nproc)" -I{} bash -c 'law_one "$@"' _ {} "$seed"
  for program in "${programs[@]}"; do
    name=$(basename "$program") log=out/laws-$(basename "$program").log
    result=$(cat "out/laws-$name.result")
    [[ $result == clean ]] || failures=$((failures + 1))
    printf '| %s | %s |\n' "$name" "$result"
    # How many of the small random worlds were proved, refuted, left open.
    sed -n 's/.*MESSAGE: \(proved [0-9].*\)/| | \1 |/p' "$log"
    # Blocks picked up, carried and stacked by robots, and how well they sit.
    sed -n 's/.*MESSAGE: \([0-9]* stacked.*\)/| | \1 |/p' "$log"
  done
  result=clean
  scripts/check.sh >out/check.log 2>&1 || { result='**failed**, see out/check.log'; failures=$((failures + 1)); }
  printf '| all of scripts/check.sh | %s |\n' "$result"
}

# One row: what stigc validate says of these arguments, which stays in `rows`, a folder of the
# caller's. What is there of the same commit, without changes since, is not done again.
validate_row() {
  local name=$1 file=$rows/$1.json work status=0
  shift
  work="$(git describe --always --dirty 2>/dev/null || echo unknown) $*"
  if [[ ! -f $file || $work == *-dirty\ * || $work == unknown* ||
    $(cat "$rows/$name.work" 2>/dev/null) != "$work" ]]; then
    say "stigc validate $*" >&2
    build/dev/stigc validate "$@" --json --quiet >"$rows/running.json" 2>"$rows/$name.log" || status=$?
    # 1 says that not every run was complete, which the row shows; anything else is a failure.
    if [[ $status -gt 1 || ! -s $rows/running.json ]]; then
      failures=$((failures + 1))
      printf '| %s | **failed**, see %s |\n' "$name" "$rows/$name.log"
      return
    fi
    mv "$rows/running.json" "$file"
    printf '%s\n' "$work" >"$rows/$name.work"
  fi
  python3 scripts/validate_row.py "$name" "$file"
}

# fault_rows [ARGUMENT…]: a row for each scene of faults in which something is built, and what
# becomes of the one in which nothing is.
fault_rows() {
  local scene name rules
  for scene in scenes/faults/*.yaml; do
    name=$(basename "$scene" .yaml) rules=rulesets/staircase.yaml
    case $name in
      robots-head-on) continue ;;
      pyramid-*) rules=rulesets/stepped-pyramid.yaml ;;
    esac
    validate_row "$name" "$rules" --scene "$scene" --duration 1200 "$@"
  done
}

# head_on RUNS [ARGUMENT…]
head_on() {
  printf '\n`robots-head-on`, %s seeds (through the corridor: 2 are both robots):\n\n' "$1"
  fenced build/dev/stigc simulate scenes/faults/robots-head-on.yaml --runs "$@" --quiet ||
    [[ $? -eq 1 ]] || failures=$((failures + 1))
}

# begin_rows FOLDER: the head of a table of validate_row, whose files come there.
begin_rows() {
  rows=$1
  mkdir -p "$rows"
  python3 scripts/validate_row.py --head
}

validate_part() {
  printf '\n## Structures built by robots\n\n'
  scripts/install.sh build >&2
  configure_and_build dev >&2
  begin_rows out/validate
  validate_row staircase rulesets/staircase.yaml --runs 25
  validate_row staircase-later-robot rulesets/staircase.yaml --robot robots/builderbot.yaml --runs 10
  validate_row pyramid rulesets/stepped-pyramid.yaml
  validate_row pyramid-four rulesets/stepped-pyramid.yaml --robots 4 --runs 20
  shape_rows --runs 20
  fault_rows
  head_on 20
}

# shape_rows [ARGUMENT…]: four shapes, each by two robots.
shape_rows() {
  local name
  for name in plus wall u plate; do
    validate_row "$name-two" "tests/compiler/$name.yaml" --robots 2 "$@"
  done
}

# uneven_rows [ARGUMENT…]: structures of which one wing, or two, are much longer than the others, and one
# at which one of two robots is slow, by robots with sides of their own and by robots that share them.
uneven_rows() {
  local allocation
  for allocation in fixed dynamic; do
    validate_row "long-wing-four-$allocation" tests/compiler/long-wing.yaml --robots 4 \
      --allocation "$allocation" "$@"
    validate_row "long-wings-two-$allocation" tests/compiler/long-wings.yaml --robots 2 \
      --allocation "$allocation" "$@"
    validate_row "slow-robot-$allocation" tests/compiler/cross.yaml \
      --scene "scenes/uneven/slow-robot-$allocation.yaml" "$@"
  done
}

# Twenty robots at five structures: how fast a core simulates them.
five_part() {
  printf '\n## Twenty robots at five structures\n\n'
  scripts/install.sh build >&2
  configure_and_build dev >&2
  mkdir -p out/five
  cp scenes/five-structures.{yaml,lua} out/five/
  build/dev/stigc compile rulesets/stepped-pyramid.yaml -o out/five/controller.lua --quiet >&2
  printf 'robot_program: controller.lua\n' >>out/five/five-structures.yaml
  local TIMEFORMAT='%U'
  {
    time build/dev/stigc simulate out/five/five-structures.yaml --duration 900 --quiet \
      >out/five/run.log 2>out/five/run.err
  } 2>out/five/seconds || failures=$((failures + 1))
  sed -n 's/^  \(end\|measure\) */- /p' out/five/run.log
  awk -v core="$(cat out/five/seconds)" '/^  end/ { for (i = 1; i < NF; i++) if ($i == "after") s = $(i + 1) }
    END { printf "- %.0f s simulated in %.0f s of a core: %.1f times real time\n", s, core, s / core }' \
    out/five/run.log
}

# set_up FOLDER ARGUMENT…: writes the set-up of stigc validate with these arguments to a folder. It does
# not run for long enough to build anything, which ends with 1.
set_up() {
  local folder=$1
  shift
  rm -rf "$folder"
  build/dev/stigc validate "$@" --duration 2 -o "$folder" --quiet >&2 || [[ $? -eq 1 ]] ||
    failures=$((failures + 1))
}

# Sizes of pages, how large ones open and turn, and what looking costs a run.
viewer_part() {
  printf '\n## The viewer\n\n| four robots at the pyramid for | trace, bytes | page, bytes |\n|---|---:|---:|\n'
  scripts/install.sh build viewer >&2
  configure_and_build dev stigc viewer >&2
  local dir=out/viewer seconds
  rm -rf "$dir"
  mkdir -p "$dir"
  set_up "$dir/four" rulesets/stepped-pyramid.yaml --robots 4
  for seconds in 400 2400; do
    build/dev/stigc simulate "$dir/four/scene.yaml" --duration "$seconds" --quiet \
      --trace "$dir/$seconds.stigp" >&2 || failures=$((failures + 1))
    build/dev/stigc view "$dir/$seconds.stigp" -o "$dir/$seconds.html" --quiet ||
      failures=$((failures + 1))
    printf '| %s s | %s | %s |\n' "$seconds" "$(stat -c %s "$dir/$seconds.stigp")" \
      "$(stat -c %s "$dir/$seconds.html")"
    [[ $(stat -c %s "$dir/$seconds.html") -lt $((seconds == 400 ? 3000000 : 10000000)) ]] ||
      failures=$((failures + 1))
  done
  printf '\n'
  tests/viewer/run.sh measure "$PWD/build/dev/viewer" "$PWD/build/dev/stigc" ||
    failures=$((failures + 1))
  printf '\n'
  sed 's/^duration: .*/duration: 60/' "$dir/four/scene.yaml" >"$dir/four/minute.yaml"
  scripts/live_cost.py build/dev/stigc "$dir/four/minute.yaml" | sed -n '/^|/p; /^$/p' ||
    failures=$((failures + 1))
}

# Packages of the release build, on a Debian that has nothing else.
packages_part() {
  printf '\n## Packages\n\n'
  scripts/install.sh build >&2
  configure_and_build release >&2
  rm -rf out/packages
  cpack --config build/release/CPackConfig.cmake -B out/packages -G 'TGZ;DEB' >&2 ||
    failures=$((failures + 1))
  scripts/bare_debian.sh out/packages || failures=$((failures + 1))
}

# cost_row WHAT SECONDS SCENE: what so many simulated seconds of a scene cost of the processor.
cost_row() {
  local TIMEFORMAT='%U'
  { time build/dev/stigc simulate "$3" --seed "$seed" --duration "$2" --quiet >&2; } \
    2>"$rows/seconds" || failures=$((failures + 1))
  awk -v what="$1" -v s="$2" '/^[0-9.]+$/ { core = $1 }
    END { printf "| %s | %d s | %.1f s | %.1f |\n", what, s, core, s / core }' "$rows/seconds"
}

# What it costs to simulate four robots at work, and a crowd. With assertions, as robots were run above.
cost_rows() {
  printf '\n### What it costs, in time of the processor\n\n|  | simulated | cost | times real time |\n|---|---:|---:|---:|\n'
  set_up "$rows/four" "$1" --robots 4
  cost_row 'four robots build the pyramid' 200 "$rows/four/scene.yaml"
  cost_row 'and go on for all of 2400 s' 2400 "$rows/four/scene.yaml"
  cost_row '100 robots push among 1024 blocks' 9 scenes/crowd.yaml
}

# drawn_targets COUNT FOLDER: so many targets of each kind, drawn by the seed, each built by one robot and by two. What the
# folder has of them is not done again.
drawn_targets() {
  scripts/install.sh build bench >&2
  configure_and_build release stigc bench_assembly >&2
  local command=(build/release/bench_assembly --build build/release/stigc -o "$2" "$1" "$seed")
  printf '`%s`\n\n' "${command[*]}"
  fenced "${command[@]}" || failures=$((failures + 1))
}

robots_part() {
  # Twenty robots, and tables of their own, with five seeds at most.
  local seeds=(--runs "$runs" --seed "$seed") few=$((runs < 5 ? runs : 5))
  local pyramid=rulesets/stepped-pyramid.yaml staircase=rulesets/staircase.yaml
  printf '\n## Robots, %s runs a row, from seed %s on\n\n' "$runs" "$seed"
  scripts/install.sh build >&2
  configure_and_build dev stigc >&2
  begin_rows "out/robots-$seed"
  validate_row pyramid-four "$pyramid" --robots 4 --runs $((5 * runs)) --seed "$seed"
  set_up "$rows/exact" "$pyramid" --robots 4
  sed -i '/^noise:/d; s/^duration: .*/duration: 2400/' "$rows/exact/scene.yaml"
  validate_row pyramid-four-without-noise "$pyramid" --scene "$rows/exact/scene.yaml" \
    --runs $((5 * runs)) --seed "$seed"
  validate_row staircase "$staircase" --runs $((10 * runs)) --seed "$seed"
  validate_row staircase-later-robot "$staircase" --robot robots/builderbot.yaml \
    --runs $((5 * runs / 2)) --seed "$seed"
  validate_row pyramid-four-later-robots "$pyramid" --robots 4 --robot robots/builderbot.yaml \
    "${seeds[@]}"
  shape_rows "${seeds[@]}"
  uneven_rows "${seeds[@]}"
  fault_rows "${seeds[@]}"
  validate_row pyramid-eight "$pyramid" --robots 8 "${seeds[@]}"
  validate_row five-pyramids-twenty "$pyramid" --structures 5 --robots 20 --runs "$few" --seed "$seed"
  # A plate of 6×6 by ten robots, of rules that are synthesised for it.
  printf 'a a a a a a\n%.0s' {1..6} >"$rows/large-plate.txt"
  build/dev/stigc synth "$rows/large-plate.txt" --floor --robot robots/bebot.yaml --robots 10 \
    -o "$rows/large-plate.yaml" --quiet >&2 || failures=$((failures + 1))
  validate_row large-plate-ten "$rows/large-plate.yaml" --robots 10 --runs "$few" --seed "$seed"
  head_on "${seeds[@]:1}"
  printf '\n### Allocation where work is uneven\n\n'
  scripts/allocation_table.py "$rows" || failures=$((failures + 1))
  printf '\n### More robots at one pyramid\n\n'
  STIGC=build/dev/stigc scripts/scaling.sh --seed "$seed" --runs "$few" ||
    failures=$((failures + 1))
  cost_rows "$pyramid"
  printf '\n### Targets that are drawn by the seed, by one robot and by two\n\n'
  drawn_targets $((runs < 10 ? 1 : runs / 5)) "$rows/drawn-$(git rev-parse --short HEAD)"
}

# Targets of every kind, drawn by the seed. What out/assembly-SEED has of them is not done again. And large ones.
assembly_part() {
  printf '\n## Drawn targets, built by one robot and by two\n\n'
  local command
  drawn_targets "$targets" "out/assembly-$seed"
  configure_and_build release >&2
  printf '\n## Large targets\n'
  for command in 'build/release/bench_assembly_sizes named' build/release/bench_assembly_sizes; do
    printf '\n`%s`\n\n' "$command"
    # shellcheck disable=SC2086
    fenced $command || failures=$((failures + 1))
  done
}

# Runs one target on its corpus; its log says what came of it. New inputs go to the first folder,
# the shipped corpus is only read.
fuzz_one() {
  local name
  name=$(basename "$1")
  mkdir -p "out/fuzz/$name"
  if "$1" -seed="$3" -max_total_time="$2" -timeout=20 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="out/fuzz/$name-" "out/fuzz/$name" "fuzz/corpus/${name#fuzz_}" \
    >"out/$name.log" 2>&1; then
    echo clean >"out/$name.result"
  else
    echo "**failed**, see out/$name.log" >"out/$name.result"
  fi
}

fuzz_part() {
  printf '\n## Fuzzing, %s s for each target, %s at a time\n\n' "$fuzz_seconds" "$fuzz_jobs"
  scripts/install.sh build fuzz >&2
  configure_and_build fuzz >&2
  printf '| target | runs | result |\n|---|---:|---|\n'
  local program name runs result programs
  mapfile -t programs < <(find build/fuzz -name 'fuzz_*' -type f -executable | sort)
  export -f fuzz_one
  say "${#programs[@]} targets" >&2
  printf '%s\0' "${programs[@]}" |
    xargs -0 -P "$fuzz_jobs" -I{} bash -c 'fuzz_one "$@"' _ {} "$fuzz_seconds" "$seed"
  for program in "${programs[@]}"; do
    name=$(basename "$program")
    result=$(cat "out/$name.result")
    [[ $result == clean ]] || failures=$((failures + 1))
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "out/$name.log")
    printf '| %s | %s | %s |\n' "$name" "${runs:-?}" "$result"
  done
}

sanitizers_part() {
  printf '\n## Tests under sanitizers\n\n| preset | result |\n|---|---|\n'
  local preset log
  for preset in asan-ubsan tsan; do
    log=out/$preset.log
    say "$preset" >&2
    scripts/test.sh "$preset" >"$log" 2>&1 || failures=$((failures + 1))
    printf '| %s | %s |\n' "$preset" \
      "$(grep -E '[0-9]+% tests passed' "$log" || echo "did not build, see $log")"
  done
}

report() {
  machine
  for part in "${parts[@]}"; do
    "${part}_part"
  done
  [[ $failures -eq 0 ]] || die "$failures of the checks failed"
}

report | tee out/acceptance.md
