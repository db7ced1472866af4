// SPDX-License-Identifier: MIT
// Bytes compressed into one zstd frame, with a checksum of what was compressed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace stig {

std::string packed(std::string_view bytes);
/// Nothing when the frame is damaged, followed by more, or holds more than `most` bytes.
std::optional<std::string> unpacked(std::string_view frame, std::size_t most);

/// A frame made piece by piece, of bytes that need not be held all at once.
class PackedStream {
 public:
  PackedStream();
  ~PackedStream();
  PackedStream(const PackedStream&) = delete;
  PackedStream& operator=(const PackedStream&) = delete;

  /// Appends to `out` what is ready of the frame.
  void add(std::string_view bytes, std::string& out);
  /// Appends its rest.
  void finish(std::string_view bytes, std::string& out);

 private:
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
};

}  // namespace stig
