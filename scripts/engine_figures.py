#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the engines of the lattice and prints markdown tables: screening, event motion, agents.

    engine_figures.py FOLDER [REPETITIONS]

FOLDER has bench_search, bench_event and bench_walk. Figures are medians of REPETITIONS (3), by
processor time but for two threads, which take the clock's. Rates below what is aimed at are marked.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

AIMS = {"sets": 1e4, "threads": 1.8, "deposits": 2e6}


def medians(program, pattern, repetitions):
    """Medians by benchmark: their counters, and the real time in ms."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, f"--benchmark_filter={pattern}",
                        f"--benchmark_repetitions={repetitions}",
                        "--benchmark_report_aggregates_only=true",
                        f"--benchmark_out={file.name}", "--benchmark_out_format=json"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        runs = json.load(file)["benchmarks"]
    return {run["run_name"]: run for run in runs if run.get("aggregate_name") == "median"}


def figure(value, aim=None):
    text = f"{value:.3g}" if value < 1e4 else f"{value:.2e}".replace("e+0", "e")
    return f"**{text}**" if aim is not None and value < aim else text


def table(head, rows):
    print("\n| " + " | ".join(head) + " |")
    print("|---" + "|---:" * (len(head) - 1) + "|")
    for row in rows:
        print("| " + " | ".join(row) + " |")


def screening(folder, repetitions):
    found = medians(folder / "bench_search", "screening", repetitions)
    shares = ("mean", "10%", "50%", "90%", "99%")
    rows = []
    for name, one in found.items():
        kind = name.removeprefix("screening/")
        if not kind.endswith("_1"):
            continue
        two = found[f"screening/{kind[:-2]}_2/real_time"]
        rows.append([kind[:-2].replace("_", " "), figure(one["sets/s"], AIMS["sets"]),
                     figure(two["sets/s"] / one["sets/s"], AIMS["threads"])] +
                    [figure(one[f"deposits_{share}"]) for share in shares])
    table(["random sets of 20 rules, 20³", "sets/s, one core", "two threads : one"] +
          [f"deposits, {share}" for share in shares], rows)


def events(folder, repetitions):
    found = medians(folder / "bench_event", "^deposits/", repetitions)
    table(["events, 20³", "deposits/s", "deposits a run"],
          [[name.removeprefix("deposits/").removesuffix("_20"),
            figure(run["deposits/s"], AIMS["deposits"]), figure(run["deposits/run"])]
           for name, run in found.items()])


def agents(folder, repetitions):
    found = medians(folder / "bench_walk", "^(engine_vector|teleport)/", repetitions)
    rows = []
    for name, run in found.items():
        motion, side, number = name.split("/")
        small = found[f"{motion}/side:20/{number}"]
        rows.append(["walk" if motion == "engine_vector" else motion,
                     side.removeprefix("side:") + "³", number.removeprefix("agents:"),
                     figure(run["agent_steps/s"]),
                     figure(run["agent_steps/s"] / small["agent_steps/s"])])
    table(["motion", "box", "agents", "agent-steps/s", ": that in 20³"], rows)


def main(arguments):
    if not 1 <= len(arguments) <= 2 or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 0 if arguments in (["-h"], ["--help"]) else 2
    folder = pathlib.Path(arguments[0])
    repetitions = int(arguments[1]) if len(arguments) > 1 else 3
    for part in (screening, events, agents):
        part(folder, repetitions)
        sys.stdout.flush()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
