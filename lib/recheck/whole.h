// SPDX-License-Identifier: MIT
// The structure that a certificate is about, and sets of its bricks.
//
// Seen from a side a cell has three coordinates: u towards the robots there, v to their left, z
// from the floor.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "recheck/uses.h"
#include "recheck/work_certificate.h"
#include "rules/rule_set.h"

namespace stig::recheck {

inline constexpr std::uint32_t kNoBrick = ~std::uint32_t{0};

/// Bricks by number, 64 a word.
class Bricks {
 public:
  explicit Bricks(std::size_t of = 0) : words_((of + 63) / 64, 0) {}
  bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
  void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << i % 64; }
  void remove(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << i % 64); }
  void add(const Bricks& o) {
    for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= o.words_[i];
  }
  bool meets(const Bricks& o) const {
    std::uint64_t both = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) both |= words_[i] & o.words_[i];
    return both != 0;
  }
  bool holds(const Bricks& o) const {
    std::uint64_t lacking = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) lacking |= o.words_[i] & ~words_[i];
    return lacking == 0;
  }
  bool operator==(const Bricks&) const = default;
  bool operator<(const Bricks& other) const { return words_ < other.words_; }

 private:
  std::vector<std::uint64_t> words_;
};

struct Seen {
  int u = 0, v = 0, z = 0;
  auto operator<=>(const Seen&) const = default;
};

class Whole {
 public:
  /// Not empty; no cell twice.
  explicit Whole(const WorkCertificate& certificate);

  std::size_t size() const { return cells_.size(); }
  Cell cell(std::size_t brick) const { return cells_[brick]; }
  Colour colour(std::size_t brick) const { return colours_[brick]; }
  /// Its number, or kNoBrick.
  std::uint32_t at(Cell cell) const;
  std::uint32_t at(int side, Seen place) const;
  Seen seen(int side, std::size_t brick) const {
    return seen_[brick][static_cast<std::size_t>(side)];
  }
  /// Levels from the lowest brick to the highest.
  int levels() const { return levels_; }
  Bricks start() const;

 private:
  std::map<Cell, std::uint32_t> numbers_;
  std::vector<Cell> cells_;
  std::vector<Colour> colours_;
  std::vector<std::array<Seen, 4>> seen_;  ///< by brick and side
  std::size_t start_ = 0;
  std::int32_t floor_ = 0;
  int levels_ = 0;
};

}  // namespace stig::recheck
