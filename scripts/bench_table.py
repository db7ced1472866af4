#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints the JSON that Google Benchmark writes as a markdown table.

    bench_table.py FILE

Counters of a benchmark (rates, ratios) become columns; standard error has nothing.
"""

import json
import sys

# What Google Benchmark itself says of each run; the rest are counters.
OWN = {"name", "family_index", "per_family_instance_index", "run_name", "run_type",
       "repetitions", "repetition_index", "threads", "iterations", "real_time", "cpu_time",
       "time_unit", "aggregate_name", "aggregate_unit", "label", "error_occurred",
       "error_message", "big_o", "cpu_coefficient", "real_coefficient", "rms"}


def figure(value):
    """Four digits, with a power of ten where it helps: 5.123e+08, 12.35."""
    return f"{value:.4g}" if isinstance(value, (int, float)) else str(value)


def time_of(run):
    """A time, or what Google Benchmark fits to the times of all sizes."""
    if "big_o" in run:
        return f"{figure(run['real_coefficient'])} {run['time_unit']} · {run['big_o']}"
    if "rms" in run:
        return f"{100 * run['rms']:.0f} % off the fit"
    return f"{figure(run['real_time'])} {run['time_unit']}"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    counters = sorted({key for run in runs for key in run} - OWN)
    labels = ["label"] if any(run.get("label") for run in runs) else []
    columns = ["benchmark", "time"] + [name.replace("_", " ") for name in counters] + labels
    print("| " + " | ".join(columns) + " |")
    print("|---" + "|---:" * (1 + len(counters)) + "|---" * len(labels) + "|")
    for run in runs:
        if run.get("error_occurred"):
            cells = [run["name"], f"failed: {run['error_message']}"] + [""] * len(counters)
        else:
            cells = [run["name"], time_of(run)] + [figure(run.get(name, "")) for name in counters]
        print("| " + " | ".join(cells + [run.get(name, "") for name in labels]) + " |")


if __name__ == "__main__":
    main()
