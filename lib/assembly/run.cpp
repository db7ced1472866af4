// SPDX-License-Identifier: MIT
#include "assembly/run.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace stig::assembly {

namespace {

constexpr std::array<Offset, 4> kAlong = {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}};

/// Has the cell no neighbours but those two?
bool alone_but_for(const TargetBricks& target, Cell cell, Cell one, Cell other) {
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dz = -1; dz <= 1; ++dz) {
        const Cell beside = cell + Offset{dx, dy, dz};
        if (beside == cell || beside == one || beside == other) continue;
        if (target.brick_at(beside) != TargetBricks::kNone) return false;
      }
    }
  }
  return true;
}

/// The run that ends freely in this cell, in this direction; empty when there is none.
FreeRun run_to(const TargetBricks& target, Cell end, Offset ahead) {
  FreeRun out;
  if (target.brick_at(end + ahead) != TargetBricks::kNone) return out;
  if (!alone_but_for(target, end + ahead, end, end)) return out;
  for (Cell at = end;; at = at - ahead) {
    if (target.brick_at(at) == TargetBricks::kNone) break;
    out.push_back(at);
    if (!alone_but_for(target, at, at - ahead, at + ahead)) break;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

/// Could the start be here, as far as the run is concerned?
bool suits(const FreeRun& run, Cell start, std::size_t colours) {
  const std::size_t n = run.size() - 1;
  const auto at = std::find(run.begin(), run.end(), start);
  if (at == run.end() || at == run.begin()) return n < colours;
  const auto j = static_cast<std::size_t>(at - run.begin());
  return n - j < colours && j < colours;
}

}  // namespace

std::vector<FreeRun> runs_too_long(const TargetBricks& target, std::optional<std::uint32_t> start,
                                   int colours) {
  assert(colours > 0);
  const auto most = static_cast<std::size_t>(colours);
  std::vector<Cell> starts;  // that are left; of long runs only, since others suit none of them
  std::vector<FreeRun> out;
  for (std::size_t i = 0; i < target.bricks(); ++i) {
    for (const Offset ahead : kAlong) {
      FreeRun run = run_to(target, target.cell(i), ahead);
      if (run.size() <= most) continue;
      if (out.empty()) starts = start ? FreeRun{target.cell(*start)} : run;
      const auto unsuited = [&](Cell one) { return !suits(run, one, most); };
      if (std::none_of(starts.begin(), starts.end(), unsuited)) continue;
      std::erase_if(starts, unsuited);
      out.push_back(std::move(run));
      if (starts.empty()) return out;
    }
  }
  return {};
}

}  // namespace stig::assembly
