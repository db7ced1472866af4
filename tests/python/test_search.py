# SPDX-License-Identifier: MIT
"""Searches that Python scores, genomes as arrays, and traces as arrays."""
import numpy as np
import pytest
import stigc

PLAN = """
stigc_search: 1
name: told
method: genetic
score: [{objective: modules}]
rules: 8
colours: 2
box: 10
deposits: 60
batch: 32
"""


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def tall(candidate):
    return candidate.measures["height"] + len(candidate.bricks) / 1000


def told(search, batches):
    for _ in range(batches):
        search.tell([tall(one) for one in search.ask()])
    return search


def test_what_is_told_decides_what_is_made():
    one, two = (told(stigc.Search(PLAN, threads=n), 6) for n in (1, 2))
    assert one.evaluated == 6 * 32 and one.content_hash == two.content_hash
    best = one.best(5)
    assert [c.score for c in best] == sorted((tall(c) for c in best), reverse=True)
    own = stigc.Search(PLAN)
    for _ in range(6):
        own.tell([c.score for c in own.ask()])
    assert own.content_hash != one.content_hash
    assert own.best(1)[0].score == own.best(1)[0].measures["modules"]


def test_candidates_have_rules_bricks_and_measures():
    candidate = stigc.Search(PLAN).ask(3)[1]
    assert candidate.id == 1 and candidate.origin == "drawn" and candidate.parents == []
    assert candidate.bricks.dtype == np.int32 and candidate.bricks.shape[1] == 4
    assert candidate.measures["bricks"] == len(candidate.bricks)
    grown = stigc.explore(candidate.rules, motion="event", box=(10, 10, 10), deposits=60)
    assert len(grown.bricks) <= 61


def test_a_search_goes_on_from_its_file():
    whole = told(stigc.Search(PLAN), 4)
    told(stigc.Search(PLAN, "found.sqlite"), 2)
    again = stigc.Search(PLAN, "found.sqlite")
    assert again.evaluated == 64
    told(again, 2)
    assert again.content_hash == whole.content_hash and again.evaluated == whole.evaluated
    ours, theirs = again.best(4), whole.best(4)
    assert all(np.array_equal(a.bricks, b.bricks) for a, b in zip(ours, theirs))
    assert all(len(a.bricks) == a.measures["bricks"] for a in ours)


def test_genomes_are_arrays():
    search = stigc.Search(PLAN)
    genome = search.draw(4)
    rows = genome.encode()
    assert rows.dtype == np.int32 and rows.shape == (8, 3 + 26)
    assert genome.with_rules(rows) == genome and stigc.Genome(genome.text) == genome
    assert hash(genome.with_rules(rows)) == hash(genome)
    fewer = genome.with_rules(rows[:3])
    assert fewer.encode().shape == (3, 29) and fewer != genome
    assert "rules:" in genome.rules.text
    for wrong in (rows[:, 1:], rows[:0], np.zeros_like(rows), rows.ravel(), rows * 1000):
        with pytest.raises(ValueError):
            genome.with_rules(wrong)
    with pytest.raises(ValueError):
        stigc.Genome("no genome")


def test_operators_serve_other_optimisers():
    search = stigc.Search(PLAN)
    genomes = [search.draw(seed) for seed in range(8)]
    assert len(set(genomes)) == 8 and search.draw(3) == genomes[3]
    assert search.mutate(genomes[0], 1) == search.mutate(genomes[0], 1) != genomes[0]
    child = search.cross(genomes[0], genomes[1], 2)
    assert len(child.encode()) == 8
    found = search.measure(genomes)
    alone = search.measure(genomes[5:6])[0]
    assert alone.measures == found[5].measures
    assert np.array_equal(alone.bricks, found[5].bricks)
    assert search.evaluated == 0
    other = stigc.Search(PLAN.replace("colours: 2", "colours: 3"))
    with pytest.raises(ValueError):
        search.mutate(other.draw(1), 1)


def test_what_is_told_has_to_be_scores():
    search = stigc.Search(PLAN)
    with pytest.raises(ValueError):
        search.tell([1.0])
    search.ask(2)
    for wrong in ([1.0], [1.0, float("nan")], [1.0, float("inf")]):
        with pytest.raises(ValueError):
            search.tell(wrong)
    search.tell(np.array([1, 2]))
    assert search.evaluated == 2
    with pytest.raises(ValueError):
        search.ask(0)
    with pytest.raises(stigc.StigcError) as caught:
        stigc.Search("stigc_search: 1\nname: a\n")
    assert "R102" in caught.value.codes
    with pytest.raises(stigc.StigcError):
        stigc.Search("none.yaml")


def test_deposits_of_a_trace_are_those_of_the_run():
    grown = stigc.explore("rulesets/staircase.yaml", seed=3)
    words = ["explore", "rulesets/staircase.yaml", "--seed=3", "-o", "run.stigt", "--quiet"]
    assert stigc._stigc.run(words)[0] == 0
    trace = stigc.read_trace("run.stigt")
    assert np.array_equal(trace.deposits, grown.deposits)
    assert trace.steps == grown.report["steps"]
    assert stigc.explore(trace.rules, seed=3).report["bricks"] == grown.report["bricks"]


def test_poses_of_a_trace_are_those_of_the_scene():
    with open("scene.yaml", "w") as file:
        file.write("stigc_scene: 1\nduration: 1\nblocks: [{at: [0, 0, 0.3]}, {at: [1, 0, 0.0275]}]\n")
    stigc.simulate("scene.yaml", trace="run.stigp")
    trace = stigc.read_trace("run.stigp")
    frames, bodies, seven = trace.poses.shape
    assert trace.times.shape == (frames,) and len(trace.names) == bodies and seven == 7
    assert trace.times[0] == 0 and np.all(np.diff(trace.times) > 0)
    falling = trace.poses[:, trace.names.index(trace.names[-2]), 2]
    assert falling[0] == pytest.approx(0.3, abs=1e-4) and falling[-1] < 0.1
    scene = stigc.Scene("scene.yaml")
    assert np.allclose(trace.poses[0], scene.poses(), atol=1e-3)


def test_what_is_no_trace_is_refused():
    for name in ("x.stigt", "x.stigp"):
        with open(name, "wb") as file:
            file.write(b"stigtrc1 and more")
        with pytest.raises(stigc.StigcError):
            stigc.read_trace(name)
    with pytest.raises(stigc.StigcError):
        stigc.read_trace("none.stigt")
