// SPDX-License-Identifier: MIT
// The column's top is the brick below its lowest empty cell; all below that has to be known. Over
// the highest level nothing is ever put, so there it need not be.
#include "recheck/decide.h"

#include <algorithm>

namespace stig::recheck {

namespace {

struct Top {
  int level = 0;
  int colour = 0;
};

std::optional<Top> top_of(const View& view, const std::vector<std::int8_t>& known) {
  std::optional<Top> out;
  for (int z = 0; z < view.levels(); ++z) {
    const int state = known[static_cast<std::size_t>(view.window({0, 0, z}))];
    if (state == 0) return out;
    if (state == kNotKnown) return z + 1 == view.levels() ? out : std::nullopt;
    out = Top{z, state};
  }
  return out;
}

}  // namespace

std::optional<Put> decide(const WorkCertificate& certificate, const View& view,
                          const std::vector<std::int8_t>& known, int side) {
  using Kind = WorkNode::Kind;
  const std::optional<Top> top = top_of(view, known);
  const WorkNode* node = &certificate.nodes.front();
  while (node->kind != Kind::put && node->kind != Kind::nothing) {
    int answer = side;
    if (node->kind == Kind::cell) {
      const int place = view.window(node->cell);
      answer = place < 0 ? kNotKnown : known[static_cast<std::size_t>(place)];
    } else if (node->kind != Kind::side) {
      answer = !top ? kNotKnown : node->kind == Kind::top_level ? top->level : top->colour;
    }
    const WorkNode* next = nullptr;
    for (const auto& [answers, child] : node->branches) {
      const bool here = std::find(answers.begin(), answers.end(), answer) != answers.end();
      if (here && next == nullptr) next = &certificate.nodes[child];
    }
    if (next == nullptr) return std::nullopt;
    node = next;
  }
  if (node->kind == Kind::nothing) return std::nullopt;
  Put out{node->cell, node->colour};
  if (out.cell.du == 0 && out.cell.dv == 0) {
    // Robots put on top of what they see to be the top.
    if (!top) return std::nullopt;
    out.cell.z = top->level + 1;
  }
  return out;
}

}  // namespace stig::recheck
