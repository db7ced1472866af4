// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cassert>

#if STIG_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace stig {

namespace {

// As much as the system gives the first thread; oneTBB's own default is half of it.
constexpr std::size_t kStackBytes = std::size_t{8} << 20;

/// oneTBB's library is built without the thread sanitizer, which does not see that what was
/// written before a piece of work is begun, or in it before it ends, is read after that.
struct Order {
#if STIG_THREAD_SANITIZER
  void before() { __tsan_release(this); }
  void after() { __tsan_acquire(this); }
#else
  void before() {}
  void after() {}
#endif
};

struct Piece {
  explicit Piece(Order& o) : order(o) { order.after(); }
  ~Piece() { order.before(); }
  Piece(const Piece&) = delete;
  Piece& operator=(const Piece&) = delete;
  Order& order;
};

struct Whole {
  explicit Whole(Order& o) : order(o) { order.before(); }
  ~Whole() { order.after(); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  Order& order;
};

}  // namespace

int thread_count(int wish) { return wish > 0 ? wish : tbb::info::default_concurrency(); }

void run_parallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stop) {
  assert(work);
  const std::size_t most = std::min(static_cast<std::size_t>(std::max(threads, 1)), count);
  if (most == 0) return;
  // More threads than there are cores only where this says so.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, most);
  const tbb::global_control stack(tbb::global_control::thread_stack_size, kStackBytes);
  tbb::task_arena arena(static_cast<int>(most));
  std::size_t next = 0;
  Order order;
  const auto begin = [&](tbb::flow_control& control) {
    const Piece piece(order);
    if (next == count || (stop && stop())) control.stop();
    return next++;
  };
  const auto run = [&](std::size_t i) {
    const Piece piece(order);
    work(i);
  };
  const Whole whole(order);
  arena.execute([&] {
    // At most `most` pieces run at a time, and the earliest are begun first.
    tbb::parallel_pipeline(
        most, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, begin) &
                  tbb::make_filter<std::size_t, void>(tbb::filter_mode::parallel, run));
  });
}

}  // namespace stig
