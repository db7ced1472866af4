#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does layering.py see what it should? Each case is a small tree with one fault."""

import tempfile
import unittest
from pathlib import Path

import layering

GRAPH = ("base | | fmt::fmt yaml-cpp | \nrules | base | fmt::fmt | \n"
         "lattice | rules | Boost::headers | \n")
SPDX = "// SPDX-License-Identifier: MIT\n"


def check(files, graph=GRAPH):
    """Problems of a tree of {path: text after the SPDX line} beside a sound header."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, text in {"lib/base/sound.h": "#include <vector>\n", **files}.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(SPDX + text, encoding="utf-8")
        return layering.check(root, layering.read_graph(graph))


class LayeringTest(unittest.TestCase):
    def expect(self, problems, path, line, words):
        self.assertEqual([(path, line)], [(p, n) for p, n, _ in problems], problems)
        self.assertIn(words, problems[0][2])

    def test_sound_tree(self):
        self.assertEqual([], check({
            "lib/lattice/a.h": '#include "base/sound.h"\n',  # used through rules
            "lib/lattice/a.cpp": '#include "lattice/a.h"\n#include <boost/graph/x.hpp>\n',
            "tools/t/main.cpp": '#include "own.h"\n#include <CLI/CLI.hpp>\n'}))

    def test_type_of_two_layers(self):
        self.expect(check({"lib/base/a.h": "struct Site {\n};\n",
                           "lib/rules/b.h": "\nclass Site final : public X {\n};\n"}),
                    "lib/rules/b.h", 3, "type 'Site' is defined in lib/base/a.h too")

    def test_namespace_of_another_layer(self):
        inside = "namespace stig::{0} {{\n}}  // namespace stig::{0}\n"
        self.assertEqual([], check({"lib/rules/a.h": inside.format("rules")}))
        self.expect(check({"lib/lattice/a.h": inside.format("rules")}),
                    "lib/lattice/a.h", 1, "layer 'lattice' is namespace stig::lattice")
        bare = "namespace stig {\n}  // namespace stig\n"
        self.expect(check({"lib/lattice/a.h": bare}),
                    "lib/lattice/a.h", 1, "layer 'lattice' is namespace stig::lattice")
        self.assertEqual([], check({"lib/base/a.h": bare,
                                    "lib/rules/a.h": bare + inside.format("rules")}))

    def test_uses_as_the_graph_has_them(self):
        uses = "namespace stig::lattice {{\n{}}}  // namespace stig::lattice\n"
        self.assertEqual([], check({"lib/lattice/uses.h": uses.format("using namespace rules;\n")}))
        self.expect(check({"lib/lattice/uses.h": uses.format("")}), "lib/lattice/uses.h", 1,
                    "namespace stig::rules is not made visible")
        self.expect(check({"lib/rules/uses.h": "using namespace lattice;\n"}),
                    "lib/rules/uses.h", 1, "is of no layer that this one uses")

    def test_uses_through_those_of_others(self):
        graph = "base | | | \nlow | base | | \nmiddle | low | | \nhigh | middle | | \n"
        files = {"lib/middle/uses.h": "namespace stig::middle {\nusing namespace low;\n}\n",
                 "lib/high/uses.h": '#include "middle/uses.h"\n'
                                    "namespace stig::high {\nusing namespace middle;\n}\n"}
        self.assertEqual([], check(files, graph))
        files["lib/middle/uses.h"] = "namespace stig::middle {\n}\n"
        self.assertEqual(["lib/high/uses.h", "lib/middle/uses.h"],
                         [path for path, _, _ in check(files, graph)])

    def test_upward_include(self):
        problems = check({"lib/rules/a.h": "",
                          "lib/base/b.cpp": '\n#include "rules/a.h"\n'})
        self.expect(problems, "lib/base/b.cpp", 3, "'base' may not include 'rules'")

    def test_layers_in_a_folder_of_layers(self):
        graph = "base | | | \nworld/low | base | | \nworld/high | world/low | | \n"
        self.assertEqual([], check({"lib/world/low/a.h": '#include "base/sound.h"\n',
                                    "lib/world/high/b.h": '#include "world/low/a.h"\n'}, graph))
        self.expect(check({"lib/world/low/a.h": '\n#include "world/high/b.h"\n',
                           "lib/world/high/b.h": ""}, graph),
                    "lib/world/low/a.h", 3, "'world/low' may not include 'world/high'")
        self.expect(check({"lib/world/a.h": '#include "base/sound.h"\n'}, graph),
                    "lib/world/a.h", 2, "folder 'world' is no layer")

    def test_installed_header(self):
        graph = "base | | | sound.h\nrules | base | | a.h\n"
        files = {"lib/rules/a.h": '#include "base/sound.h"\n', "lib/rules/own.h": "",
                 "lib/rules/a.cpp": '#include "rules/own.h"\n'}
        self.assertEqual([], check(files, graph))
        files["lib/rules/a.h"] = '\n#include "rules/own.h"\n'
        self.expect(check(files, graph), "lib/rules/a.h", 3, '"rules/own.h" is not installed')

    def test_installed_header_that_is_gone(self):
        self.expect(check({}, "base | | | sound.h gone.h\n"),
                    "lib/base/CMakeLists.txt", 1, '"base/gone.h" is no file')

    def test_include_without_layer(self):
        self.expect(check({"lib/base/b.cpp": '#include "sound.h"\n'}),
                    "lib/base/b.cpp", 2, "names no layer")

    def test_include_of_missing_file(self):
        self.expect(check({"lib/base/b.cpp": '#include "base/gone.h"\n'}),
                    "lib/base/b.cpp", 2, "no file of lib/")

    def test_folder_that_is_no_layer(self):
        self.expect(check({"lib/stray/b.cpp": '#include "base/sound.h"\n'}),
                    "lib/stray/b.cpp", 2, "is no layer")

    def test_vendor_in_header(self):
        self.expect(check({"lib/base/b.h": "#include <fmt/core.h>\n"}),
                    "lib/base/b.h", 2, "vendor headers stand in .cpp files")

    def test_vendor_that_the_layer_does_not_link(self):
        self.expect(check({"lib/rules/b.cpp": "#include <boost/any.hpp>\n"}),
                    "lib/rules/b.cpp", 2, "does not link Boost::headers")

    def test_unknown_vendor(self):
        self.expect(check({"lib/base/b.cpp": "#include <wonder/all.hpp>\n"}),
                    "lib/base/b.cpp", 2, "is unknown")

    def test_slow_vendor_in_two_files(self):
        include = "#include <yaml-cpp/yaml.h>\n"
        self.expect(check({"lib/base/a.cpp": include, "lib/base/b.cpp": include}),
                    "lib/base/b.cpp", 2, "one file wraps it")

    def test_header_cycle(self):
        problems = check({"lib/base/a.h": '#include "base/b.h"\n',
                          "lib/base/b.h": '#include "base/a.h"\n'})
        self.expect(problems, "lib/base/a.h", 1, "headers in a circle")

    def test_layer_cycle(self):
        problems = check({}, "base | rules | |\nrules | base | |\n")
        self.expect(problems, "lib/CMakeLists.txt", 1, "base -> rules -> base")

    def test_layer_that_uses_nothing_known(self):
        self.expect(check({}, "base | sand | |\n"), "lib/CMakeLists.txt", 1, "'sand'")

    def test_missing_spdx(self):
        self.expect(check({"scripts/run.sh": ""}), "scripts/run.sh", 1, "# SPDX")


if __name__ == "__main__":
    unittest.main()
