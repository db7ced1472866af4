# SPDX-License-Identifier: MIT
"""The module from Python: what it returns, what it refuses, and that it leaves Python free."""
import gc
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import stigc

SOURCES = pathlib.Path(os.environ["STIG_SOURCE_DIR"])
STAIRCASE = "rulesets/staircase.yaml"
SCENE = """
stigc_scene: 1
duration: 4
robots: [{file: bebot.yaml, name: robot, at: [0, 0], heading: 0}]
"""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    """Files that ship are found by their names from anywhere."""
    monkeypatch.chdir(tmp_path)


def test_explore_has_bricks_and_deposits_as_arrays():
    grown = stigc.explore(stigc.RuleSet.load(STAIRCASE), agents=3, seed=2)
    assert grown.bricks.dtype == np.int32 and grown.bricks.shape == (6, 4)
    assert grown.deposits.dtype == np.int64 and grown.deposits.shape == (5, 7)
    assert grown.report["bricks"] == 6
    assert np.array_equal(np.unique(grown.bricks[:, 3], return_counts=True), [[1, 2, 3], [1, 2, 3]])
    assert np.all(np.diff(grown.deposits[:, 0]) >= 0)
    placed = {tuple(row) for row in grown.deposits[:, 2:6]}
    assert placed < {tuple(row) for row in grown.bricks}


def test_arrays_are_views_that_keep_their_memory():
    grown = stigc.explore(STAIRCASE, seed=2)
    bricks = grown.bricks
    assert not bricks.flags.owndata
    before = bricks.copy()
    del grown
    gc.collect()
    assert np.array_equal(bricks, before)


def test_runs_are_those_of_the_command_line():
    report = stigc.explore(STAIRCASE, agents=4, seed=9, box=(12, 12, 12)).report
    assert report["box"]["size"] == [12, 12, 12]
    again = stigc.explore(STAIRCASE, agents=4, seed=9, box="12,12,12").report
    assert report == again
    assert stigc.explore(STAIRCASE, agents=4, seed=10, box="12,12,12").report != report


def test_rule_sets_are_objects_that_do_not_change():
    coral = stigc.RuleSet.load("rulesets/coral.yaml")
    other = coral.with_value("rules.sprout.probability", 0.9)
    assert "probability: 0.2" in coral.text and "probability: 0.9" in other.text
    hashes = [stigc.explore(r, steps=10).report["ruleset_hash"] for r in (coral, other)]
    assert hashes[0] != hashes[1]
    with pytest.raises(ValueError, match="none"):
        coral.with_value("rules.none.place", 1)


def test_errors_have_the_programs_status_and_codes():
    with pytest.raises(stigc.StigcError) as caught:
        stigc.explore(stigc.RuleSet("stigc: 1\nname: x\n"))
    assert caught.value.status == 1 and "R102" in caught.value.codes
    with pytest.raises(stigc.StigcError) as caught:
        stigc.explore(STAIRCASE, agents=0)
    assert caught.value.status == 2
    with pytest.raises(stigc.StigcError) as caught:
        stigc.verify(STAIRCASE, nonsense=1)
    assert caught.value.status == 2
    with pytest.raises(stigc.StigcError) as caught:
        stigc.RuleSet.load("none.yaml")
    assert caught.value.codes == ["R001"]
    with pytest.raises(stigc.StigcError) as caught:
        stigc.compile("rulesets/plate.yaml")
    assert caught.value.status == 1 and caught.value.codes


def test_proofs_and_what_refutes():
    assert stigc.verify(STAIRCASE, certificate="proof.cert")["verdict"] == "proved"
    assert stigc.certify(STAIRCASE, "proof.cert")
    assert stigc.verify("rulesets/order-dependent.yaml")["verdict"] == "refuted"
    assert stigc.check(STAIRCASE) == []


def test_a_structure_goes_round():
    grown = stigc.explore("rulesets/stepped-pyramid.yaml")
    found = stigc.synth(grown.bricks[:, :3])
    assert found.report["verdict"] == "compiled"
    again = stigc.explore(found.rules, box="none", motion="event")
    shift = again.bricks[:, :3].min(axis=0) - grown.bricks[:, :3].min(axis=0)
    assert np.array_equal(again.bricks[:, :3] - shift, grown.bricks[:, :3])
    stigc.write_structure("pyramid.json", grown.bricks)
    assert np.array_equal(stigc.read_structure("pyramid.json"), grown.bricks)
    with pytest.raises(stigc.StigcError):
        stigc.read_structure("none.json")
    with pytest.raises(ValueError):
        stigc.write_structure("x.json", [1, 2, 3])


def test_robots_compile_validate_and_simulate():
    rules = stigc.RuleSet.load(STAIRCASE)
    assert stigc.compile(rules)["structure"]["bricks"] == 6
    run = stigc.validate(rules, duration=2)["runs"][0]
    assert run["end"] == "out of time"
    pathlib.Path("scene.yaml").write_text(SCENE)
    assert stigc.simulate("scene.yaml", duration=0.5)["time"] == pytest.approx(0.5)


def drive(readings):
    return {"wheels": (0.05, 0.05), "log": "on" if readings["tick"] == 0 else "off"}


def test_a_scene_is_stepped_with_a_controller_in_python():
    pathlib.Path("scene.yaml").write_text(SCENE)
    scene = stigc.Scene("scene.yaml", controllers={"robot": drive})
    assert scene.robots == ["robot"] and scene.duration == 4
    assert scene.step(1) == "" and scene.time == pytest.approx(1)
    way = scene.robot_pose("robot")[0]
    assert 0.02 < way < 0.06
    scene.step(1)
    assert scene.robot_pose("robot")[0] > way
    assert scene.poses().shape[1] == 7 and len(scene.poses()) >= 1
    assert scene.take_lines() and scene.take_lines() == []
    other = stigc.Scene("scene.yaml", controllers={"robot": drive})
    other.step(1), other.step(1)
    assert other.hash == scene.hash


def test_what_a_controller_raises_arrives():
    pathlib.Path("scene.yaml").write_text(SCENE)

    def fail(readings):
        raise KeyError("nothing")

    scene = stigc.Scene("scene.yaml", controllers={"robot": fail})
    with pytest.raises(KeyError):
        scene.step(1)
    wrong = stigc.Scene("scene.yaml", controllers={"robot": lambda readings: {"fly": 1}})
    with pytest.raises(ValueError, match="fly"):
        wrong.step(1)
    with pytest.raises(ValueError, match="nobody"):
        stigc.Scene("scene.yaml", controllers={"nobody": fail})
    pathlib.Path("bad.yaml").write_text("stigc_scene: 1\nnothing: 1\n")
    with pytest.raises(stigc.StigcError) as caught:
        stigc.Scene("bad.yaml")
    assert "R101" in caught.value.codes


def test_other_threads_run_while_a_command_works():
    counted = []

    def count():
        while not done.is_set():
            counted.append(1)
            time.sleep(0.001)

    done = threading.Event()
    thread = threading.Thread(target=count)
    thread.start()
    stigc.explore("rulesets/wall.yaml", agents=1, box=(60, 60, 60), steps=20_000_000)
    done.set()
    thread.join()
    assert len(counted) > 1


def test_two_threads_have_runs_of_their_own():
    expected = [stigc.explore(STAIRCASE, seed=seed).report for seed in range(6)]
    found = [None] * 6

    def work(seed):
        found[seed] = stigc.explore(stigc.RuleSet.load(STAIRCASE), seed=seed).report

    threads = [threading.Thread(target=work, args=(seed,)) for seed in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == expected


def test_an_interrupt_ends_a_command():
    code = (
        "import stigc\nprint('begun', flush=True)\ntry:\n"
        "  stigc.validate('rulesets/staircase.yaml', runs=5000)\n"
        "except KeyboardInterrupt:\n  print('stopped')\n"
        "print(stigc.explore('rulesets/staircase.yaml').report['bricks'])\n"
    )
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "begun\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=60)[0] == "stopped\n6\n"


def test_stubs_name_what_there_is():
    text = pathlib.Path(stigc._stigc.__file__).with_name("_stigc.pyi").read_text()
    names = set(re.findall(r"^(?:def|class) (\w+)", text, re.M))
    assert names == {n for n in dir(stigc._stigc) if not n.startswith("_") and n != "version"}
    for name in stigc.__all__:
        assert getattr(stigc, name).__doc__, name


def test_the_page_runs_from_top_to_bottom():
    page = (SOURCES / "docs" / "python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", page, re.S)
    assert len(blocks) >= 6
    # Two of the figure's runs stand for all: the others differ by their seeds.
    names = {}
    exec(compile_page("\n".join(blocks).replace("runs = 25", "runs = 2")), names)
    stigc.validate(STAIRCASE, runs=2, output="judged")
    table = np.genfromtxt("judged/progress.csv", delimiter=",", names=True)
    assert names["curves"][:, -1].tolist() == [5, 5]
    assert names["mean"][-1] == 5 and len(table) > 0
    assert pathlib.Path("progress.svg").read_text().count("<polyline") == 3


def compile_page(text):
    import builtins

    return builtins.compile(text, "docs/python.md", "exec")
