#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what --allocation dynamic gains where work is uneven, as a markdown table.

    allocation_table.py FOLDER

FOLDER holds what stigc validate --json said of rows of scripts/acceptance.sh. Times are those of the
last brick of complete runs, mean and median; a ratio below 1 says that dynamic allocation is faster.
"""

import json
import pathlib
import statistics
import sys

# What is uneven, and the rows of either allocation.
PAIRS = [
    ("one wing of five bricks, three of two, by four", "long-wing-four-fixed", "long-wing-four-dynamic"),
    ("two wings of seven bricks, two of one, by two", "long-wings-two-fixed", "long-wings-two-dynamic"),
    ("one of two robots at a quarter of its speed", "slow-robot-fixed", "slow-robot-dynamic"),
    ("one of four robots stops for good", "pyramid-robot-stopped-out-of-the-way",
     "pyramid-robot-replaced"),
]


def finishes(path):
    """Times of the last brick of complete runs, and how many runs there are."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["runs"]
    complete = [run for run in runs if run["verdict"] == "complete"]
    return [max(event["time"] for event in run["events"] if event["what"] == "placed")
            for run in complete], len(runs)


def cell(times, runs):
    text = f"{len(times)} of {runs}"
    return f"{text}, {statistics.mean(times):.0f} s ({statistics.median(times):.0f} s)" if times else text


def ratios(fixed, dynamic):
    if not fixed or not dynamic:
        return "–"
    mean, median = (of(dynamic) / of(fixed) for of in (statistics.mean, statistics.median))
    return f"{mean:.2f} ({median:.2f})"


def main():
    folder = pathlib.Path(sys.argv[1])
    print("| | fixed: complete, mean (median) | dynamic | dynamic / fixed |")
    print("|---|---:|---:|---:|")
    for what, *names in PAIRS:
        paths = [folder / f"{name}.json" for name in names]
        if all(path.exists() for path in paths):
            (fixed, fixed_runs), (dynamic, dynamic_runs) = map(finishes, paths)
            print(f"| {what} | {cell(fixed, fixed_runs)} | {cell(dynamic, dynamic_runs)} "
                  f"| {ratios(fixed, dynamic)} |")


if __name__ == "__main__":
    main()
