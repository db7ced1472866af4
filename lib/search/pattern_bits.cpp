// SPDX-License-Identifier: MIT
// Most cells of most patterns either do not matter or must be empty. So every bit is set first, and
// those are cleared that a pattern excludes.
#include "search/pattern_bits.h"

#include <algorithm>
#include <bit>

namespace stig::search {
namespace {

/// The groups of both lattices, made once: their elements have names, which take longer to make
/// than a candidate may take in all.
const std::vector<Orientation>& group_of(const Genome& genome) {
  static const auto kGroups = [] {
    std::array<std::array<std::vector<Orientation>, 3>, 2> groups;
    for (std::size_t l = 0; l < 2; ++l) {
      for (std::size_t s = 0; s < 3; ++s) {
        groups[l][s] =
            rules::orientations(static_cast<Lattice>(l), static_cast<Symmetry>(s), false);
      }
    }
    return groups;
  }();
  return kGroups[static_cast<std::size_t>(genome.lattice)]
                [static_cast<std::size_t>(genome.symmetry)];
}

std::size_t size_of(const Genome& genome) {
  return static_cast<std::size_t>(neighbourhood(genome.lattice).size);
}

}  // namespace

void PatternBits::compile(const Genome& genome, std::int32_t low, std::int32_t high) {
  orientations_ = group_of(genome).size();
  const std::size_t patterns = genome.rules.size() * orientations_;
  words_ = (patterns + 63) / 64;
  all_.assign(words_, ~std::uint64_t{0});
  if (patterns % 64 != 0) all_.back() = (std::uint64_t{1} << patterns % 64) - 1;
  accept_all(genome);
  asked_.fill(false);
  for (std::size_t r = 0; r < genome.rules.size(); ++r) exclude(genome, r);
  for (std::size_t i = 0; i < size_of(genome); ++i) {
    const auto empty = accept_.begin() + static_cast<std::ptrdiff_t>(i * kRows * words_);
    std::copy_n(empty, words_, empty + static_cast<std::ptrdiff_t>(kRowOutside * words_));
  }
  limit_heights(genome, low, high);
  sort_neighbours(size_of(genome));
}

/// Rows of colours that the genome does not have are never read, and are left as they are.
void PatternBits::accept_all(const Genome& genome) {
  accept_.resize(kMaxNeighbours * kRows * words_);
  const auto colours = static_cast<std::size_t>(genome.colours);
  for (std::size_t i = 0; i < size_of(genome); ++i) {
    std::uint64_t* rows = &accept_[i * kRows * words_];
    for (std::size_t row = 0; row <= colours; ++row) {
      std::copy_n(all_.data(), words_, rows + row * words_);
    }
    std::copy_n(all_.data(), words_, rows + kRowFloor * words_);
  }
}

void PatternBits::exclude(const Genome& genome, std::size_t rule) {
  const std::vector<Orientation>& group = group_of(genome);
  const CellGene shown = ((CellGene{2} << genome.colours) - 1) | kGeneFloor;
  for (std::size_t i = 0; i < size_of(genome); ++i) {
    const CellGene excluded = shown & ~genome.rules[rule].when[i];
    if (excluded == 0) continue;
    for (std::size_t g = 0; g < group.size(); ++g) {
      const auto image = static_cast<std::size_t>(group[g].image[i]);
      const std::size_t bit = rule * group.size() + g;
      const std::uint64_t kept = ~(std::uint64_t{1} << bit % 64);
      std::uint64_t* word = &accept_[image * kRows * words_ + bit / 64];
      asked_[image] = true;
      // Rows are numbered as the bits of a gene are.
      for (CellGene rest = excluded; rest != 0; rest &= rest - 1) {
        word[static_cast<std::size_t>(std::countr_zero(rest)) * words_] &= kept;
      }
    }
  }
}

void PatternBits::limit_heights(const Genome& genome, std::int32_t low, std::int32_t high) {
  low_ = low;
  limited_ = std::any_of(genome.rules.begin(), genome.rules.end(), [](const GeneRule& rule) {
    return rule.height_min != kNoHeightMin || rule.height_max != kNoHeightMax;
  });
  if (!limited_) return;
  heights_.resize(static_cast<std::size_t>(high - low + 1) * words_);
  for (std::int32_t z = low; z <= high; ++z) {
    std::uint64_t* level = &heights_[static_cast<std::size_t>(z - low) * words_];
    std::copy_n(all_.data(), words_, level);
    for (std::size_t r = 0; r < genome.rules.size(); ++r) {
      const GeneRule& rule = genome.rules[r];
      if (z >= rule.height_min && z <= rule.height_max) continue;
      for (std::size_t bit = r * orientations_; bit < (r + 1) * orientations_; ++bit) {
        level[bit / 64] &= ~(std::uint64_t{1} << bit % 64);
      }
    }
  }
}

/// Views are mostly empty, so the neighbours at which few patterns accept emptiness exclude most.
void PatternBits::sort_neighbours(std::size_t size) {
  std::array<int, kMaxNeighbours> accepting_empty{};
  order_.clear();
  for (std::size_t i = 0; i < size; ++i) {
    if (!asked_[i]) continue;
    for (std::size_t w = 0; w < words_; ++w) {
      accepting_empty[i] += std::popcount(accepting(i, 0, w));
    }
    order_.push_back(static_cast<std::uint8_t>(i));
  }
  std::sort(order_.begin(), order_.end(), [&](std::uint8_t a, std::uint8_t b) {
    return std::pair(accepting_empty[a], a) < std::pair(accepting_empty[b], b);
  });
}

}  // namespace stig::search
