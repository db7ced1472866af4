#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the Debian packages that packages.txt lists for the given purposes:
#
#   scripts/install.sh [PURPOSE…]      build test viewer playground python cluster slurm
#                                 tidy docs bench fuzz coverage
#
# Without a purpose: build and test. What is there already is left alone, so running
# it twice costs nothing. STIG_SKIP_INSTALL=1 leaves everything to you.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[[ $# -gt 0 ]] || set -- build test

# Prints "package [command]" for each package of the purposes given.
packages_for() {
  local line section='' wanted=" $* "
  while IFS= read -r line; do
    line=${line%%#*}
    if [[ $line =~ ^\[([a-z]+)\] ]]; then
      section=${BASH_REMATCH[1]}
    elif [[ $wanted == *" $section "* ]]; then
      printf '%s\n' "$line"
    fi
  done <packages.txt | awk 'NF && !seen[$1]++'
}

# The packages among those on standard input that are missing here.
missing() {
  local package command
  while read -r package command; do
    if [[ -n $command ]] && command -v "${command//[\[\]]/}" >/dev/null; then continue; fi
    dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' ||
      printf '%s\n' "$package"
  done
}

for purpose in "$@"; do
  grep -q "^\[$purpose\]" packages.txt || die "packages.txt knows no purpose '$purpose'"
done
[[ -z ${STIG_SKIP_INSTALL:-} ]] || exit 0

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  printf 'This system has no apt-get. Install what matches these Debian packages, then run\n' >&2
  printf 'again with STIG_SKIP_INSTALL=1:\n\n' >&2
  packages_for "$@" | awk '{print "  " $1}' >&2
  exit 1
fi

mapfile -t packages < <(packages_for "$@" | missing)
if [[ ${#packages[@]} -eq 0 ]]; then
  printf 'All packages for %s are there.\n' "$*"
  exit 0
fi

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null ||
    die "needs root: apt-get install -y --no-install-recommends ${packages[*]}"
  as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
    -o Dpkg::Use-Pty=0 "$@" >>"$log" 2>&1 </dev/null
}

say "Installing for $*: ${packages[*]}"
# The lists are fetched only where there are none yet, or where the ones here are stale.
if ! compgen -G '/var/lib/apt/lists/*Packages*' >/dev/null; then
  apt update || { tail -n 20 "$log" >&2; die "apt-get update failed"; }
fi
if ! apt install --no-install-recommends "${packages[@]}"; then
  apt update || true
  apt install --no-install-recommends "${packages[@]}" ||
    { tail -n 30 "$log" >&2; die "apt-get could not install them"; }
fi
printf 'Installed.\n'
