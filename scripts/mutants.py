#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the tests by what they notice: changes one operator, constant or return value of a
random line, builds it, runs the tests of that layer, and prints which changes survived.

    mutants.py SEED N [--layer NAME…] [--folder DIR]

N changes that build are tried, drawn by SEED from the sources of lib/, every layer as often as
every other (or of the layers named alone). The work is done on a copy of the files as they stand,
in DIR (build/mutants), which is kept for the next call. A change is killed when a test fails,
crashes or takes more than ten times as long as without it. Progress goes to standard error, the
table to standard output. Property tests run with the seed that ctest gives them.
"""

import argparse
import os
import random
import re
import shutil
import subprocess
import sys
import time

# What may be changed, and into what. Operators stand between spaces in formatted sources, so
# templates, references and pointers are left alone.
SWAPS = [(re.compile(pattern), instead) for pattern, instead in (
    (r" == ", " != "), (r" != ", " == "),
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "),
    (r" && ", " || "), (r" \|\| ", " && "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "),
    (r" \+= ", " -= "), (r" -= ", " += "),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"(?<=[(&|] )!(?=[a-z(])|(?<=\()!(?=[a-z(])", ""),
    (r"\bif \((?!auto|const|std::)([^;]*)\) (?=\{|return|continue|break)", r"if (!(\1)) "),
    (r"\breturn ([^;{}]+);$", r"return !(\1);"),
    (r"(?<![\w.\"'])(\d+)(?![\w.\"'])", lambda match: str(int(match.group(1)) + 1)),
    (r"(?<![\w.\"'])(\d+\.\d+)(?![\w.\"'])", r"(\1 * 1.5)"),
)]
SKIP = re.compile(r"\s*(//|#|\*|using |namespace |template|static_assert|assert\(|case '|SPDX)")


def git_files():
    return subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                          check=True, capture_output=True, text=True).stdout.splitlines()


def refresh(folder):
    """Copies what differs, so that unchanged files keep their times and need no new build."""
    listed = [path for path in git_files() if os.path.isfile(path)]
    for path in listed:
        there = os.path.join(folder, path)
        with open(path, "rb") as file:
            content = file.read()
        if os.path.isfile(there):
            with open(there, "rb") as file:
                if file.read() == content:
                    continue
        os.makedirs(os.path.dirname(there), exist_ok=True)
        shutil.copyfile(path, there)
        shutil.copymode(path, there)
    return listed


def without_text(line):
    """The line with its strings and comments blanked, as long as before."""
    line = re.sub(r"\"(\\.|[^\"\\])*\"", lambda m: "\"" * len(m.group()), line)
    return re.sub(r"//.*", lambda m: "/" * len(m.group()), line)


def changes_of(line):
    """All lines that differ from this one in a single operator, constant or return value."""
    if SKIP.match(line):
        return []
    blank, found = without_text(line), []
    for pattern, instead in SWAPS:
        for match in pattern.finditer(blank):
            original = pattern.match(line, match.start()) or pattern.search(line, match.start())
            if original is None or original.start() != match.start():
                continue
            found.append(line[:original.start()] + original.expand(instead)
                         + line[original.end():] if isinstance(instead, str) else
                         line[:original.start()] + instead(original) + line[original.end():])
    return [changed for changed in found if changed != line]


class Bench:
    """A copy of the project with its build, in which one file at a time is changed."""

    def __init__(self, folder):
        self.folder = folder
        self.usual = {}

    def run(self, command, limit, cwd=None):
        environment = dict(os.environ, RC_PARAMS="seed=1")
        with subprocess.Popen(command, cwd=cwd or self.folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, start_new_session=True) as process:
            try:
                return process.wait(limit)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, 9)
                process.wait()
                return None

    def build(self, targets):
        return self.run(["cmake", "--build", "build/dev", "--target", *targets], 3600) == 0

    def test(self, targets, limit):
        for target in targets:
            if self.run([f"build/dev/tests/{target}"], limit) != 0:
                return False
        return True

    def prepare(self, targets):
        """Builds and runs the unchanged tests once; how long they may take is learnt here."""
        key = tuple(targets)
        if key not in self.usual:
            if not self.build(targets):
                sys.exit(f"mutants.py: {' '.join(targets)} does not build unchanged")
            begin = time.monotonic()
            if not self.test(targets, 3600):
                sys.exit(f"mutants.py: {' '.join(targets)} fails unchanged")
            self.usual[key] = 10 * (time.monotonic() - begin) + 10
        return self.usual[key]

    def survives(self, path, number, changed, targets):
        """True, False, or None where the change does not build."""
        limit = self.prepare(targets)
        there = os.path.join(self.folder, path)
        with open(there, encoding="utf-8") as file:
            original = file.read()
        lines = original.split("\n")
        lines[number] = changed
        try:
            with open(there, "w", encoding="utf-8") as file:
                file.write("\n".join(lines))
            return self.test(targets, limit) if self.build(targets) else None
        finally:
            with open(there, "w", encoding="utf-8") as file:
                file.write(original)


# Of folders of lib/ whose tests stand under another name, or in another folder too.
TESTS = {"robots": ["controllers"], "lua": ["controllers"], "physical": ["physical", "behaviour"]}


def tests_of(layer, folder):
    """The test programs of a layer: that of its folder's name unless TESTS says otherwise."""
    names = TESTS.get(layer, [layer])
    return [f"test_{name}" for name in names if os.path.isdir(f"{folder}/tests/{name}")]


def sources_by_layer(listed):
    layers = {}
    for path in listed:
        parts = path.split("/")
        if parts[0] == "lib" and len(parts) > 2 and path.endswith((".cpp", ".h")):
            layers.setdefault(parts[1], []).append(path)
    return layers


def draw(chance, paths, folder):
    """A random change of a random line among those that can be changed."""
    while True:
        places = []
        path = chance.choices(paths, [os.path.getsize(os.path.join(folder, path))
                                      for path in paths])[0]
        with open(os.path.join(folder, path), encoding="utf-8") as file:
            for number, line in enumerate(file.read().split("\n")):
                places += [(number, line)] if changes_of(line) else []
        if places:
            number, line = chance.choice(places)
            return path, number, line, chance.choice(changes_of(line))


def report(results):
    print("| layer | killed | of |")
    print("|---|---:|---:|")
    for layer in sorted({layer for layer, *_ in results}):
        own = [survived for name, survived, *_ in results if name == layer]
        print(f"| {layer} | {own.count(False)} | {len(own)} |")
    print(f"| all | {sum(not survived for _, survived, *_ in results)} | {len(results)} |")
    for _, survived, path, number, line, changed in results:
        if survived:
            print(f"\n{path}:{number + 1}\n-{line}\n+{changed}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("seed", type=int)
    parser.add_argument("n", type=int)
    parser.add_argument("--layer", action="append")
    parser.add_argument("--folder", default="build/mutants")
    asked = parser.parse_args()
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    listed = refresh(asked.folder)
    layers = sources_by_layer(listed)
    names = asked.layer or sorted(layers)
    unknown = [name for name in names if name not in layers]
    if unknown or asked.n < 1:
        parser.error(f"no layer {unknown[0]} in lib/" if unknown else "N is at least 1")
    bench = Bench(asked.folder)
    if bench.run(["cmake", "--preset", "dev"], 600) != 0:
        sys.exit("mutants.py: cmake --preset dev failed")
    chance, results = random.Random(asked.seed), []
    while len(results) < asked.n:
        layer = names[len(results) % len(names)]
        path, number, line, changed = draw(chance, layers[layer], asked.folder)
        survived = bench.survives(path, number, changed, tests_of(layer, asked.folder))
        if survived is None:
            continue
        results.append((layer, survived, path, number, line, changed))
        print(f"{len(results)}/{asked.n} {path}:{number + 1} "
              f"{'SURVIVED' if survived else 'killed'}: {changed.strip()}", file=sys.stderr)
    report(results)


if __name__ == "__main__":
    main()
