// SPDX-License-Identifier: MIT
#include "base/parallel.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace stig;

TEST_CASE("every piece is done once, in places of its own alike for any number of threads") {
  for (const int threads : {-1, 1, 2, 7, 100}) {
    CAPTURE(threads);
    std::vector<std::size_t> done(50, 0);
    run_parallel(done.size(), threads, [&](std::size_t i) { done[i] += i + 1; });
    for (std::size_t i = 0; i < done.size(); ++i) CHECK(done[i] == i + 1);
  }
  run_parallel(0, 4, [](std::size_t) { FAIL("there is none"); });
}

TEST_CASE("as many at a time as there are threads, and the earliest first") {
  constexpr std::size_t kPieces = 40, kThreads = 3;
  std::mutex mutex;
  std::vector<bool> begun(kPieces, false);
  std::size_t under_way = 0, most = 0;
  bool in_order = true;
  run_parallel(kPieces, kThreads, [&](std::size_t i) {
    {
      const std::lock_guard lock(mutex);
      begun[i] = true;
      most = std::max(most, ++under_way);
      // At most two others can be between their turn and this line.
      const auto missing = std::count(begun.begin(), begun.begin() + long(i), false);
      in_order = in_order && missing < long(kThreads);
    }
    std::this_thread::yield();
    const std::lock_guard lock(mutex);
    --under_way;
  });
  CHECK(in_order);
  CHECK(most <= kThreads);
}

TEST_CASE("two threads do work at the same time, also where there is one core") {
  // Each of the two pieces waits for the other to begin.
  std::atomic<int> begun{0};
  run_parallel(2, 2, [&](std::size_t) {
    ++begun;
    while (begun < 2) std::this_thread::yield();
  });
  CHECK(begun == 2);
}

TEST_CASE("a stop lets what is begun end, and begins nothing more") {
  std::atomic<bool> stop{false};
  std::vector<int> done(30, 0);
  run_parallel(
      done.size(), 1,
      [&](std::size_t i) {
        if (i == 4) stop = true;
        done[i] = 1;
      },
      [&] { return stop.load(); });
  CHECK(std::count(done.begin(), done.end(), 1) == 5);
  CHECK(done[4] == 1);
}

TEST_CASE("what a piece throws reaches the caller, and the rest is left") {
  std::atomic<int> begun{0};
  const auto work = [&](std::size_t i) {
    ++begun;
    if (i == 3) throw std::runtime_error("the third");
  };
  CHECK_THROWS_WITH_AS(run_parallel(1000, 1, work), "the third", std::runtime_error);
  CHECK(begun == 4);
  CHECK_THROWS_AS(run_parallel(1000, 4, work), std::runtime_error);
}

TEST_CASE("a wish for threads is heeded, and none means every core") {
  CHECK(thread_count(3) == 3);
  CHECK(thread_count(1) == 1);
  CHECK(thread_count(0) >= 1);
}
