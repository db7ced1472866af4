#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads a table of poses with Python's csv module: pose_table.py TABLE. Prints, for each body, its
rows and the last of its places; fails where a value is no number, where times fall, or where a
quaternion is no unit."""
import csv
import sys

NUMBERS = ("time", "x", "y", "z", "qw", "qx", "qy", "qz")
rows = {}
with open(sys.argv[1], newline="") as file:
    before = 0.0
    for row in csv.DictReader(file, strict=True):
        assert None not in row and None not in row.values(), row
        value = {key: float(row[key]) for key in NUMBERS}
        assert value["time"] >= before, row
        before = value["time"]
        assert row["kind"] in ("block", "robot") and row["awake"] in ("0", "1"), row
        assert abs(sum(value[key] ** 2 for key in NUMBERS[4:]) - 1) < 1e-4, row
        rows.setdefault((row["body"], row["kind"]), []).append(value)
for (body, kind), values in sorted(rows.items()):
    last = values[-1]
    print(f"{body} ({kind}): {len(values)} rows, {last['time']} s,"
          f" {last['x']:.5f} {last['y']:.5f} {last['z']:.5f}")
