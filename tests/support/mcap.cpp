// SPDX-License-Identifier: MIT
#include "support/mcap.h"

#include <doctest/doctest.h>

#include <array>
#include <set>

#include "base/packed.h"

namespace stig {

namespace {

const std::string kMagic("\x89MCAP0\r\n");

/// A bit at a time, as ISO 3309 has it.
std::uint32_t slow_crc(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

struct Cursor {
  std::string bytes;
  std::size_t at = 0;

  std::uint64_t number(std::size_t size) {
    REQUIRE(at + size <= bytes.size());
    std::uint64_t out = 0;
    for (std::size_t i = size; i-- > 0;) out = out << 8 | static_cast<unsigned char>(bytes[at + i]);
    at += size;
    return out;
  }
  std::string text(std::size_t size) {
    REQUIRE(at + size <= bytes.size());
    at += size;
    return bytes.substr(at - size, size);
  }
  std::string sized() { return text(number(4)); }
  std::uint64_t u16() { return number(2); }
  std::uint64_t u32() { return number(4); }
  std::uint64_t u64() { return number(8); }
  bool over() const { return at == bytes.size(); }
};

struct Record {
  std::size_t place = 0, size = 0;  ///< with opcode and length
  int opcode = 0;
  std::string content;
};

std::vector<Record> records_in(const std::string& bytes, std::size_t from, std::size_t to) {
  std::vector<Record> out;
  Cursor in{bytes.substr(0, to), from};
  while (in.at < to) {
    Record record;
    record.place = in.at;
    record.opcode = static_cast<int>(in.number(1));
    record.content = in.text(in.u64());
    record.size = in.at - record.place;
    out.push_back(std::move(record));
  }
  return out;
}

using Numbers = std::map<std::uint64_t, std::uint64_t>;

Numbers numbers_in(const std::string& bytes) {
  Numbers out;
  Cursor in{bytes};
  while (!in.over()) {
    const std::uint64_t key = in.u16();
    CHECK(out.emplace(key, in.u64()).second);
  }
  return out;
}

class McapReading {
 public:
  explicit McapReading(const std::string& bytes) : bytes_(bytes) {}

  McapContent read() {
    REQUIRE(bytes_.size() > 2 * kMagic.size() + 29);
    CHECK(bytes_.substr(0, kMagic.size()) == kMagic);
    CHECK(bytes_.substr(bytes_.size() - kMagic.size()) == kMagic);
    const std::size_t footer = bytes_.size() - kMagic.size() - 29;
    const auto last = records_in(bytes_, footer, footer + 29);
    REQUIRE(last.size() == 1);
    REQUIRE(last[0].opcode == 2);
    Cursor in{last[0].content};
    const std::uint64_t summary = in.u64(), offsets = in.u64();
    CHECK(in.u32() == slow_crc(bytes_.substr(summary, footer + 25 - summary)));
    read_data(summary);
    read_summary(records_in(bytes_, summary, offsets));
    read_offsets(records_in(bytes_, offsets, footer), summary, offsets);
    return out_;
  }

 private:
  void read_data(std::size_t end) {
    const auto records = records_in(bytes_, kMagic.size(), end);
    REQUIRE(!records.empty());
    CHECK(records.front().opcode == 1);
    CHECK(records.back().opcode == 15);
    Cursor crc{records.back().content};
    CHECK(crc.u32() == slow_crc(bytes_.substr(0, records.back().place)));
    for (std::size_t i = 1; i + 1 < records.size(); ++i) {
      const Record& record = records[i];
      if (record.opcode == 3 || record.opcode == 4) {
        read_definition(record);
        definitions_ += record.content;
      } else if (record.opcode == 12) {
        read_facts(record);
      } else if (record.opcode == 6) {
        read_chunk(records, i);
      } else {
        CHECK(record.opcode == 7);
      }
    }
  }

  void read_definition(const Record& record) {
    Cursor in{record.content};
    const std::uint64_t number = in.u16();
    if (record.opcode == 3) {
      CHECK(number > 0);
      schemas_[number] = in.sized();
      CHECK(in.sized() == "jsonschema");
      CHECK(nlohmann::json::parse(in.sized())["title"] == schemas_[number]);
    } else {
      const std::uint64_t schema = in.u16();
      REQUIRE(schemas_.count(schema) == 1);
      topics_[number] = in.sized();
      out_.schemas[topics_[number]] = schemas_[schema];
      CHECK(in.sized() == "json");
      CHECK(in.sized().empty());
    }
    CHECK(in.over());
  }

  void read_facts(const Record& record) {
    Cursor in{record.content};
    CHECK(in.sized() == "run");
    Cursor facts{in.sized()};
    while (!facts.over()) {
      const std::string key = facts.sized();
      out_.facts[key] = facts.sized();
    }
    facts_place_ = {record.place, record.size};
  }

  void read_chunk(const std::vector<Record>& records, std::size_t number) {
    const Record& record = records[number];
    ++out_.chunks;
    Cursor in{record.content};
    const std::uint64_t from = in.u64(), to = in.u64(), size = in.u64(), crc = in.u32();
    CHECK(in.sized() == "zstd");
    const std::string frame = in.text(in.u64());
    CHECK(in.over());
    const auto payload = unpacked(frame, std::size_t{1} << 30);
    REQUIRE(payload);
    CHECK(payload->size() == size);
    CHECK(slow_crc(*payload) == crc);
    std::set<std::array<std::uint64_t, 3>> places;  // channel, time, offset
    std::uint64_t low = UINT64_MAX, high = 0;
    for (const Record& message : records_in(*payload, 0, payload->size())) {
      CHECK(message.opcode == 5);
      Cursor m{message.content};
      const std::uint64_t channel = m.u16(), sequence = m.u32(), time = m.u64();
      CHECK(m.u64() == time);
      REQUIRE(topics_.count(channel) == 1);
      CHECK(sequence == counts_[channel]++);
      low = std::min(low, time);
      high = std::max(high, time);
      places.insert({channel, time, message.place});
      out_.messages.push_back(
          {topics_[channel], time, nlohmann::json::parse(m.text(m.bytes.size() - m.at))});
    }
    CHECK(low == from);
    CHECK(high == to);
    low_ = std::min(low_, low);
    high_ = std::max(high_, high);
    // The indices behind it name each message once.
    Numbers index_places;
    std::size_t index_size = 0;
    for (std::size_t i = number + 1; records[i].opcode == 7; ++i) {
      Cursor index{records[i].content};
      const std::uint64_t channel = index.u16();
      index_places[channel] = records[i].place;
      index_size += records[i].size;
      Cursor list{index.sized()};
      CHECK(index.over());
      for (std::uint64_t last = 0; !list.over();) {
        const std::uint64_t time = list.u64();
        CHECK(time >= last);
        CHECK(places.erase({channel, time, list.u64()}) == 1);
        last = time;
      }
    }
    CHECK(places.empty());
    chunks_[record.place] = {from, to, record.size, index_size, frame.size(), size};
    chunk_indices_[record.place] = index_places;
  }

  void read_summary(const std::vector<Record>& records) {
    std::string definitions;
    std::size_t chunks = 0;
    for (const Record& record : records) {
      Cursor in{record.content};
      if (record.opcode == 3 || record.opcode == 4) {
        definitions += record.content;
      } else if (record.opcode == 8) {
        ++chunks;
        const std::uint64_t from = in.u64(), to = in.u64(), place = in.u64(), size = in.u64();
        REQUIRE(chunks_.count(place) == 1);
        CHECK(numbers_in(in.sized()) == chunk_indices_[place]);
        const std::uint64_t index_size = in.u64();
        CHECK(in.sized() == "zstd");
        const std::uint64_t packed_size = in.u64();
        CHECK(chunks_[place] ==
              std::array<std::uint64_t, 6>{from, to, size, index_size, packed_size, in.u64()});
      } else if (record.opcode == 11) {
        read_statistics(in);
      } else {
        CHECK(record.opcode == 13);
        const std::uint64_t place = in.u64();
        CHECK(std::pair(place, in.u64()) == facts_place_);
        CHECK(in.sized() == "run");
      }
      CHECK((in.over() || record.opcode <= 4));
    }
    CHECK(definitions == definitions_);
    CHECK(chunks == out_.chunks);
  }

  void read_statistics(Cursor& in) {
    CHECK(in.u64() == out_.messages.size());
    CHECK(in.u16() == schemas_.size());
    CHECK(in.u32() == topics_.size());
    CHECK(in.u32() == 0);
    CHECK(in.u32() == 1);
    CHECK(in.u32() == out_.chunks);
    CHECK(in.u64() == low_);
    CHECK(in.u64() == high_);
    CHECK(numbers_in(in.sized()) == counts_);
  }

  /// Groups of one kind, one behind the other.
  void read_offsets(const std::vector<Record>& records, std::size_t begin, std::size_t end) {
    for (const Record& record : records) {
      CHECK(record.opcode == 14);
      Cursor in{record.content};
      const auto opcode = static_cast<int>(in.number(1));
      CHECK(in.u64() == begin);
      const std::size_t size = in.u64();
      for (const Record& one : records_in(bytes_, begin, begin + size)) CHECK(one.opcode == opcode);
      begin += size;
    }
    CHECK(begin == end);
  }

  std::string bytes_;
  McapContent out_;
  std::map<std::uint64_t, std::string> schemas_, topics_;
  std::string definitions_;
  Numbers counts_;
  std::pair<std::uint64_t, std::uint64_t> facts_place_;
  std::map<std::uint64_t, std::array<std::uint64_t, 6>> chunks_;
  std::map<std::uint64_t, Numbers> chunk_indices_;
  std::uint64_t low_ = UINT64_MAX, high_ = 0;
};

}  // namespace

std::vector<McapContent::Message> McapContent::of(const std::string& topic) const {
  std::vector<Message> out;
  for (const Message& message : messages) {
    if (message.topic == topic) out.push_back(message);
  }
  return out;
}

McapContent mcap_content(const std::string& bytes) { return McapReading(bytes).read(); }

}  // namespace stig
