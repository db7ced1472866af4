// SPDX-License-Identifier: MIT
// What a program has read since it began, packed. A program's own state cannot be saved; but
// given the same readings once more, a fresh one comes to the same state.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "physical/robots/uses.h"

namespace stig::physics {

class ReadingHistory {
 public:
  void add(std::string_view record);
  /// Hands the records to `next`, which takes one at a time from the reader; until the end, or
  /// until it or the reader finds something wrong: then false.
  bool each(const std::function<bool(ByteReader&)>& next) const;

  static void members(auto& each, auto& history) {
    each.list(history.packed_), each(history.last_);
  }

 private:
  std::vector<std::string> packed_;
  std::string last_;  ///< not packed yet
};

}  // namespace stig::physics
