// SPDX-License-Identifier: MIT
// stigc certify: proofs looked at again, by code that shares nothing with their makers.
//
// Three kinds of proof: a certificate for a rule set, one of robots' work by it, and a DRAT proof
// for a formula, with or without the check that the formula says what it should. Nothing here may
// use verify/, synthesis/ or what compiler/ proves, so that the check is worth something; the
// readers of files are shared.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/file_io.h"
#include "base/hash.h"
#include "base/text.h"
#include "base/text_bytes.h"
#include "certify/check.h"
#include "certify/drat.h"
#include "certify/fewest.h"
#include "commands.h"
#include "lattice/box.h"
#include "lattice/structure.h"
#include "meant_box.h"
#include "recheck/check_work.h"
#include "report.h"
#include "robot_input.h"
#include "rules/cell_text.h"
#include "rules/rule_printer.h"
#include "rules/worked_from.h"

namespace stig::cli {
namespace {

// Sizes are bounded before anything is parsed, since a proof may come from anybody. Large proofs
// are legitimate, and are read into memory as a whole.
constexpr std::size_t kMostCertificateBytes = std::size_t{1} << 28;
constexpr std::size_t kMostProofBytes = std::size_t{1} << 30;

std::optional<std::string> bytes_of(const std::string& path, std::size_t most, const App& app) {
  FileError error;
  auto bytes = read_file(path, most, error);
  if (!bytes) app.complain(error.message);
  return bytes;
}

std::string place_of(const std::optional<BoxSpec>& box) {
  if (!box) return "in unbounded space";
  return fmt::format("in the {}box {} at {}", box->periodic ? "periodic " : "", to_text(box->size),
                     cell_text(*box->origin));
}

/// The box is part of a certificate's claim about rules; nothing else has one.
bool bounded(const CertifyOptions& options) {
  return options.world.box || options.world.origin || options.world.periodic;
}

/// Only a certificate of robots' work speaks of a robot.
bool names_robot(const CertifyOptions& options) { return options.robot || options.block; }

// An empty refusal is acceptance, in both checkers.
void print_verdict(const std::string& path, const std::string& refusal, App& app) {
  if (refusal.empty()) {
    app.print(fmt::format("{}: {}\n", printable(path), green("accepted", app.color_out())));
  } else {
    app.print(
        fmt::format("{}: {}: {}\n", printable(path), red("refused", app.color_out()), refusal));
  }
}

void print_text(const CertifyOptions& options, const CheckReport& report, std::uint64_t hash,
                std::size_t stages, App& app) {
  print_verdict(options.proof, report.refusal, app);
  if (!report.accepted) return;
  app.print(fmt::format("  every order of events ends in the same structure of {}, hash {}\n",
                        counted(report.structure.size(), "brick"), to_hex(hash)));
  app.print(fmt::format("  {}; {} {}, {} sites, {} local states\n", place_of(report.box), stages,
                        stages == 1 ? "stage" : "stages", report.sites, report.local_states));
}

void print_json(const CertifyOptions& options, const RuleSet& rules, const CheckReport& report,
                std::uint64_t hash, std::size_t stages, App& app) {
  Json json;
  // The hash is of the rules as they are checked, after --sides: a certificate is for these.
  json["ruleset"] = rules.name;
  json["ruleset_hash"] = to_hex(rule_set_hash(rules));
  json["certificate"] = options.proof;
  json["accepted"] = report.accepted;
  if (report.accepted) {
    std::optional<Box> box;
    if (report.box) {
      box = Box{*report.box->origin, report.box->size, report.box->periodic, rules.floor};
    }
    json["bricks"] = report.structure.size();
    json["structure_hash"] = to_hex(hash);
    json["box"] = to_json(box);
    json["stages"] = stages;
    json["sites"] = report.sites;
    json["local_states"] = report.local_states;
  } else {
    json["refusal"] = report.refusal;
  }
  app.print(dump(json));
}

std::vector<std::string> sides_of(const WorkCertificate& certificate) {
  std::vector<std::string> out;
  for (const int side : certificate.sides) {
    out.emplace_back(recheck::kSideNames[static_cast<std::size_t>(side)]);
  }
  return out;
}

std::string work_text(const WorkCertificate& certificate, const WorkReport& report) {
  const std::string looked =
      certificate.ordered
          ? fmt::format("{} before a column", counted(report.situations, "situation"))
          : fmt::format("{} on the way", counted(report.structures, "structure"));
  const bool one = certificate.crowd == recheck::WorkCrowd::one;
  return fmt::format(
      "  {} complete{} the structure of {} in every order of work\n"
      "  from {}; {}, {}\n",
      one                                            ? "one robot that follows these decisions"
      : certificate.crowd == recheck::WorkCrowd::any ? "any number of robots at work at once"
                                                     : "robots that each have sides of their own",
      one ? "s" : "", counted(certificate.bricks.size(), "brick"),
      fmt::join(sides_of(certificate), " "), counted(certificate.looks.size(), "look"), looked);
}

/// What robots do with the rules, for the robot and the block of their files.
int certify_work(const CertifyOptions& options, const RuleSet& file, const std::string& text,
                 App& app) {
  Diagnostics diagnostics;
  const auto certificate = read_work_certificate(options.proof, text, diagnostics);
  if (!certificate) {
    app.report(diagnostics);
    return kFailed;
  }
  const auto builder = read_builder({options.robot, options.block}, app);
  if (!builder) return kFailed;
  // The compiler takes the file's own sides where none are given.
  const RuleSet rules = worked_from_own(file, options.sides);
  const std::vector<std::string> meant = own_sides(file, options.sides);
  const auto as_set = [](const std::vector<std::string>& sides) {
    return std::set<std::string>(sides.begin(), sides.end());
  };
  WorkReport report;
  if (certificate->rule_set_hash != rule_set_hash(rules)) {
    report.refusal = "it is of other rules than these, or of robots that work from other sides";
  } else if (!meant.empty() && as_set(meant) != as_set(sides_of(*certificate))) {
    report.refusal = fmt::format("it is of robots that work from {}, and these work from {}",
                                 fmt::join(sides_of(*certificate), " "), fmt::join(meant, " "));
  } else {
    report = check_work(rules, recheck::figures_of(builder->robot, builder->block), *certificate);
  }
  if (options.json) {
    Json json{{"ruleset", rules.name},
              {"ruleset_hash", to_hex(rule_set_hash(rules))},
              {"certificate", options.proof},
              {"robot", builder->robot.name},
              {"accepted", report.accepted}};
    if (!report.accepted) json["refusal"] = report.refusal;
    json["any_number"] = certificate->crowd == recheck::WorkCrowd::any;
    json["sides"] = sides_of(*certificate);
    json["one_a_side"] = certificate->crowd != recheck::WorkCrowd::one;
    json["bricks"] = certificate->bricks.size();
    json["situations"] = report.situations;
    json["structures"] = report.structures;
    app.print(dump(json));
  } else {
    print_verdict(options.proof, report.refusal, app);
    if (report.accepted) app.print(work_text(*certificate, report));
  }
  return report.accepted ? kOk : kFailed;
}

int certify_rules(const CertifyOptions& options, App& app) {
  std::optional<RuleSet> rules = app.read_rules(options.file);
  if (!rules) return kFailed;
  const auto text = bytes_of(options.proof, kMostCertificateBytes, app);
  if (!text) return kFailed;
  if (text->starts_with(kByteOrderMark)) {
    app.complain(fmt::format("'{}' begins with a byte order mark, and no certificate does",
                             printable(options.proof)));
    return kFailed;
  }
  if (text->starts_with(kWorkCertificate)) {
    if (bounded(options)) {
      app.complain("robots know no box");
      return kUsage;
    }
    return certify_work(options, *rules, *text, app);
  }
  if (names_robot(options)) {
    app.complain("--robot and --block are for a certificate of robots' work, and this is none");
    return kUsage;
  }
  // Sides change what orientations rules have, and so what is proved: the check must be given the
  // same ones as the proof.
  rules = worked_from(std::move(*rules), options.sides);
  Diagnostics diagnostics;
  const auto certificate = read_certificate(options.proof, *text, diagnostics);
  if (!certificate) {
    app.report(diagnostics);
    return kFailed;
  }
  std::string problem;
  // The box of the file unless the command line says another: the theorem is about that box.
  const std::optional<BoxSpec> box = meant_box(*rules, options.world, problem);
  if (!problem.empty()) {
    app.complain(problem);
    return kUsage;
  }
  const CheckReport report = check_certificate(*rules, *certificate, box);
  // For comparison with what explore and measure print of the same structure.
  const std::uint64_t hash = structure_hash(Structure(rules->lattice, report.structure));
  if (options.json) {
    print_json(options, *rules, report, hash, certificate->stages.size(), app);
  } else {
    print_text(options, report, hash, certificate->stages.size(), app);
  }
  return report.accepted ? kOk : kFailed;
}

int certify_drat(const CertifyOptions& options, App& app) {
  const auto formula = bytes_of(options.file, kMostProofBytes, app);
  if (!formula) return kFailed;
  const auto proof = bytes_of(options.proof, kMostProofBytes, app);
  if (!proof) return kFailed;
  // Reverse unit propagation and RAT checks, see certify/drat.h.
  const DratReport report = check_drat(*formula, *proof);
  if (options.json) {
    Json json;
    json["formula"] = options.file;
    json["proof"] = options.proof;
    json["accepted"] = report.refuted;
    if (!report.refuted) json["refusal"] = report.refusal;
    json["variables"] = report.variables;
    json["clauses"] = report.clauses;
    json["lemmas"] = report.lemmas;
    json["deletions"] = report.deletions;
    app.print(dump(json));
  } else {
    print_verdict(options.proof, report.refusal, app);
    if (report.refuted) {
      app.print(fmt::format("  the formula has no solution: {} variables, {} clauses, {} {}\n",
                            report.variables, report.clauses, report.lemmas,
                            report.lemmas == 1 ? "lemma" : "lemmas"));
    }
  }
  return report.refuted ? kOk : kFailed;
}

/// A formula, that it says what it should, and that it has no solution.
int certify_fewest(const CertifyOptions& options, App& app) {
  const auto problem = bytes_of(options.file + "/fewer.json", kMostProofBytes, app);
  const auto formula = bytes_of(options.file + "/fewer.cnf", kMostProofBytes, app);
  const auto proof = bytes_of(options.file + "/fewer.drat", kMostProofBytes, app);
  if (!problem || !formula || !proof) return kFailed;
  // The formula is not believed: it is derived again from the problem, clause by clause.
  const FewestReport claim = derive_formula(*problem, *formula);
  DratReport drat;
  // A proof of a formula that is not the problem's is of no use.
  if (claim.derived) drat = check_drat(*formula, *proof);
  const std::string& refusal = claim.derived ? drat.refusal : claim.refusal;
  if (options.json) {
    Json json{{"folder", options.file}, {"accepted", drat.refuted}};
    if (!drat.refuted) json["refusal"] = refusal;
    json["bricks"] = claim.cells;
    json["colours"] = claim.colours;
    json["order"] = claim.order;
    json["clashes"] = claim.clashes;
    json["clauses"] = drat.clauses;
    json["lemmas"] = drat.lemmas;
    app.print(dump(json));
  } else {
    print_verdict(options.file, printable(refusal), app);
    if (drat.refuted) {
      app.print(
          fmt::format("  {} {} not do for these {} in the order '{}'\n"
                      "  {} clauses, derived again, {} of them of sites that look alike; "
                      "{} {}\n",
                      claim.colours, claim.colours == 1 ? "colour does" : "colours do",
                      counted(claim.cells, "brick"), printable(claim.order), drat.clauses,
                      claim.clashes, drat.lemmas, drat.lemmas == 1 ? "lemma" : "lemmas"));
    }
  }
  return drat.refuted ? kOk : kFailed;
}

}  // namespace

int run(const CertifyOptions& options, App& app) {
  if (options.fewest &&
      (options.drat || bounded(options) || names_robot(options) || !options.proof.empty())) {
    app.complain("--fewest wants a folder and nothing else");
    return kUsage;
  }
  if (options.fewest) return certify_fewest(options, app);
  if (options.proof.empty()) {
    app.complain("PROOF is required\ntry 'stigc certify --help'");
    return kUsage;
  }
  if (options.drat && (bounded(options) || names_robot(options))) {
    app.complain(bounded(options) ? "--drat knows no box" : "--drat knows no robot");
    return kUsage;
  }
  return options.drat ? certify_drat(options, app) : certify_rules(options, app);
}

}  // namespace stig::cli
