// SPDX-License-Identifier: MIT
// Cases that look alike, found shape by shape, against comparing each case with each other.
#include "assembly/likeness.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "support/uses.h"

namespace stig {
namespace {

// Few of each, so that many cases look alike, and many do nearly.
constexpr std::size_t kCells = 4;
constexpr int kBricks = 6, kPlaces = 3, kColours = 2, kMostCases = 12;

using Done = std::vector<std::vector<bool>>;
using Pairs = std::multiset<std::tuple<std::uint32_t, std::uint32_t, bool>>;

/// Each as likely as the others from the first try on.
int below(int most) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, most)); }

std::uint32_t brick_by_chance() { return static_cast<std::uint32_t>(below(kBricks)); }

Case case_by_chance() {
  Case out;
  out.side = *rc::gen::element(ApproachSide::plus_x, ApproachSide::minus_y);
  out.bricks.assign(kCells, 0);
  for (std::size_t i = 0; i < kCells; ++i) {
    const int seen = below(4);
    out.empty[i] = seen == 1;
    out.filled[i] = seen > 1;
    if (out.filled[i]) out.bricks[i] = brick_by_chance();
  }
  for (int k = below(4); k > 0; --k) {
    out.choices.push_back({{below(kPlaces), 0, 0}, brick_by_chance()});
  }
  return out;
}

/// A robot that asks what `a` answers, and does there what is done in `a`, would do wrong in `b`.
bool does_harm(const Case& a, const std::vector<bool>& done, const Case& b,
               const std::vector<Colour>& colours) {
  for (std::size_t c = 0; c < done.size(); ++c) {
    const Choice& one = a.choices[c];
    const bool is_choice =
        std::any_of(b.choices.begin(), b.choices.end(), [&](const Choice& other) {
          return other.at == one.at && colours[other.brick] == colours[one.brick];
        });
    if (done[c] && !is_choice) return true;
  }
  return false;
}

/// What both see differs in some cell.
bool differ(const Case& a, const Case& b, const std::vector<Colour>& colours) {
  if (a.side != b.side) return true;
  for (std::size_t i = 0; i < kCells; ++i) {
    if ((a.empty[i] && b.filled[i]) || (a.filled[i] && b.empty[i])) return true;
    if (a.filled[i] && b.filled[i] && colours[a.bricks[i]] != colours[b.bricks[i]]) return true;
  }
  return false;
}

/// Some cell is seen in `a` alone.
bool asks_more(const Case& a, const Case& b) {
  for (std::size_t i = 0; i < kCells; ++i) {
    if ((a.empty[i] || a.filled[i]) && !b.empty[i] && !b.filled[i]) return true;
  }
  return false;
}

Pairs one_by_one(const std::vector<Case>& cases, const std::vector<Colour>& colours,
                 const Done& done) {
  const auto idle = [&](std::size_t i) {
    return std::find(done[i].begin(), done[i].end(), true) == done[i].end();
  };
  Pairs out;
  for (std::uint32_t a = 0; a < cases.size(); ++a) {
    for (std::uint32_t b = 0; b < cases.size(); ++b) {
      if (a == b || differ(cases[a], cases[b], colours)) continue;
      if (!does_harm(cases[a], done[a], cases[b], colours)) continue;
      const bool more = asks_more(cases[a], cases[b]);
      if (!more || !idle(b)) out.emplace(a, b, more);
    }
  }
  return out;
}

TEST_CASE("pairs of cases that look alike are those that are found one by one") {
  CHECK(rc::check([] {
    std::vector<Case> cases(static_cast<std::size_t>(1 + below(kMostCases)));
    Done done;
    for (Case& one : cases) {
      one = case_by_chance();
      done.push_back(
          *rc::gen::container<std::vector<bool>>(one.choices.size(), rc::gen::arbitrary<bool>()));
    }
    const auto colours = *rc::gen::container<std::vector<Colour>>(
        kBricks, rc::gen::cast<Colour>(rc::gen::inRange(1, kColours + 1)));
    const Pairs expected = one_by_one(cases, colours, done);
    const Likenesses likenesses(cases);
    Pairs found;
    likenesses.for_each(colours, done, [&](const Likeness& one) {
      found.emplace(one.a, one.b, one.unless_idle);
      return true;
    });
    RC_TAG(expected.empty() ? "none" : expected.size() < 10 ? "some" : "many");
    RC_ASSERT(found == expected);
    // And no more than are asked for.
    const auto asked = static_cast<std::size_t>(1 + below(static_cast<int>(expected.size()) + 1));
    std::size_t visits = 0;
    likenesses.for_each(colours, done, [&](const Likeness&) { return ++visits < asked; });
    RC_ASSERT(visits == std::min(asked, expected.size()));
  }));
}

}  // namespace
}  // namespace stig
