// SPDX-License-Identifier: MIT
// Writes the problem and the formula of a minimality proof; the header has the form, and
// docs/proofs.md says how it is checked. Every clause is preceded by its reason, equal
// reasons in a row being written once.
#include "synthesis/proof_files.h"

#include <fmt/format.h>

#include <cassert>
#include <iterator>

#include "synthesis/encoding.h"

namespace stig::synthesis {
namespace {

std::string reason_of(const Differences& differences, const std::vector<int>& naming,
                      const Encoding& encoding, ClauseKind kind) {
  const Schedule& schedule = differences.schedule();
  const auto at = static_cast<std::size_t>(kind.index);
  switch (kind.kind) {
    case ClauseKind::Kind::colour_of:
      return fmt::format("colour {}", kind.index);
    case ClauseKind::Kind::one_colour:
      return fmt::format("one {}", kind.index);
    case ClauseKind::Kind::domain:
      return fmt::format("domain {}", kind.index);
    case ClauseKind::Kind::naming:
      return fmt::format("naming {} {}", kind.index + 1, naming[at]);
    case ClauseKind::Kind::pair: {
      const auto [a, b] = differences.pairs()[at];
      return fmt::format("pair {} {} {}", encoding.equal(kind.index), a, b);
    }
    case ClauseKind::Kind::clash:
      break;
  }
  const Clash& clash = differences.clauses()[at].reason;
  const std::int32_t from = schedule.keys[static_cast<std::size_t>(clash.key)].site;
  const Cell q = schedule.frame->sites[static_cast<std::size_t>(from)].at;
  const Site& site = schedule.frame->sites[static_cast<std::size_t>(clash.site)];
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", clash.intended ? 'B' : 'A', from, q.x, q.y,
                     q.z, clash.orientation, site.orbit, site.at.x, site.at.y, site.at.z,
                     clash.mask);
}

}  // namespace

std::string print_cnf(const Differences& differences, int named, int k,
                      const std::vector<int>& naming) {
  Encoding encoding(differences, named, k);
  std::string body, last;
  std::size_t clauses = 0;
  // Clauses are counted while they are written, since the header comes before them and
  // needs their number.
  const auto sink = [&](std::span<const int> literals, ClauseKind kind) {
    std::string reason = reason_of(differences, naming, encoding, kind);
    if (reason != last) fmt::format_to(std::back_inserter(body), "c {}\n", reason);
    last = std::move(reason);
    for (const int literal : literals) fmt::format_to(std::back_inserter(body), "{} ", literal);
    body += "0\n";
    ++clauses;
  };
  encoding.emit_domains(naming, sink);
  encoding.emit_clashes(0, sink);
  return fmt::format("p cnf {} {}\n", encoding.variables(), clauses) + body;
}

/// Written by hand and not by a JSON library, so that the bytes are the same with every
/// version of one.
std::string print_problem(const Schedule& schedule, int named, int k) {
  assert(schedule.order.rank.size() == schedule.frame->orbits.size());
  const Frame& frame = *schedule.frame;
  std::string out = fmt::format(
      "{{\"stigc_colouring\": 1, \"lattice\": \"{}\", \"symmetry\": \"{}\", \"floor\": {},\n"
      " \"colours\": {}, \"named\": {}, \"order\": \"{}\",\n \"orbits\": [\n",
      to_string(frame.lattice), to_string(frame.symmetry), frame.floor, k, named,
      schedule.order.name);
  std::vector<std::string> cells(frame.orbits.size());
  for (std::size_t i = 0; i < frame.cells.size(); ++i) {
    std::string& of = cells[static_cast<std::size_t>(frame.orbit_of[i])];
    const Cell c = frame.cells[i];
    of += fmt::format("{}[{}, {}, {}]", of.empty() ? "" : ", ", c.x, c.y, c.z);
  }
  for (std::size_t i = 0; i < frame.orbits.size(); ++i) {
    const Orbit& orbit = frame.orbits[i];
    const bool any = orbit.colours == StateSet::anything();
    std::string allowed;
    for (int c = 1; c <= k && !any; ++c) {
      if (orbit.colours.contains(static_cast<State>(c))) {
        allowed += fmt::format("{}{}", allowed.empty() ? "" : ", ", c);
      }
    }
    out += fmt::format(
        "  {{\"at\": [{}, {}, {}], \"rank\": {}, \"start\": {}, \"colours\": {}, "
        "\"cells\": [{}]}}{}\n",
        orbit.at.x, orbit.at.y, orbit.at.z, schedule.order.rank[i], orbit.start,
        any ? "\"any\"" : "[" + allowed + "]", cells[i], i + 1 < frame.orbits.size() ? "," : "");
  }
  return out + " ]}\n";
}

}  // namespace stig::synthesis
