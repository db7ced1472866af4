// SPDX-License-Identifier: MIT
// One hash over the listed members of a struct (key_field.h), however deep.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/hash.h"
#include "rules/cell.h"
#include "rules/key_field.h"
#include "rules/rule.h"

namespace stig::rules {

/// Feeds values into one hash; every list is led by its length.
class FieldHash {
 public:
  /// The first `neighbours` entries of a pattern are fed in, which are all that the lattice has.
  explicit FieldHash(int neighbours) : neighbours_(static_cast<std::size_t>(neighbours)) {}

  template <class T>
  requires std::integral<T> || std::is_enum_v<T>
  void add(T value) { add_word(static_cast<std::uint64_t>(static_cast<std::int64_t>(value))); }
  void add(double value) { add_word(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(text.size());
    add_word(hash_text(text));
  }
  void add(StateSet states) { add_word(states.bits()); }
  void add(const Pattern& pattern) {
    for (std::size_t i = 0; i < neighbours_; ++i) add(pattern.allowed[i]);
  }
  void add(Offset o) {
    add(o.x);
    add(o.y);
    add(o.z);
  }
  void add(Cell c) { add(c - Cell{}); }
  /// The same number of words whether it is there or not.
  void add(const std::optional<Cell>& cell) {
    add(cell.has_value());
    add(cell.value_or(Cell{}));
  }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    add(list.size());
    for (const T& value : list) add(value);
  }
  template <class Key, class T>
  void add(const std::map<Key, T>& map) {
    add(map.size());
    for (const auto& [key, value] : map) {
      add(key);
      add(value);
    }
  }
  template <HasFields T>
  void add(const T& object) {
    for_each_pair(object, T{}, [&](const auto& field, const auto& usual) {
      if (field.hashed == Hashed::never) return;
      if (field.hashed == Hashed::when_set) {
        if (same_fields(field.value, usual.value)) return;
        add(field.key);
      }
      add(field.value);
    });
  }

  std::uint64_t value() const { return hash_; }

 private:
  void add_word(std::uint64_t word) { hash_ = combine(hash_, word); }

  std::size_t neighbours_;
  std::uint64_t hash_ = 0;
};

}  // namespace stig::rules
