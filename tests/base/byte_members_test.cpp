// SPDX-License-Identifier: MIT
#include "base/byte_members.h"
#include "support/uses.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace stig {
namespace {

enum class Phase { first, second, third };

/// Something of every kind.
class Sample {
 public:
  static void members(auto& each, auto& self) {
    each(self.on), each(self.small), each(self.wide), each(self.less), each(self.real);
    each(self.word), each_member(each, self.pose), each.list(self.numbers);
    each.choice(self.phase, Phase::third), each.known(self.devices);
  }
  friend bool operator==(const Sample& a, const Sample& b) {
    return a.on == b.on && a.small == b.small && a.wide == b.wide && a.less == b.less &&
           a.real == b.real && a.word == b.word && a.pose.p == b.pose.p && a.pose.q == b.pose.q &&
           a.numbers == b.numbers && a.phase == b.phase;
  }

  bool on = false;
  std::uint32_t small = 0;
  std::uint64_t wide = 0;
  int less = 0;
  double real = 0;
  std::string word;
  Pose pose;
  std::vector<double> numbers;
  Phase phase = Phase::first;
  std::uint64_t devices = 4;  ///< the same on both sides
};

std::string bytes_of(const Sample& sample) {
  BytesOut out;
  each_member(out, sample);
  return out.take();
}

Sample full() {
  Sample out;
  out.on = true;
  out.small = 0xffffffff;
  out.wide = 0xffffffff'ffffffff;
  out.less = -300;
  out.real = -0.1;
  out.word = std::string("a\0b", 3);
  out.pose = {{1, 2, 3}, {0, 1, 0, 0}};
  out.numbers = {0.5, -0.0, 1e300};
  out.phase = Phase::third;
  return out;
}

/// Whether the bytes are a sample, and all of them.
bool taken(const std::string& bytes, Sample& out) {
  ByteReader reader(bytes);
  BytesIn in(reader);
  each_member(in, out);
  return in.good() && reader.left() == 0;
}

}  // namespace

TEST_CASE("one list of members writes values and takes them again") {
  const Sample sample = full();
  Sample back;
  REQUIRE(taken(bytes_of(sample), back));
  CHECK(back == sample);
  CHECK(bytes_of(back) == bytes_of(sample));
}

TEST_CASE("what is cut short or no value of its kind makes the reader bad") {
  const std::string bytes = bytes_of(full());
  Sample out;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(taken(bytes.substr(0, size), out));
  }
  const auto with = [&](std::size_t at, char byte) {
    std::string bad = bytes;
    bad[at] = byte;
    return taken(bad, out);
  };
  CHECK_FALSE(with(0, '\2'));                 // no bool
  CHECK_FALSE(with(5, '\x1f'));               // a number of more than 32 bits
  CHECK_FALSE(with(bytes.size() - 2, '\3'));  // beyond the last choice
  CHECK_FALSE(with(bytes.size() - 1, '\5'));  // not the number that is known
  CHECK_FALSE(taken(bytes + "x", out));
}

}  // namespace stig
