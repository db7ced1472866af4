#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what stigc validate --json says of different numbers of robots as a markdown table.

    scaling_table.py FILE…

Files are named …-ROBOTS-ALLOCATION.json. Times are those of the last brick, mean and deviation of
complete runs. Bricks an hour are over all runs, whole or not; the speed-up is theirs over one robot's.
"""

import json
import pathlib
import sys


def row(path):
    """What the table says of one file."""
    robots, allocation = path.stem.split("-")[-2:]
    with open(path, encoding="utf-8") as file:
        return int(robots), allocation, json.load(file)["summary"]


def ratio(over, under):
    """Of two times; a dash where one is not known."""
    return f"{over / under:.2f}" if over and under else "–"


def time_of(summary):
    if summary["finish_s"] is None:
        return "–"
    return f"{summary['finish_s']:.0f} ± {summary['finish_deviation_s']:.0f}"


def rate_of(robots, summary):
    """Bricks placed in an hour of simulated time."""
    return 3600 * summary["placed"] * robots / summary["robots_s"]


def main():
    rows = [row(pathlib.Path(name)) for name in sys.argv[1:]]
    finish = {(robots, allocation): all_["finish_s"] for robots, allocation, all_ in rows}
    rates = {(robots, allocation): rate_of(robots, all_) for robots, allocation, all_ in rows}
    print("| robots | allocation | complete | last brick / s | bricks an hour | speed-up "
          "| busy a brick | idle |")
    print("|---:|---|---:|---:|---:|---:|---:|---:|")
    for robots, allocation, all_ in rows:
        rate = rates[robots, allocation]
        print(f"| {robots} | {allocation} | {all_['complete']} of {all_['runs']} "
              f"| {time_of(all_)} | {rate:.0f} | {ratio(rate, rates.get((1, 'fixed')))} "
              f"| {all_['busy_per_brick']:.2f} | {100 * all_['idle_share']:.0f} % |")
    for (robots, allocation), time in finish.items():
        if allocation == "fixed" and (robots, "dynamic") in finish:
            print(f"\nTime to the last brick, dynamic over fixed allocation, {robots} robots: "
                  f"{ratio(finish.get((robots, 'dynamic')), time)}")


if __name__ == "__main__":
    main()
