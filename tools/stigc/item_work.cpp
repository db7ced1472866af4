// SPDX-License-Identifier: MIT
#include "item_work.h"

#include <atomic>
#include <chrono>
#include <mutex>

#include "app.h"
#include "base/parallel.h"

namespace stig::cli {
namespace {

/// Lines that wait until it is worth while to hand them over: each time costs a wait for the disk.
class Basket {
 public:
  explicit Basket(const TakeLines& take) : take_(take) {}

  void put(std::string line) {
    const std::lock_guard lock(mutex_);
    if (!good_) return;
    lines_.push_back(std::move(line));
    if (Clock::now() - emptied_ >= std::chrono::milliseconds(200)) empty();
  }
  bool close() {
    const std::lock_guard lock(mutex_);
    if (good_ && !lines_.empty()) empty();
    return good_;
  }
  bool good() const { return good_; }

 private:
  using Clock = std::chrono::steady_clock;

  void empty() {
    good_ = take_(lines_);
    lines_.clear();
    emptied_ = Clock::now();
  }

  const TakeLines& take_;
  std::mutex mutex_;
  std::vector<std::string> lines_;
  Clock::time_point emptied_ = Clock::now();
  std::atomic<bool> good_{true};
};

}  // namespace

bool share_among_threads(const std::vector<std::string>& items, int threads, const DoItem& work,
                         const TakeLines& take) {
  Basket basket(take);
  std::atomic<bool> stopped{false};
  run_parallel(
      items.size(), thread_count(threads),
      [&](std::size_t i) {
        std::string line = work(items[i]);
        if (line.empty()) {
          stopped = true;
        } else {
          basket.put(std::move(line));
        }
      },
      [&] { return stop_requested() || stopped || !basket.good(); });
  return basket.close() && !stopped && !stop_requested();
}

Workforce& workforce() {
  static Workforce one;
  return one;
}

}  // namespace stig::cli
