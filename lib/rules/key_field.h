// SPDX-License-Identifier: MIT
// The members of a struct as a list, each with the key under which a rule set file has it.
//
// Beside each struct that a file describes stands one function that lists its members:
//
//     template <SameButConst<Brick> B>
//     auto fields(B& brick) {
//       auto& [symbol, name, color, led, range] = brick;
//       return std::tuple(KeyField{"name", name, Hashed::never}, …);
//     }
//
// The hash, the comparison, the printer, the reader of plain values, and the generators of
// the tests fold over that list, so that none of them can forget a member. The structured
// binding names every member: a new one does not compile until it stands there too. Members
// that are bound but not listed say where in the file something stands, and its comments.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace stig::rules {

/// Does a member enter rule_set_hash?
enum class Hashed : std::uint8_t {
  never,    ///< words for people, and what is assumed or expected
  always,   ///< meaning
  when_set  ///< meaning, of a key that is younger than hashes in use: with its key, and only
            ///< where it differs from the default, so that other rule sets keep their hash
};

/// A member under its key. `a/b` is the key b of a mapping under the key a; a member that
/// stands for a key of its own (a brick's symbol) has none.
template <class T>
struct KeyField {
  std::string_view key;
  T& value;
  Hashed hashed = Hashed::always;
};
template <class T>
KeyField(std::string_view, T&) -> KeyField<T>;
template <class T>
KeyField(std::string_view, T&, Hashed) -> KeyField<T>;

template <class T, class Plain>
concept SameButConst = std::same_as<std::remove_const_t<T>, Plain>;

/// A struct whose members are listed.
template <class T>
concept HasFields = requires(T& object) {
  fields(object);
};

template <HasFields T, class Visit>
void for_each_field(T& object, Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, fields(object));
}

/// visit(field of a, field of b), member by member.
template <HasFields T, class Visit>
void for_each_pair(const T& a, const T& b, Visit&& visit) {
  const auto of_a = fields(a), of_b = fields(b);
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(std::get<I>(of_a), std::get<I>(of_b)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(of_a)>>());
}

/// Equal in all that is listed, however deep.
template <class T>
bool same_fields(const T& a, const T& b) {
  return a == b;
}
template <HasFields T>
bool same_fields(const T& a, const T& b);
template <class T>
bool same_fields(const std::optional<T>& a, const std::optional<T>& b);
template <class T>
bool same_fields(const std::vector<T>& a, const std::vector<T>& b);

template <HasFields T>
bool same_fields(const T& a, const T& b) {
  bool same = true;
  for_each_pair(a, b, [&](const auto& of_a, const auto& of_b) {
    same = same && same_fields(of_a.value, of_b.value);
  });
  return same;
}
template <class T>
bool same_fields(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same_fields(*a, *b));
}
template <class T>
bool same_fields(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& x, const T& y) { return same_fields(x, y); });
}

}  // namespace stig::rules
