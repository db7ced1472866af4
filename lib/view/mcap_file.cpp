// SPDX-License-Identifier: MIT
// The file: magic, header, schemas and channels, metadata, chunks each followed by an index of its
// messages for each channel, the end of data with its CRC, the summary (schemas and channels again,
// statistics, where chunks and metadata are), where in the summary each kind of record begins,
// footer with the summary's CRC, magic. All integers are little-endian.
#include "view/mcap_file.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <numeric>

#include "base/bytes.h"
#include "base/packed.h"

namespace stig::view {

namespace {

enum Opcode : std::uint8_t {
  kHeader = 1,
  kFooter,
  kSchema,
  kChannel,
  kMessage,
  kChunk,
  kMessageIndex,
  kChunkIndex,
  kStatistics = 0x0b,
  kMetadata,
  kMetadataIndex,
  kSummaryOffset,
  kDataEnd
};

// What readers load at once to show a moment.
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
constexpr std::string_view kCompression = "zstd";

/// Strings, bytes, lists and maps stand behind their size in bytes.
void put_sized(std::string& out, std::string_view bytes) {
  put(out, static_cast<std::uint32_t>(bytes.size()));
  out += bytes;
}

void put_record(std::string& out, Opcode opcode, std::string_view content) {
  out.push_back(static_cast<char>(opcode));
  put(out, std::uint64_t{content.size()});
  out += content;
}

std::string facts_bytes(const std::map<std::string, std::string>& facts) {
  std::string out;
  for (const auto& [key, value] : facts) {
    put_sized(out, key);
    put_sized(out, value);
  }
  return out;
}

std::uint32_t crc_of(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

/// A schema for each channel: its number is one more than the channel's, as 0 means none.
std::uint16_t schema_number(std::size_t channel) { return static_cast<std::uint16_t>(channel + 1); }

std::string schema_records(const std::vector<McapChannel>& channels) {
  std::string out;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    std::string content;
    put(content, schema_number(i));
    put_sized(content, channels[i].schema_name);
    put_sized(content, "jsonschema");
    put_sized(content, channels[i].schema);
    put_record(out, kSchema, content);
  }
  return out;
}

std::string channel_records(const std::vector<McapChannel>& channels) {
  std::string out;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    std::string content;
    put(content, static_cast<std::uint16_t>(i));
    put(content, schema_number(i));
    put_sized(content, channels[i].topic);
    put_sized(content, "json");
    put_sized(content, {});
    put_record(out, kChannel, content);
  }
  return out;
}

}  // namespace

McapWriter::McapWriter(std::vector<McapChannel> channels, Sink sink)
    : channels_(std::move(channels)), sink_(std::move(sink)), counts_(channels_.size()) {
  assert(channels_.size() < UINT16_MAX);
  chunk_.places.resize(channels_.size());
  std::string content;
  put_sized(content, {});  // no profile
  put_sized(content, "stigc");
  std::string out(kMcapMagic);
  put_record(out, kHeader, content);
  hand_over(out + schema_records(channels_) + channel_records(channels_));
}

void McapWriter::hand_over(std::string_view bytes) {
  written_ += bytes.size();
  data_crc_ = crc_of(bytes, data_crc_);
  wanted_ = wanted_ && sink_(bytes);
}

void McapWriter::metadata(const std::string& name,
                          const std::map<std::string, std::string>& facts) {
  put_chunk();
  std::string content, record, index;
  put_sized(content, name);
  put_sized(content, facts_bytes(facts));
  put_record(record, kMetadata, content);
  put(index, written_);
  put(index, std::uint64_t{record.size()});
  put_sized(index, name);
  put_record(metadata_indices_, kMetadataIndex, index);
  ++facts_;
  hand_over(record);
}

void McapWriter::message(std::size_t channel, std::uint64_t time, std::string_view json) {
  assert(channel < channels_.size());
  if (!wanted_) return;
  std::string content;
  put(content, static_cast<std::uint16_t>(channel));
  put(content, counts_[channel]++);
  // When it was written down, and when it was said: a simulation knows no delay.
  put(content, time);
  put(content, time);
  content += json;
  chunk_.from = chunk_.records.empty() ? time : std::min(chunk_.from, time);
  chunk_.to = chunk_.records.empty() ? time : std::max(chunk_.to, time);
  from_ = std::min(from_, time);
  to_ = std::max(to_, time);
  chunk_.places[channel].emplace_back(time, chunk_.records.size());
  put_record(chunk_.records, kMessage, content);
  if (chunk_.records.size() >= kChunkBytes) put_chunk();
}

void McapWriter::put_chunk() {
  if (chunk_.records.empty()) return;
  const std::string frame = packed(chunk_.records);
  std::string times;
  put(times, chunk_.from);
  put(times, chunk_.to);
  std::string content = times, out;
  put(content, std::uint64_t{chunk_.records.size()});
  put(content, crc_of(chunk_.records));
  put_sized(content, kCompression);
  put(content, std::uint64_t{frame.size()});
  put_record(out, kChunk, content + frame);
  const std::uint64_t begin = written_, chunk_size = out.size();
  std::string index_places;
  for (std::size_t i = 0; i < chunk_.places.size(); ++i) {
    Places& places = chunk_.places[i];
    if (places.empty()) continue;
    std::stable_sort(places.begin(), places.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    put(index_places, static_cast<std::uint16_t>(i));
    put(index_places, begin + out.size());
    std::string list, index;
    for (const auto& [time, place] : places) {
      put(list, time);
      put(list, place);
    }
    put(index, static_cast<std::uint16_t>(i));
    put_sized(index, list);
    put_record(out, kMessageIndex, index);
    places.clear();
  }
  std::string index = times;
  put(index, begin);
  put(index, chunk_size);
  put_sized(index, index_places);
  put(index, std::uint64_t{out.size()} - chunk_size);
  put_sized(index, kCompression);
  put(index, std::uint64_t{frame.size()});
  put(index, std::uint64_t{chunk_.records.size()});
  put_record(chunk_indices_, kChunkIndex, index);
  ++chunks_;
  chunk_.records.clear();
  hand_over(out);
}

std::string McapWriter::statistics() const {
  std::string content, counts, out;
  const std::uint64_t messages = std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
  put(content, messages);
  put(content, static_cast<std::uint16_t>(channels_.size()));
  put(content, static_cast<std::uint32_t>(channels_.size()));
  put(content, std::uint32_t{0});  // attachments
  put(content, facts_);
  put(content, chunks_);
  put(content, messages > 0 ? from_ : 0);
  put(content, to_);
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    put(counts, static_cast<std::uint16_t>(i));
    put(counts, std::uint64_t{counts_[i]});
  }
  put_sized(content, counts);
  put_record(out, kStatistics, content);
  return out;
}

/// Records of one kind, and where they are.
void McapWriter::put_group(std::string& summary, std::string& offsets, std::uint8_t opcode,
                           const std::string& records) const {
  if (records.empty()) return;
  std::string content;
  content.push_back(static_cast<char>(opcode));
  put(content, written_ + summary.size());
  put(content, std::uint64_t{records.size()});
  put_record(offsets, kSummaryOffset, content);
  summary += records;
}

void McapWriter::finish() {
  put_chunk();
  std::string end, record;
  put(end, data_crc_);
  put_record(record, kDataEnd, end);
  hand_over(record);

  const std::uint64_t summary_place = written_;
  std::string summary, offsets;
  put_group(summary, offsets, kSchema, schema_records(channels_));
  put_group(summary, offsets, kChannel, channel_records(channels_));
  put_group(summary, offsets, kStatistics, statistics());
  put_group(summary, offsets, kChunkIndex, chunk_indices_);
  put_group(summary, offsets, kMetadataIndex, metadata_indices_);
  const std::uint64_t offsets_place = written_ + summary.size();
  summary += offsets;

  // The CRC is of all from the summary's begin to the two places in the footer.
  std::string places, footer;
  put(places, summary_place);
  put(places, offsets_place);
  put_record(footer, kFooter, places + std::string(sizeof(std::uint32_t), '\0'));
  footer.resize(footer.size() - sizeof(std::uint32_t));
  put(footer, crc_of(footer, crc_of(summary)));
  hand_over(summary + footer + std::string(kMcapMagic));
}

}  // namespace stig::view
