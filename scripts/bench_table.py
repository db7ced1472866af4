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
       "error_message"}


def figure(value):
    """Four digits, with a power of ten where it helps: 5.123e+08, 12.35."""
    return f"{value:.4g}" if isinstance(value, (int, float)) else str(value)


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
            time = f"{figure(run['real_time'])} {run['time_unit']}"
            cells = [run["name"], time] + [figure(run.get(name, "")) for name in counters]
        print("| " + " | ".join(cells + [run.get(name, "") for name in labels]) + " |")


if __name__ == "__main__":
    main()
