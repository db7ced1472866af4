// SPDX-License-Identifier: MIT
#include "validate/block_count.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stig::validate {
namespace {

// On the floor: the radius of a cache knows no height, as in the run that fills it.
bool at_cache(const WatchedBlock& block, const CacheSpawn& cache) {
  return std::hypot(block.X_WB.p.x - cache.at.x, block.X_WB.p.y - cache.at.y) < cache.radius;
}

}  // namespace

BlockCount count_blocks(const std::vector<WatchedBlock>& there, const Watch& watch,
                        const std::vector<CacheSpawn>& caches) {
  BlockCount count;
  for (const WatchedBlock& block : there) {
    const bool stored = std::any_of(caches.begin(), caches.end(), [&](const CacheSpawn& cache) {
      return at_cache(block, cache);
    });
    // The order decides for blocks that are two things at once: a brick under an end-effector is
    // part of the structure, a fixed block in a cache is none that the cache can give.
    ++(watch.is_part(block.block) ? count.structure
       : watch.held(block.block)  ? count.carried
       : block.fixed              ? count.fixed
       : stored                   ? count.caches
                                  : count.loose);
  }
  return count;
}

std::string count_text(const BlockCount& count) {
  std::string out = fmt::format("{} and {} dropped", count.began, count.dropped);
  const char* between = "; ";
  for (const auto& [number, where] : {std::pair{count.structure, "in the structure"},
                                      {count.carried, "carried"},
                                      {count.caches, "at caches"},
                                      {count.loose, "loose elsewhere"},
                                      {count.fixed, "fixed elsewhere"},
                                      {count.left, "out of the arena"}}) {
    if (number == 0) continue;
    out += fmt::format("{}{} {}", between, number, where);
    between = ", ";
  }
  return count.adds_up() ? out : out + ": which does not add up";
}

std::vector<std::string> cache_troubles(const RuleSet& rules,
                                        const std::vector<WatchedBlock>& there, const Watch& watch,
                                        const std::vector<CacheSpawn>& caches) {
  std::vector<std::string> out;
  // A cache serves while it has a block that a robot would take, or will have one as soon as a hand
  // has gone. Whatever else lies in its radius keeps the next one from being dropped, for good.
  for (const CacheSpawn& cache : caches) {
    const WatchedBlock* in_the_way = nullptr;
    bool serves = false;
    for (const WatchedBlock& block : there) {
      if (!at_cache(block, cache)) continue;
      // One in a robot's hand is on its way out.
      serves = serves || watch.held(block.block) ||
               (colour_of(rules, block.led) == 0 && !block.fixed && !watch.is_part(block.block));
      in_the_way = &block;
    }
    if (serves) continue;
    const std::string where =
        fmt::format("the cache at ({:.2f}, {:.2f}) m ", cache.at.x, cache.at.y);
    if (in_the_way == nullptr) {
      out.push_back(where + "is empty: its stock is used up, or something stands there");
    } else {
      out.push_back(fmt::format(
          "{}drops no block while one that {} lies at ({:.2f}, {:.2f}) m", where,
          in_the_way->fixed ? "is fixed" : fmt::format("shows {}", to_string(in_the_way->led)),
          in_the_way->X_WB.p.x, in_the_way->X_WB.p.y));
    }
  }
  return out;
}

}  // namespace stig::validate
