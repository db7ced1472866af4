// SPDX-License-Identifier: MIT
// A sparse array of bricks in chunks of 8 x 8 x 8 bytes. Chunks never
// move; an open-addressing index finds them. 512 bytes are eight cache lines, and growth
// touches few chunks at a time; a hash entry for each brick would take several times the
// memory of compact structures. Bricks are never removed, so there is no deletion.
#include "lattice/structure.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <random>

#include "base/hash.h"

namespace stig::lattice {
namespace {

constexpr int kShift = 3;
static_assert(1 << kShift == Structure::kChunkSide);

/// Two's complement makes the mask round down for negative coordinates as well.
constexpr Cell chunk_origin(Cell c) {
  constexpr std::int32_t mask = ~(Structure::kChunkSide - 1);
  return {c.x & mask, c.y & mask, c.z & mask};
}

constexpr std::size_t slot_in_chunk(Cell c) {
  constexpr std::int32_t mask = Structure::kChunkSide - 1;
  return static_cast<std::size_t>(((c.z & mask) << (2 * kShift)) | ((c.y & mask) << kShift) |
                                  (c.x & mask));
}

/// Drawn anew by every process, so that no file can be made to fill one slot of the
/// chunk index. Nothing but the time to find a chunk depends on it.
const std::uint64_t kSalt = std::random_device{}();

std::uint64_t chunk_hash(Cell c) {
  constexpr std::uint64_t kBias = 1U << 20;  // 21 bits a coordinate suffice for hashing
  const auto part = [](std::int32_t v) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)) + kBias) & 0x1fffffULL;
  };
  return mix((part(c.x) << 42 | part(c.y) << 21 | part(c.z)) + kSalt * 0x9e3779b97f4a7c15ULL);
}

/// The canonical place of a structure; hashes and files that ignore translation use it.
std::vector<PlacedBrick> shifted_to_origin(std::vector<PlacedBrick> bricks) {
  if (bricks.empty()) return bricks;
  Cell low = bricks.front().at;
  for (const PlacedBrick& b : bricks) {
    low = {std::min(low.x, b.at.x), std::min(low.y, b.at.y), std::min(low.z, b.at.z)};
  }
  for (PlacedBrick& b : bricks) b.at = b.at - (low - Cell{});
  std::sort(bricks.begin(), bricks.end());
  return bricks;
}

/// Images of the bricks at the origin, sorted, under each orientation in turn.
template <class Visit>
void for_each_image(const Structure& structure, Symmetry symmetry, bool inversion,
                    const Visit& visit) {
  const std::vector<PlacedBrick> bricks = structure.bricks();
  for (const Orientation& g : orientations(structure.lattice(), symmetry, inversion)) {
    std::vector<PlacedBrick> image = bricks;
    for (PlacedBrick& b : image) b.at = Cell{} + g.apply(b.at - Cell{});
    visit(shifted_to_origin(std::move(image)));
  }
}

std::uint64_t finish_hash(Lattice lattice, std::size_t bricks, std::uint64_t sum) {
  return combine(combine(static_cast<std::uint64_t>(lattice), bricks), sum);
}

}  // namespace

Structure::Structure(Lattice lattice, const std::vector<PlacedBrick>& bricks) : lattice_(lattice) {
  for (const PlacedBrick& b : bricks) place(b.at, b.brick);
}

const Structure::Chunk* Structure::find(Cell cell) const {
  if (index_.empty()) return nullptr;
  const Cell origin = chunk_origin(cell);
  const std::size_t mask = index_.size() - 1;
  for (std::size_t slot = chunk_hash(origin) & mask; index_[slot] != 0; slot = (slot + 1) & mask) {
    const Chunk* chunk = chunks_[index_[slot] - 1].get();
    if (chunk->origin == origin) return chunk;
  }
  return nullptr;
}

Structure::Chunk& Structure::find_or_make(Cell cell) {
  if (const Chunk* chunk = find(cell)) {
    // The cast saves a second copy of the search.
    return const_cast<Chunk&>(*chunk);  // of this object, which is not const here
  }
  chunks_.emplace_back(chunk_origin(cell));
  // At most half of the index is taken.
  if (chunks_.size() * 2 > index_.size()) {
    grow_index();
  } else {
    insert_in_index(chunks_.size());
  }
  return *chunks_.back();
}

void Structure::insert_in_index(std::size_t number) {
  assert(number >= 1 && number <= chunks_.size());
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = chunk_hash(chunks_[number - 1]->origin) & mask;
  while (index_[slot] != 0) slot = (slot + 1) & mask;
  index_[slot] = static_cast<std::uint32_t>(number);
}

void Structure::grow_index() {
  index_.assign(std::max<std::size_t>(16, index_.size() * 2), 0);
  for (std::size_t number = 1; number <= chunks_.size(); ++number) insert_in_index(number);
}

State Structure::at(Cell cell) const {
  const Chunk* chunk = find(cell);
  return chunk ? chunk->states[slot_in_chunk(cell)] : kEmpty;
}

void Structure::place(Cell cell, Colour colour) {
  assert(colour >= 1 && colour <= kMaxColours);
  State& state = find_or_make(cell).states[slot_in_chunk(cell)];
  assert(state == kEmpty);
  state = colour;
  if (size_++ == 0) bounds_ = {cell, cell};
  bounds_.low = {std::min(bounds_.low.x, cell.x), std::min(bounds_.low.y, cell.y),
                 std::min(bounds_.low.z, cell.z)};
  bounds_.high = {std::max(bounds_.high.x, cell.x), std::max(bounds_.high.y, cell.y),
                  std::max(bounds_.high.z, cell.z)};
}

/// Kept up to date by `place`, since bounds are asked for at every picture and measure.
std::optional<CellBounds> Structure::bounds() const {
  if (empty()) return std::nullopt;
  return bounds_;
}

std::vector<PlacedBrick> Structure::bricks() const {
  std::vector<PlacedBrick> all;
  all.reserve(size_);
  for_each([&](Cell at, Colour colour) { all.push_back({at, colour}); });
  std::sort(all.begin(), all.end());
  return all;
}

/// The engines' inner loop: 125 states around a cell, as 25 words of a row each. Rows of a
/// chunk are eight bytes along x, so a row is at most two loads and a shift.
void Structure::gather(Cell centre, Surroundings& out) const {
  static_assert(std::endian::native == std::endian::little, "rows are moved as words");
  static_assert(kChunkSide == 8);
  const Cell low = centre - Offset{2, 2, 2};
  // Those of a row's five cells from 8 - inside on lie in the next chunk.
  const int inside = low.x & 7;
  const auto row = [](const Chunk* chunk, std::int32_t y, std::int32_t z) {
    std::uint64_t word = 0;
    if (chunk) std::memcpy(&word, chunk->states.data() + slot_in_chunk({0, y, z}), 8);
    return word;
  };
  // Part by part of the box that lies in one chunk, or in two side by side along x.
  for (std::int32_t z0 = low.z; z0 < low.z + 5; z0 = (z0 | 7) + 1) {
    for (std::int32_t y0 = low.y; y0 < low.y + 5; y0 = (y0 | 7) + 1) {
      const Chunk* left = find({low.x, y0, z0});
      const Chunk* right = inside > 3 ? find({low.x + 8, y0, z0}) : nullptr;
      for (std::int32_t z = z0; z <= std::min(z0 | 7, low.z + 4); ++z) {
        for (std::int32_t y = y0; y <= std::min(y0 | 7, low.y + 4); ++y) {
          std::uint64_t word = row(left, y, z) >> (8 * inside);
          if (right) word |= row(right, y, z) << (8 * (8 - inside));
          std::memcpy(&out.at[static_cast<std::size_t>((z - low.z) * 5 + y - low.y) * 8], &word, 8);
        }
      }
    }
  }
}

bool operator==(const Structure& a, const Structure& b) {
  return a.lattice_ == b.lattice_ && a.size_ == b.size_ && a.bricks() == b.bricks();
}

Structure to_origin(const Structure& structure) {
  return {structure.lattice(), shifted_to_origin(structure.bricks())};
}

Structure transformed(const Structure& structure, const Orientation& orientation) {
  std::vector<PlacedBrick> bricks = structure.bricks();
  for (PlacedBrick& b : bricks) b.at = Cell{} + orientation.apply(b.at - Cell{});
  return {structure.lattice(), bricks};
}

Structure canonical(const Structure& structure, Symmetry symmetry, bool inversion) {
  std::vector<PlacedBrick> best;
  for_each_image(structure, symmetry, inversion, [&](std::vector<PlacedBrick> image) {
    if (best.empty() || image < best) best = std::move(image);
  });
  return {structure.lattice(), best};
}

/// Absolute places; a sum of these is invariant under the order of placement and can be
/// maintained brick by brick.
std::uint64_t placement_hash(Cell cell, Colour colour) {
  const auto word = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v));
  };
  return combine(combine(word(cell.x) << 32 | word(cell.y), word(cell.z)), colour);
}

std::uint64_t structure_hash(const Structure& structure) {
  const Offset shift = structure.empty() ? Offset{} : structure.bounds()->low - Cell{};
  std::uint64_t sum = 0;
  structure.for_each([&](Cell at, Colour colour) { sum += placement_hash(at - shift, colour); });
  return finish_hash(structure.lattice(), structure.size(), sum);
}

/// The least hash over the images is a canonical one without building a canonical
/// structure.
std::uint64_t structure_hash(const Structure& structure, Symmetry symmetry, bool inversion) {
  std::optional<std::uint64_t> least;
  for_each_image(structure, symmetry, inversion, [&](const std::vector<PlacedBrick>& image) {
    std::uint64_t sum = 0;
    for (const PlacedBrick& b : image) sum += placement_hash(b.at, b.brick);
    const std::uint64_t h = finish_hash(structure.lattice(), image.size(), sum);
    least = std::min(least.value_or(h), h);
  });
  // There is always an image: the group has the identity, also for no bricks.
  return *least;
}

}  // namespace stig::lattice
