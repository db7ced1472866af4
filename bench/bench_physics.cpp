// SPDX-License-Identifier: MIT
// Prints what the physical world is held to as a markdown table; ends with 1 when one of its
// bounds is broken.
//
//     bench_physics [NAME…]      only trials whose names hold one of these texts
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string_view>

#include "physics_rows.h"
#include "support/uses.h"

namespace {

std::size_t live = 0, peak = 0;

void* count_new(std::size_t size) {
  void* p = std::malloc(size);
  if (p == nullptr) throw std::bad_alloc();
  live += malloc_usable_size(p);
  peak = std::max(peak, live);
  return p;
}

void count_delete(void* p) noexcept {
  if (p != nullptr) live -= malloc_usable_size(p);
  std::free(p);
}

}  // namespace

// One thread: nothing here is atomic.
void* operator new(std::size_t size) { return count_new(size); }
void* operator new[](std::size_t size) { return count_new(size); }
void operator delete(void* p) noexcept { count_delete(p); }
void operator delete[](void* p) noexcept { count_delete(p); }
void operator delete(void* p, std::size_t) noexcept { count_delete(p); }
void operator delete[](void* p, std::size_t) noexcept { count_delete(p); }

namespace stig::bench {

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
std::size_t allocated_bytes() { return live; }
std::size_t peak_bytes(bool reset) {
  if (reset) peak = live;
  return peak;
}

namespace {

bool chosen(const Trial& trial, int argc, char** argv) {
  const auto names = [&trial](const char* text) {
    return std::string_view(trial.name).find(text) != std::string_view::npos;
  };
  return argc == 1 || std::any_of(argv + 1, argv + argc, names);
}

/// Rows that are held to nothing are measured for what is decided by them.
const char* mark_of(const Row& row) {
  if (row.held_to.empty()) return "";
  return row.held ? "held" : "**not held**";
}

int run(int argc, char** argv) {
  Diagnostics diagnostics;
  const auto block = read_block_file(STIG_SOURCE_DIR "/blocks/stigmergic.yaml", diagnostics);
  if (!block) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
  }
  bool held = true;
  fmt::print("| trial | what | held to | measured | DART's step | |\n|---|---|---|---|---|---|\n");
  for (const auto* trials : {&kFigureTrials, &kSpeedTrials}) {
    for (const Trial& trial : *trials) {
      if (!chosen(trial, argc, argv)) continue;
      for (const Row& row : trial.run(*block)) {
        fmt::print("| `{}` | {} | {} | {} | {} | {} |\n", trial.name, row.what, row.held_to,
                   row.measured, row.stock, mark_of(row));
        std::fflush(stdout);
        held = held && row.held;
      }
    }
  }
  return held ? 0 : 1;
}

}  // namespace
}  // namespace stig::bench

int main(int argc, char** argv) { return stig::bench::run(argc, argv); }
