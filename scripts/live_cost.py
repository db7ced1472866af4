#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What recording a run and looking at it cost it.

    scripts/live_cost.py STIGC [SCENE [TURNS]]

Runs a scene by turns with `stigc simulate` alone, with `--trace`, with `--trace-detail`, and with
`stigc view --live` as fast as it goes, once without anybody who looks and once with one that reads all
events. Prints the time that the run's thread has worked, without reading the scene, and the median
of the ratios of each turn to the run alone. Time of the processor, so that a machine with other
work to do gives about the same. Then, by the clock, how long after a file is saved the run has begun
again, as one that looks is told.
"""

import json
import os
import queue
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

TURNS = 7
SAVES = 9


def ask(address, token, **command):
    request = urllib.request.Request(f"{address}command", json.dumps(command).encode(),
                                     {"X-Stig-Token": token, "Content-Type": "application/json"})
    return json.load(urllib.request.urlopen(request, timeout=60))


def worked(process):
    """Seconds that the first thread, which the run has, has worked."""
    with open(f"/proc/{process.pid}/task/{process.pid}/schedstat", encoding="ascii") as file:
        return int(file.read().split()[0]) * 1e-9


def read_events(address, token):
    try:
        for _ in urllib.request.urlopen(f"{address}events?token={token}", timeout=60):
            pass
    except OSError:
        pass  # the run has ended


def simulated(stigc, scene, *more):
    """Seconds that the first thread of a run without a page has worked."""
    process = subprocess.Popen([stigc, "simulate", scene, "--quiet", *more],
                               stdout=subprocess.DEVNULL)
    os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
    used = worked(process)
    process.wait()
    return used


def live(stigc, scene, clients):
    process = subprocess.Popen([stigc, "view", "--live", scene, "--paused"], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    address, token = process.stdout.readline().strip().split("?token=")
    for _ in range(clients):
        threading.Thread(target=read_events, args=(address, token), daemon=True).start()
    time.sleep(0.5)
    ask(address, token, do="speed", times=None)
    before = worked(process)
    ask(address, token, do="run")
    # A run that has ended works no more.
    last = -1.0
    while worked(process) - last > 0.02:
        last = worked(process)
        time.sleep(1)
    process.send_signal(signal.SIGINT)
    used = last - before
    process.wait()
    return used


def turn(stigc, scene, trace):
    reading = simulated(stigc, scene, "--duration", "0.01")
    out = {"alone": simulated(stigc, scene) - reading,
           "--trace": simulated(stigc, scene, "--trace", trace) - reading,
           "--trace-detail": simulated(stigc, scene, "--trace", trace, "--trace-detail") - reading,
           "live": live(stigc, scene, 0), "live, one looks": live(stigc, scene, 1)}
    print(", ".join(f"{name} {used:.2f} s" for name, used in out.items()), flush=True)
    return out


def told_runs(address, token, runs):
    """Puts the number of each run that begins into a queue."""
    known = 0
    try:
        for line in urllib.request.urlopen(f"{address}events?token={token}", timeout=600):
            text = line.decode()
            if text.startswith("data: {") and '"run":' in text:
                run = json.loads(text[6:])["run"]
                if run > known:
                    known = run
                    runs.put(run)
    except OSError:
        pass  # the program has ended


def begun_again(stigc, file, saves):
    """Seconds from saving the file until a run has begun with it, of each of the saves."""
    process = subprocess.Popen([stigc, "view", "--live", file], text=True, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL)
    address, token = process.stdout.readline().strip().split("?token=")
    runs = queue.Queue()
    threading.Thread(target=told_runs, args=(address, token, runs), daemon=True).start()
    runs.get(timeout=60)
    taken = []
    for save in range(saves):
        time.sleep(1.5 + 0.13 * save)  # at other moments of the program's looks at the file
        with open(file, "a", encoding="utf-8") as out:
            out.write(f"# saved {save}\n")
        saved = time.monotonic()
        runs.get(timeout=60)
        taken.append(time.monotonic() - saved)
    process.send_signal(signal.SIGINT)
    process.wait()
    return taken


def restarts(stigc, scene, folder):
    # Beside the scene, since it names other files.
    copied = os.path.join(os.path.dirname(scene), f"saved-{os.getpid()}.yaml")
    rules = shutil.copy("rulesets/staircase.yaml", folder)
    print("\n| saved | s until the run has begun again, median (least to most) |\n|---|---|")
    try:
        shutil.copy(scene, copied)
        for name, file in (("the scene", copied), ("a rule set", rules)):
            taken = sorted(begun_again(stigc, file, SAVES))
            print(f"| {name} | {statistics.median(taken):.2f} ({taken[0]:.2f} to {taken[-1]:.2f}) |")
    finally:
        os.remove(copied)


def main():
    if len(sys.argv) not in (2, 3, 4):
        sys.exit(__doc__)
    scene = sys.argv[2] if len(sys.argv) > 2 else "scenes/crowd.yaml"
    turns = int(sys.argv[3]) if len(sys.argv) > 3 else TURNS
    with tempfile.TemporaryDirectory() as folder:
        times = [turn(sys.argv[1], scene, f"{folder}/t.stigp") for _ in range(turns)]
    print(f"\n| | times the run alone, median of {turns} (least to most) |\n|---|---|")
    for name in list(times[0])[1:]:
        ratios = sorted(one[name] / one["alone"] for one in times)
        print(f"| {name} | {statistics.median(ratios):.3f} ({ratios[0]:.3f} to {ratios[-1]:.3f}) |")
    with tempfile.TemporaryDirectory() as folder:
        restarts(sys.argv[1], scene, folder)


if __name__ == "__main__":
    main()
