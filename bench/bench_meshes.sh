#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Time that a mesh takes to become bricks, by its number of triangles:
#
#   bench/bench_meshes.sh [STIGC]
#
# A structure is drawn as a surface, and its surface turned into bricks again.
set -euo pipefail
stigc=${1:-build/release/stigc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

printf '| triangles | bricks | s |\n|---|---|---|\n'
for side in 10 30 60 91; do
  # Every second cell of a cube as a chequerboard on a plate: its surface grows with the cells.
  awk -v n="$side" 'BEGIN {
    for (y = 0; y < n; y++) { for (x = 0; x < n; x++) printf "1 "; print "" }
    print "---"
    for (y = 0; y < n; y++) { for (x = 0; x < n; x++) printf (x + y) % 2 ? ". " : "1 "; print "" }
  }' >"$work/plate.txt"
  "$stigc" draw -q "$work/plate.txt" -o "$work/plate.stl"
  begun=$(date +%s.%N)
  "$stigc" voxelise -q "$work/plate.stl" --side 1 -o "$work/back.txt" --json >"$work/report.json"
  ended=$(date +%s.%N)
  python3 - "$work/report.json" "$begun" "$ended" <<'END'
import json, sys
report = json.load(open(sys.argv[1]))
print(f"| {report['faces']} | {report['bricks']} | {float(sys.argv[3]) - float(sys.argv[2]):.2f} |")
END
done
