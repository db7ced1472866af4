// SPDX-License-Identifier: MIT
#include <bit>

#include "base/hash.h"
#include "rules/rule_printer.h"

namespace stig {

namespace {

/// Feeds values into one hash; every list is led by its length.
class Hasher {
 public:
  void add(std::uint64_t value) { hash_ = combine(hash_, value); }
  void add_signed(std::int64_t value) { add(static_cast<std::uint64_t>(value)); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    add(hash_text(text));
  }
  void add(Cell c) {
    add_signed(c.x);
    add_signed(c.y);
    add_signed(c.z);
  }
  template <class T>
  void add_optional(const std::optional<T>& value) {
    add(std::uint64_t{value.has_value()});
    if (value) add_signed(static_cast<std::int64_t>(*value));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

void add_rule(Hasher& hasher, const Rule& rule, Lattice lattice) {
  hasher.add(std::uint64_t{rule.place});
  for (int i = 0; i < neighbourhood(lattice).size; ++i) {
    hasher.add(rule.pattern.allowed[static_cast<std::size_t>(i)].bits());
  }
  hasher.add_optional(rule.height_min);
  hasher.add_optional(rule.height_max);
  hasher.add(std::uint64_t{rule.counts.size()});
  for (const CountCondition& count : rule.counts) {
    hasher.add(count.of.bits());
    hasher.add(std::uint64_t{count.faces_only});
    hasher.add_signed(count.min);
    hasher.add_signed(count.max);
  }
  hasher.add(rule.probability);
  hasher.add(rule.weight);
  hasher.add_signed(rule.stage);
  hasher.add_optional(rule.symmetry);
  hasher.add_optional(rule.inversion);
}

}  // namespace

std::uint64_t rule_set_hash(const RuleSet& rules) {
  Hasher hasher;
  hasher.add_signed(static_cast<std::int64_t>(rules.lattice));
  hasher.add_signed(static_cast<std::int64_t>(rules.symmetry));
  hasher.add(std::uint64_t{rules.inversion});
  hasher.add(std::uint64_t{rules.floor});
  hasher.add_signed(static_cast<std::int64_t>(rules.conflicts));
  hasher.add(std::uint64_t{rules.bricks.size()});
  for (const Brick& brick : rules.bricks) {
    hasher.add(brick.symbol);
    hasher.add(brick.led);
  }
  hasher.add(std::uint64_t{rules.start.size()});
  for (const PlacedBrick& brick : rules.start) {
    hasher.add(brick.at);
    hasher.add(std::uint64_t{brick.brick});
  }
  hasher.add(std::uint64_t{rules.rules.size()});
  for (const Rule& rule : rules.rules) add_rule(hasher, rule, rules.lattice);
  hasher.add(std::uint64_t{rules.stages.size()});
  for (const auto& [stage, deposits] : rules.stages) {
    hasher.add_signed(stage);
    hasher.add_signed(deposits);
  }
  hasher.add(std::uint64_t{rules.box.has_value()});
  if (rules.box) {
    hasher.add(Cell{} + rules.box->size);
    hasher.add(std::uint64_t{rules.box->origin.has_value()});
    hasher.add(rules.box->origin.value_or(Cell{}));
    hasher.add(std::uint64_t{rules.box->periodic});
  }
  return hasher.value();
}

}  // namespace stig
