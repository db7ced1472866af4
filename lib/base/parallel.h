// SPDX-License-Identifier: MIT
// Independent pieces of work in several threads, which are oneTBB's.
#pragma once

#include <cstddef>
#include <functional>

namespace stig {

/// The number of threads for a wish: the wish itself, or one for each core that the process may
/// use where it is 0.
int thread_count(int wish);

/// Calls work(0) to work(count - 1), each once, in at most `threads` threads, of which the
/// caller's is one; returns when all that were begun have ended. They are begun in rising order,
/// none any more once `stop` says so or one has thrown; what it threw is thrown from here.
/// Results that each piece writes to a place of its own are the same for any number of threads.
void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stop = {});

}  // namespace stig
