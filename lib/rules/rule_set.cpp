// SPDX-License-Identifier: MIT
#include "rules/rule_set.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace stig {
namespace {

auto key(const CountCondition& c) { return std::tuple(c.of.bits(), c.faces_only, c.min, c.max); }
auto key(const Brick& b) { return std::tie(b.symbol, b.name, b.color, b.led); }
auto key(const LegendEntry& e) { return std::tuple(e.symbol, e.states.bits()); }
auto key(const BoxSpec& b) { return std::tie(b.size, b.origin, b.periodic); }
auto key(const PhysicalSpec& p) { return std::tie(p.sides, p.robots); }

struct SameKey {
  template <class T>
  bool operator()(const T& a, const T& b) const {
    return key(a) == key(b);
  }
};

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), SameKey{});
}
template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || key(*a) == key(*b));
}

bool same(const Rule& a, const Rule& b) {
  const auto plain = [](const Rule& r) {
    return std::tie(r.name, r.place, r.pattern.allowed, r.height_min, r.height_max, r.probability,
                    r.weight, r.stage, r.symmetry, r.inversion);
  };
  return plain(a) == plain(b) && same(a.counts, b.counts);
}

bool same(const Expectation& a, const Expectation& b) {
  return std::tie(a.bricks, a.verdict, a.structure) == std::tie(b.bricks, b.verdict, b.structure);
}

}  // namespace

Colour RuleSet::colour_of(std::string_view symbol) const {
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    if (bricks[i].symbol == symbol) return static_cast<Colour>(i + 1);
  }
  return 0;
}

int RuleSet::stage_count() const {
  int highest = 1;
  for (const Rule& rule : rules) highest = std::max(highest, rule.stage);
  return highest;
}

bool operator==(const RuleSet& a, const RuleSet& b) {
  const auto plain = [](const RuleSet& r) {
    return std::tie(r.name, r.title, r.source, r.lattice, r.symmetry, r.inversion, r.floor,
                    r.conflicts, r.start, r.stages);
  };
  const auto same_rule = [](const Rule& x, const Rule& y) { return same(x, y); };
  return plain(a) == plain(b) && same(a.bricks, b.bricks) && same(a.legend, b.legend) &&
         std::equal(a.rules.begin(), a.rules.end(), b.rules.begin(), b.rules.end(), same_rule) &&
         same(a.box, b.box) && same(a.physical, b.physical) &&
         a.expect.has_value() == b.expect.has_value() && (!a.expect || same(*a.expect, *b.expect));
}

std::string_view to_string(Conflicts conflicts) {
  switch (conflicts) {
    case Conflicts::error:
      return "error";
    case Conflicts::random:
      return "random";
    case Conflicts::first:
      return "first";
  }
  assert(false);
  return "";
}

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::coordinated:
      return "coordinated";
    case Verdict::order_dependent:
      return "order-dependent";
    case Verdict::endless:
      return "endless";
  }
  assert(false);
  return "";
}

}  // namespace stig
