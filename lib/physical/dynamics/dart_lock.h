// SPDX-License-Identifier: MIT
// DART's objects are made and destroyed by one thread at a time: names and types are
// counted process-wide.
#pragma once

#include <mutex>

#include "physical/dynamics/uses.h"

namespace stig::physics {

inline std::mutex& dart_lock() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace stig::physics
