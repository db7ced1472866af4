#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What looking at a run costs it.

    scripts/live_cost.py STIGC [SCENE]

Runs a scene as fast as it goes, by turns without a client and with one that reads all events, and
prints the time that the run's thread has worked, the least of three, and their ratio. Time of the
processor, so that a machine with other work to do gives about the same.
"""

import json
import os
import signal
import subprocess
import sys
import threading
import time
import urllib.request

TURNS = 3


def ask(address, token, **command):
    request = urllib.request.Request(f"{address}command", json.dumps(command).encode(),
                                     {"X-Stig-Token": token, "Content-Type": "application/json"})
    return json.load(urllib.request.urlopen(request, timeout=60))


def worked(process):
    """Seconds that the first thread, which the run has, has worked."""
    with open(f"/proc/{process.pid}/task/{process.pid}/schedstat", encoding="ascii") as file:
        return int(file.read().split()[0]) * 1e-9


def read_events(address, token, seen):
    try:
        for line in urllib.request.urlopen(f"{address}events?token={token}", timeout=60):
            seen[0] += len(line)
    except OSError:
        pass  # the run has ended


def turn(stigc, scene, clients):
    process = subprocess.Popen([stigc, "view", "--live", scene, "--paused"], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    address, token = process.stdout.readline().strip().split("?token=")
    seen = [0]
    for _ in range(clients):
        threading.Thread(target=read_events, args=(address, token, seen), daemon=True).start()
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
    return used, seen[0]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    scene = sys.argv[2] if len(sys.argv) > 2 else "scenes/crowd.yaml"
    least = [float("inf")] * 2
    for _ in range(TURNS):
        for clients in (0, 1):
            used, seen = turn(sys.argv[1], scene, clients)
            least[clients] = min(least[clients], used)
            print(f"{clients} clients: {used:.2f} s, {seen} bytes of events", flush=True)
    print(f"with a client {least[1] / least[0]:.3f} times as long as without")


if __name__ == "__main__":
    main()
