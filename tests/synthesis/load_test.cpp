// SPDX-License-Identifier: MIT
// What is found depends on the effort allowed, not on how busy the machine is.
#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "rules/rule_printer.h"
#include "support/uses.h"
#include "synthesis/emit.h"
#include "synthesis/shapes.h"
#include "synthesis/synthesise.h"
#include "verify/verify.h"

namespace stig {
namespace {

std::string text_of(const Synthesis& result) {
  if (!result.best) return result.obstacle ? result.obstacle->what : "";
  const Solution& s = *result.best;
  return print_rule_set(
      make_rule_set(*s.frame, s.colours, s.colour_count, {}, s.rules, {"made", s.order.name, ""}));
}

std::string made(const Target& target, double effort) {
  SynthesisOptions options;
  options.effort = effort;
  const Synthesis result = synthesise(target, options);
  CHECK_FALSE(result.cut_short);
  return text_of(result);
}

TEST_CASE("the same effort gives the same rules, whatever runs beside it") {
  // So little that the search is cut off in the midst of orders, solver calls and merging.
  for (const double effort : {1e-6, 1e-3, 0.02}) {
    CAPTURE(effort);
    const Target target = hollow_box(4);
    const std::string alone = made(target, effort);
    std::atomic<bool> stop = false;
    std::vector<std::thread> busy;
    for (int i = 0; i < 4; ++i) {
      busy.emplace_back([&stop] {
        while (!stop) std::this_thread::yield();
      });
    }
    const std::string together = made(target, effort);
    stop = true;
    for (std::thread& thread : busy) thread.join();
    CHECK(alone == together);
  }
}

TEST_CASE("a deadline that is over ends the search, and the result says so") {
  std::atomic<bool> stop = true;
  SynthesisHooks hooks;
  hooks.deadline.stop = &stop;
  const Synthesis result = synthesise(box({4, 4, 4}), {}, hooks);
  CHECK(result.cut_short);
  CHECK_FALSE(result.obstacle);
}

/// Are these the target's cells, whatever the order of events?
void check_proved(const Solution& s) {
  const VerifyResult result =
      verify::verify(make_rule_set(*s.frame, s.colours, s.colour_count, {}, s.rules, {}), {});
  CHECK(result.verdict == ProofVerdict::proved);
  REQUIRE(result.structure);
  CHECK(result.structure->size() == s.frame->cells.size());
}

TEST_CASE("a stop ends merging at once, and what was found is right") {
  std::atomic<bool> stop = false;
  SynthesisHooks hooks;
  hooks.deadline.stop = &stop;
  hooks.progress = [&](double, const std::string& what) {
    if (what.find("merging") != std::string::npos) stop = true;
  };
  const Synthesis result = synthesise(hollow_box(5), {}, hooks);
  CHECK(result.cut_short);
  REQUIRE(result.best);
  CHECK(result.best->rules.size() == result.best->exact_rules);
  check_proved(*result.best);
}

TEST_CASE("when the time is over nothing is done for each of the rules that stay exact") {
  const Target target = hollow_box(9);
  const Frame frame = make_frame(target, {{target.cells.front()}});
  BadOrder bad;
  const auto schedule = make_schedule(frame, order_plans().front().make(frame), bad);
  REQUIRE(schedule);
  ColouringSearch search(*schedule, 0);
  Colouring colours;
  int k = search.at_least();
  while (search.colour(k, {}, colours) != Answered::yes) ++k;
  const auto exact = exact_rules(*schedule, colours);
  const auto views = local_views(*schedule, colours, {});
  REQUIRE(views);
  std::atomic<bool> stop = true;
  Effort effort({std::chrono::steady_clock::time_point::max(), &stop});
  CHECK_FALSE(local_views(*schedule, colours, {&effort}));
  CHECK(merge_rules(frame, k, exact, *views, 5, {&effort}).size() == exact.size());
  CHECK(effort.cut_short());
  CHECK(effort.spent() < exact.size() * exact.size());
}

TEST_CASE("when the time is over no stage of the search goes on") {
  const Target target = hollow_box(9);
  const Frame frame = make_frame(target, {{target.cells.front()}});
  BadOrder bad;
  const Order order = order_plans().front().make(frame);
  const auto schedule = make_schedule(frame, order, bad);
  REQUIRE(schedule);
  const ColouringSearch search(*schedule, 0);
  std::atomic<bool> stop = true;
  Effort effort({std::chrono::steady_clock::time_point::max(), &stop});
  const Allowance over{&effort};
  CHECK_FALSE(make_schedule(frame, order, bad, {.allowance = over}));
  CHECK(bad.kind == BadOrder::Kind::no_time);
  const Colouring same(frame.orbits.size(), 1);
  CHECK_FALSE(find_clashes(*schedule, same, 4, 1000).empty());
  CHECK(find_clashes(*schedule, same, 4, 1000, over).empty());
  CHECK(search.differences().clauses().size() > 0);
  ColouringSearch cut(*schedule, 0, over);
  CHECK(cut.differences().clauses().empty());
  Colouring colours = same;
  CHECK(cut.colour(62, {over, {}}, colours) == Answered::given_up);
  CHECK(cut.rounds() == 0);
}

TEST_CASE("a stop in the midst of a question to the solver gives it up") {
  const Target target = hollow_box(9);
  const Frame frame = make_frame(target, {{target.cells.front()}});
  BadOrder bad;
  const auto schedule = make_schedule(frame, order_plans().front().make(frame), bad);
  REQUIRE(schedule);
  ColouringSearch search(*schedule, 0);
  std::atomic<bool> stop = false;
  Effort effort({std::chrono::steady_clock::time_point::max(), &stop});
  // Set before the first round: neither the clauses nor the clashes are gone through.
  const ColouringLimits limits{{&effort}, [&](int, int) { stop = true; }};
  Colouring colours;
  CHECK(search.colour(kMaxColours, limits, colours) == Answered::given_up);
  CHECK(search.rounds() == 0);
}

TEST_CASE("impossible is said of every order alone") {
  SynthesisOptions options;
  options.start = {{0, 0, 0}};
  options.most_colours = 6;
  Synthesis result = synthesise(box({7, 1, 1}), options);  // one order there is
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->proved);
  options.most_colours = 12;
  result = synthesise(box({13, 1, 1}), options);  // too long for all orders to be listed
  REQUIRE(result.obstacle);
  CHECK_FALSE(result.obstacle->proved);
  result = synthesise(drawn("1 1 1 1", ColourUse::given), {});  // from every start
  REQUIRE(result.obstacle);
  CHECK(result.obstacle->proved);
}

TEST_CASE("of a single cell there is nothing to build, whatever the symmetry") {
  SynthesisOptions options;
  for (const Symmetry symmetry :
       {Symmetry::none, Symmetry::rotations, Symmetry::rotations_mirrors}) {
    options.symmetry = symmetry;
    const Synthesis one = synthesise(box({1, 1, 1}), options);
    REQUIRE(one.obstacle);
    CHECK(one.obstacle->proved);
    CHECK(one.obstacle->what == "the start is all of the target: there is nothing to build");
  }
  // Of more cells nobody has tried every start.
  const Synthesis line = synthesise(box({6, 1, 1}), options);
  REQUIRE(line.obstacle);
  CHECK_FALSE(line.obstacle->proved);
}

TEST_CASE("orders with ties are listed, each that differs in what comes before what") {
  const Frame plate = make_frame(box({2, 2, 1}), {{{0, 0, 0}}});
  // Three cells that are all neighbours of each other and of the start: weak orders of three.
  CHECK(all_orders(plate, 100).size() == 6);
  CHECK(all_orders(plate, 100, Ties::allowed).size() == 13);
  CHECK(all_orders(plate, 12, Ties::allowed).empty());
}

}  // namespace
}  // namespace stig
