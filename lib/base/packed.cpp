// SPDX-License-Identifier: MIT
// Compression by zstd, in one piece or as a stream. The level trades time against size;
// both were set for traces, which compress to a few bytes per event at either.
#include "base/packed.h"

#include <zstd.h>

#include <cassert>
#include <memory>

namespace stig {

namespace {

constexpr int kLevel = 6;
constexpr int kStreamLevel = 3;  ///< it packs while a run waits

using Compressor = std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)>;

/// With a checksum, so that no changed byte goes unnoticed.
Compressor make_compressor(int level) {
  Compressor context{ZSTD_createCCtx(), ZSTD_freeCCtx};
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  return context;
}

void compress(ZSTD_CCtx* context, std::string_view bytes, ZSTD_EndDirective mode,
              std::string& out) {
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  std::string chunk(ZSTD_CStreamOutSize(), '\0');
  while (true) {
    ZSTD_outBuffer piece{chunk.data(), chunk.size(), 0};
    const std::size_t rest = ZSTD_compressStream2(context, &piece, &in, mode);
    assert(!ZSTD_isError(rest));
    out.append(chunk, 0, piece.pos);
    // With ZSTD_e_end the call has to be repeated until nothing is left to flush; with
    // ZSTD_e_continue until all input is taken.
    if (mode == ZSTD_e_end ? rest == 0 : in.pos == in.size) return;
  }
}

}  // namespace

std::string packed(std::string_view bytes) {
  const Compressor context = make_compressor(kLevel);
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size());
  assert(!ZSTD_isError(size));
  out.resize(size);
  return out;
}

/// The size in the frame's header is not believed: output is bounded as it grows, so a
/// small frame cannot fill the memory.
std::optional<std::string> unpacked(std::string_view frame, std::size_t most) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context{ZSTD_createDCtx(),
                                                                        ZSTD_freeDCtx};
  std::string out, chunk(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer in{frame.data(), frame.size(), 0};
  while (true) {
    ZSTD_outBuffer piece{chunk.data(), chunk.size(), 0};
    const std::size_t rest = ZSTD_decompressStream(context.get(), &piece, &in);
    if (ZSTD_isError(rest) || out.size() + piece.pos > most) return std::nullopt;
    out.append(chunk, 0, piece.pos);
    // Bytes after the frame are an error: a file holds one frame and nothing else.
    if (rest == 0) return in.pos == in.size ? std::optional(std::move(out)) : std::nullopt;
    if (in.pos == in.size && piece.pos == 0) return std::nullopt;  // cut short
  }
}

PackedStream::PackedStream() : context_(make_compressor(kStreamLevel)) {}
PackedStream::~PackedStream() = default;

void PackedStream::add(std::string_view bytes, std::string& out) {
  compress(context_.get(), bytes, ZSTD_e_continue, out);
}

void PackedStream::finish(std::string_view bytes, std::string& out) {
  compress(context_.get(), bytes, ZSTD_e_end, out);
}

}  // namespace stig
