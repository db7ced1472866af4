// SPDX-License-Identifier: MIT
// Values as bytes and back, by one list of members for both directions:
//
//     void each_member(auto& each, EitherWay<Push> auto& push) { each(push.body), each(push.until);
//     }
//
//     BytesOut out;                 BytesIn in(reader);
//     each_member(out, push);       each_member(in, push);
//     out.take();                   in.good();
//
// Bytes from outside may be anything; the reader is bad after whatever is no value. Whether a
// value makes sense is for those to say who know what it means.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "base/bytes.h"
#include "base/vec.h"

namespace stig {

/// T or its const: what a list of members takes, to read it or to write it.
template <class Value, class T>
concept EitherWay = std::is_same_v<std::remove_const_t<Value>, T>;

/// Appends values.
class BytesOut {
 public:
  void operator()(bool value) { out_.push_back(value ? '\1' : '\0'); }
  void operator()(double value) { put(out_, std::bit_cast<std::uint64_t>(value)); }
  void operator()(int value) { put_zigzag(out_, value); }
  void operator()(std::uint32_t value) { put_varint(out_, value); }
  void operator()(std::uint64_t value) { put_varint(out_, value); }
  void operator()(const std::string& value) { put_block(out_, value); }
  /// One of an enumeration whose last value is the second argument.
  template <class Enum>
  void choice(const Enum& value, Enum /*last*/) {
    out_.push_back(static_cast<char>(value));
  }
  template <class List>
  void list(const List& values) {
    put_varint(out_, values.size());
    for (const auto& value : values) each_member(*this, value);
  }
  /// A number that both sides know already.
  void known(std::uint64_t value) { put_varint(out_, value); }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

/// Takes them again.
class BytesIn {
 public:
  explicit BytesIn(ByteReader& in) : in_(in) {}
  void operator()(bool& value) {
    const std::uint8_t byte = in_.u8();
    if (byte > 1) in_.fail();
    value = byte == 1;
  }
  void operator()(double& value) { value = std::bit_cast<double>(in_.u64()); }
  void operator()(int& value) { value = static_cast<int>(in_.zigzag()); }
  void operator()(std::uint32_t& value) {
    const std::uint64_t number = in_.varint();
    if (number > std::numeric_limits<std::uint32_t>::max()) in_.fail();
    value = static_cast<std::uint32_t>(number);
  }
  void operator()(std::uint64_t& value) { value = in_.varint(); }
  void operator()(std::string& value) { value = in_.block(); }
  template <class Enum>
  void choice(Enum& value, Enum last) {
    const std::uint8_t byte = in_.u8();
    if (byte > static_cast<std::uint8_t>(last)) return in_.fail();
    value = static_cast<Enum>(byte);
  }
  template <class List>
  void list(List& values) {
    values.clear();
    const std::uint64_t size = in_.varint();
    // Each takes a byte at least.
    for (std::uint64_t i = 0; i < size && in_.good(); ++i) {
      typename List::value_type value{};
      each_member(*this, value);
      values.push_back(std::move(value));
    }
  }
  void known(std::uint64_t value) {
    if (in_.varint() != value) in_.fail();
  }
  bool good() const { return in_.good(); }

 private:
  ByteReader& in_;
};

/// Numbers, words and what else is written as it is.
template <class Each, class Value>
requires requires(Each& each, Value& value) { each(value); }
void each_member(Each& each, Value& value) { each(value); }
/// Classes list theirs themselves: static void members(auto& each, auto& self).
template <class Each, class Value>
requires requires(Each& each, Value& value) { Value::members(each, value); }
void each_member(Each& each, Value& value) { Value::members(each, value); }

void each_member(auto& each, EitherWay<Vec3> auto& v) { each(v.x), each(v.y), each(v.z); }
void each_member(auto& each, EitherWay<Quat> auto& q) {
  each(q.w), each(q.x), each(q.y), each(q.z);
}
void each_member(auto& each, EitherWay<Pose> auto& pose) {
  each_member(each, pose.p), each_member(each, pose.q);
}

}  // namespace stig
