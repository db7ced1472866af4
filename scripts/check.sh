#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The quick checks, everything that is not a test: shell syntax, formatting, layering,
# and that each source and header compiles alone.
#
#   scripts/check.sh [--fix] [--recent] [--tidy [FILE…]]
#
#   --fix    format the sources instead of complaining
#   --recent compile alone what the last 40 commits touched, and not all
#   --tidy   clang-tidy as well, over the given or all source files (minutes)
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

fix='' recent='' tidy='' tidy_files=()
while [[ $# -gt 0 ]]; do
  case $1 in
    --fix) fix=1 ;;
    --recent) recent=1 ;;
    --tidy) tidy=1; shift; tidy_files=("$@"); break ;;
    -h | --help) sed -n '3,10s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) die "unknown option '$1'; see --help" ;;
  esac
  shift
done

purposes=(build test)
[[ -z $tidy ]] || purposes+=(tidy)
scripts/install.sh "${purposes[@]}"

# The project's files that end in one of the given patterns; new ones count too.
files() { git ls-files --cached --others --exclude-standard -- "$@"; }

say "Shell scripts parse"
while IFS= read -r script; do
  bash -n "$script"
done < <(files '*.sh' '.ci/*')

say "Sources are formatted"
if [[ -n $fix ]]; then
  files '*.cpp' '*.h' | xargs -r clang-format -i
else
  files '*.cpp' '*.h' | xargs -r clang-format --dry-run -Werror ||
    die "run scripts/check.sh --fix"
fi

# Configured only: for the graph of layers, and for the commands that compile one source.
cmake --preset dev -B build/alone -D STIG_UNITY=OFF >/dev/null

say "Includes keep to the layers"
python3 tests/layering/layering.py --graph build/alone/layers.txt --root .

alone=()
if [[ -n $recent ]]; then
  mapfile -t alone < <(git log -40 --name-only --format= -- '*.cpp' '*.h' | sort -u)
fi
say "Sources and headers compile alone${recent:+ (of the last 40 commits)}"
[[ -n $recent && ${#alone[@]} -eq 0 ]] || scripts/compile_alone.py build/alone "${alone[@]}"

if [[ -n $tidy ]]; then
  say "clang-tidy"
  [[ ${#tidy_files[@]} -gt 0 ]] || mapfile -t tidy_files < <(files 'lib/*.cpp' 'tools/*.cpp')
  printf '%s\n' "${tidy_files[@]}" |
    xargs -P "$(nproc)" -n 1 clang-tidy -p build/alone --quiet --warnings-as-errors='*'
fi

say "All checks passed"
