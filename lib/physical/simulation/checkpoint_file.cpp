// SPDX-License-Identifier: MIT
// A checkpoint is self-contained: scene and programs as texts, the seed, and the state. It is read
// by the same list of members that it is written by (base/byte_members.h).
#include "physical/simulation/checkpoint_file.h"

#include "base/byte_members.h"
#include "base/packed.h"

namespace stig::physics {

namespace {

// The last digit rises whenever the order of bytes changes.
constexpr std::string_view kCheckpointMagic = "stigchk2";
constexpr std::size_t kMostCheckpoint = std::size_t{1} << 30;

}  // namespace

static void each_member(auto& each, EitherWay<SceneFile> auto& file) {
  each(file.name), each(file.text);
}
static void each_member(auto& each, EitherWay<Checkpoint> auto& checkpoint) {
  each(checkpoint.seed), each.list(checkpoint.files), each(checkpoint.state);
}

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  BytesOut out;
  each_member(out, checkpoint);
  return std::string(kCheckpointMagic) + packed(out.take());
}

std::optional<Checkpoint> read_checkpoint_file(std::string_view bytes, std::string& problem) {
  if (!bytes.starts_with(kCheckpointMagic)) {
    problem = "it is no checkpoint of stigc simulate";
    return std::nullopt;
  }
  const auto payload = unpacked(bytes.substr(kCheckpointMagic.size()), kMostCheckpoint);
  // Set before anything can fail, and cleared at the end.
  problem = "it is damaged or cut short";
  if (!payload) return std::nullopt;
  ByteReader reader(*payload);
  BytesIn in(reader);
  Checkpoint out;
  each_member(in, out);
  if (!in.good() || reader.left() > 0 || out.files.empty()) return std::nullopt;
  problem.clear();
  return out;
}

}  // namespace stig::physics
