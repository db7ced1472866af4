// SPDX-License-Identifier: MIT
// MCAP files (mcap.dev/spec): messages with times, on channels whose schemas stand in the file, in
// compressed chunks with indices behind them, so that a reader can begin anywhere.
//
// Messages are JSON, schemas JSON Schema. Records are handed over as they become whole: what is
// held is a chunk, and some hundred bytes of index for each that was written. The same messages
// give the same bytes.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "view/uses.h"

namespace stig::view {

inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

struct McapChannel {
  std::string topic;
  std::string schema_name;
  std::string schema;  ///< JSON Schema of its messages
};

class McapWriter {
 public:
  /// Returns false to end the file: nothing more is handed over then.
  using Sink = std::function<bool(std::string_view)>;

  McapWriter(std::vector<McapChannel> channels, Sink sink);
  /// Facts about the whole, before the first message or after the last.
  void metadata(const std::string& name, const std::map<std::string, std::string>& facts);
  /// On a channel, by its number in the list; `time` in ns.
  void message(std::size_t channel, std::uint64_t time, std::string_view json);
  /// Index, statistics and end; nothing may follow.
  void finish();
  /// False: the sink wants no more.
  bool wanted() const { return wanted_; }

 private:
  /// Where the messages of a channel are in a chunk: times and offsets.
  using Places = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
  struct Chunk {
    std::uint64_t from = 0, to = 0;  ///< ns, of its messages
    std::string records;
    std::vector<Places> places;  ///< of each channel
  };

  void hand_over(std::string_view bytes);
  void put_chunk();
  void put_group(std::string& summary, std::string& offsets, std::uint8_t opcode,
                 const std::string& records) const;
  std::string statistics() const;

  std::vector<McapChannel> channels_;
  Sink sink_;
  bool wanted_ = true;
  std::uint64_t written_ = 0;   ///< bytes
  std::uint32_t data_crc_ = 0;  ///< of all of them
  Chunk chunk_;
  std::string chunk_indices_, metadata_indices_;  ///< records of the summary
  std::uint32_t chunks_ = 0, facts_ = 0;
  std::vector<std::uint32_t> counts_;  ///< messages of each channel
  std::uint64_t from_ = UINT64_MAX, to_ = 0;
};

}  // namespace stig::view
