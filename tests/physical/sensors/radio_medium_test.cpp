// SPDX-License-Identifier: MIT
#include "physical/sensors/radio_medium.h"
#include "support/uses.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

using namespace stig;

namespace {
using Messages = std::vector<std::vector<Message>>;
}

TEST_CASE("radios: the range of the sender, just within and just beyond") {
  const auto heard = [](double distance, double sender, double receiver) {
    return carry({{{0, 0, 0}, sender}, {{0, distance, 0}, receiver}}, {{"1"}, {}})[1].size() == 1;
  };
  CHECK(heard(0.02 - 1e-9, 0.02, 0.02));
  CHECK(!heard(0.02 + 1e-9, 0.02, 0.02));
  CHECK(heard(0.03, 0.04, 0.001));  // the sender's counts
  CHECK(!heard(0.03, 0.001, 0.04));
}

TEST_CASE("radios are half duplex, and a sender does not hear itself") {
  const std::vector<Radio> radios = {{{0, 0, 0}}, {{0.01, 0, 0}}, {{0, 0.01, 0}}};
  CHECK(carry(radios, {{"a"}, {"b"}, {}}) == Messages{{}, {}, {"a", "b"}});
  CHECK(carry(radios, {{}, {"b"}, {}}) == Messages{{"b"}, {}, {"b"}});
  CHECK(carry(radios, {{"a"}, {"b"}, {"c"}}) == Messages{{}, {}, {}});
  CHECK(carry(radios, {{}, {}, {}}) == Messages{{}, {}, {}});
  CHECK(carry({}, {}).empty());
}

TEST_CASE("messages keep their bytes and their order") {
  const std::string bytes{'\0', '\xff', '1'};
  const std::vector<Radio> radios = {{{0.01, 0, 0}}, {{0, 0, 0}}, {{-0.01, 0, 0}}};
  CHECK(carry(radios, {{"late", "later"}, {}, {bytes, ""}}) ==
        Messages{{}, {"late", "later", bytes, ""}, {}});
}

TEST_CASE("what is sent in one step is read in the next, and only then") {
  const std::vector<Radio> radios = {{{0, 0, 0}}, {{0.01, 0, 0}}};
  Messages inbox(2);
  std::vector<std::size_t> read;
  for (int step = 0; step < 4; ++step) {
    read.push_back(inbox[1].size());  // sense
    const Messages sends = {step == 1 ? std::vector<Message>{"4"} : std::vector<Message>{}, {}};
    inbox = carry(radios, sends);  // media, after control and physics
  }
  CHECK(read == std::vector<std::size_t>{0, 0, 1, 0});
}

TEST_CASE("the index changes nothing of what is heard") {
  CHECK(rc::check("as each pair", [] {
    const auto value = [] { return *rc::gen::inRange(-100, 101) * 1e-3; };
    std::vector<Radio> radios;
    Messages sends;
    for (int i = 0; i < 40; ++i) {
      radios.push_back({{value(), value(), value() / 2}, std::abs(value()) + 5e-5});
      sends.push_back(*rc::gen::inRange(0, 3) == 0 ? std::vector<Message>{std::to_string(i)}
                                                   : std::vector<Message>{});
    }
    Messages expected(radios.size());
    for (std::size_t s = 0; s < radios.size(); ++s) {
      for (std::size_t r = 0; r < radios.size(); ++r) {
        const bool near = length(radios[s].p_W - radios[r].p_W) <= radios[s].range;
        if (!sends[s].empty() && sends[r].empty() && near) expected[r].push_back(sends[s][0]);
      }
    }
    RC_ASSERT(carry(radios, sends) == expected);
  }));
}
