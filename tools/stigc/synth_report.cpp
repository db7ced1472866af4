// SPDX-License-Identifier: MIT
// A solution's claims are told with their strength: "the fewest for this order" where that was
// proved, "perhaps" where it was not, and what verify says of the rules, which is the claim that
// counts.
#include "synth_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "app.h"
#include "rules/cell_text.h"
#include "synth_words.h"

namespace stig::cli {
namespace {

std::string_view words(Obstacle::Kind kind) {
  switch (kind) {
    case Obstacle::Kind::bad_start:
      return "bad-start";
    case Obstacle::Kind::not_connected:
      return "not-connected";
    case Obstacle::Kind::asymmetric:
      return "asymmetric";
    case Obstacle::Kind::look_alike:
      return "look-alike";
    case Obstacle::Kind::colours:
      break;
  }
  return "colours";
}

// A solution as a point of the trade between colours and rules: the best one and the others alike.
Json point_json(const Solution& s) {
  return {{"colours", s.colour_count}, {"fewer_refuted", s.fewer_refuted},
          {"rules", s.rules.size()},   {"exact_rules", s.exact_rules},
          {"heights", s.heights},      {"order", s.order.name}};
}

}  // namespace

std::string orders_in_words(std::size_t tried) {
  return tried == 1 ? "the one order tried does not work"
                    : fmt::format("none of the {} orders tried works", tried);
}

// Three verdicts: compiled, with what verify says of the rules; impossible, where that is proved;
// or not found, which says nothing of what more effort would find.
Json synth_json(const SynthOptions& options, const Synthesis& result, const SynthOutcome& outcome) {
  Json json{{"target", options.target}};
  if (result.best) {
    const Solution& s = *result.best;
    json["verdict"] = "compiled";
    json["proof"] = to_string(outcome.proof.verdict);
    json["method"] = to_string(outcome.proof.method);
    json["local_states"] = outcome.proof.local_states;
    json["bricks"] = s.frame->cells.size();
    json.update(point_json(s));
    // Bricks of the scaffold are a part of the structure that is built, so they are counted above.
    if (!outcome.scaffold.empty()) {
      json["scaffold"] = Json::array();
      for (const Cell c : outcome.scaffold) json["scaffold"].push_back(to_json(c));
    }
    json["walled_in"] = Json::array();
    for (const WalledIn& walled : outcome.findings.walled_in) {
      json["walled_in"].push_back(to_json(walled.site));
    }
    json["start"] = Json::array();
    for (const Orbit& orbit : s.frame->orbits) {
      if (orbit.start) json["start"].push_back(to_json(orbit.at));
    }
    json["others"] = Json::array();
    for (const Solution& other : result.others) json["others"].push_back(point_json(other));
  } else if (result.obstacle) {
    // Words that programs compare; people read synth_reason.
    json["verdict"] = result.obstacle->proved ? "impossible" : "not-found";
    json["reason"] = words(result.obstacle->kind);
    json["what"] = result.obstacle->what;
    if (!result.obstacle->drawing.empty()) json["drawing"] = result.obstacle->drawing;
    json["remedies"] = result.obstacle->remedies;
  } else {
    json["verdict"] = result.cut_short ? early_verdict() : "not-found";
  }
  json["impossible"] = result.obstacle && result.obstacle->proved;
  json["cut_short"] = result.cut_short;
  json["orders_tried"] = result.orders_tried;
  json["seconds"] = result.seconds;
  if (!outcome.written.empty()) json["written"] = outcome.written;
  return json;
}

std::string synth_summary(const Synthesis& result, const SynthOutcome& outcome) {
  const Solution& s = *result.best;
  const VerifyResult& proof = outcome.proof;
  std::string out = line(
      "bricks", fmt::format("{}{}", s.frame->cells.size(),
                            outcome.scaffold.empty()
                                ? ""
                                : fmt::format(", {} of them a scaffold", outcome.scaffold.size())));
  out +=
      line("colours", fmt::format("{}{}", s.colour_count,
                                  s.colour_count == 1 ? ""
                                  : s.fewer_refuted   ? ", the fewest for this order"
                                                      : ", perhaps not the fewest for this order"));
  out += line("rules", s.heights ? fmt::format("{}, with heights", s.rules.size())
                                 : fmt::format("{}, merged from {} exact ones", s.rules.size(),
                                               s.exact_rules));
  // Skeletons with heights try no orders.
  out += line("order", result.orders_tried == 0
                           ? s.order.name
                           : fmt::format("{} (of {} tried)", s.order.name, result.orders_tried));
  out += line("proof", proof.verdict == ProofVerdict::proved
                           ? fmt::format("every order of events builds it ({} local states)",
                                         proof.local_states)
                           : fmt::format("stigc verify says {}", to_string(proof.verdict)));
  for (const WalledIn& walled : outcome.findings.walled_in) {
    out += line("walled in", cell_text(walled.site) +
                                 " can be cut off before it is placed; stigc verify shows how");
  }
  // Solutions that are better in one figure and worse in another.
  for (const Solution& other : result.others) {
    out += line("or", fmt::format("{} colours and {} rules: {}", other.colour_count,
                                  other.rules.size(), other.order.name));
  }
  if (result.cut_short) out += line("note", std::string(ended_early()));
  return out;
}

std::string synth_reason(const Synthesis& result, bool color) {
  const Obstacle& obstacle = *result.obstacle;
  std::string out;
  if (obstacle.proved) {
    out = fmt::format("{}: {}\n", red("impossible", color), obstacle.what);
  } else if (result.orders_tried == 0) {
    out = fmt::format("{}: {}\n", red("not found", color), obstacle.what);
  } else {
    // Many orders have failed: the obstacle of one is told, that which says most.
    out = fmt::format("{}: {}\n  in the most telling one {}\n", red("not found", color),
                      orders_in_words(result.orders_tried), obstacle.what);
  }
  out += obstacle.drawing;
  for (const std::string& remedy : obstacle.remedies) out += "  remedy: " + remedy + "\n";
  return out;
}

}  // namespace stig::cli
