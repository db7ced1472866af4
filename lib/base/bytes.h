// SPDX-License-Identifier: MIT
// Little-endian numbers, LEB128 varints and length-prefixed blocks in and out of
// strings of bytes.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace stig {

/// Appends a number of 1, 2, 4 or 8 bytes.
template <class Number>
void put(std::string& out, Number value) {
  static_assert(std::is_integral_v<Number> || std::is_same_v<Number, float>);
  if constexpr (std::is_same_v<Number, float>) {
    put(out, std::bit_cast<std::uint32_t>(value));
  } else {
    const auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      out.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
    }
  }
}

inline void put_varint(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out.push_back(static_cast<char>(value | 0x80));
  out.push_back(static_cast<char>(value));
}
/// Small numbers of either sign in few bytes.
inline void put_zigzag(std::string& out, std::int64_t value) {
  put_varint(out, static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
}
inline void put_block(std::string& out, std::string_view bytes) {
  put_varint(out, bytes.size());
  out += bytes;
}

/// Reads from the front of a string of bytes. A read past the end gives zeros and
/// makes the reader bad for good, so that one check after several reads will do.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  bool good() const { return good_; }
  std::size_t left() const { return left_.size(); }

  std::uint8_t u8() { return static_cast<std::uint8_t>(number(1)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  std::uint64_t u64() { return number(8); }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }

  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = u8();
      value |= std::uint64_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return value;
    }
    fail();  // longer than any 64-bit number
    return 0;
  }
  std::int64_t zigzag() {
    const std::uint64_t value = varint();
    return static_cast<std::int64_t>(value >> 1 ^ (0 - (value & 1)));
  }
  /// Bytes behind their number.
  std::string_view block() {
    const std::uint64_t size = varint();
    return take(size);
  }
  void fail() {
    left_ = {};
    good_ = false;
  }

  /// The next `size` bytes; empty, and bad, when there are fewer.
  std::string_view take(std::size_t size) {
    if (size > left_.size()) {
      fail();
      return {};
    }
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }

 private:
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    const std::string_view bytes = take(size);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    }
    return value;
  }

  std::string_view left_;
  bool good_ = true;
};

}  // namespace stig
