// SPDX-License-Identifier: MIT
// Traces of poses and checkpoints: a whole file, or bytes that become the payload of a chunk
// here, compressed, so that they reach the decoder.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/bytes.h"
#include "base/packed.h"
#include "physical/simulation/checkpoint_file.h"
#include "physical/trace/pose_trace.h"
#include "support/uses.h"

namespace {

using namespace stig;

/// A trace of three bodies whose one chunk is `payload`.
std::string around(const std::string& payload) {
  PoseTraceHeader header;
  header.channels = {"leds", "log"};
  header.bodies.resize(3);
  for (TraceBody& body : header.bodies) body.shape = Shape::box({1, 1, 1});
  std::string bytes;
  PoseTraceWriter begin(header, [&](std::string_view piece) { bytes += piece; });
  const std::size_t place = bytes.size();
  const auto section = [&bytes](char tag, const std::string& inside) {
    const std::string frame = packed(inside);
    bytes.push_back(tag);
    put(bytes, static_cast<std::uint32_t>(frame.size()));
    bytes += frame;
  };
  section('C', payload);
  const std::size_t end = bytes.size();
  std::string index(2, '\0');
  put(index, std::uint64_t{0});
  put_block(index, "");
  put_varint(index, 1);
  ByteReader first(payload);
  put_varint(index, first.varint());
  put_varint(index, place);
  section('E', index);
  put(bytes, static_cast<std::uint64_t>(end));
  return bytes + "stigpend";
}

void try_trace(const std::string& bytes) {
  Diagnostics diagnostics;
  const auto trace = read_pose_trace("fuzz.stigp", bytes, diagnostics);
  if (trace.has_value() == diagnostics.has_errors()) std::abort();
  if (!trace) return;
  if (frame_at(*trace, 5).bodies.size() != trace->header.bodies.size()) std::abort();
  std::string copy;
  PoseTraceWriter writer(trace->header, [&](std::string_view piece) { copy += piece; });
  copy_records(*trace, UINT64_MAX, writer);
  writer.finish(trace->end);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  std::string problem;
  read_checkpoint_file(bytes, problem);
  read_checkpoint_file("stigchk1" + packed(bytes), problem);
  try_trace(bytes);
  try_trace(around(bytes));
  return 0;
}
