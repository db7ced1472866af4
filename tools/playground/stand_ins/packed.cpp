// SPDX-License-Identifier: MIT
// zstd frames of blocks that are not compressed (RFC 8878, section 3.1.1), in place of
// lib/base/packed.cpp: longer, and read by every reader of the format. There is no checksum, since
// readers ask for none where the frame announces none.
#include "base/packed.h"

#include <algorithm>

#include "base/bytes.h"

struct ZSTD_CCtx_s {
  std::string bytes;
};

namespace stig {

namespace {

constexpr std::uint32_t kMagic = 0xFD2FB528;
constexpr std::size_t kMostInBlock = std::size_t{128} << 10;
/// One segment whose size is given in 8 bytes.
constexpr std::uint8_t kDescriptor = 0xE0;

std::size_t forget(ZSTD_CCtx_s* context) {
  delete context;
  return 0;
}

}  // namespace

std::string packed(std::string_view bytes) {
  std::string out;
  put(out, kMagic);
  put(out, kDescriptor);
  put(out, static_cast<std::uint64_t>(bytes.size()));
  do {
    const std::size_t size = std::min(bytes.size(), kMostInBlock);
    const bool last = size == bytes.size();
    const auto header = static_cast<std::uint32_t>(size << 3 | (last ? 1U : 0U));
    for (int shift = 0; shift < 24; shift += 8) {
      put(out, static_cast<std::uint8_t>(header >> shift & 0xFFU));
    }
    out += bytes.substr(0, size);
    bytes.remove_prefix(size);
    if (last) break;
  } while (true);
  return out;
}

PackedStream::PackedStream() : context_(new ZSTD_CCtx_s, forget) {}
PackedStream::~PackedStream() = default;

// The size comes first in the frame, so nothing is ready before the end.
void PackedStream::add(std::string_view bytes, std::string&) { context_->bytes += bytes; }

void PackedStream::finish(std::string_view bytes, std::string& out) {
  context_->bytes += bytes;
  out += packed(context_->bytes);
}

}  // namespace stig
