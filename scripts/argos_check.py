#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs what `stigc compile --target argos` writes in a real ARGoS 3, and says what was built.

ARGoS is no part of this project: the program is a user's own. Nothing of the controllers is changed. For
the sake of measuring, each block's copy of the experiment also has a positioning sensor, and its program
writes into the log where the block is; the structure's own lattice begins at the first block that does
not move. With --beside the same rule set is also built by the same robots in `stigc validate`, as many times,
and a second table sets the two worlds side by side.
"""
import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

SIDE = 0.055            # m
LOOSE = 0.002           # m, off its cell beyond which a brick does not count; as in stigc validate
LOOSE_TURN = 2          # degrees, likewise
QUADRANTS = {"magenta": "Q1", "orange": "Q2", "green": "Q3", "blue": "Q4", "black": "off"}

# Put behind the block's program: what it says is read here alone.
OBSERVER = """
do
   local step_block, init_block, tick, colour = step, init, 0, %r
   function init()
      local set = robot.directional_leds.set_all_colors
      robot.directional_leds.set_all_colors = function(c) colour = c return set(c) end
      init_block()
   end
   function step()
      step_block()
      tick = tick + 1
      if tick %% 25 ~= 0 then return end
      local at, turn = robot.positioning.position, robot.positioning.orientation
      local x, z = vector3(1, 0, 0):rotate(turn), vector3(0, 0, 1):rotate(turn)
      log(string.format('block %%s %%d %%.5f %%.5f %%.5f %%.3f %%.3f %%s', robot.id, tick, at.x, at.y, at.z,
                        math.deg(math.atan(x.y, x.x)), math.deg(math.acos(math.min(1, z.z))), colour))
   end
end
"""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rules", help="a rule set")
    parser.add_argument("--argos", default="argos3", help="the program of ARGoS 3 (argos3)")
    parser.add_argument("--stigc", default="stigc", help="the program of this project (stigc)")
    parser.add_argument("--robots", type=int, help="as stigc compile has it")
    parser.add_argument("--runs", type=int, default=20, help="starts (20)")
    parser.add_argument("--seed", type=int, default=1, help="of the first run's start and noise (1)")
    parser.add_argument("--shift", type=float, default=10, help="robots begin up to so many mm off (10)")
    parser.add_argument("--turn", type=float, default=5, help="and up to so many degrees (5)")
    parser.add_argument("--length", type=float, help="seconds of each run, other than the experiment has")
    parser.add_argument("--beside", metavar="ROBOT",
                        help="also build with this robot in stigc validate, and compare: robots/builderbot.yaml")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="runs at a time (as many as cores)")
    parser.add_argument("--keep", help="a folder for the experiments and their logs")
    return parser.parse_args()


def run(command, **more):
    return subprocess.run(command, check=True, capture_output=True, text=True, **more)


def compile_rules(options, folder):
    """The experiment's path, and the structure wanted as {cell: quadrant}, with the cells of the start."""
    name = folder / "work"
    command = [options.stigc, "compile", options.rules, "--target", "argos", "-o", str(name), "--quiet"]
    if options.robots:
        command += ["--robots", str(options.robots)]
    run(command)
    wanted = []
    for file, more in ((folder / "wanted.json", []), (folder / "start.json", ["--deposits", "0"])):
        run([options.stigc, "explore", options.rules, "--motion", "event", "--quiet", "-o", str(file)] + more)
        structure = json.loads(file.read_text())
        # Bricks that robots place are named after their LEDs.
        names = {int(brick["symbol"]): brick["name"] for brick in structure["bricks"]}
        wanted.append({tuple(cell[:3]): names[cell[3]] for cell in structure["cells"]})
    return name.with_suffix(".argos"), wanted[0], wanted[1]


def place(element):
    return [float(x) for x in element.find("body").get("position").split(",")]


def prepare(experiment, folder, seed, options):
    """A folder with the experiment of one run."""
    folder.mkdir(parents=True, exist_ok=True)
    tree = ElementTree.parse(experiment)
    root, draw = tree.getroot(), random.Random(seed)
    root.find("framework/experiment").set("random_seed", str(seed))
    if options.length:
        root.find("framework/experiment").set("length", str(options.length))
    arena, controllers = root.find("arena"), root.find("controllers")
    for robot in arena.findall("builderbot"):
        body, (x, y, z) = robot.find("body"), place(robot)
        off = [draw.uniform(-options.shift, options.shift) / 1000 for _ in range(2)]
        heading = float(body.get("orientation").split(",")[0]) + draw.uniform(-options.turn, options.turn)
        body.set("position", f"{x + off[0]},{y + off[1]},{z}")
        body.set("orientation", f"{heading},0,0")
    block = controllers.find("lua_controller[@id='block']")
    ElementTree.SubElement(block.find("sensors"), "positioning", implementation="default")
    script = experiment.parent / block.find("params").get("script")
    # A program for each colour that blocks begin with.
    for colour in {one.get("init_led_color") for one in arena.findall("block")}:
        (folder / f"block_{colour}.lua").write_text(script.read_text() + OBSERVER % colour)
        own = ElementTree.fromstring(ElementTree.tostring(block))
        own.set("id", f"block_{colour}")
        own.find("params").set("script", f"block_{colour}.lua")
        controllers.append(own)
    controllers.remove(block)
    for one in arena.findall("block"):
        one.find("controller").set("config", "block_" + one.get("init_led_color"))
    for params in controllers.iter("params"):
        own = params.get("script")
        if not own.startswith("block_"):
            (folder / own).write_text((experiment.parent / own).read_text())
    tree.write(folder / "run.argos")
    return root


def lattice(root, start):
    """Where cell 0 0 0 is: what brings the blocks that do not move onto the cells of the start."""
    fixed = [place(one) for one in root.find("arena").findall("block") if one.get("movable") == "false"]
    first = fixed[0]
    for cell in start:
        origin = [first[i] - SIDE * cell[i] for i in range(3)]
        cells = {tuple(round((at[i] - origin[i]) / SIDE) for i in range(3)) for at in fixed}
        if cells == set(start):
            return origin
    sys.exit("the experiment's start is not that of the rules")


def samples(log):
    """The blocks at each time that was logged: {s: [(x, y, z, turn, tilt, quadrant)]}."""
    out = {}
    for line in re.sub("\x1b[^m]*m", "", log).splitlines():
        words = line.split()
        if len(words) >= 9 and "block" in words:
            words = words[words.index("block") + 1:]
            at = [float(word) for word in words[2:7]]
            out.setdefault(int(words[1]) / 5, []).append((*at, QUADRANTS.get(words[7], words[7])))
    return out


def judge(blocks, origin, wanted):
    """The distance from its cell in mm of each brick that is as wanted, by cell, and how many other blocks are
    less than one and a half of their width from a cell of the structure."""
    right, wrong = {}, 0
    for x, y, z, turn, tilt, quadrant in blocks:
        off = [(p - o) / SIDE for p, o in zip((x, y, z), origin)]
        cell = tuple(round(c) for c in off)
        away = SIDE * math.dist(off, cell)
        askew = max(abs((turn + 45) % 90 - 45), tilt)
        if wanted.get(cell) == quadrant and away <= LOOSE and askew <= LOOSE_TURN:
            right[cell] = away * 1000
        elif any(math.dist(off, other) < 1.5 for other in wanted):
            wrong += 1
    return right, wrong


def placements(times, origin, wanted, start):
    """When the structure's bricks came, but for those of the start: for each that is as wanted at the end,
    the time in s since when it is so."""
    since = {}
    for time in sorted(times):
        right = judge(times[time], origin, wanted)[0]
        since = {cell: since.get(cell, time) for cell in right}
    return sorted(time for cell, time in since.items() if cell not in start)


def one_run(seed, experiment, wanted, start, options, folder):
    own = folder / f"seed-{seed}"
    root = prepare(experiment, own, seed, options)
    origin = lattice(root, start)
    done = subprocess.run([options.argos, "-z", "-c", "run.argos"], cwd=own, capture_output=True, text=True)
    (own / "log").write_text(done.stdout + done.stderr)
    times = samples(done.stdout + done.stderr)
    if done.returncode != 0 or not times:
        return {"seed": seed, "problem": f"argos3 ended with {done.returncode}, see {own / 'log'}"}
    return {"seed": seed, **run_of(times, origin, wanted, start)}


def run_of(times, origin, wanted, start):
    """What came of a run: until it was complete for the first time, where `stigc validate` ends, and whether
    it is so at its end."""
    end = max(times)
    complete = [time for time in times if len(judge(times[time], origin, wanted)[0]) == len(wanted)]
    until = min(complete, default=end)
    right = judge(times[until], origin, wanted)[0]
    last, wrong = judge(times[end], origin, wanted)
    seen = {time: blocks for time, blocks in times.items() if time <= until}
    return {"complete": bool(complete), "placed": placements(seen, origin, wanted, start),
            "off": [away for cell, away in right.items() if cell not in start],
            "bricks": len(last), "wrong": wrong, "stands": len(last) == len(wanted) and wrong == 0}


def validated(options):
    """The runs of `stigc validate` that are compared, in the form of one_run's."""
    command = [options.stigc, "validate", options.rules, "--robot", options.beside, "--runs", str(options.runs),
               "--seed", str(options.seed), "--json", "--quiet"]
    if options.robots:
        command += ["--robots", str(options.robots)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1):  # 1: some run was not complete, which the table says
        sys.exit(f"argos_check: {done.stderr}")
    rows = []
    for trial in json.loads(done.stdout)["runs"]:
        placed = {}
        for event in trial["events"]:
            placed.pop(tuple(event["cell"]), None)
            if event["what"] == "placed":
                placed[tuple(event["cell"])] = event["time"]
        own = [brick for brick in trial["bricks"] if brick["there"] and not brick["start"]]
        good = [brick for brick in own if brick["shows"] == brick["brick"] and abs(brick["yaw_degrees"]) <= LOOSE_TURN
                and math.hypot(*brick["off_mm"]) <= LOOSE * 1000]
        rows.append({"complete": trial["verdict"] == "complete", "stands": trial["verdict"] == "complete",
                     "placed": sorted(placed.get(tuple(brick["cell"]), trial["time"]) for brick in good),
                     "off": [math.hypot(*brick["off_mm"]) for brick in good],
                     "wrong": len(own) - len(good) + len(trial["extra"])})
    return rows


def middle(values, form):
    return form.format(statistics.median(values)) if values else ""


def side_by_side(worlds, bricks):
    """Prints what was built in each world: {name: rows}, and when its bricks came."""
    def row(name, of):
        print(f"| {name} | " + " | ".join(of(rows) for rows in worlds.values()) + " |")

    print("\n| | " + " | ".join(worlds) + " |\n|---|" + "---:|" * len(worlds))
    row("complete", lambda rows: f"{sum(one['complete'] for one in rows)} of {len(rows)}")
    row("and so at the end of the run", lambda rows: str(sum(one["stands"] for one in rows)))
    row("bricks placed", lambda rows: f"{sum(len(one['off']) for one in rows)} of {bricks * len(rows)}")
    row("other bricks at the structure in the end", lambda rows: str(sum(one["wrong"] for one in rows)))
    row("off their cells, median, mm", lambda rows: middle([mm for one in rows for mm in one["off"]], "{:.2f}"))
    row("the worst, mm", lambda rows: f"{max((mm for one in rows for mm in one['off']), default=0):.2f}")
    for k in range(bricks):
        row(f"brick {k + 1} after, median, s",
            lambda rows: middle([one["placed"][k] for one in rows if len(one["placed"]) > k], "{:.0f}"))


def main():
    options = arguments()
    options.argos = str(pathlib.Path(options.argos).resolve()) if "/" in options.argos else options.argos
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(options.keep or temporary).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        try:
            experiment, wanted, start = compile_rules(options, folder)
        except (subprocess.CalledProcessError, FileNotFoundError) as problem:
            sys.exit(f"argos_check: {getattr(problem, 'stderr', None) or problem}")
        print("| seed | bricks | after/s | mm | wrong | |\n|---:|---:|---:|---:|---:|---|", flush=True)
        rows = []
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            work = [pool.submit(one_run, options.seed + i, experiment, wanted, start, options, folder)
                    for i in range(options.runs)]
            for one in work:
                row = one.result()
                if "problem" in row:
                    print(f"| {row['seed']} | | | | | {row['problem']} |", flush=True)
                    continue
                rows.append(row)
                last = row["placed"][-1] if row["complete"] else ""
                verdict = "complete" if row["stands"] else "lost again" if row["complete"] else "incomplete"
                print(f"| {row['seed']} | {row['bricks']} of {len(wanted)} | {last} | "
                      f"{max(row['off'], default=0):.2f} | {row['wrong']} | "
                      f"{verdict} |", flush=True)
        after = [row["placed"][-1] for row in rows if row["stands"]]
        mean = f"; the last brick after {sum(after) / len(after):.0f} s on average" if after else ""
        print(f"\ncomplete in {len(after)} of {options.runs}{mean}", flush=True)
        if options.beside:
            side_by_side({"ARGoS 3": rows, "stigc validate": validated(options)}, len(wanted) - len(start))
    return 0 if len(after) == options.runs else 1


if __name__ == "__main__":
    sys.exit(main())
