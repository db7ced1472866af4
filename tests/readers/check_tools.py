# SPDX-License-Identifier: MIT
"""Has other people's command-line readers read the samples, and compares.

    check_tools.py TOOL FOLDER        TOOL: assimp, admesh or pngcheck

Exit status 77 (skipped) when the tool is not installed, unless STIG_REQUIRE_READERS
is set.
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=120)
    return done.returncode, done.stdout + done.stderr


def number(pattern, text):
    found = re.search(pattern, text)
    if not found:
        raise AssertionError(f"'{pattern}' is not in the answer:\n{text}")
    return float(found.group(1))


def point(label, text):
    found = re.search(label + r" +\((\S+) (\S+) (\S+)\)", text)
    return [float(value) for value in found.groups()]


def near(got, expected, what, slack=1e-4):
    got, expected = ([x] if not isinstance(x, list) else x for x in (got, expected))
    for g, e in zip(got, expected, strict=True):
        assert abs(g - e) <= slack * max(1, abs(e)), f"{what}: got {got}, expected {expected}"


def y_up(low, high):
    """Bounds after (x, y, z) -> (x, z, -y)."""
    return [low[0], low[2], -high[1]], [high[0], high[2], -low[1]]


def check_assimp(folder, name, expected):
    for kind in ("stl", "ply", "glb"):
        status, text = run("assimp", "info", str(folder / f"{name}.{kind}"))
        assert status == 0, text
        triangles = expected["triangles" if kind == "stl" else "merged_triangles"]
        near(number(r"Faces: +(\d+)", text), triangles, f"{name}.{kind}: triangles")
        low, high = expected["low"], expected["high"]
        if kind == "glb":
            low, high = y_up(low, high)
            near(number(r"Materials: +(\d+)", text), len(expected["colours"]), "materials")
        near(point("Minimum point", text), low, f"{name}.{kind}: lowest")
        near(point("Maximum point", text), high, f"{name}.{kind}: highest")


def check_admesh(folder, name, expected):
    status, text = run("admesh", str(folder / f"{name}.stl"))
    assert status == 0, text
    near(number(r"Number of facets +: +(\d+)", text), expected["triangles"], "facets")
    troubles = ["Total disconnected facets", "Degenerate facets", "Edges fixed",
                "Facets removed", "Facets added", "Facets reversed", "Normals fixed"]
    # Where bricks touch at an edge or a corner alone, they are parted by a narrow gap.
    slack = 1e-3 if expected["two_faces_an_edge"] else 0.03 * expected["volume"]
    near(number(r"Volume +: +(\S+)", text), expected["volume"], f"{name}: volume", slack)
    for trouble in troubles:
        near(number(trouble + r" +: +(\d+)", text), 0, f"{name}: {trouble}")


def check_pngcheck(folder, name, _):
    status, text = run("pngcheck", str(folder / f"{name}.png"))
    assert status == 0 and text.startswith("OK"), text


def main():
    tool, folder = sys.argv[1], Path(sys.argv[2])
    if shutil.which(tool) is None:
        print(f"{tool} is not installed (apt-get install {tool.replace('assimp', 'assimp-utils')})")
        return 1 if os.environ.get("STIG_REQUIRE_READERS") else 77
    check = {"assimp": check_assimp, "admesh": check_admesh, "pngcheck": check_pngcheck}[tool]
    for name, expected in json.loads((folder / "manifest.json").read_text()).items():
        check(folder, name, expected)
        print(f"{tool} reads {name} as it was written")
    return 0


if __name__ == "__main__":
    sys.exit(main())
