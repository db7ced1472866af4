// SPDX-License-Identifier: MIT
// Everything that a controller has read in a run, compressed in chunks: similar readings follow
// each other, and a chunk is packed once it is full, so memory grows by what zstd leaves of it. The
// last chunk stays open.
#include "physical/robots/reading_history.h"

#include <algorithm>

#include "base/packed.h"

namespace stig::physics {

namespace {

constexpr std::size_t kChunk = std::size_t{1} << 16;
/// One record may be long: as many messages as there are senders.
constexpr std::size_t kMostChunk = std::size_t{1} << 28;

// Records carry no length: their reader knows where each ends, or has failed.
bool read_all(std::string_view bytes, const std::function<bool(ByteReader&)>& next) {
  ByteReader in(bytes);
  while (in.left() > 0) {
    if (!next(in) || !in.good()) return false;
  }
  return true;
}

}  // namespace

void ReadingHistory::add(std::string_view record) {
  last_ += record;
  if (last_.size() < kChunk) return;
  packed_.push_back(packed(last_));
  last_.clear();
}

bool ReadingHistory::each(const std::function<bool(ByteReader&)>& next) const {
  const auto whole = [&](const std::string& chunk) {
    const auto bytes = unpacked(chunk, kMostChunk);
    return bytes && read_all(*bytes, next);
  };
  return std::all_of(packed_.begin(), packed_.end(), whole) && read_all(last_, next);
}

}  // namespace stig::physics
