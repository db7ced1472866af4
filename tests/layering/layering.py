#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Holds every #include to the layer graph.

    layering.py --graph build/dev/layers.txt [--root .]

The graph is what the stig_layer() calls below lib/ say; CMake writes it when it configures. A
layer's name is its folder's path: physical/solver. Checked, each with path:line and what to do:

  - a file of lib/ includes layers that its own layer uses, by "layer/header.h", and
    nothing else of the project; the graph itself has no cycle;
  - a header that is installed includes headers that are installed too;
  - no headers include each other in a circle;
  - vendor headers stand in .cpp files, of layers that name the vendor; yaml-cpp and
    CLI11, which cost much to compile, in one file each;
  - a file of lib/ opens its layer's namespace, if any, and a layer's uses.h makes visible the
    namespaces of the layers that it uses, directly or through others, and of no others;
  - no two headers of lib/ define a type of one name: tests and programs speak of all layers
    unqualified;
  - each source begins with its SPDX line.

Exit status: 0 clean, 1 violations, 2 the check could not run.
"""

import argparse
import re
import sys
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

FOLDERS = ["lib", "tools", "examples", "tests", "bench", "fuzz", "cmake", "scripts"]
CODE = {".cpp", ".h", ".def"}
SPDX = "SPDX-License-Identifier: MIT"
COMMENT_OF = {".cpp": "//", ".h": "//", ".def": "//", ".js": "//", ".mjs": "//", ".ts": "//",
              ".cmake": "#", ".in": "#", ".py": "#", ".sh": "#"}


@dataclass(frozen=True)
class Vendor:
    prefix: str              # what its includes begin with
    target: str              # the CMake target that a layer must name
    in_headers: tuple = ()   # includes that headers may use too
    one_file: bool = False   # its headers are slow: one source file wraps it


VENDORS = [
    Vendor("fmt/", "fmt::fmt"),
    Vendor("yaml-cpp/", "yaml-cpp", one_file=True),
    Vendor("nlohmann/", "nlohmann_json::nlohmann_json", in_headers=("nlohmann/json_fwd.hpp",)),
    Vendor("zstd", "PkgConfig::ZSTD"),
    Vendor("zlib.h", "ZLIB::ZLIB"),
    Vendor("pugixml.hpp", "pugixml::pugixml", one_file=True),
    Vendor("sqlite3.h", "PkgConfig::SQLITE3", one_file=True),
    Vendor("cairo", "PkgConfig::CAIRO"),
    Vendor("boost/", "Boost::headers"),
    Vendor("oneapi/tbb/", "TBB::tbb"),
    Vendor("Random123/", "Random123::Random123"),
    Vendor("CLI/", "CLI11::CLI11", one_file=True),
    Vendor("httplib.h", "PkgConfig::HTTPLIB", one_file=True),
    Vendor("dart/", "dart"),
    Vendor("Eigen/", "dart"),  # which brings it
    Vendor("cadical", "Cadical::Cadical"),
    Vendor("lua", "PkgConfig::LUA"),
]
# The language's own headers have no dot; these are the system's and the compiler's.
SYSTEM = re.compile(r"[a-z_]+$"
                    r"|(unistd|fcntl|signal|termios|pthread|immintrin)\.h$|(sys|sanitizer)/[a-z_]+\.h$")
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


@dataclass
class Layer:
    uses: list
    vendors: list
    installed: list = field(default_factory=list)


@dataclass
class Tree:
    root: Path
    layers: dict
    problems: list = field(default_factory=list)

    def report(self, path, line, message):
        self.problems.append((path.relative_to(self.root).as_posix(), line, message))


def read_graph(text):
    """{name: Layer} from lines "name | layers it uses | vendor targets | installed headers"."""
    layers = {}
    for line in text.splitlines():
        name, uses, vendors, installed = (part.strip() for part in line.split("|"))
        layers[name] = Layer(uses.split(), vendors.split(), installed.split())
    return layers


def reach(layers, name):
    """The layers that `name` uses, directly or through others."""
    seen, todo = set(), list(layers[name].uses)
    while todo:
        layer = todo.pop()
        if layer not in seen:
            seen.add(layer)
            todo += layers[layer].uses
    return seen


def includes_of(path):
    """(line, name, quoted) of each #include."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] or match[2], match[1] is not None


def sources(root, folders, suffixes):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            hidden = any(part in ("build", "node_modules") for part in path.parts)
            if path.is_file() and path.suffix in suffixes and not hidden:
                yield path


def find_cycle(edges):
    """A list of nodes that leads back to its first, or None."""
    done = set()
    for first in sorted(edges):
        trail, stack = [], [(first, False)]
        while stack:
            node, leaving = stack.pop()
            if leaving:
                done.add(trail.pop())
            elif node in trail:
                return trail[trail.index(node):] + [node]
            elif node not in done:
                trail.append(node)
                stack.append((node, True))
                stack += [(next_node, False) for next_node in sorted(edges.get(node, ()))]
    return None


TYPE = re.compile(r"^(?:struct|class|enum class)\s+(\w+)\s*(?:final\s*)?(?::[^;{]*)?\{", re.MULTILINE)


def check_type_names(tree):
    first = {}
    for path in sources(tree.root, ["lib"], {".h"}):
        text = path.read_text(encoding="utf-8")
        for match in TYPE.finditer(text):
            name, line = match[1], text.count("\n", 0, match.start()) + 1
            if name in first:
                other = first[name].relative_to(tree.root).as_posix()
                tree.report(path, line, f"type '{name}' is defined in {other} too: rename one")
            first.setdefault(name, path)


def space_of(layer):
    """The namespace of a layer, below stig: that of the layers in lib/physical is one."""
    if layer.startswith("physical"):
        return "physics"
    return "" if layer == "base" else layer


OPENS = re.compile(r"^namespace stig(?:::(\w+))?(?:::\w+)? \{$", re.MULTILINE)
MAKES_VISIBLE = re.compile(r"^using namespace (\w+);$", re.MULTILINE)


def made_visible(tree, path):
    """The namespaces of the directives in a uses.h and in those that it includes. An include of
    what is no file is check_own_include's to report."""
    found = set(MAKES_VISIBLE.findall(path.read_text(encoding="utf-8")))
    for _, name, quoted in includes_of(path):
        other = tree.root / "lib" / name
        if quoted and other.name == "uses.h" and other != path and other.is_file():
            found |= made_visible(tree, other)
    return found


def check_namespaces(tree):
    for path in sources(tree.root, ["lib"], {".h", ".cpp"}):
        here = layer_of(tree, path)
        if here not in tree.layers:
            continue
        text, own = path.read_text(encoding="utf-8"), space_of(here)
        opened = {match[1] or "" for match in OPENS.finditer(text)}
        # A header that adds to the namespace of a lower layer, for lookup by argument, opens both.
        if opened and own not in opened:
            tree.report(path, 1, f"layer '{here}' is namespace stig::{own}".removesuffix("::"))
        if path.name == "uses.h":
            wanted = {space_of(layer) for layer in reach(tree.layers, here)} - {"", own}
            for name in sorted(wanted ^ (made_visible(tree, path) - {own})):
                tree.report(path, 1, f"namespace stig::{name} is " +
                            ("not made visible" if name in wanted else "of no layer that this one uses"))


def check_graph(tree):
    build_file = tree.root / "lib" / "CMakeLists.txt"
    for name, layer in tree.layers.items():
        for used in layer.uses:
            if used not in tree.layers:
                tree.report(build_file, 1, f"layer '{name}' uses '{used}', which is no layer")
                return False
    cycle = find_cycle({name: layer.uses for name, layer in tree.layers.items()})
    if cycle:
        tree.report(build_file, 1, "layers use each other in a circle: " + " -> ".join(cycle))
    return cycle is None


def layer_of(tree, path):
    return path.parent.relative_to(tree.root / "lib").as_posix()


def check_own_include(tree, path, line, name):
    here = layer_of(tree, path)
    layer = name.rpartition("/")[0]
    if layer not in tree.layers:
        tree.report(path, line, f'"{name}" names no layer: write "layer/header.h"')
    elif not (tree.root / "lib" / name).is_file():
        tree.report(path, line, f'"{name}" is no file of lib/')
    elif here not in tree.layers:
        tree.report(path, line, f"folder '{here}' is no layer: call stig_layer({here} ...) in it")
    elif layer != here and layer not in reach(tree.layers, here):
        allowed = ", ".join(sorted(reach(tree.layers, here))) or "no other layer"
        tree.report(path, line, f"layer '{here}' may not include '{layer}' (it uses: {allowed})")


def vendor_of(name):
    return next((vendor for vendor in VENDORS if name.startswith(vendor.prefix)), None)


def check_vendor_include(tree, path, line, name):
    vendor = vendor_of(name)
    if vendor is None:
        if not SYSTEM.match(name):
            tree.report(path, line, f"<{name}> is unknown: list its library among VENDORS "
                                    "in tests/layering/layering.py")
        return
    here = layer_of(tree, path)
    if path.suffix != ".cpp" and name not in vendor.in_headers:
        tree.report(path, line, f"<{name}> in a header: vendor headers stand in .cpp files")
    if here in tree.layers and vendor.target not in tree.layers[here].vendors:
        tree.report(path, line, f"layer '{here}' does not link {vendor.target}: "
                                f"name it in lib/{here}/CMakeLists.txt")


def check_library_includes(tree):
    for path in sources(tree.root, ["lib"], CODE):
        for line, name, quoted in includes_of(path):
            if quoted:
                check_own_include(tree, path, line, name)
            else:
                check_vendor_include(tree, path, line, name)


def check_installed(tree):
    """Whoever includes an installed header finds what it includes."""
    installed = {f"{name}/{header}" for name, layer in tree.layers.items()
                 for header in layer.installed}
    for name in sorted(installed):
        path = tree.root / "lib" / name
        if not path.is_file():
            layer = name.rpartition("/")[0]
            tree.report(tree.root / "lib" / layer / "CMakeLists.txt", 1, f'"{name}" is no file of lib/')
            continue
        for line, other, quoted in includes_of(path):
            if quoted and other not in installed:
                tree.report(path, line, f'"{other}" is not installed, and this header is: name it '
                                        "after API in its layer's CMakeLists.txt")


def check_one_file(tree):
    users = defaultdict(list)
    for path in sources(tree.root, ["lib", "tools"], CODE):
        for line, name, quoted in includes_of(path):
            vendor = None if quoted else vendor_of(name)
            if vendor and vendor.one_file and path not in [user for user, _ in users[vendor]]:
                users[vendor].append((path, line))
    for vendor, places in users.items():
        for path, line in places[1:]:
            first = places[0][0].relative_to(tree.root).as_posix()
            tree.report(path, line, f"{vendor.target} is included here and in {first}: "
                                    "one file wraps it")


def resolve(tree, path, name):
    """The project's header that a quoted include of `path` means, or None."""
    for folder in (path.parent, tree.root / "lib", tree.root / "tests"):
        if (folder / name).is_file():
            return (folder / name).resolve().relative_to(tree.root).as_posix()
    return None


def check_header_cycles(tree):
    edges = {}
    for path in sources(tree.root, ["lib", "tools", "tests", "bench", "fuzz"], {".h"}):
        targets = (resolve(tree, path, name) for _, name, quoted in includes_of(path) if quoted)
        edges[path.relative_to(tree.root).as_posix()] = {to for to in targets if to}
    cycle = find_cycle(edges)
    if cycle:
        tree.report(tree.root / cycle[0], 1, "headers in a circle: " + " -> ".join(cycle))


def check_spdx(tree):
    paths = list(sources(tree.root, FOLDERS, set(COMMENT_OF)))
    paths += [path for path in sources(tree.root, FOLDERS, {".txt"})
              if path.name == "CMakeLists.txt"]
    for path in paths:
        lines = path.read_text(encoding="utf-8").splitlines()
        at = 1 if lines and lines[0].startswith("#!") else 0
        expected = f"{COMMENT_OF.get(path.suffix, '#')} {SPDX}"
        if lines[at:at + 1] != [expected]:
            tree.report(path, at + 1, f"this line must be '{expected}'")


def check(root, layers):
    """Sorted (path, line, message) of all that breaks the rules."""
    tree = Tree(Path(root).resolve(), layers)
    if check_graph(tree):
        check_library_includes(tree)
    check_installed(tree)
    check_one_file(tree)
    check_header_cycles(tree)
    check_type_names(tree)
    check_namespaces(tree)
    check_spdx(tree)
    return sorted(tree.problems)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--graph", type=Path, required=True)
    parser.add_argument("--root", type=Path, default=Path("."))
    arguments = parser.parse_args()
    try:
        layers = read_graph(arguments.graph.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        print(f"cannot read the layer graph: {error}", file=sys.stderr)
        return 2
    problems = check(arguments.root, layers)
    for path, line, message in problems:
        print(f"{path}:{line}: {message}")
    print(f"{len(layers)} layers, {len(problems)} violations")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
