// SPDX-License-Identifier: MIT
// A structure: a finite map cell -> brick colour that only grows, unbounded in
// every direction. Stored as a hash map of 8×8×8 chunks of bytes.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "lattice/uses.h"
#include "rules/rule_set.h"
#include "rules/symmetry.h"

namespace stig::lattice {

/// Bounding box, both corners inclusive.
struct CellBounds {
  Cell low, high;
  Offset size() const { return high - low + Offset{1, 1, 1}; }
  bool operator==(const CellBounds&) const = default;
};

/// The 5×5×5 states around a cell: all that the views of its neighbours see. Rows are
/// padded to 8 bytes, as they are in a structure's chunks.
struct Surroundings {
  std::array<State, 5 * 5 * 8> at{};
  static constexpr int index(int dx, int dy, int dz) {
    return ((dz + 2) * 5 + (dy + 2)) * 8 + (dx + 2);
  }
  static constexpr int kLevel = 5 * 8;  ///< entries of one level, the lowest first
};

class Structure {
 public:
  static constexpr int kChunkSide = 8;

  explicit Structure(Lattice lattice = Lattice::cubic) : lattice_(lattice) {}
  Structure(Lattice lattice, const std::vector<PlacedBrick>& bricks);

  Lattice lattice() const { return lattice_; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  /// kEmpty or a colour.
  State at(Cell cell) const;
  /// The cell must be empty and the colour 1..kMaxColours (asserted).
  void place(Cell cell, Colour colour);

  /// Nothing for an empty structure.
  std::optional<CellBounds> bounds() const;
  /// All bricks in the order of cells (lexicographic): the deterministic iteration.
  std::vector<PlacedBrick> bricks() const;
  /// Calls visit(cell, colour) for every brick in an order that depends on how the
  /// structure grew: for sums and sets alone.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const OwnChunk& chunk : chunks_) {
      for (std::size_t row = 0; row < chunk->states.size(); row += kChunkSide) {
        std::uint64_t word = 0;  // most rows are empty
        std::memcpy(&word, chunk->states.data() + row, kChunkSide);
        for (std::size_t i = row; word != 0 && i < row + kChunkSide; ++i) {
          if (chunk->states[i] != kEmpty) visit(cell_in_chunk(chunk->origin, i), chunk->states[i]);
        }
      }
    }
  }
  /// States of the cells around `centre`, without floor.
  void gather(Cell centre, Surroundings& out) const;

  /// Equal lattice, cells and colours.
  friend bool operator==(const Structure& a, const Structure& b);

 private:
  struct Chunk {
    Cell origin;  ///< lowest cell
    alignas(8) std::array<State, kChunkSide * kChunkSide * kChunkSide> states{};
  };
  /// A chunk of its own: growth and moves of the list leave it where it is.
  struct OwnChunk : std::unique_ptr<Chunk> {
    explicit OwnChunk(Cell origin) : std::unique_ptr<Chunk>(new Chunk{origin, {}}) {}
    OwnChunk(const OwnChunk& other) : std::unique_ptr<Chunk>(new Chunk(*other)) {}
    OwnChunk(OwnChunk&&) noexcept = default;
    OwnChunk& operator=(OwnChunk other) noexcept {
      swap(other);
      return *this;
    }
  };
  static constexpr Cell cell_in_chunk(Cell origin, std::size_t i) {
    const auto n = static_cast<std::int32_t>(i);
    return origin +
           Offset{n % kChunkSide, n / kChunkSide % kChunkSide, n / (kChunkSide * kChunkSide)};
  }
  const Chunk* find(Cell cell) const;
  Chunk& find_or_make(Cell cell);
  void insert_in_index(std::size_t number);  ///< 1 + position in chunks_
  void grow_index();

  Lattice lattice_;
  std::size_t size_ = 0;
  CellBounds bounds_{};
  std::vector<OwnChunk> chunks_;
  std::vector<std::uint32_t> index_;  ///< open addressing: 1 + position in chunks_, 0 free
};

/// Translated so that its lowest corner is (0, 0, 0).
Structure to_origin(const Structure& structure);
/// Image under an orientation (about the cell (0, 0, 0)).
Structure transformed(const Structure& structure, const Orientation& orientation);
/// The smallest, as a list of bricks at the origin, of the images under the group.
Structure canonical(const Structure& structure, Symmetry symmetry, bool inversion);

/// 64-bit hash of lattice, shape and colours modulo translation; the same on every
/// machine and in every version that reads the same traces.
std::uint64_t structure_hash(const Structure& structure);
/// The same modulo the symmetry group too.
std::uint64_t structure_hash(const Structure& structure, Symmetry symmetry, bool inversion);
/// Term of one brick in a hash of absolute places that is a plain sum over bricks,
/// so that it can be kept up to date while the structure grows.
std::uint64_t placement_hash(Cell cell, Colour colour);

}  // namespace stig::lattice
