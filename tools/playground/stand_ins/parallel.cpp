// SPDX-License-Identifier: MIT
// One thread, in place of lib/base/parallel.cpp: pages opened from disk have no others to share
// memory with.
#include "base/parallel.h"

#include <cassert>

namespace stig {

int thread_count(int) { return 1; }

void run_parallel(std::size_t count, int, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stop) {
  assert(work);
  for (std::size_t i = 0; i < count && !(stop && stop()); ++i) work(i);
}

}  // namespace stig
