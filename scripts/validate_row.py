#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what stigc validate --json says of some runs as one row of a markdown table.

    validate_row.py NAME FILE
    validate_row.py --head

The time is that of the last brick, mean and deviation of complete runs. Fewer complete runs than 19
of 20 are in bold. Runs that are not complete are listed by verdict and end, with their seeds; of the
first of them the first three findings.
"""

import json
import sys

AIM = 19 / 20
MOST_FINDINGS = 3
HEAD = ["", "complete", "last brick / s", "efficiency", "robots on their side", "not complete: seeds",
        "what went wrong first"]


def seconds(summary):
    if summary["finish_s"] is None:
        return "–"
    return f"{summary['finish_s']:.0f} ± {summary['finish_deviation_s']:.0f}"


def complete(summary):
    text = f"{summary['complete']} of {summary['runs']}"
    return text if summary["complete"] >= AIM * summary["runs"] else f"**{text}**"


def fallen(runs):
    robots = [robot for run in runs for robot in run["robots"]]
    return f"{sum(robot['fallen'] for robot in robots)} of {len(robots)}"


def verdicts(failed):
    """Seeds by verdict and end, in the order in which these first came."""
    seeds = {}
    for run in failed:
        seeds.setdefault(f"{run['verdict']}, {run['end']}", []).append(str(run["seed"]))
    return "; ".join(f"{what}: {', '.join(some)}" for what, some in seeds.items())


def row(name, report):
    summary, runs = report["summary"], report["runs"]
    failed = [run for run in runs if run["verdict"] != "complete"]
    findings = failed[0]["findings"][:MOST_FINDINGS] if failed else []
    return [name, complete(summary), seconds(summary), f"{summary['efficiency']:.2f}", fallen(runs),
            verdicts(failed), "; ".join(findings).replace("|", "\\|")]


def main():
    if sys.argv[1:] == ["--head"]:
        print("| " + " | ".join(HEAD) + " |")
        print("|---|---:|---:|---:|---:|---|---|")
        return
    name, path = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        print("| " + " | ".join(row(name, json.load(file))) + " |")


if __name__ == "__main__":
    main()
