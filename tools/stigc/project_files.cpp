// SPDX-License-Identifier: MIT
#include "project_files.h"

#include "physical/scene/scene.h"
#include "rules/rule_schema.h"
#include "uses.h"

namespace stig::cli {
namespace {

constexpr const char* kReadme = R"(# A project for stigc

`rules.yaml` is a rule set, `drawing.txt` a drawing of a structure, `scene.yaml` a scene of blocks as
physics has them. The commands below run in this folder as they stand; change a file and run them again.

## Rules

What is wrong with the rules, if anything; the canonical form; what a swarm builds with them; a proof
that it is always that; and why a rule does not fire at a place:

    stigc check rules.yaml
    stigc fmt --check rules.yaml
    stigc explore rules.yaml --box 9,9,9 --agents 5 -o column.png -o column.txt
    stigc verify rules.yaml
    stigc test rules.yaml
    stigc explain rules.yaml --structure column.txt --at 0,0,4

## A drawing

From a drawing to rules that build it, proved; and from a drawing to robots that have built it:

    stigc synth drawing.txt --floor -o drawn.yaml
    stigc build drawing.txt -o built

## Physics

A run of the scene, its poses as a table, and a picture of its end:

    stigc simulate scene.yaml --trace scene.stigp
    stigc replay scene.stigp -o scene.csv
    stigc render scene.stigp -o scene.png

## With an editor

Editors with a YAML language server complete keys in both files by the schemas beside them. When the
rules have new bricks, or stigc is a newer one, write the schemas anew:

    stigc schema --symbols-of rules.yaml > rules.schema.json
    stigc schema scene > scene.schema.json

`stigc COMMAND --help` has more examples, and `stigc --explain CODE` says what a diagnostic means.
)";

constexpr const char* kRules = R"(# yaml-language-server: $schema=rules.schema.json
# A column of four bricks, from one rule.
#
# A rule says what must be around an empty site for a brick to be placed there. Each drawing shows
# three slices: the one above the site, the site's own level with the site as *, and the one below. "?" is anything,
# "." an empty cell, "=" the floor, and a brick's symbol that brick.
stigc: 1
name: column
title: A column of four bricks
lattice: cubic
# "rotations" would let every rule hold in all four directions.
symmetry: none
floor: true
bricks:
  a: {name: red, color: "#e6194b"}
start:
  - {at: [0, 0, 0], brick: a}
# What stigc test holds the file to.
expect:
  bricks: 4
  verdict: coordinated
rules:
  - name: raise
    place: a
    when: |
      ? ? ?   ? ? ?   ? ? ?
      ? ? ?   ? * ?   ? a ?
      ? ? ?   ? ? ?   ? ? ?
    # Of the site, the floor's is 0: try 5.
    height: {max: 3}
)";

constexpr const char* kDrawing =
    R"(// Slices from the top down, parted by ---; 1 is a brick, . an empty place.
1 .
---
1 1
)";

constexpr const char* kScene = R"(# yaml-language-server: $schema=scene.schema.json
# A column of three blocks, and one that falls onto it. Lengths are in metres, angles in degrees.
stigc_scene: 1
title: A column, and one more
duration: 3
blocks:
  - {name: column, column: 3, color: Q3}
  - {name: late, at: [0.002, 0.001, 0.3], turn: [5, 0, 0], color: Q1}
)";

}  // namespace

std::vector<ProjectFile> project_files() {
  return {{"README.md", kReadme},
          {"rules.yaml", kRules},
          {"rules.schema.json", json_schema(std::vector<std::string>{"a"})},
          {"drawing.txt", kDrawing},
          {"scene.yaml", kScene},
          {"scene.schema.json", scene_schema()}};
}

}  // namespace stig::cli
