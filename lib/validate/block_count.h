// SPDX-License-Identifier: MIT
// Where every block of a run is at its end: none may be lost from the count. And what keeps a
// cache from dropping the next one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "physical/scene/scene.h"
#include "validate/uses.h"
#include "validate/watch.h"

namespace stig::validate {

struct BlockCount {
  std::size_t began = 0;      ///< there when the run began
  std::size_t dropped = 0;    ///< came from caches, or were dropped by the scene's script
  std::size_t structure = 0;  ///< bricks, those of the start too
  std::size_t caches = 0;     ///< at rest within the radius of a cache, and no bricks
  std::size_t carried = 0;    ///< in robots' hands
  std::size_t loose = 0;      ///< elsewhere
  std::size_t fixed = 0;      ///< fixed ones that are no bricks, such as walls
  std::size_t left = 0;       ///< have left the arena

  bool adds_up() const {
    return began + dropped == structure + caches + carried + loose + fixed + left;
  }
  friend bool operator==(const BlockCount&, const BlockCount&) = default;
};

/// Counts the blocks in the arena; `began`, `dropped` and `left` are the caller's to set.
BlockCount count_blocks(const std::vector<WatchedBlock>& there, const Watch& watch,
                        const std::vector<CacheSpawn>& caches);

/// "1 and 15 dropped; 15 in the structure, 1 carried", for reports. Says so when that does not add
/// up.
std::string count_text(const BlockCount& count);

/// Why caches have no block that robots would take, a sentence for each that has none. They take no
/// block that shows a brick's colour.
std::vector<std::string> cache_troubles(const RuleSet& rules,
                                        const std::vector<WatchedBlock>& there, const Watch& watch,
                                        const std::vector<CacheSpawn>& caches);

}  // namespace stig::validate
