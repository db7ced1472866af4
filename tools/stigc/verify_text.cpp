// SPDX-License-Identifier: MIT
// The verdict comes first and in capitals; then what it is about, with the figures; then what else
// was found. Nothing is called proved here that the result does not call so.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "base/hash.h"
#include "base/text.h"
#include "rules/cell_text.h"
#include "rules/explain.h"
#include "rules/rule_printer.h"
#include "verify_report.h"

namespace stig::cli {
namespace {

// More names than a line has room for.
constexpr std::size_t kMostNames = 8;

std::string rule_name(const RuleSet& rules, std::uint32_t rule) {
  const Rule& r = rules.rules[rule];
  std::string text = fmt::format("'{}'", printable(r.name));
  if (r.range) {
    // In the manner of compilers, so that editors and terminals lead there.
    text += fmt::format(" ({}:{})", printable(r.range.file->path()),
                        r.range.file->position(r.range.begin).line);
  }
  return text;
}

// Rules by name only: these lists may be long, and positions would fill the lines.
std::string names(const RuleSet& rules, const std::vector<std::uint32_t>& some) {
  std::string text;
  for (std::size_t i = 0; i < std::min(some.size(), kMostNames); ++i) {
    text += fmt::format("{}'{}'", i == 0 ? "" : ", ", printable(rules.rules[some[i]].name));
  }
  if (some.size() > kMostNames) text += fmt::format(" and {} more", some.size() - kMostNames);
  return text;
}

std::string indented(const std::string& drawing) {
  std::string out;
  // A last line without a newline gets one.
  for (std::size_t at = 0; at < drawing.size();) {
    const std::size_t end = std::min(drawing.find('\n', at), drawing.size());
    out += "    " + drawing.substr(at, end - at) + "\n";
    at = end + 1;
  }
  return out;
}

std::string brick(const RuleSet& rules, Colour colour) {
  return printable(symbol_of(rules, StateSet::of(colour)));
}

std::string in_box(const std::optional<Box>& box) {
  if (!box) return "in unbounded space";
  return fmt::format("in the {}box {} from {}", box->periodic ? "periodic " : "",
                     to_text(box->size), cell_text(box->low));
}

// One word that scripts can look for, then what it means.
std::string verdict_line(ProofVerdict verdict, bool color) {
  switch (verdict) {
    case ProofVerdict::proved:
      return green("PROVED", color) + ": every order of events ends in the same structure\n";
    case ProofVerdict::refuted:
      return red("REFUTED", color) + ": two orders of events end in different structures\n";
    case ProofVerdict::endless:
      return yellow("ENDLESS", color) + ": an order of events goes on for ever\n";
    case ProofVerdict::unknown:
      break;
  }
  return yellow("UNKNOWN", color) + ": neither shown nor refuted\n";
}

/// A rule that does nothing is seldom meant. A warning and no error: the structure is what it is
/// without the rule.
std::string never_fires_text(const VerifyReport& report) {
  const std::vector<std::uint32_t>& dead = report.findings.dead;
  if (dead.empty()) return {};
  const std::string text =
      dead.size() == 1 ? fmt::format("rule {} never fires", rule_name(report.rules, dead.front()))
                       : fmt::format("rules {} never fire", names(report.rules, dead));
  return line("warning", text);
}

std::string proved_text(const VerifyReport& report) {
  assert(report.result.structure);
  const VerifyResult& result = report.result;
  std::string out = line("world", in_box(report.box));
  out += line("bricks", fmt::format("{}: {} at the start, {} placed", result.structure->size(),
                                    report.rules.start.size(), result.run.size()));
  out += line("hash", to_hex(structure_hash(*result.structure)));
  // The strength of the method in words: it says what the certificate lists.
  std::string method = "the order of neighbours, site by site";
  if (result.method == ProofMethod::components) {
    method = "the order of neighbours, and all orders of independent groups of bricks";
  } else if (result.method == ProofMethod::exhaustive) {
    method = "all orders";
  }
  return out + line("method", fmt::format("{} ({}), {}", to_string(result.method), method,
                                          counted(result.local_states, "local state")));
}

std::string deposit_in_words(const RuleSet& rules, const Deposit& deposit) {
  return fmt::format("brick {} at {} by rule {}", brick(rules, deposit.colour),
                     cell_text(deposit.site), rule_name(rules, deposit.match.rule));
}

std::string end_in_words(const Structure& structure, bool ended) {
  // The second order's end may be no end yet: one brick too many is enough.
  return fmt::format("{}{}, hash {}", counted(structure.size(), "brick"),
                     ended ? "" : " and growing", to_hex(structure_hash(structure)));
}

std::string refuted_text(const VerifyReport& report) {
  assert(report.result.refutation);
  const DivergingOrders& found = *report.result.refutation;
  // Both orders have the first `common` deposits; then they part.
  const Deposit& decisive = found.second[found.common];
  std::string out = line("world", in_box(report.box));
  out += line("one end", end_in_words(found.first_end, true));
  out += line("another", end_in_words(found.second_end, found.second_ended));
  // Hashes do not depend on the place, and structures that differ by it differ.
  if (structure_hash(found.first_end) == structure_hash(found.second_end)) {
    out += line("", "the same shape, but in another place");
  }
  out += fmt::format("\nAfter {} these two are at odds", counted(found.common, "deposit"));
  if (report.rules.stage_count() > 1) out += fmt::format(" (stage {})", report.result.stage);
  out += ":\n";
  out += fmt::format("  {}, which sees\n{}", deposit_in_words(report.rules, found.rival),
                     indented(draw_view(report.rules, found.rival_view)));
  out += fmt::format("  {}, which sees\n{}", deposit_in_words(report.rules, decisive),
                     indented(draw_view(report.rules, found.view)));
  return out;
}

// One period is a run of deposits that leaves a translate of the structure behind.
std::string endless_text(const VerifyReport& report) {
  assert(report.result.endless);
  const EndlessGrowth& endless = *report.result.endless;
  std::string out = line("world", in_box(report.box));
  out +=
      line("period",
           fmt::format("after {}, the last {} again and again, each time ({}, {}, {}) further on",
                       counted(endless.run.size(), "deposit"),
                       endless.period == 1 ? "one" : fmt::to_string(endless.period), endless.step.x,
                       endless.step.y, endless.step.z));
  return out;
}

std::string unknown_text(const VerifyReport& report) {
  std::string out = line("world", in_box(report.box));
  out += line("explored", printable(report.result.open));
  if (report.rules.stage_count() > 1) {
    out += line("stage", fmt::format("{} of {}", report.result.stage, report.rules.stage_count()));
  }
  // Who interrupted it knows what would have helped.
  if (report.result.interrupted) return out;
  std::string help = "more effort (--effort), time (--budget) or memory (--states)";
  if (!report.box) help += ", or a box to grow in (--box)";
  if (report.rules.stage_count() > 1) help = "the rules of one stage in a file of their own";
  return out + line("may help", help);
}

std::string repair_text(const VerifyReport& report, const Repair& repair) {
  const RuleSet& rules = report.rules;
  std::string out;
  // With several stages, the repair reaches as far as it was proved.
  const std::string where =
      repair.whole ? "" : fmt::format(" up to the end of stage {}", report.result.stage);
  if (!repair.removed.empty()) {
    out += line("repair",
                fmt::format("without rule {} every order ends in the same {}{}",
                            names(rules, repair.removed), counted(repair.bricks, "brick"), where));
  }
  if (repair.added.empty()) return out;
  out += line("repair", fmt::format("with {} every order ends in the same {}{}:",
                                    repair.added.size() == 1
                                        ? std::string("one rule more")
                                        : fmt::format("{} rules more", repair.added.size()),
                                    counted(repair.bricks, "brick"), where));
  for (const Rule& rule : repair.added) {
    out += fmt::format("    place {}{} when\n{}", brick(rules, rule.place),
                       rule.stage > 0 ? fmt::format(" in stage {}", rule.stage) : "",
                       indented(draw_pattern(repair.repaired, rule.pattern)));
  }
  return out;
}

std::string findings_text(const VerifyReport& report) {
  const Findings& f = report.findings;
  const RuleSet& rules = report.rules;
  std::string out;
  if (f.level_count > 0) {
    out += line("levels", fmt::format("the rules follow each other in {}",
                                      counted(static_cast<std::uint64_t>(f.level_count), "level")));
  }
  if (f.parallelism && !f.parallelism->rounds.empty()) {
    out += line("parallel",
                fmt::format("{}, up to {} at once, {:.1f} on average",
                            counted(f.parallelism->rounds.size(), "round"),
                            counted(f.parallelism->widest(), "brick"), f.parallelism->mean()));
  }
  if (!f.redundant.empty()) {
    out += line("not needed", fmt::format("each alone: {}", names(rules, f.redundant)));
  }
  if (f.untried > 0) {
    out += line("not needed?", fmt::format("not decided of {} within the effort (--effort)",
                                           counted(f.untried, "rule")));
  }
  // The list may hold blockings that cannot occur, so it says "may".
  if (report.result.verdict == ProofVerdict::proved) {
    for (std::size_t i = 0; i < std::min(f.blocking.size(), kMostNames); ++i) {
      const Blocking& b = f.blocking[i];
      out +=
          line("may block", fmt::format("'{}' at {} closes '{}' at {}, for a while",
                                        printable(rules.rules[b.placed].name), cell_text(b.at),
                                        printable(rules.rules[b.blocked].name), cell_text(b.site)));
    }
  }
  // An order was found for each of these.
  for (const WalledIn& walled : f.walled_in) {
    out += line("walled in",
                fmt::format("{} can be cut off while it is open, after {}", cell_text(walled.site),
                            counted(walled.order.size(), "deposit")));
  }
  // Neither an order nor a proof that there is none.
  if (f.maybe_walled_in > 0) {
    out += line("walled in?", fmt::format("{} could not be shown to be in reach at all times",
                                          counted(f.maybe_walled_in, "site")));
  }
  if (f.repair) out += repair_text(report, *f.repair);
  if (f.repair_cut_short) {
    out += line("repair", "none was found within the effort (--effort); not all were tried");
  }
  return out;
}

std::string drawing_of(const VerifyReport& report, const std::vector<PlacedBrick>& bricks) {
  return indented(small_drawing(Structure(report.rules.lattice, bricks), report.rules.bricks));
}

/// The numbers, bricks whose loss is not always mended, and one such loss with what comes of it.
std::string losses_text(const VerifyReport& report) {
  const LossResult& losses = *report.losses;
  if (losses.verdict == LossVerdict::unknown) {
    return line("losses", "unknown: " + printable(losses.open));
  }
  const std::string of = fmt::format("{} {} of a brick, from {}", losses.losses(),
                                     losses.losses() == 1 ? "loss" : "losses",
                                     counted(losses.reached.size(), "structure"));
  if (losses.verdict == LossVerdict::restored) {
    if (losses.losses() == 0) return line("losses", "there is no brick that can be lost");
    return line("losses", of + ": every order of events mends each");
  }
  std::string out =
      line("losses", fmt::format("{}: every order of events mends {}", of, losses.restored()));
  std::size_t named = 0;
  for (const LostBrick& one : losses.bricks) {
    if (one.restored == one.losses) continue;
    if (++named > kMostNames) continue;
    out += line("", fmt::format("{} at {}: {} of {}", brick(report.rules, one.brick.brick),
                                cell_text(one.brick.at), one.restored, one.losses));
  }
  if (named > kMostNames) out += line("", fmt::format("and {} bricks more", named - kMostNames));
  const LastingLoss& lasting = *losses.lasting;
  return out + fmt::format("\nA structure of {}\n{}  that loses brick {} at {} can end as\n{}",
                           counted(lasting.before.size(), "brick"),
                           drawing_of(report, lasting.before),
                           brick(report.rules, lasting.lost.brick), cell_text(lasting.lost.at),
                           drawing_of(report, lasting.end));
}

}  // namespace

std::string to_text(const VerifyReport& report, bool color) {
  const std::string title = report.rules.title.empty() ? "" : ": " + printable(report.rules.title);
  std::string out = bold(printable(report.rules.name), color) + title + "\n";
  out += verdict_line(report.result.verdict, color) + never_fires_text(report);
  switch (report.result.verdict) {
    case ProofVerdict::proved:
      out += proved_text(report);
      break;
    case ProofVerdict::refuted:
      out += refuted_text(report);
      break;
    case ProofVerdict::endless:
      out += endless_text(report);
      break;
    case ProofVerdict::unknown:
      out += unknown_text(report);
      break;
  }
  out += findings_text(report);
  if (report.losses) out += losses_text(report);
  if (report.result.verdict == ProofVerdict::proved) {
    // Large structures have no small drawing; draw makes one.
    const std::string drawing = small_drawing(*report.result.structure, report.rules.bricks);
    if (!drawing.empty()) out += "\n" + drawing;
  }
  return out;
}

}  // namespace stig::cli
