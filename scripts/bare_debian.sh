#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what cpack made into a Debian that has nothing else, and runs it there:
#
#   scripts/bare_debian.sh PACKAGES [SUITE]
#
# PACKAGES is a folder with the .deb files and the tarball, SUITE a release of Debian (bookworm). Root,
# debootstrap and a mirror of Debian are needed; where one is missing, that is said, and nothing is tried.
# Prints a table; ends with 1 when something in it failed.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=$(cd "${1:?a folder of packages is needed; see scripts/bare_debian.sh}" && pwd)
suite=${2:-bookworm} mirror=http://deb.debian.org/debian
left_out() { printf 'Left out: %s.\n' "$1"; exit 0; }
command -v debootstrap >/dev/null || left_out 'there is no debootstrap (Debian: debootstrap)'
[[ $(id -u) -eq 0 ]] || left_out 'debootstrap needs root'

work=$(mktemp -d) failures=0
root="$work/root"
# Only what was mounted here is in the way of taking the folder away.
clean() { mountpoint -q "$root/proc" && umount "$root/proc"; rm -rf --one-file-system "$work"; }
trap clean EXIT
say "debootstrap $suite" >&2
debootstrap --variant=minbase "$suite" "$root" "$mirror" >"$work/log" 2>&1 ||
  left_out "no $suite came from $mirror"
# The program finds its files by where it is itself, which /proc tells.
mount -t proc proc "$root/proc" || left_out 'nothing can be mounted here'
mkdir -p "$root/packages" "$root/opt/odd place (1)" "$root/root/small" "$root/root/large"
cp "$packages"/*.deb "$root/packages"
tar -C "$root/opt/odd place (1)" -xf "$packages"/stig-*.tar.gz

# try NAME SCRIPT: one row; the script begins in /, which has nothing to do with stigc.
try() {
  local result=good
  say "$1" >&2
  if ! chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive /bin/bash -euc "cd /; $2" \
    >"$work/log" 2>&1; then
    result="**failed**: $(tail -n 2 "$work/log" | tr '\n|' '  ')"
    cat "$work/log" >&2
    failures=$((failures + 1))
  fi
  printf '| %s | %s |\n' "$1" "$result"
}
install='apt-get install -y --no-install-recommends'

cat >"$root/root/small/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small CXX)
find_package(stig 0.1 REQUIRED COMPONENTS verify)
add_executable(small small.cpp)
target_link_libraries(small PRIVATE stig::verify)
END
cat >"$root/root/small/small.cpp" <<'END'
#include "rules/rule_reader.h"
int main() {
  stig::Diagnostics diagnostics;
  return stig::rules::read_rule_set_file("/usr/share/stig/rulesets/staircase.yaml", diagnostics) ? 0 : 1;
}
END
cat >"$root/root/large/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(large CXX)
find_package(stig 0.1 REQUIRED)
add_executable(large large.cpp)
target_link_libraries(large PRIVATE stig::physical_dynamics)
END
cat >"$root/root/large/large.cpp" <<'END'
#include "physical/dynamics/world.h"
int main() {
  using namespace stig::physics;
  WorldConfig config;
  config.bodies.push_back(solid_body(Shape::box({0.1, 0.1, 0.1}), 1, {0, 0, 1}));
  World world(config);
  for (int i = 0; i < 400; ++i) world.step();
  return world.state(BodyId{0}).X_WB.p.z < 0.051 ? 0 : 1;
}
END

printf '| on a bare %s | |\n|---|---|\n' "$suite"
try 'tarball at a path with spaces, beside nothing else: what it lacks is said' \
  '! "/opt/odd place (1)"/stig-*/bin/stigc --version 2>/tmp/said; grep -q "lib.*\.so" /tmp/said'
try '`apt install ./stigc_*.deb`' "apt-get update; $install /packages/stigc_*.deb"
try '`stigc doctor`' 'stigc doctor'
try 'shipped files by name: explore, verify, compile, simulate' \
  'stigc explore rulesets/staircase.yaml -o /tmp/s.png; stigc verify rulesets/staircase.yaml
   stigc compile rulesets/staircase.yaml -o /tmp/s.lua; stigc simulate scenes/stack.yaml --duration 0.2'
try 'validate, until one brick of the staircase is placed' \
  'stigc validate rulesets/staircase.yaml --duration 100 >/tmp/said || [ $? = 1 ]; grep -q "verdict" /tmp/said'
try '`stigc init`, and what its page says' \
  'stigc init /root/mine; cd /root/mine; stigc check rules.yaml scene.yaml; stigc verify rules.yaml'
try 'a page' 'stigc simulate scenes/stack.yaml --duration 0.2 --trace /tmp/a.stigp
   stigc view /tmp/a.stigp -o /tmp/a.html; [ -s /tmp/a.html ]'
try 'tarball at a path with spaces' 'cd /tmp; s=$(echo "/opt/odd place (1)"/stig-*/bin/stigc)
   "$s" explore rulesets/staircase.yaml 2>&1 | grep -q "odd place"; "$s" simulate scenes/stack.yaml --duration 0.1'
try '`libstig-lattice-dev`: a program of one'"'"'s own, without DART' \
  "$install /packages/libstig-lattice-dev_*.deb g++ cmake ninja-build
   ! dpkg -s libdart-dev >/dev/null 2>&1
   cmake -G Ninja -S /root/small -B /root/small/b; cmake --build /root/small/b; /root/small/b/small"
try '`libstig-dev`: one with physics' \
  "$install /packages/libstig-dev_*.deb
   cmake -G Ninja -S /root/large -B /root/large/b; cmake --build /root/large/b; /root/large/b/large"
if compgen -G "$packages/stigc-mesh_*.deb" >/dev/null; then
  try '`stigc-mesh`: a mesh to bricks' "$install /packages/stigc-mesh_*.deb
   stigc explore rulesets/stepped-pyramid.yaml -o /tmp/p.stl; stigc voxelise /tmp/p.stl --side 1 -o /tmp/p.vox"
fi
if compgen -G "$packages/stigc-python_*.deb" >/dev/null; then
  try '`stigc-python`: the module' "$install /packages/stigc-python_*.deb; PYTHONPATH=/usr/lib/stig/python python3 -c 'import stigc'"
fi
[[ $failures -eq 0 ]] || die "$failures of these failed"
