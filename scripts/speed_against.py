#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sets the speed of the engines, the verifier and physics against that of another revision.

    speed_against.py REVISION [ROUNDS]

Builds the benchmarks of both (preset release; the other's sources in build/against/REVISION), runs
them by turns ROUNDS times (3), and prints a markdown table: the least time of each and the median
of the ratios of pairs, so that what slows the machine for a while slows both. A ratio below 1 is
faster. Nothing else should run meanwhile. Progress goes to standard error.
"""

import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ("bench_walk", "bench_event", "bench_verify", "bench_physics")
# Trials of bench_physics that are about time, and what their figures look like: ms for a step, or
# how many times faster than real time. What has settled costs nothing, and is left out.
TIMED_TRIALS = ("awake", "apart", "drop")
FIGURE = re.compile(r"([\d.e+-]+) ms\b|([\d.e+-]+) for\b")


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(*words, cwd=ROOT):
    subprocess.run(words, cwd=cwd, check=True, stdout=sys.stderr)


def build(folder):
    """The folder of the built programs."""
    run("cmake", "--preset", "release", cwd=folder)
    run("cmake", "--build", "build/release", "--parallel", str(os.cpu_count()), "--target",
        *PROGRAMS, cwd=folder)
    return folder / "build/release"


def sources_of(revision):
    """The revision's files, in a folder that is kept for the next call."""
    commit = subprocess.run(["git", "rev-parse", "--short", revision + "^{commit}"], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout.strip()
    folder = ROOT / "build/against" / commit
    if not folder.exists():
        folder.mkdir(parents=True)
        archive = subprocess.run(["git", "archive", commit], cwd=ROOT, check=True,
                                 capture_output=True).stdout
        subprocess.run(["tar", "-x"], cwd=folder, input=archive, check=True)
    return commit, folder


def times_by_library(program):
    """Nanoseconds by benchmark, from a program on Google Benchmark; fits of complexity left out."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, f"--benchmark_out={file.name}", "--benchmark_out_format=json"],
                       cwd=ROOT, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        found = json.load(file)["benchmarks"]
    scale = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
    return {one["name"]: one["cpu_time"] * scale[one["time_unit"]] for one in found
            if one.get("run_type") == "iteration" and "cpu_time" in one}


def times_of_physics(program):
    """Nanoseconds for a step; for a drop those for a second of simulated time."""
    out = subprocess.run([program, *TIMED_TRIALS], cwd=ROOT, check=False, capture_output=True,
                         text=True).stdout
    times = {}
    for line in out.splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) < 6 or cells[1].strip("`") not in TIMED_TRIALS:
            continue
        figure = FIGURE.search(cells[4])
        if figure:
            times[cells[2]] = float(figure[1]) * 1e6 if figure[1] else 1e9 / float(figure[2])
    return times


def measure(folder):
    times = {}
    for program in PROGRAMS:
        of = times_of_physics if program == "bench_physics" else times_by_library
        for name, time in of(folder / program).items():
            times[f"{program.removeprefix('bench_')}: {name}"] = time
    return times


def print_table(commit, rounds):
    """rounds: pairs of what was measured now and then."""
    print(f"| | {commit} / ms | now / ms | now : {commit} |")
    print("|---|---:|---:|---:|")
    for name in rounds[0][0]:
        pairs = [(now[name], then[name]) for now, then in rounds if name in now and name in then]
        if not pairs:
            continue
        ratio = statistics.median(now / then for now, then in pairs)
        least = [min(pair[side] for pair in pairs) / 1e6 for side in (1, 0)]
        print(f"| {name.removesuffix('/iterations:1')} | {least[0]:.4g} | {least[1]:.4g} "
              f"| {ratio:.3f} |")


def main(arguments):
    if not 1 <= len(arguments) <= 2 or arguments[0].startswith("-"):
        say(__doc__)
        return 0 if arguments in (["-h"], ["--help"]) else 2
    commit, other = sources_of(arguments[0])
    folders = [build(ROOT), build(other)]
    rounds = []
    for i in range(int(arguments[1]) if len(arguments) > 1 else 3):
        order = (0, 1) if i % 2 == 0 else (1, 0)
        found = {}
        for side in order:
            say(f"round {i + 1}, {'now' if side == 0 else commit}")
            found[side] = measure(folders[side])
        rounds.append((found[0], found[1]))
    print_table(commit, rounds)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
