# SPDX-License-Identifier: MIT
"""Compiles rule sets and holds what comes out to luac, to luacheck, and to its line map.

    check_lua.py STIGC SOURCE_DIR
"""

import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

RULE_SETS = ["rulesets/staircase.yaml", "rulesets/stepped-pyramid.yaml",
             "tests/compiler/line.yaml", "tests/compiler/column.yaml",
             "tests/compiler/overhang.yaml", "tests/compiler/done.yaml",
             "tests/compiler/plus.yaml"]
LONGEST = 40  # lines of a function of the robots' library
SHIPPED = ["programs", "blocks", "scenes", "tests/controllers", "tests/lua"]


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return done.stdout


def check_lengths(luac, path):
    """No function is longer than one can see at once."""
    for first, last in re.findall(r"^function <.*:(\d+),(\d+)>", run(luac, "-p", "-l", path), re.M):
        assert int(last) - int(first) < LONGEST, f"{path}:{first}: a function of many lines"


def check_line_map(program, rules):
    """Every line that is mapped names its rule or returns a placement; none is forgotten."""
    lines = program.read_text().split("\n")
    source = rules.read_text().split("\n")
    mapped = json.loads(pathlib.Path(f"{program}.map").read_text())["lines"]
    for one in mapped:
        text = lines[one["line"] - 1].strip()
        comment = f"-- {rules.name}:{one['source']} {one['rule']}"
        assert text == comment or text.startswith("return { what = "), (one, text)
        assert source[one["source"] - 1].strip() == f"- name: {one['rule']}", one
    known = {one["line"] for one in mapped}
    for number, text in enumerate(lines, 1):
        if text.strip().startswith("return { what = "):
            assert number in known, (number, text)


def main():
    stigc, root = sys.argv[1], pathlib.Path(sys.argv[2])
    luac = shutil.which("luac5.4")
    luacheck = shutil.which("luacheck")
    if not luac or not luacheck:
        print("luac5.4 or luacheck is not installed")
        sys.exit(77)
    shipped = [path for folder in SHIPPED for path in sorted((root / folder).rglob("*.lua"))]
    assert len(shipped) > 10
    with tempfile.TemporaryDirectory() as folder:
        emitted = []
        for name in RULE_SETS:
            program = pathlib.Path(folder) / (pathlib.Path(name).stem + ".lua")
            run(stigc, "compile", root / name, "-o", program)
            check_line_map(program, root / name)
            emitted.append(program)
        for path in shipped + emitted:
            run(luac, "-p", path)
            if path.is_relative_to(root / "programs"):
                check_lengths(luac, path)
        run(luacheck, "--config", root / ".luacheckrc", *shipped, *emitted)
    print(f"{len(shipped)} files of our own and {len(emitted)} controllers")


main()
