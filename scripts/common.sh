# SPDX-License-Identifier: MIT
# What the scripts share; sourced, never run. Leaves the caller in the project's root.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '\n== %s\n' "$*"; }

die() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# configure_and_build PRESET [TARGET…]
configure_and_build() {
  local preset=$1
  shift
  local log="build/$preset-configure.log"
  mkdir -p build
  cmake --preset "$preset" >"$log" 2>&1 || { cat "$log" >&2; die "cmake --preset $preset failed"; }
  cmake --build "build/$preset" --parallel "$(nproc)" ${1:+--target "$@"}
}

# program_for_pictures: sets `stigc` to $STIGC, or to the program built here; pngquant is
# there afterwards.
program_for_pictures() {
  stigc=${STIGC:-}
  if [[ -z $stigc ]]; then
    scripts/install.sh build docs
    configure_and_build quick stigc
    stigc=build/quick/stigc
  fi
  command -v pngquant >/dev/null || die "needs pngquant: scripts/install.sh docs"
}
