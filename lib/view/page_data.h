// SPDX-License-Identifier: MIT
// The data of a page as its script reads them (tools/viewer/src/packed_data.ts): the size of a JSON
// text as u32, the text, and the bytes that columns of numbers lie in; compressed by zlib, which is
// what browsers unpack by themselves, and written as base64.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "view/uses.h"

namespace stig::view {

/// Collects columns of whole numbers. A column is the zigzag varints of the differences from one
/// number to the next, the first from 0: what grows slowly takes a byte each.
class PageColumns {
 public:
  /// Where the column lies, for the JSON text.
  nlohmann::ordered_json add(std::span<const std::int64_t> numbers);
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Text of the page's data. Bytes of strings that are no UTF-8 are replaced.
std::string page_data(const nlohmann::ordered_json& json, const PageColumns& columns);

/// A zlib stream (RFC 1950).
std::string deflated(std::string_view bytes);

}  // namespace stig::view
