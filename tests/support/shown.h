// SPDX-License-Identifier: MIT
// Structs as texts that differ when any of their members do; places in source files apart.
//
//     template <>
//     struct MembersOf<AxisRef> {
//       static auto of(const AxisRef& o) {
//         const auto& [joint, axis] = o;
//         return std::tie(joint, axis);
//       }
//     };
//     shown(robot.drive->left);   // "[(0, 0), (1, 0)]"
//
// The structured binding names every member, so that a new one does not compile until it stands
// there.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

#include "base/rgb.h"
#include "base/source.h"
#include "base/vec.h"
#include "support/uses.h"

namespace stig {

template <class T>
struct MembersOf;

template <class T>
std::string shown(const T& value);

/// One after the other, however many.
template <class... Values>
std::string shown_all(const Values&... values) {
  std::string out;
  ((out += (out.empty() ? "" : ", ") + shown(values)), ...);
  return "(" + out + ")";
}

template <class... Values>
std::string shown_tuple(const std::tuple<Values...>& values) {
  return std::apply([](const auto&... each) { return shown_all(each...); }, values);
}

template <class T>
std::string shown(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return std::to_string(static_cast<int>(value));
  } else if constexpr (std::is_arithmetic_v<T>) {
    return fmt::format("{}", value);
  } else if constexpr (std::convertible_to<const T&, std::string_view>) {
    return fmt::format("'{}'", std::string_view(value));
  } else if constexpr (std::same_as<T, SourceRange> || std::same_as<T, SourceRef>) {
    return "somewhere";
  } else if constexpr (requires { value.has_value(); }) {
    return value ? shown(*value) : "nothing";
  } else if constexpr (requires { value.valueless_by_exception(); }) {
    return fmt::format("{}: {}", value.index(),
                       std::visit([](const auto& one) { return shown(one); }, value));
  } else if constexpr (requires { value.begin(); }) {
    std::string out;
    for (const auto& one : value) out += (out.empty() ? "" : ", ") + shown(one);
    return "[" + out + "]";
  } else {
    return shown_tuple(MembersOf<T>::of(value));
  }
}

template <class A, class B>
struct MembersOf<std::pair<A, B>> {
  static auto of(const std::pair<A, B>& o) { return std::tie(o.first, o.second); }
};
template <>
struct MembersOf<Vec3> {
  static auto of(const Vec3& o) { return std::tie(o.x, o.y, o.z); }
};
template <>
struct MembersOf<Quat> {
  static auto of(const Quat& o) { return std::tie(o.w, o.x, o.y, o.z); }
};
template <>
struct MembersOf<Pose> {
  static auto of(const Pose& o) { return std::tie(o.p, o.q); }
};
template <>
struct MembersOf<Rgb> {
  static auto of(const Rgb& o) { return std::tie(o.r, o.g, o.b); }
};

}  // namespace stig
