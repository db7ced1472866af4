#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compiles each source by itself, and each header with which no source begins: builds put
several sources into one translation unit, where the includes of one serve the next.

    scripts/compile_alone.py BUILD [FILE…]

BUILD is a folder configured with -D STIG_UNITY=OFF (nothing need be built in it). Of FILEs,
only the sources among them are compiled. Where there is ccache, what compiled before is not
compiled again, whichever clone it was in."""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^#include ["<](.*?)[">]', re.MULTILINE)


def command_of(entry):
    """The compiler's command, without the cache and what it reads and writes."""
    words = shlex.split(entry["command"])
    cache = [i for i, word in enumerate(words) if pathlib.Path(word).name == "ccache"]
    words = words[cache[0] + 1:] if cache else words
    kept, skip = [], False
    for word in words:
        if skip or word in ("-MD", "-c"):
            skip = False
        elif word in ("-o", "-MT", "-MF"):
            skip = True
        else:
            kept.append(word)
    return kept[:-1] + ["-Werror"]


def first_include(source):
    found = INCLUDE.search(source.read_text())
    return found and found[1]


def jobs_of(build):
    """Pairs of a file and the command that compiles it."""
    entries = json.loads((build / "compile_commands.json").read_text())
    jobs, covered, commands = {}, set(), {}
    for entry in entries:
        source = pathlib.Path(entry["file"])
        if source.suffix != ".cpp" or build in source.parents or source in jobs:
            continue
        jobs[source] = command_of(entry) + [str(source)]
        commands.setdefault(source.parent, command_of(entry))
        first = first_include(source)
        covered |= {ROOT / "lib" / first, source.parent / first} if first else set()
    for folder, command in commands.items():
        for header in sorted(folder.glob("*.h")):
            if header not in covered and ROOT / "lib" in header.parents:
                jobs[header] = command + ["-include", str(header), "-x", "c++", os.devnull]
    return jobs


def run_cached(command, work):
    """By ccache, which looks at what is read alone and so spares the preprocessor too."""
    out = os.path.join(work, "out")
    settings = {"STIG_COMPILER": command[0], "CCACHE_COMPILERTYPE": "gcc", "CCACHE_DEPEND": "1",
                "CCACHE_COMPILERCHECK": "%compiler% --version", "CCACHE_BASEDIR": str(ROOT)}
    words = ["ccache", str(ROOT / "scripts/parse.sh"), "-c", "-MD", "-MF", out + ".d", "-o", out + ".o"]
    return subprocess.run(words + command[1:], cwd=ROOT, env=os.environ | settings,
                          capture_output=True, text=True)


def compiles(job):
    path, command = job
    if shutil.which("ccache"):
        with tempfile.TemporaryDirectory() as work:
            run = run_cached(command, work)
    else:
        run = subprocess.run(command + ["-fsyntax-only"], cwd=ROOT, capture_output=True, text=True)
    if run.returncode != 0:
        sys.stderr.write(f"{path.relative_to(ROOT)} does not compile alone:\n{run.stderr}\n")
    return run.returncode == 0


def main(arguments):
    jobs = jobs_of(pathlib.Path(arguments[0]).resolve())
    if len(arguments) > 1:
        wanted = {(pathlib.Path.cwd() / name).resolve() for name in arguments[1:]}
        jobs = {path: command for path, command in jobs.items() if path in wanted}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        bad = list(pool.map(compiles, jobs.items())).count(False)
    print(f"{len(jobs) - bad} of {len(jobs)} files compile alone")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) if len(sys.argv) > 1 else __doc__)
