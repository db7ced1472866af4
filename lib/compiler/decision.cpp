// SPDX-License-Identifier: MIT
// Learns a decision tree from the policy's cases, each an observation with the set of
// placements that are allowed there. It is exact: every case ends in a leaf that it allows,
// or the tree does not exist. Questions about the column's top come first, as in Allwright
// et al. 2017; then the question that leaves the fewest cases mixed is taken, greedily,
// since the smallest tree is NP-hard to find. What cannot be told apart is handed back to
// the policy, which withdraws it and starts again.
#include "compiler/decision.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <set>
#include <tuple>

namespace stig::compiler {

namespace {

/// What may be done at some observation: placements, or nothing.
using Choices = std::set<std::optional<Placement>>;

struct Case {
  std::uint32_t observation = 0;
  const Observation* seen = nullptr;
  Choices choices;
};

/// Raise before extend, low before high. Among several allowed placements the choice
/// decides how a structure grows; raising first keeps lanes free.
auto preference(const std::optional<Placement>& placement) {
  if (!placement) return std::tuple(3, 0, Placement{});
  return std::tuple(static_cast<int>(kind_of(*placement)), placement->at.z, *placement);
}

/// What all cases may do.
Choices common(const std::vector<Case>& cases) {
  assert(!cases.empty());
  Choices out = cases.front().choices;
  for (const Case& one : cases) {
    std::erase_if(out, [&](const auto& choice) { return !one.choices.contains(choice); });
  }
  return out;
}

std::unique_ptr<DecisionNode> leaf(const std::vector<Case>& cases, const Choices& choices) {
  assert(!choices.empty());
  auto node = std::make_unique<DecisionNode>();
  node->placement =
      *std::min_element(choices.begin(), choices.end(),
                        [](const auto& a, const auto& b) { return preference(a) < preference(b); });
  for (const Case& one : cases) node->observations.push_back(one.observation);
  return node;
}

bool is_of_top(const Question& question) {
  return question.kind == Question::Kind::top_colour || question.kind == Question::Kind::top_level;
}

/// Questions in the order in which they are preferred: the top, then the nearest cells, then the
/// side.
std::vector<Question> all_questions(std::size_t cells) {
  std::vector<Question> out = {{Question::Kind::top_colour, {}}, {Question::Kind::top_level, {}}};
  for (std::size_t i = 0; i < cells; ++i) out.push_back({Question::Kind::cell, window_cell(i)});
  std::stable_sort(out.begin() + 2, out.end(), [](const Question& a, const Question& b) {
    const auto far = [](const WindowCell& c) { return std::abs(c.du) + std::abs(c.dv); };
    return far(a.cell) < far(b.cell);
  });
  out.push_back({Question::Kind::side, {}});
  return out;
}

using Parts = std::map<int, std::vector<Case>>;

/// Where the answer is not seen, only nothing can be done. A case that does not see the
/// answer can take the branch "nothing is done", if it allows that.
constexpr int kNotSeen = -1;

/// Nothing when some case does not see the answer and wants something, or all have the same.
std::optional<Parts> split(const std::vector<Case>& cases, const Question& question) {
  Parts parts;
  for (const Case& one : cases) {
    const std::optional<int> got = answer(question, *one.seen);
    if (!got && !one.choices.contains(std::nullopt)) return std::nullopt;
    parts[got.value_or(kNotSeen)].push_back(one);
  }
  if (parts.size() < 2) return std::nullopt;
  return parts;
}

/// Cases that still want to be told apart.
std::size_t mixed(const Parts& parts) {
  std::size_t out = 0;
  for (const auto& [got, cases] : parts) {
    if (common(cases).empty()) out += cases.size();
  }
  return out;
}

/// Are two trees the same? Trees are built from the leaves up, so branches that turn out
/// alike can be joined at once.
bool same(const DecisionNode& a, const DecisionNode& b) {
  if (a.question != b.question || a.placement != b.placement) return false;
  if (a.branches.size() != b.branches.size()) return false;
  for (std::size_t i = 0; i < a.branches.size(); ++i) {
    if (a.branches[i].first != b.branches[i].first) return false;
    if (!same(*a.branches[i].second, *b.branches[i].second)) return false;
  }
  return true;
}

void gather(const DecisionNode& from, DecisionNode& to) {
  to.observations.insert(to.observations.end(), from.observations.begin(), from.observations.end());
  for (std::size_t i = 0; i < from.branches.size(); ++i) {
    gather(*from.branches[i].second, *to.branches[i].second);
  }
}

class Builder {
 public:
  explicit Builder(std::vector<Question> questions) : questions_(std::move(questions)) {}

  /// Null when two cases cannot be told apart, which then are in `stuck`.
  std::unique_ptr<DecisionNode> build(const std::vector<Case>& cases) {
    const Choices choices = common(cases);
    if (!choices.empty()) return leaf(cases, choices);
    const std::optional<std::pair<Question, Parts>> best = best_split(cases);
    if (!best) {
      stuck = cases;
      return nullptr;
    }
    auto node = std::make_unique<DecisionNode>();
    node->question = best->first;
    for (const auto& [got, part] : best->second) {
      if (got == kNotSeen) continue;  // no branch: nothing is done
      auto child = build(part);
      if (!child) return nullptr;
      const auto alike = std::find_if(node->branches.begin(), node->branches.end(),
                                      [&](const auto& b) { return same(*b.second, *child); });
      if (alike != node->branches.end()) {
        alike->first.push_back(got);
        gather(*child, *alike->second);
      } else {
        node->branches.emplace_back(std::vector<int>{got}, std::move(child));
      }
    }
    return node;
  }

  std::vector<Case> stuck;

 private:
  /// The top's colour and level are asked first, since they say which column this is; after
  /// that whatever leaves the fewest cases open. Ties go to the earlier question in
  /// all_questions, that is, to the nearer cell.
  std::optional<std::pair<Question, Parts>> best_split(const std::vector<Case>& cases) const {
    std::optional<std::pair<Question, Parts>> best;
    std::size_t fewest = SIZE_MAX;
    for (const Question& question : questions_) {
      auto parts = split(cases, question);
      if (!parts) continue;
      if (is_of_top(question)) return std::pair(question, std::move(*parts));
      const std::size_t left = mixed(*parts);
      if (left >= fewest) continue;
      fewest = left;
      best = std::pair(question, std::move(*parts));
    }
    return best;
  }

  std::vector<Question> questions_;
};

/// What some of the cases allow and others do not.
std::vector<Withdrawal> differences(const std::vector<Case>& cases,
                                    const std::map<std::uint32_t, std::uint32_t>& example) {
  const Choices all = common(cases);
  std::vector<Withdrawal> out;
  for (const Case& one : cases) {
    for (const std::optional<Placement>& choice : one.choices) {
      if (!choice || all.contains(choice)) continue;
      const auto lacking = std::find_if(cases.begin(), cases.end(), [&](const Case& other) {
        return !other.choices.contains(choice);
      });
      out.push_back({Withdrawal::Reason::unasked, one.observation, *choice,
                     example.at(one.observation), example.at(lacking->observation)});
    }
  }
  return out;
}

}  // namespace

std::optional<int> answer(const Question& question, const Observation& seen) {
  if (question.kind == Question::Kind::cell) {
    const int state = seen.cells[window_index(question.cell)];
    return state == kUnseen ? std::nullopt : std::optional(state);
  }
  if (question.kind == Question::Kind::side) {
    return seen.side ? std::optional(static_cast<int>(*seen.side)) : std::nullopt;
  }
  const std::optional<ColumnTop> top = column_top(seen);
  if (!top) return std::nullopt;
  return question.kind == Question::Kind::top_colour ? top->colour : top->level;
}

Decision make_decision(const Policy& policy) {
  assert(policy.complete);
  std::vector<Case> cases;
  std::map<std::uint32_t, std::uint32_t> example;  // a situation of each observation
  for (std::uint32_t i = 0; i < policy.situations.size(); ++i) {
    const Situation& situation = policy.situations[i];
    if (!policy.reached[situation.state]) continue;
    // One case for each observation: situations that look the same are one to a robot.
    if (!example.emplace(situation.observation, i).second) continue;
    Case one{situation.observation, &policy.observations[situation.observation], {}};
    for (const Placement& placement : policy.allowed[situation.observation]) {
      one.choices.insert(placement);
    }
    if (one.choices.empty()) one.choices.insert(std::nullopt);
    cases.push_back(std::move(one));
  }
  Builder builder(all_questions(policy.observations.front().cells.size()));
  Decision out;
  out.root = builder.build(cases);
  if (!out.root) out.unasked = differences(builder.stuck, example);
  return out;
}

/// Each withdrawal makes the policy smaller, so this ends.
std::unique_ptr<DecisionNode> settle(const TargetBricks& target, Policy& policy, Pruning pruning) {
  prune(target, policy, pruning);
  while (policy.complete) {
    Decision decision = make_decision(policy);
    if (decision.root) return std::move(decision.root);
    for (const Withdrawal& one : decision.unasked) withdraw(policy, one);
    prune(target, policy, pruning);
  }
  return nullptr;
}

namespace {

std::size_t size_of(const DecisionNode& node) {
  std::size_t out = 1;
  for (const auto& [answers, child] : node.branches) out += size_of(*child);
  return out;
}

bool asks_more(const DecisionNode& node) {
  if (!node.question) return false;
  if (!is_of_top(*node.question)) return true;
  return std::any_of(node.branches.begin(), node.branches.end(),
                     [](const auto& branch) { return asks_more(*branch.second); });
}

/// Observations under nodes below the questions about the top, where more is asked. Groups
/// are sets of observations with one top, so each can be simplified by itself.
void gather_groups(const DecisionNode& node, std::vector<std::vector<std::uint32_t>>& out) {
  if (!node.question || !asks_more(node)) return;
  if (!is_of_top(*node.question)) {
    DecisionNode all;
    const std::function<void(const DecisionNode&)> take = [&](const DecisionNode& one) {
      all.observations.insert(all.observations.end(), one.observations.begin(),
                              one.observations.end());
      for (const auto& [answers, child] : one.branches) take(*child);
    };
    take(node);
    out.push_back(std::move(all.observations));
    return;
  }
  for (const auto& [answers, child] : node.branches) gather_groups(*child, out);
}

/// The policy without what the group's observations allow, but where the cell shows this.
Policy only_where(const Policy& policy, const std::vector<std::uint32_t>& group,
                  const Question& question, int shown) {
  Policy out = policy;
  for (const std::uint32_t observation : group) {
    if (answer(question, out.observations[observation]) == shown) continue;
    out.allowed[observation].clear();
  }
  return out;
}

/// The best of all single questions for a group; false when none makes the tree smaller.
/// Tried for all cells and all contents; each trial settles the whole policy, so that it
/// stays complete. This costs much, hence the limit on structures.
bool ask_once(const TargetBricks& target, Policy& policy, std::unique_ptr<DecisionNode>& root,
              const std::vector<std::uint32_t>& group) {
  std::size_t fewest = size_of(*root);
  bool found = false;
  const Policy before = policy;
  for (const Question& question : all_questions(policy.observations.front().cells.size())) {
    if (question.kind != Question::Kind::cell) continue;
    std::set<int> shown;
    for (const std::uint32_t observation : group) {
      if (before.allowed[observation].empty()) continue;
      if (const auto got = answer(question, before.observations[observation])) shown.insert(*got);
    }
    for (const int one : shown) {
      Policy tried = only_where(before, group, question, one);
      auto tree = settle(target, tried, Pruning::at_once);
      if (!tree || size_of(*tree) >= fewest) continue;
      fewest = size_of(*tree);
      policy = std::move(tried);
      root = std::move(tree);
      found = true;
    }
  }
  return found;
}

}  // namespace

std::unique_ptr<DecisionNode> simplify(const TargetBricks& target, Policy& policy,
                                       std::unique_ptr<DecisionNode> root, std::size_t most) {
  assert(root != nullptr);
  if (policy.states.size() > most) return root;
  for (bool better = true; better;) {
    better = false;
    std::vector<std::vector<std::uint32_t>> groups;
    gather_groups(*root, groups);
    for (const auto& group : groups) better = better || ask_once(target, policy, root, group);
  }
  return root;
}

/// Nothing is done wherever an answer is not known, so an unforeseen view is harmless.
std::optional<Placement> decide(const DecisionNode& root, const Observation& seen) {
  const DecisionNode* node = &root;
  while (node->question) {
    const std::optional<int> got = answer(*node->question, seen);
    if (!got) return std::nullopt;
    const auto branch =
        std::find_if(node->branches.begin(), node->branches.end(), [&](const auto& one) {
          return std::find(one.first.begin(), one.first.end(), *got) != one.first.end();
        });
    if (branch == node->branches.end()) return std::nullopt;
    node = branch->second.get();
  }
  return node->placement;
}

}  // namespace stig::compiler
