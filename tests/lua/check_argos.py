# SPDX-License-Identifier: MIT
"""Compiles rule sets for ARGoS and runs what comes out, experiment and programs, against a mock of
its interface that takes no wrong name, argument or unit.

    check_argos.py STIGC SOURCE_DIR
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree


def run(*command, **options):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, **options)


def good(*command, **options):
    done = run(*command, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def lua(value):
    """A value as a Lua table's constructor."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"[{lua(k)}] = {lua(v)}" for k, v in value.items()) + " }"
    if isinstance(value, list):
        return "{ " + ", ".join(map(lua, value)) + " }"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return "'" + value.replace("\\", "\\\\").replace("'", "\\'") + "'"
    return repr(value)


def devices_of(controller):
    """As 'actuator lift_system'; each has to name its implementation."""
    out = []
    for kind in ("actuators", "sensors"):
        for device in controller.find(kind):
            assert device.get("implementation") == "default", device.tag
            out.append(f"{kind[:-1]} {device.tag.removeprefix('builderbot_')}")
    return out


def place_of(entity):
    body = entity.find("body")
    x, y, z = map(float, body.get("position").split(","))
    turn, *others = map(float, body.get("orientation").split(","))
    assert others == [0, 0]
    return {"id": entity.get("id"), "x": x, "y": y, "z": z, "turn": turn,
            "controller": entity.find("controller").get("config")}


def read_experiment(path):
    """What the mock's world needs of an .argos file; what has to be there is held to."""
    root = ElementTree.parse(path).getroot()
    assert root.tag == "argos-configuration"
    assert root.find("framework/experiment").get("ticks_per_second") == "5"
    engine = root.find("physics_engines/dynamics3d")
    assert engine.get("iterations") == "100"  # with fewer, wheels slip in turns
    assert {plugin.tag for plugin in engine} == {"floor", "gravity", "srocs"}
    # else what stands near strips the block in hand
    assert engine.find("srocs").get("disable_block_magnets_during_manipulation") == "true"
    media = {(medium.tag, medium.get("id")) for medium in root.find("media")}
    assert media == {("directional_led", "directional_leds"), ("tag", "tags"),
                     ("simple_radio", "nfc"), ("simple_radio", "wifi")}, media
    controllers = {}
    for one in root.find("controllers"):
        params = dict(one.find("params").attrib)
        script = path.parent / params.pop("script")
        assert script.exists(), script
        controllers[one.get("id")] = {"script": str(script), "params": params,
                                      "devices": devices_of(one)}
    arena = root.find("arena")
    half = float(arena.get("size").split(",")[0]) / 2
    blocks = [place_of(e) | {"fixed": e.get("movable") == "false", "colour": e.get("init_led_color")}
              for e in arena.findall("block")]
    robots = [place_of(e) for e in arena.findall("builderbot")]
    for one in blocks + robots:
        assert one["controller"] in controllers
        assert max(abs(one["x"]), abs(one["y"])) < half
    for robot in robots:
        int(robot["id"])  # cameras read the tag on its top as a number
    assert len({one["id"] for one in blocks + robots}) == len(blocks) + len(robots)
    return {"controllers": controllers, "blocks": blocks, "robots": robots}


class Bench:
    """Compiles, runs, and reads what came of it."""

    def __init__(self, stigc, root, folder):
        self.stigc, self.root, self.folder = stigc, root, folder

    def compile(self, rules, name="out"):
        output = self.folder / f"{name}.argos"
        good(self.stigc, "compile", rules, "--target", "argos", "-o", output)
        block = self.folder / f"{name}_block.lua"
        assert block.read_text() == (self.root / "programs/argos_block.lua").read_text()
        return output

    def run(self, experiment, ticks, bricks=10**6):
        file = self.folder / "experiment.lua"
        file.write_text("return " + lua(experiment) + "\n")
        tests = self.root / "tests/lua"
        return run("lua5.4", tests / "run_argos.lua", file, ticks, bricks,
                   env=os.environ | {"LUA_PATH": f"{tests}/?.lua"})

    def last_bricks(self, rules):
        """{(x, y, level): led} of the finished structure."""
        file = self.folder / "whole.json"
        good(self.stigc, "explore", "-q", rules, "-o", file)
        whole = json.loads(file.read_text())
        leds = [brick["name"] for brick in whole["bricks"]]
        return {(x, y, z): leds[colour - 1] for x, y, z, colour in whole["cells"]}


LEDS = {"magenta": "Q1", "orange": "Q2", "green": "Q3", "blue": "Q4"}
# Of a face, right, up, left and down of its tag: code words, worked out by hand.
LEDS |= {"/".join(list(LEDS)[int(i) - 1] for i in word): f"Q{kind}"
         for kind, word in [(5, "1234"), (6, "2143"), (7, "3412"), (8, "4321")]}


def built(output, on_its_way):
    """{(x, y, level): led} of lit blocks that stand, against the first start block; calls."""
    bricks, calls, first = {}, {}, None
    for line in output.splitlines():
        word, *rest = line.split()
        if word == "call":
            calls[rest[0]] = int(rest[1])
        if word != "block" or rest[1] in ("black", on_its_way):
            continue
        place = [float(x) for x in rest[2:5]]
        first = first or place
        cell = [(a - b) / 0.055 for a, b in zip(place, first)]
        assert all(abs(c - round(c)) < 0.1 for c in cell), line
        bricks[tuple(round(c) for c in cell)] = LEDS[rest[1]]
    return bricks, calls


# What a controller that builds has to have called.
NEEDED = {"robot.camera_system.enable", "robot.camera_system.detect_led",
          "robot.differential_drive.set_target_velocity", "robot.lift_system.set_position",
          "robot.electromagnet_system.set_discharge_mode", "robot.simple_radios.nfc.send",
          "robot.random.uniform", "robot.directional_leds.set_all_colors"}


def check_builds(bench, rules, ticks, on_its_way="blue"):
    """It searches, picks up, places: every brick in its place and colour, within so many ticks."""
    whole = bench.last_bricks(rules)
    done = bench.run(read_experiment(bench.compile(rules)), ticks, len(whole))
    assert done.returncode == 0, done.stderr
    there, calls = built(done.stdout, on_its_way)
    assert there == whole, done.stdout
    assert NEEDED <= calls.keys(), NEEDED - calls.keys()


def check_code_words(bench):
    """A line of six, its bricks of six kinds: from Q5 on blocks show code words, and as Q16 those
    on their way."""
    drawing, rules = bench.folder / "line.txt", bench.folder / "line.yaml"
    drawing.write_text("# # # # # #\n")
    good(bench.stigc, "synth", drawing, "--robot", bench.root / "robots/builderbot.yaml", "--kinds",
         "6", "--start", "0,0,0", "--sides=+x", "-o", rules)
    rules.write_text(re.sub(r"{(color: [^,]*, led: (Q\d))}", r"{name: \2, \1}", rules.read_text()))
    check_builds(bench, rules, 6000, on_its_way="blue/magenta/green/orange")


def check_sides(bench, rules):
    """Several robots: each is told its side, each starts to work."""
    several = bench.folder / "several.yaml"
    text, count = re.subn(r"(?m)^lattice: cubic$", "lattice: cubic\nphysical: {robots: 6}",
                          rules.read_text())
    assert count == 1
    several.write_text(text)
    experiment = read_experiment(bench.compile(several))
    assert len(experiment["robots"]) == 6
    sides = [experiment["controllers"][r["controller"]]["params"]["side"]
             for r in experiment["robots"]]
    assert sides == ["+x", "+y", "-x", "-y", "+x", "+y"], sides
    done = bench.run(experiment, 300)
    assert done.returncode == 0, done.stderr


def check_adapter(bench, experiment):
    probe = bench.folder / "probe.lua"
    probe.write_text("local argos = (function()\n" +
                     (bench.root / "programs/argos.lua").read_text() + "end)()\n" +
                     (bench.root / "tests/lua/adapter_probe.lua").read_text())

    def block(name, x, y, turn=0, colour="black"):
        return {"id": name, "x": x, "y": y, "z": 0, "turn": turn, "controller": "block",
                "fixed": False, "colour": colour}
    controllers = dict(experiment["controllers"])
    builder = controllers[experiment["robots"][0]["controller"]]
    controllers["probe"] = builder | {"script": str(probe), "params": {"side": "-y"}}
    done = bench.run({"controllers": controllers,
                      "robots": [{"id": "1", "x": 0, "y": 0, "turn": 0, "controller": "probe"}],
                      "blocks": [block("ahead", 0.0915, 0), block("left", -0.0025, 0.1215),
                                 block("behind", -0.1515, 0),
                                 block("seen", 0.22, 0.02, 20, "orange")]}, 8)
    assert done.returncode == 0 and "probed" in done.stdout, done.stderr


# What stands in a program, what stands there instead, and what is said of it.
WRONG = [
    ("robot", "set_target_velocity(sent[1], sent[2])",
     "set_target_velocity(100 * sent[1], 100 * sent[2])", "is not within -0.33 and 0.33"),
    ("robot", "set_target_velocity(sent[1], sent[2])", "set_target_velocity(sent[1])",
     "set_target_velocity expects 2 arguments, got 1"),
    ("robot", "set_target_velocity(sent[1], sent[2])", "set_target_velocity(sent[1], '0')",
     "argument 2 is a string"),
    ("robot", "set_target_velocity(sent[1], sent[2])", "set_target_velocity(sent[1], 0/0)",
     "a finite number expected"),
    ("robot", "robot.lift_system.set_position(sent)", "robot.lift_system.set_position(1000 * sent)",
     "lift: "),
    ("robot", "magnets:discharge('constructive')", "magnets:discharge('on')",
     "no mode of discharge: on"),
    ("robot", "nfc.send(sent)", "nfc.send(sent[1])",
     "argument 1 is a number"),
    ("robot", "nfc.send(sent)", "nfc.send { 300 }", "no byte of a message"),
    ("robot", "robot.camera_system.enable()", "robot.camera_system:enable()",
     "enable expects 0 arguments, got 1"),
    ("robot", "host.electromagnet_system, host.simple_radios", "host.electromagnet_system, host.radios",
     "robot has no radios"),
    ("robot", "host = _G.robot", "host = _G.robot _G.robot = robot", "is not ARGoS's any more"),
    ("robot", "local math = argos.math", "",
     "not from the experiment's seed"),
    ("robot", "(place - eye):length()", "((place - eye) / 1):length()", "arithmetic"),
    ("robot", "function destroy() end", "", "ARGoS calls destroy"),
    ("block", "or 'black'", "or 'off'", "knows no off"),
    ("block", "COLOURS[message[1]] or 'black'", "4", "argument 1 is a number"),
]


def check_mock_sees(bench, output):
    """Each slip is an error of its own: what passes above passes for a reason."""
    for program, text, instead, said in WRONG:
        experiment = read_experiment(output)
        path = output.with_name(f"{output.stem}_{program}.lua")
        right = path.read_text()
        assert text in right, text
        slip = output.with_name("slip.lua")
        slip.write_text(right.replace(text, instead))
        for controller in experiment["controllers"].values():
            if controller["script"] == str(path):
                controller["script"] = str(slip)
        # a block that is told something it does not know, at once
        if "'off'" in instead:
            slip.write_text(slip.read_text().replace("function step()", "function step()\n" +
                            "   robot.directional_leds.set_all_colors(COLOURS[9] or 'off')"))
        done = bench.run(experiment, 1200, 3)
        assert done.returncode != 0 and said in done.stderr, (instead, done.stderr)
    experiment = read_experiment(output)
    for controller in experiment["controllers"].values():
        controller["devices"] = [d for d in controller["devices"] if d != "sensor system"]
    done = bench.run(experiment, 10)
    assert done.returncode != 0 and "robot has no system" in done.stderr, done.stderr


def check_turns_slip(bench, output, ticks):
    """Without the adapter's ramp the mock's wheels slip as ARGoS's do, and the time does not suffice."""
    path = output.with_name(f"{output.stem}_robot.lua")
    right = path.read_text()
    assert "local RAMP = 0.04 " in right
    path.write_text(right.replace("local RAMP = 0.04 ", "local RAMP = 10 "))
    done = bench.run(read_experiment(output), ticks, 6)
    path.write_text(right)
    assert done.returncode == 0 and f"ticks {ticks}\n" in done.stdout, done.stdout


def check_others_readers(root, folder):
    scripts = sorted(folder.glob("*.lua"))
    for path in scripts:
        good("luac5.4", "-p", path)
    good("luacheck", "--config", root / ".luacheckrc", *scripts)
    good("luacheck", "--config", root / ".luacheckrc", "--std", "lua53", *scripts)  # ARGoS's
    if shutil.which("xmllint"):
        good("xmllint", "--noout", *folder.glob("*.argos"))


def main():
    stigc, root = sys.argv[1], pathlib.Path(sys.argv[2])
    if not all(map(shutil.which, ("lua5.4", "luac5.4", "luacheck"))):
        print("lua5.4 or luacheck is not installed")
        sys.exit(77)
    staircase, pyramid = root / "rulesets/staircase.yaml", root / "rulesets/stepped-pyramid.yaml"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bench = Bench(stigc, root, folder)
        good(stigc, "compile", staircase, "-o", folder / 'a & "b" <c>.argos')
        good(stigc, "compile", pyramid, "-o", folder / "pyramid.argos")
        read_experiment(folder / 'a & "b" <c>.argos')
        check_others_readers(root, folder)
        check_builds(bench, staircase, 4000)
        check_builds(bench, pyramid, 16000)
        check_sides(bench, pyramid)
        check_code_words(bench)
        output = bench.compile(staircase)
        check_adapter(bench, read_experiment(output))
        check_mock_sees(bench, output)
        check_turns_slip(bench, output, 4000)
    print(f"two structures, {len(WRONG) + 1} slips")


main()
